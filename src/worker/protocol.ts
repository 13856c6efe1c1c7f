import type { StartAdjustment } from '../core/dynamics/consistentStart.ts';
import type { Scenario } from '../core/scenario/types.ts';
import type { Continuation, RunCounts, RunEnd } from '../core/simulation/simulation.ts';

/** Page to worker. Every message names the run it belongs to, so that nothing of an old run is taken for the new. */
export type ToWorker = { type: 'start'; run: number; scenario: Scenario; from?: Continuation } | { type: 'cancel'; run: number };

/** Worker to page. Column buffers are transferred, not copied; `seconds` is the time spent computing so far. */
export type FromWorker =
  | { type: 'started'; run: number; columns: string[]; adjustments: StartAdjustment[]; notes: string[] }
  | { type: 'rows'; run: number; columns: Float64Array[]; rows: number; time: number; counts: RunCounts; seconds: number }
  | { type: 'ended'; run: number; end: RunEnd; counts: RunCounts; seconds: number }
  | { type: 'refused'; run: number; path: string; message: string };
