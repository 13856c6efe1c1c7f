import type { Handlers } from '../remote/serve.ts';
import type { ControlCalls } from './controlTypes.ts';
import { systemOf } from './load.ts';

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
  async 'control.locus'({ scenario, request }, { emit }) {
    const [{ scenarioLocus }, system] = await Promise.all([
      import('../../core/control/locus/scenarioLocus.ts'),
      systemOf(scenario),
    ]);
    let told = performance.now();
    return scenarioLocus(scenario, system, request, (share) => {
      if (performance.now() - told < TELL_MS) return;
      told = performance.now();
      emit(share);
    });
  },
};
