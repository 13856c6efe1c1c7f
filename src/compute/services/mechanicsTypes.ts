import type { StateOfSystem, Terms } from '../../core/mechanics/terms.ts';
import type { Call } from '../remote/protocol.ts';

export interface MechanicsCalls {
  /** A system's equations evaluated at one state. */
  'mechanics.terms': Call<StateOfSystem, Terms>;
}
