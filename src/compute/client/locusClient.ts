import type { LocusRequest, ScenarioLocus } from '../../core/control/locus/scenarioLocus.ts';
import type { ScenarioFile } from '../../core/scenario/types.ts';
import { RemoteWorker, type WorkerLike } from '../remote/remoteWorker.ts';
import type { ControlCalls } from '../services/controlTypes.ts';
import { answerOf, checked, type Answer, type Metas } from './answer.ts';

/** Root loci, each in a worker of its own: it takes seconds, tells how far it got, and is cancelled by ending it. */
export class LocusClient {
  private readonly worker: RemoteWorker<ControlCalls>;
  private readonly metas: Metas;

  constructor(start: () => WorkerLike, metas: Metas) {
    this.worker = new RemoteWorker(start);
    this.metas = metas;
  }

  /** Takes the place of one under way. @returns null where it was cancelled */
  async start(
    file: ScenarioFile,
    request: LocusRequest,
    onShare: (share: number) => void,
  ): Promise<Answer<ScenarioLocus> | null> {
    this.cancel();
    const scenario = checked(file, this.metas);
    if (!scenario.ok) return scenario;
    const call = this.worker.call('control.locus', { scenario: scenario.value, request }, { onEvent: onShare });
    const answer = await answerOf(call.result, 'try again');
    // Cancelled, the worker is ended already, and another's may be under way.
    if (answer) this.worker.close();
    return answer;
  }

  cancel(): void {
    this.worker.close();
  }
}
