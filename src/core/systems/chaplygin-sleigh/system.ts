import { rollingRows } from '../rollingRows.ts';
import type { System } from '../types.ts';
import * as equations from './equations.generated.ts';
import { chaplyginSleighView } from './view.ts';

export const chaplyginSleigh: System = {
  ...chaplyginSleighView,
  mechanics: equations.mechanics,
  jacobians: equations.jacobians,
  energy: equations.energy,
  poseJacobian: equations.poseJacobian,
  constraintSets: { rolling: rollingRows(equations, 1) },
};
