import { termsOf } from '../../core/mechanics/terms.ts';
import type { Handlers } from '../remote/serve.ts';
import { systemOf } from './load.ts';
import type { MechanicsCalls } from './mechanicsTypes.ts';

export const calls: Handlers<MechanicsCalls> = {
  'mechanics.terms': async (state) => termsOf(await systemOf(state), state),
  'mechanics.export': async ({ scenario, format }) => {
    const { exportScenario } = await import('../../core/exchange/index.ts');
    await import('../../core/simulation/everyMotion.ts');
    return exportScenario(scenario, await systemOf(scenario), format);
  },
};
