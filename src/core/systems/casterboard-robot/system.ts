import { rollingRows } from '../rollingRows.ts';
import type { System } from '../types.ts';
import * as equations from './equations.generated.ts';
import { casterboardRobotView } from './view.ts';

export const casterboardRobot: System = {
  ...casterboardRobotView,
  mechanics: equations.mechanics,
  jacobians: equations.jacobians,
  energy: equations.energy,
  poseJacobian: equations.poseJacobian,
  constraintSets: { rolling: rollingRows(equations, 2) },
};
