import type { ControlAnalysis } from '../core/control/analysis.ts';
import { checkScenario } from '../core/scenario/schema.ts';
import { ScenarioError, type Scenario, type ScenarioFile } from '../core/scenario/types.ts';
import type { SystemMeta } from '../core/model/system.ts';
import type { ControlReply, ControlRequest } from './controlProtocol.ts';

/** A value, or why there is none: `path` is the scenario's key that it is about, empty where it is none of them. */
export type Answer<T> = { ok: true; value: T } | { ok: false; path: string; message: string };

interface Question {
  asker: string;
  scenario: Scenario;
  resolve(answer: Answer<ControlAnalysis> | null): void;
}

/**
 * The page's end of the control worker. One question is computed at a time; of those that wait, each asker's newest
 * replaces its older one, so that turning a knob never makes a queue.
 */
export class ControlClient {
  private readonly create: () => Worker;
  private readonly metas: Readonly<Record<string, SystemMeta>>;
  private worker: Worker | null = null;
  private next = 1;
  private current: { id: number; question: Question } | null = null;
  private readonly waiting = new Map<string, Question>();

  constructor(create: () => Worker, metas: Readonly<Record<string, SystemMeta>>) {
    this.create = create;
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
    let scenario: Scenario;
    try {
      scenario = checkScenario(file, this.metas);
    } catch (error) {
      if (!(error instanceof ScenarioError)) throw error;
      return Promise.resolve({ ok: false, path: error.path, message: error.message });
    }
    return new Promise((resolve) => {
      this.waiting.set(asker, { asker, scenario, resolve });
      this.proceed();
    });
  }

  /** Makes an asker's open questions void. */
  forget(asker: string): void {
    this.waiting.get(asker)?.resolve(null);
    this.waiting.delete(asker);
    if (this.current?.question.asker === asker) this.current.question.resolve(null);
  }

  /** Ends the worker; open questions are void. */
  close(): void {
    this.current?.question.resolve(null);
    for (const question of this.waiting.values()) question.resolve(null);
    this.waiting.clear();
    this.current = null;
    this.worker?.terminate();
    this.worker = null;
  }

  private proceed(): void {
    if (this.current) return;
    const [first] = this.waiting;
    if (!first) return;
    const [asker, question] = first;
    this.waiting.delete(asker);
    this.current = { id: this.next++, question };
    this.worker ??= this.open();
    this.worker.postMessage({
      type: 'analyse',
      id: this.current.id,
      scenario: question.scenario,
    } satisfies ControlRequest);
  }

  private receive(reply: ControlReply): void {
    if (reply.id !== this.current?.id) return;
    const { question } = this.current;
    this.current = null;
    if (reply.type === 'analysed') question.resolve({ ok: true, value: reply.analysis });
    else if (reply.type === 'refused') question.resolve({ ok: false, path: reply.path, message: reply.message });
    this.proceed();
  }

  private open(): Worker {
    const worker = this.create();
    worker.addEventListener('message', ({ data }: MessageEvent<ControlReply>) => this.receive(data));
    worker.addEventListener('error', (event) => {
      // A worker that died cannot be asked again: the next question gets a new one.
      worker.terminate();
      this.worker = null;
      const question = this.current?.question;
      this.current = null;
      question?.resolve({
        ok: false,
        path: '',
        message: `the computation stopped unexpectedly${event.message ? ` (${event.message})` : ''}; change something to try again`,
      });
      this.proceed();
    });
    return worker;
  }
}
