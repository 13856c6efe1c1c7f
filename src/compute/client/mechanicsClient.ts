import type { ExchangeFormat, Exchanged } from '../../core/exchange/index.ts';
import type { StateOfSystem, Terms } from '../../core/mechanics/terms.ts';
import type { Ask } from '../../core/lessons/lesson.ts';
import type { Scenario } from '../../core/scenario/types.ts';
import { RemoteWorker, type WorkerLike } from '../remote/remoteWorker.ts';
import type { MechanicsCalls } from '../services/mechanicsTypes.ts';
import { answerOf, type Answer } from './answer.ts';

/** A system's equations in numbers, for what shows them; the page itself holds no equations. */
export class MechanicsClient {
  private readonly worker: RemoteWorker<MechanicsCalls>;

  constructor(start: () => WorkerLike) {
    this.worker = new RemoteWorker(start);
  }

  terms(state: StateOfSystem): Promise<Answer<Terms> | null> {
    return answerOf(this.worker.call('mechanics.terms', state).result);
  }

  /** The answer of a lesson's question. */
  answer(scenario: Scenario, ask: Ask): Promise<Answer<number> | null> {
    return answerOf(this.worker.call('mechanics.answer', { scenario, ask }).result);
  }

  /** A scenario's system as a file of another tool. */
  export(scenario: Scenario, format: ExchangeFormat): Promise<Answer<Exchanged> | null> {
    return answerOf(this.worker.call('mechanics.export', { scenario, format }).result);
  }
}
