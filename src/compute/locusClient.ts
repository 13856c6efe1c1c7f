import type { LocusRequest, ScenarioLocus } from '../core/control/locus/scenarioLocus.ts';
import { checkScenario } from '../core/scenario/schema.ts';
import { ScenarioError, type Scenario, type ScenarioFile } from '../core/scenario/types.ts';
import type { SystemMeta } from '../core/model/system.ts';
import type { ControlReply, ControlRequest } from './controlProtocol.ts';
import type { Answer } from './controlClient.ts';

/** Root loci, each in a worker of its own: it takes seconds, is told how far it got, and is cancelled by ending it. */
export class LocusClient {
  private readonly create: () => Worker;
  private readonly metas: Readonly<Record<string, SystemMeta>>;
  private worker: Worker | null = null;
  private settle: ((answer: Answer<ScenarioLocus> | null) => void) | null = null;

  constructor(create: () => Worker, metas: Readonly<Record<string, SystemMeta>>) {
    this.create = create;
    this.metas = metas;
  }

  /** Takes the place of one under way. @returns null where it was cancelled */
  start(
    file: ScenarioFile,
    request: LocusRequest,
    progress: (share: number) => void,
  ): Promise<Answer<ScenarioLocus> | null> {
    this.cancel();
    let scenario: Scenario;
    try {
      scenario = checkScenario(file, this.metas);
    } catch (error) {
      if (!(error instanceof ScenarioError)) throw error;
      return Promise.resolve({ ok: false, path: error.path, message: error.message });
    }
    return new Promise((resolve) => {
      const worker = this.create();
      this.worker = worker;
      this.settle = resolve;
      worker.addEventListener('message', ({ data }: MessageEvent<ControlReply>) => {
        if (worker !== this.worker) return;
        if (data.type === 'progress') progress(data.share);
        else if (data.type === 'locus') this.end({ ok: true, value: data.locus });
        else if (data.type === 'refused') this.end({ ok: false, path: data.path, message: data.message });
      });
      worker.addEventListener('error', (event) => {
        if (worker === this.worker)
          this.end({
            ok: false,
            path: '',
            message: `the computation stopped unexpectedly${event.message ? ` (${event.message})` : ''}; try again`,
          });
      });
      worker.postMessage({ type: 'locus', id: 1, scenario, request } satisfies ControlRequest);
    });
  }

  cancel(): void {
    if (this.worker) this.end(null);
  }

  private end(answer: Answer<ScenarioLocus> | null): void {
    this.worker?.terminate();
    this.worker = null;
    const settle = this.settle;
    this.settle = null;
    settle?.(answer);
  }
}
