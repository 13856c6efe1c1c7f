/** A controller that was designed is taken again as long as the next run asks for the same one. */
import type { System } from '../model/system.ts';
import type { Scenario } from '../scenario/types.ts';

/**
 * Designs a controller once for runs that ask for the same one after another, as most of a study's do, and those of a page
 * whose start is dragged.
 *
 * @param design makes the controller; one that fails, at once or later, is tried again by the next run
 */
export function sharedFeedback<F>(
  design: (scenario: Scenario, system: System) => F,
): (s: Scenario, system: System) => F {
  let last: { asked: string; system: System; feedback: F } | null = null;
  return (scenario, system) => {
    const { parameters, constraints, hold, control } = scenario;
    const asked = JSON.stringify([parameters, constraints, hold, control]);
    if (last?.asked === asked && last.system === system) return last.feedback;
    last = null;
    const designed = { asked, system, feedback: design(scenario, system) };
    last = designed;
    if (designed.feedback instanceof Promise) designed.feedback.catch(() => last === designed && (last = null));
    return designed.feedback;
  };
}
