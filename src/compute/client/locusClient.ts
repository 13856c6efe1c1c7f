import type { CurvesRequest, DesignCurves } from '../../core/control/locus/designCurves.ts';
import type { LocusRequest, ScenarioLocus } from '../../core/control/locus/scenarioLocus.ts';
import type { Scenario, ScenarioFile } from '../../core/scenario/types.ts';
import { RemoteWorker, type WorkerLike } from '../remote/remoteWorker.ts';
import type { ControlCalls } from '../services/controlTypes.ts';
import { answerOf, checked, type Answer, type Metas } from './answer.ts';

/** Root loci and curves of designs, each in a worker of its own: it takes seconds, tells how far it got, and is cancelled by ending it. */
export class LocusClient {
  private readonly worker: RemoteWorker<ControlCalls>;
  private readonly metas: Metas;

  constructor(start: () => WorkerLike, metas: Metas) {
    this.worker = new RemoteWorker(start);
    this.metas = metas;
  }

  /** Takes the place of whatever is under way. @returns null where it was cancelled */
  start(
    file: ScenarioFile,
    request: LocusRequest,
    onShare: (share: number) => void,
  ): Promise<Answer<ScenarioLocus> | null> {
    return this.ask(
      file,
      (scenario) => this.worker.call('control.locus', { scenario, request }, { onEvent: onShare }).result,
    );
  }

  /** The regulator designed anew along a range. As `start`. */
  curves(
    file: ScenarioFile,
    request: CurvesRequest,
    onShare: (share: number) => void,
  ): Promise<Answer<DesignCurves> | null> {
    return this.ask(
      file,
      (scenario) => this.worker.call('control.curves', { scenario, request }, { onEvent: onShare }).result,
    );
  }

  private async ask<T>(file: ScenarioFile, call: (scenario: Scenario) => Promise<T>): Promise<Answer<T> | null> {
    this.cancel();
    const scenario = checked(file, this.metas);
    if (!scenario.ok) return scenario;
    const answer = await answerOf(call(scenario.value), 'try again');
    // Cancelled, the worker is ended already, and another's may be under way.
    if (answer) this.worker.close();
    return answer;
  }

  cancel(): void {
    this.worker.close();
  }
}
