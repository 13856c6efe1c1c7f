import type { SweepMeasure } from '../core/motion/sweepMeasures.ts';
import type { ScenarioFile } from '../core/scenario/types.ts';
import type { RunCounts, RunEnd } from '../core/simulation/simulation.ts';

/** Page to worker: one run to be measured; it is checked there, so that the page has nothing to wait for. */
export interface SweepRequest {
  job: number;
  file: ScenarioFile;
  measures: readonly SweepMeasure[];
}

/** Worker to page: numbers only, no rows. One `measured` or `refused` a request, `progress` before. */
export type SweepReply =
  | { type: 'progress'; job: number; share: number }
  | { type: 'measured'; job: number; values: number[]; end: RunEnd; counts: RunCounts; seconds: number }
  | { type: 'refused'; job: number; path: string; message: string };
