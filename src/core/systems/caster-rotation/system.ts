import type { System } from '../types.ts';
import * as equations from './equations.generated.ts';
import { casterRotationView } from './view.ts';

export const casterRotation: System = {
  ...casterRotationView,
  mechanics: equations.mechanics,
  jacobians: equations.jacobians,
  energy: equations.energy,
  poseJacobian: equations.poseJacobian,
  constraintSets: {},
};
