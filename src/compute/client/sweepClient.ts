import { RemoteWorker, type WorkerLike } from '../remote/remoteWorker.ts';
import type { Reduced } from '../../core/sweep/reduceRun.ts';
import type { MeasureRequest, SweepCalls } from '../services/sweepTypes.ts';
import { answerOf, type Answer } from './answer.ts';

/** Measures one run at a time in a worker of its own. */
export class SweepClient {
  private readonly worker: RemoteWorker<SweepCalls>;

  constructor(start: () => WorkerLike) {
    this.worker = new RemoteWorker(start);
  }

  /** @returns null where it was closed meanwhile; a worker that died takes its run with it, the next run gets a new one */
  measure(request: MeasureRequest, onShare: (share: number) => void): Promise<Answer<Reduced> | null> {
    return answerOf(this.worker.call('sweep.measure', request, { onEvent: onShare }).result);
  }

  close(): void {
    this.worker.close();
  }
}
