import { termsOf } from '../../core/mechanics/terms.ts';
import type { Handlers } from '../remote/serve.ts';
import { systemOf } from './load.ts';
import type { MechanicsCalls } from './mechanicsTypes.ts';

export const calls: Handlers<MechanicsCalls> = {
  'mechanics.terms': async (state) => termsOf(await systemOf(state), state),
};
