import { RemoteWorker, type WorkerLike } from '../remote/remoteWorker.ts';
import type { TestAnswer, TestRequest, TestsCalls } from '../services/testsTypes.ts';
import { answerOf, type Answer } from './answer.ts';
import { Pool } from './pool.ts';

/** Measures one run of a test at a time in a worker of its own. */
export class TestsClient {
  private readonly worker: RemoteWorker<TestsCalls>;

  constructor(start: () => WorkerLike) {
    this.worker = new RemoteWorker(start);
  }

  /** @returns null where it was closed meanwhile */
  measure(request: TestRequest): Promise<Answer<TestAnswer> | null> {
    return answerOf(this.worker.call('tests.measure', request).result);
  }

  close(): void {
    this.worker.close();
  }
}

/** As many at a time as there are cores. */
export const testsPool = (start: (purpose: 'tests') => WorkerLike, cores: number): Pool<TestsClient> =>
  new Pool(() => new TestsClient(() => start('tests')), cores);
