import type { System } from '../types.ts';
import * as equations from './equations.generated.ts';
import { bicycleView } from './view.ts';

/** The Whipple bicycle. Rows: rear along and across its heading, front along and across, height of the front contact. */
export const bicycle: System = {
  ...bicycleView,
  mechanics: equations.mechanics,
  jacobians: equations.jacobians,
  energy: equations.energy,
  poseJacobian: equations.poseJacobian,
  constraintSets: {
    rolling: {
      id: 'rolling',
      label: 'rolling',
      rows: 5,
      evaluate: equations.rollingConstraints,
      dynamics: equations.rollingDynamics,
      jacobians: equations.rollingJacobians,
      contact: { count: 1, rows: [4], heights: equations.rollingHeights, solveFor: ['pitch'] },
    },
  },
};
