import type { Feedback } from '../mechanics/forcing.ts';
import type { System } from '../model/system.ts';
import { extrasFor, needsRows, RunMeasurer, type SweepMeasure } from '../motion/sweepMeasures.ts';
import type { EngineId, Scenario } from '../scenario/types.ts';
import { RepeatedRuns } from '../simulation/repeatedRuns.ts';
import type { RunCounts, RunEnd } from '../simulation/simulation.ts';

/** Rows after which they are measured and let go. */
const CHUNK_ROWS = 2048;

/** One run is over before the next one begins. */
const runs = new RepeatedRuns();

export interface Reduced {
  /** One number a measure, NaN where the run has none. */
  values: number[];
  end: RunEnd;
  counts: RunCounts;
  /** Of computing. */
  seconds: number;
  engine: EngineId;
}

export interface ReduceOptions {
  feedback: ReadonlyMap<string, Feedback> | null;
  /** A clock, ms; without one `seconds` is 0. */
  now?: () => number;
  /** Whether it should stop for `between` now, although few rows are there. */
  pause?: () => boolean;
  /** Called after a pause, with the share of the run that is done (0 to 1). */
  between?: (share: number) => void;
}

/**
 * One run reduced to its measures; no row is kept.
 *
 * @param checked the scenario, SI
 * @param system that the study names
 * @param measures what is taken of the run
 * @throws ScenarioError, StartError
 */
export function reduceRun(
  checked: Scenario,
  system: System,
  measures: readonly SweepMeasure[],
  { feedback, now = () => 0, pause = () => false, between = () => {} }: ReduceOptions,
): Reduced {
  const scenario = needsRows(measures, system.meta) ? checked : { ...checked, outputStep: checked.duration };
  const from = now();
  const simulation = runs.next(scenario, system, { extras: extrasFor(measures, system.meta.inputs), feedback });
  const measurer = new RunMeasurer(system, scenario.parameters, simulation.columns, measures, simulation.q);
  const take = (): void => {
    const { columns, rows } = simulation.takeChunk();
    measurer.take(columns, rows);
  };
  while (!simulation.end) {
    simulation.advance(() => simulation.rows >= CHUNK_ROWS || pause());
    take();
    if (pause()) between(simulation.time / scenario.duration);
  }
  // A run that ended at its very start still has that row.
  take();
  const seconds = (now() - from) / 1000;
  const { end, counts, engine } = simulation;
  return { values: measurer.result(end, counts, seconds), end, counts, seconds, engine };
}
