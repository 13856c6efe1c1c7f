import { termsOf } from '../../core/mechanics/terms.ts';
import type { Handlers } from '../remote/serve.ts';
import { feedbackFor, systemOf } from './load.ts';
import type { MechanicsCalls } from './mechanicsTypes.ts';

export const calls: Handlers<MechanicsCalls> = {
  'mechanics.terms': async (state) => termsOf(await systemOf(state), state),
  'mechanics.answer': async ({ scenario, ask }) => {
    const { answerOf } = await import('../../core/lessons/answer.ts');
    await import('../../core/simulation/everyMotion.ts');
    const system = await systemOf(scenario);
    return answerOf(scenario, system, ask, await feedbackFor(scenario, system));
  },
  'mechanics.export': async ({ scenario, format }) => {
    const { exportScenario } = await import('../../core/exchange/index.ts');
    await import('../../core/simulation/everyMotion.ts');
    return exportScenario(scenario, await systemOf(scenario), format);
  },
};
