import type { StartAdjustment } from '../../core/mechanics/consistentStart.ts';
import type { EngineId, RideCommand, Scenario } from '../../core/scenario/types.ts';
import type { Push, PushRecord } from '../../core/simulation/push.ts';
import type { Continuation, RunCounts, RunEnd } from '../../core/simulation/simulation.ts';
import type { Call } from '../remote/protocol.ts';

export interface RunCalls {
  /** Computes a run and sends its rows as they come. Aborted, it answers with the end `cancelled`. */
  'run.compute': Call<RunRequest, RunResult, RunEvent, Live>;
}

export interface RunRequest {
  scenario: Scenario;
  /** A row to go on from, in place of a start at t = 0. */
  from?: Continuation | undefined;
  /** What pushes the run from its start; without it the run cannot be pushed. */
  live?: Live | undefined;
  /** The time (s) that is waited for on the stage: rows are sent as soon as it is reached. */
  until?: number | undefined;
  /** Begins without what only makes a run faster: the bits are the same, the engine may be another. */
  soonest?: boolean | undefined;
}

/** What pushes a run, and how far ahead (s) it may be computed; null: to its end. */
export interface Live {
  /** Left out: as it was. */
  push?: Push | null;
  horizon: number | null;
}

/** Column buffers are transferred, not copied; `seconds` is the time spent computing so far. */
export type RunEvent =
  /** The equations of a described system are on their way: the share that is done. */
  | { type: 'derived'; share: number }
  | { type: 'started'; columns: string[]; adjustments: StartAdjustment[]; notes: string[]; engine: EngineId }
  | { type: 'rows'; columns: Float64Array[]; rows: number; time: number; counts: RunCounts; seconds: number }
  /** From this time on the push acts that the page asked for. */
  | { type: 'pushed'; record: PushRecord }
  /** A ride has this command in its list from now on; and when it was given, as the page said (ms). */
  | { type: 'told'; command: RideCommand; given: number };

export interface RunResult {
  end: RunEnd;
  counts: RunCounts;
  seconds: number;
}
