import type { ControlAnalysis } from '../../core/control/analysis.ts';
import type { ComputerReport } from '../../core/control/sampled/computerReport.ts';
import type { TurnMap } from '../../core/control/path/turnMap.ts';
import type { Responses } from '../../core/control/responses.ts';
import type { Scenario, ScenarioFile } from '../../core/scenario/types.ts';
import type { RegulatorEffect } from '../../core/control/design/effect.ts';
import { RemoteWorker, type WorkerLike } from '../remote/remoteWorker.ts';
import type { ControlCalls } from '../services/controlTypes.ts';
import { answerOf, checked, type Answer, type Metas } from './answer.ts';

interface Question {
  asker: string;
  /** Has it computed; settles once the worker is free. */
  compute(): Promise<void>;
  /** A newer question took its place. */
  drop(): void;
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
    return this.ask(file, asker, (scenario) => this.worker.call('control.analyse', scenario).result);
  }

  /** Margins of its regulator and its sampled loop; takes longer. As `analyse`, of which its askers are apart. */
  computer(file: ScenarioFile, asker: string): Promise<Answer<ComputerReport> | null> {
    return this.ask(file, asker, (scenario) => this.worker.call('control.computer', scenario).result);
  }

  /** What its regulator does in a whole run, which takes as long as the run. */
  effect(file: ScenarioFile, asker: string): Promise<Answer<RegulatorEffect> | null> {
    return this.ask(file, asker, (scenario, drop) => {
      const { result, drop: end } = this.worker.call('control.effect', scenario);
      // It looks at its mailbox: a newer question need not wait for its end.
      drop(end);
      return result;
    });
  }

  /** Steady turns over radius and speed. As `computer`. */
  turns(file: ScenarioFile, asker: string): Promise<Answer<TurnMap> | null> {
    return this.ask(file, asker, (scenario) => this.worker.call('control.turns', scenario).result);
  }

  /** Loop gain at an input and a step's answer in a state. As `computer`. */
  responses(file: ScenarioFile, input: string, state: string, asker: string): Promise<Answer<Responses | null> | null> {
    return this.ask(
      file,
      asker,
      (scenario) => this.worker.call('control.responses', { scenario, input, state }).result,
    );
  }

  private ask<T>(
    file: ScenarioFile,
    asker: string,
    call: (scenario: Scenario, onDrop: (end: () => void) => void) => Promise<T>,
  ): Promise<Answer<T> | null> {
    this.forget(asker);
    const scenario = checked(file, this.metas);
    if (!scenario.ok) return Promise.resolve(scenario);
    return new Promise((resolve) => {
      let end = (): void => {};
      const compute = async (): Promise<void> =>
        resolve(
          await answerOf(
            call(scenario.value, (drop) => (end = drop)),
            'change something to try again',
          ),
        );
      const drop = (): void => {
        resolve(null);
        end();
      };
      this.waiting.set(asker, { asker, compute, drop });
      this.proceed();
    });
  }

  /** Makes an asker's open questions void. */
  forget(asker: string): void {
    this.waiting.get(asker)?.drop();
    this.waiting.delete(asker);
    if (this.current?.asker === asker) this.current.drop();
  }

  /** Ends the worker; open questions are void. */
  close(): void {
    this.current?.drop();
    for (const question of this.waiting.values()) question.drop();
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
    void question.compute().then(() => {
      if (this.current !== question) return;
      this.current = null;
      this.proceed();
    });
  }
}
