/** Answers of a lesson's questions, computed as everything else is. */
import { controlReport } from '../control/design/report.ts';
import type { Feedback } from '../mechanics/forcing.ts';
import type { System } from '../model/system.ts';
import type { SweepMeasure } from '../motion/sweepMeasures.ts';
import { ScenarioError, type Scenario } from '../scenario/types.ts';
import { reduceRun } from '../sweep/reduceRun.ts';
import type { Ask } from './lesson.ts';

/** No lesson waits longer than a run of so many seconds takes. */
const LONGEST_RUN = 120;

/**
 * The number, in SI.
 *
 * @param scenario checked
 * @param system that it names
 * @param ask what of it
 * @param feedback of its controller
 * @throws ScenarioError where there is no such number
 */
export function answerOf(
  scenario: Scenario,
  system: System,
  ask: Ask,
  feedback: ReadonlyMap<string, Feedback> | null,
): number {
  if (ask.kind === 'growth') {
    const { eigenvalues, closedLoopEigenvalues } = controlReport(scenario, system);
    // Neutral modes, as where on the ground a board stands, are exact zeros and neither grow nor fade.
    const moving = (closedLoopEigenvalues ?? eigenvalues).filter(([re, im]) => re !== 0 || im !== 0);
    return finite(Math.max(...moving.map(([re]) => re)), 'growth');
  }
  if (scenario.duration > LONGEST_RUN)
    throw new ScenarioError('duration', `a lesson's run takes at most ${LONGEST_RUN} s`);
  const { column } = ask;
  const measures: SweepMeasure[] =
    ask.kind === 'time'
      ? [{ kind: 'time' }]
      : ask.kind === 'range'
        ? [
            { kind: 'max', column },
            { kind: 'min', column },
          ]
        : [{ kind: ask.kind, column }];
  const [one, other] = reduceRun(scenario, system, measures, { feedback }).values;
  return finite(ask.kind === 'range' ? one! - other! : one!, column || ask.kind);
}

function finite(x: number, what: string): number {
  if (!Number.isFinite(x)) throw new ScenarioError('answer', `there is no ${what} in this run`);
  return x;
}
