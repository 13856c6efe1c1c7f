import type { ControlAnalysis } from '../../core/control/analysis.ts';
import type { Scenario, ScenarioFile } from '../../core/scenario/types.ts';
import { RemoteWorker, type WorkerLike } from '../remote/remoteWorker.ts';
import type { ControlCalls } from '../services/controlTypes.ts';
import { answerOf, checked, type Answer, type Metas } from './answer.ts';

interface Question {
  asker: string;
  scenario: Scenario;
  resolve(answer: Answer<ControlAnalysis> | null): void;
}

/**
 * Analyses of scenarios. One question is computed at a time; of those that wait, each asker's newest replaces its older
 * one, so that turning a knob never makes a queue.
 */
export class ControlClient {
  private readonly worker: RemoteWorker<ControlCalls>;
  private readonly metas: Metas;
  private current: Question | null = null;
  private readonly waiting = new Map<string, Question>();

  constructor(start: () => WorkerLike, metas: Metas) {
    this.worker = new RemoteWorker(start);
    this.metas = metas;
  }

  /**
   * Linearization, modes and, with an lqr, the gain of a scenario as it is written.
   *
   * @param asker who asks: a question makes older ones of the same asker void
   * @returns null where a newer question of the same asker took its place
   */
  analyse(file: ScenarioFile, asker: string): Promise<Answer<ControlAnalysis> | null> {
    this.forget(asker);
    const scenario = checked(file, this.metas);
    if (!scenario.ok) return Promise.resolve(scenario);
    return new Promise((resolve) => {
      this.waiting.set(asker, { asker, scenario: scenario.value, resolve });
      this.proceed();
    });
  }

  /** Makes an asker's open questions void. */
  forget(asker: string): void {
    this.waiting.get(asker)?.resolve(null);
    this.waiting.delete(asker);
    if (this.current?.asker === asker) this.current.resolve(null);
  }

  /** Ends the worker; open questions are void. */
  close(): void {
    this.current?.resolve(null);
    for (const question of this.waiting.values()) question.resolve(null);
    this.waiting.clear();
    this.current = null;
    this.worker.close();
  }

  private proceed(): void {
    if (this.current) return;
    const [first] = this.waiting;
    if (!first) return;
    const [asker, question] = first;
    this.waiting.delete(asker);
    this.current = question;
    const { result } = this.worker.call('control.analyse', question.scenario);
    void answerOf(result, 'change something to try again').then((answer) => {
      question.resolve(answer);
      if (this.current !== question) return;
      this.current = null;
      this.proceed();
    });
  }
}
