import type { System } from '../types.ts';
import * as equations from './equations.generated.ts';
import { stiffDecayView } from './view.ts';

export const stiffDecay: System = {
  ...stiffDecayView,
  mechanics: equations.mechanics,
  jacobians: equations.jacobians,
  energy: equations.energy,
  constraintSets: {},
  firstOrder: { rate: equations.rate, jacobian: equations.rateJacobian },
};
