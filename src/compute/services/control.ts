import type { Handlers } from '../remote/serve.ts';
import type { ControlCalls } from './controlTypes.ts';
import { feedbackFor, partsOf, systemOf } from './load.ts';
import { nextTurn } from './nextTurn.ts';

/** Computing time between looks at the mailbox, ms. */
const SLICE_MS = 12;
/** Progress is told about as often as a screen is drawn. */
const TELL_MS = 30;

export const calls: Handlers<ControlCalls> = {
  async 'control.analyse'(scenario) {
    const [{ analyse }, system] = await Promise.all([import('../../core/control/analysis.ts'), systemOf(scenario)]);
    return analyse(scenario, system);
  },
  async 'control.computer'(scenario) {
    const [{ computerReport }, system] = await Promise.all([
      import('../../core/control/sampled/computerReport.ts'),
      systemOf(scenario),
    ]);
    return computerReport(scenario, system);
  },
  async 'control.effect'(scenario, { signal }) {
    const [{ EffectMeter }, { Simulation }, system] = await Promise.all([
      import('../../core/control/design/effect.ts'),
      import('../../core/simulation/simulation.ts'),
      systemOf(scenario, partsOf(scenario, false, false)),
    ]);
    const meter = new EffectMeter(scenario, system);
    const simulation = new Simulation(scenario, system, {
      extras: ['inputs'],
      feedback: await feedbackFor(scenario, system),
    });
    while (!simulation.end && !signal.aborted) {
      const began = performance.now();
      simulation.advance(() => performance.now() >= began + SLICE_MS);
      const { columns, rows } = simulation.takeChunk();
      meter.take(simulation.columns, columns, rows);
      await nextTurn();
    }
    const { end, time, counts } = simulation;
    return meter.effect(end ?? { reason: 'cancelled', time }, counts.work);
  },
  async 'control.responses'(request) {
    const [{ responsesOf }, system] = await Promise.all([
      import('../../core/control/responses.ts'),
      systemOf(request.scenario),
    ]);
    return responsesOf(request, system);
  },
  async 'control.turns'(scenario) {
    const [{ turnMap }, system] = await Promise.all([import('../../core/control/path/turnMap.ts'), systemOf(scenario)]);
    return turnMap(scenario, system);
  },
  async 'control.locus'({ scenario, request }, { emit }) {
    const [{ scenarioLocus }, system] = await Promise.all([
      import('../../core/control/locus/scenarioLocus.ts'),
      systemOf(scenario),
    ]);
    return scenarioLocus(scenario, system, request, nowAndThen(emit));
  },
  async 'control.curves'({ scenario, request }, { emit }) {
    const [{ designCurves }, system] = await Promise.all([
      import('../../core/control/locus/designCurves.ts'),
      systemOf(scenario),
    ]);
    return designCurves(scenario, system, request, nowAndThen(emit));
  },
};

function nowAndThen(emit: (share: number) => void): (share: number) => void {
  let told = performance.now();
  return (share) => {
    if (performance.now() - told < TELL_MS) return;
    told = performance.now();
    emit(share);
  };
}
