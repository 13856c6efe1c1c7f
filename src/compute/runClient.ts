import type { StartAdjustment } from '../core/mechanics/consistentStart.ts';
import type { Scenario } from '../core/scenario/types.ts';
import type { Continuation, RunCounts, RunEnd } from '../core/simulation/simulation.ts';
import type { PushRecord } from '../core/simulation/push.ts';
import type { FromWorker, Live, ToWorker } from './protocol.ts';

export interface RunHandlers {
  started(columns: string[], adjustments: StartAdjustment[], notes: string[]): void;
  rows(columns: Float64Array[], rows: number, time: number, counts: RunCounts, seconds: number): void;
  /** A hand acts from then on, or lets go. */
  pushed?(record: PushRecord): void;
  ended(end: RunEnd, counts: RunCounts, seconds: number): void;
  refused(path: string, message: string): void;
}

/** How long a cancelled worker may take to answer; it looks at its mailbox every 12 ms. */
const PATIENCE_MS = 3000;

/** The page's end of the worker: one run at a time; what an older run still sends is dropped. */
export class RunClient {
  private readonly create: () => Worker;
  private worker: Worker | null = null;
  private run = 0;
  private handlers: RunHandlers | null = null;

  constructor(create: () => Worker) {
    this.create = create;
  }

  /**
   * @param from a row to go on from, in place of a start at t = 0
   * @param live what a hand does to it from the start; without it nothing can be done by hand
   */
  start(scenario: Scenario, handlers: RunHandlers, from?: Continuation, live?: Live): void {
    this.handlers = handlers;
    this.run++;
    this.send({ type: 'start', run: this.run, scenario, from, live });
  }

  /** What a hand does to the current run. */
  act(live: Live): void {
    if (this.handlers) this.send({ type: 'push', run: this.run, live });
  }

  /** Asks the current run to stop; its `ended` follows with reason `cancelled`. A worker that does not answer is ended. */
  cancel(): void {
    const { run, handlers } = this;
    if (!handlers) return;
    this.send({ type: 'cancel', run });
    setTimeout(() => {
      if (this.handlers === handlers && this.run === run) this.lose('it did not answer');
    }, PATIENCE_MS);
  }

  /** Forgets the current run: nothing of it is heard any more. */
  abandon(): void {
    this.cancel();
    this.handlers = null;
    this.run++;
  }

  /** Ends the worker; nothing more is heard of it. */
  close(): void {
    this.handlers = null;
    this.worker?.terminate();
    this.worker = null;
  }

  private send(message: ToWorker): void {
    this.worker ??= this.open();
    this.worker.postMessage(message);
  }

  private open(): Worker {
    const worker = this.create();
    worker.addEventListener('message', ({ data }: MessageEvent<FromWorker>) => this.receive(data));
    worker.addEventListener('error', (event) => {
      if (this.worker === worker) this.lose(event.message);
    });
    worker.addEventListener('messageerror', () => {
      if (this.worker === worker) this.lose('a message could not be read');
    });
    return worker;
  }

  /** A worker that died cannot be asked again; the next run gets a new one, and what came so far stays. */
  private lose(why: string): void {
    const { handlers } = this;
    this.close();
    handlers?.refused(
      '',
      `the computation stopped unexpectedly${why ? ` (${why})` : ''}; rows computed so far are kept, run again to retry`,
    );
  }

  private receive(message: FromWorker): void {
    const handlers = this.handlers;
    if (!handlers || message.run !== this.run) return;
    switch (message.type) {
      case 'started':
        return handlers.started(message.columns, message.adjustments, message.notes);
      case 'rows':
        return handlers.rows(message.columns, message.rows, message.time, message.counts, message.seconds);
      case 'pushed':
        return handlers.pushed?.(message.record);
      case 'ended':
        this.handlers = null;
        return handlers.ended(message.end, message.counts, message.seconds);
      case 'refused':
        this.handlers = null;
        return handlers.refused(message.path, message.message);
    }
  }
}
