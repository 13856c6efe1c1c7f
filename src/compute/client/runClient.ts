import type { StartAdjustment } from '../../core/mechanics/consistentStart.ts';
import type { EngineId, RideCommand, Scenario } from '../../core/scenario/types.ts';
import type { PushRecord } from '../../core/simulation/push.ts';
import type { RunCounts, RunEnd } from '../../core/simulation/simulation.ts';
import { RemoteWorker, type OngoingCall, type WorkerLike } from '../remote/remoteWorker.ts';
import type { Live, RunCalls, RunEvent, RunRequest, RunResult } from '../services/runTypes.ts';
import type { RideCalls, RideStart, RideUpdate } from '../services/rideTypes.ts';
import { answerOf } from './answer.ts';

export interface RunHandlers {
  /** Share of the equations of a described system that is derived. */
  derived?(share: number): void;
  started(columns: string[], adjustments: StartAdjustment[], notes: string[], engine: EngineId): void;
  rows(columns: Float64Array[], rows: number, time: number, counts: RunCounts, seconds: number): void;
  /** A push acts from then on, or ends. */
  pushed?(record: PushRecord): void;
  /** A ride was told this; when it was given, ms. */
  told?(command: RideCommand, given: number): void;
  ended(end: RunEnd, counts: RunCounts, seconds: number): void;
  refused(path: string, message: string): void;
}

/** How it is computed: from where, pushed by what, and what is waited for. */
export type RunOptions = Omit<RunRequest, 'scenario'> & {
  /** In step with the clock, told where to go: the scenario's control is a ride. */
  ride?: RideStart | undefined;
};

/** One run at a time, in a worker of its own; nothing is heard of an older one. */
export class RunClient {
  private readonly worker: RemoteWorker<RunCalls & RideCalls>;
  private current: {
    call: OngoingCall<RunResult, Live> | OngoingCall<RunResult, RideUpdate>;
    abort: AbortController;
  } | null = null;

  constructor(start: () => WorkerLike) {
    this.worker = new RemoteWorker(start);
  }

  start(scenario: Scenario, handlers: RunHandlers, { from, live, until, soonest, ride }: RunOptions = {}): void {
    this.abandon();
    const abort = new AbortController();
    const heard = { signal: abort.signal, onEvent: (event: RunEvent) => hear(event, handlers) };
    const call = ride
      ? this.worker.call('ride.compute', { scenario, ride }, { ...heard, prompt: true })
      : this.worker.call('run.compute', { scenario, from, live, until, soonest }, heard);
    const current = (this.current = { call, abort });
    void answerOf(call.result, 'rows computed so far are kept, run again to retry').then((answer) => {
      if (this.current !== current || !answer) return;
      this.current = null;
      if (answer.ok) handlers.ended(answer.value.end, answer.value.counts, answer.value.seconds);
      else handlers.refused(answer.path, answer.message);
    });
  }

  /** What pushes the current run. */
  act(live: Live): void {
    (this.current?.call as OngoingCall<RunResult, Live> | undefined)?.update(live);
  }

  /** What a ride is told, or how fast its clock goes. */
  steer(update: RideUpdate): void {
    (this.current?.call as OngoingCall<RunResult, RideUpdate> | undefined)?.update(update);
  }

  /** Asks the current run to stop; its `ended` follows with reason `cancelled`. A worker that does not answer is ended. */
  cancel(): void {
    this.current?.abort.abort();
  }

  /** Forgets the current run: nothing of it is heard any more. */
  abandon(): void {
    const { current } = this;
    this.current = null;
    current?.call.drop();
  }

  /** Ends the worker; nothing more is heard of it. */
  close(): void {
    this.current = null;
    this.worker.close();
  }
}

function hear(event: RunEvent, handlers: RunHandlers): void {
  switch (event.type) {
    case 'derived':
      return handlers.derived?.(event.share);
    case 'started':
      return handlers.started(event.columns, event.adjustments, event.notes, event.engine);
    case 'rows':
      return handlers.rows(event.columns, event.rows, event.time, event.counts, event.seconds);
    case 'pushed':
      return handlers.pushed?.(event.record);
    case 'told':
      return handlers.told?.(event.command, event.given);
  }
}
