import type { System } from '../types.ts';
import * as equations from './equations.generated.ts';
import { cartPendulumView } from './view.ts';

export const cartPendulum: System = {
  ...cartPendulumView,
  mechanics: equations.mechanics,
  jacobians: equations.jacobians,
  energy: equations.energy,
  poseJacobian: equations.poseJacobian,
  constraintSets: {},
};
