import type { Feedback } from '../../core/mechanics/forcing.ts';
import { ScenarioError, type Scenario } from '../../core/scenario/types.ts';
import { methods } from '../../core/integrators/methods.ts';
import { learnSystem, loadSystem, type SystemParts } from '../../core/systems/registry.ts';
import type { System } from '../../core/model/system.ts';

/** The equations of the system that a scenario names, and of no other. @throws ScenarioError */
export async function systemOf(
  { system: id, description }: Pick<Scenario, 'system' | 'description'>,
  parts?: SystemParts,
): Promise<System> {
  if (description !== undefined) await learnSystem(description);
  const system = await loadSystem(id, parts);
  if (!system) throw new ScenarioError('system', `unknown system "${id}"`);
  return system;
}

/**
 * What of its system's equations a run takes.
 *
 * @param pushed the run can be pushed by hand
 * @param soonest the first rows matter more than the last: what only makes a run faster is left out
 */
export function partsOf({ method, control }: Scenario, pushed: boolean, soonest: boolean): SystemParts {
  const implicit = methods.some(({ id, implicit }) => id === method.name && implicit);
  return {
    jacobians: implicit || pushed || control?.type === 'lqr' || control?.type === 'ride',
    tape: !soonest && method.engine !== 'typescript',
  };
}

/** The state feedback that a scenario asks for; what designs it is loaded only where there is one. */
export async function feedbackFor(scenario: Scenario, system: System): Promise<ReadonlyMap<string, Feedback> | null> {
  if (scenario.control?.type !== 'lqr' && scenario.control?.type !== 'ride') return null;
  const { feedbackOf } = await import('../../core/control/design/feedback.ts');
  return feedbackOf(scenario, system);
}
