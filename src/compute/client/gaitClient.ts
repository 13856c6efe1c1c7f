import type { GaitReport } from '../../core/gait/measureGait.ts';
import type { SearchState } from '../../core/gait/optimiseGait.ts';
import { RemoteWorker, type WorkerLike } from '../remote/remoteWorker.ts';
import type { GaitCalls, GaitRequest } from '../services/gaitTypes.ts';
import { answerOf, type Answer } from './answer.ts';

/** Looks for gaits, one search at a time, in a worker of its own: it takes seconds and tells how far it got. */
export class GaitClient {
  private readonly worker: RemoteWorker<GaitCalls>;
  private abort: AbortController | null = null;

  constructor(start: () => WorkerLike) {
    this.worker = new RemoteWorker(start);
  }

  /** @returns the gait that was found, null where it was cancelled before there was one */
  async find(request: GaitRequest, onState: (state: SearchState) => void): Promise<Answer<GaitReport | null>> {
    this.cancel();
    const abort = (this.abort = new AbortController());
    const call = this.worker.call('gait.find', request, { signal: abort.signal, onEvent: onState });
    return (await answerOf(call.result, 'try again')) ?? { ok: true, value: null };
  }

  /** The search under way answers with the cheapest so far. */
  cancel(): void {
    this.abort?.abort();
    this.abort = null;
  }
}
