import type { StartAdjustment } from '../core/mechanics/consistentStart.ts';
import type { Scenario } from '../core/scenario/types.ts';
import type { Push, PushRecord } from '../core/simulation/push.ts';
import type { Continuation, RunCounts, RunEnd } from '../core/simulation/simulation.ts';

/** Page to worker. Every message names the run it belongs to, so that nothing of an old run is taken for the new. */
export type ToWorker =
  | { type: 'start'; run: number; scenario: Scenario; from?: Continuation | undefined; live?: Live | undefined }
  | { type: 'cancel'; run: number }
  | { type: 'push'; run: number; live: Live };

/** What a hand does to a run, and how far ahead (s) it may be computed; null: to its end. */
export interface Live {
  /** Left out: as it was. */
  push?: Push | null;
  horizon: number | null;
}

/** Worker to page. Column buffers are transferred, not copied; `seconds` is the time spent computing so far. */
export type FromWorker =
  | { type: 'started'; run: number; columns: string[]; adjustments: StartAdjustment[]; notes: string[] }
  | {
      type: 'rows';
      run: number;
      columns: Float64Array[];
      rows: number;
      time: number;
      counts: RunCounts;
      seconds: number;
    }
  /** From this time on the push acts that the page asked for. */
  | { type: 'pushed'; run: number; record: PushRecord }
  | { type: 'ended'; run: number; end: RunEnd; counts: RunCounts; seconds: number }
  | { type: 'refused'; run: number; path: string; message: string };
