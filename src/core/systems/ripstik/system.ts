import type { ConstraintSet, System } from '../types.ts';
import * as equations from './equations.generated.ts';
import { ripstikView } from './view.ts';

const n = 10;
/** Positions in the parameter vector (order of the meta). */
const PLATE_LENGTH = 4;
const PLATE_WIDTH = 5;
const PLATE_THICKNESS = 6;
const WHEEL_DRAG = 19;
const PLATES = [1, 2] as const;

const force = new Float64Array(n);
const forceQ = new Float64Array(n * n);
const forceV = new Float64Array(n * n);
const bodyPoses = new Float64Array(12 * 5);

/** Both sets keep the skate points on the ground: rows 1 and 3 are the gradients of their heights. */
const contact = { count: 2, rows: [1, 3], heights: equations.rollingHeights, solveFor: ['Z', 'psi'] } as const;

const rolling: ConstraintSet = {
  id: 'rolling',
  label: 'rolling',
  rows: 4,
  evaluate: equations.rollingConstraints,
  dynamics(q, v, p, massMatrix, h, omega, gamma) {
    equations.rollingDynamics(q, v, p, massMatrix, h, omega, gamma);
    addWheelDrag(q, v, p, h);
  },
  jacobians: equations.rollingJacobians,
  contact,
};

const report: ConstraintSet = {
  id: 'report',
  label: 'report',
  rows: 4,
  evaluate: equations.reportConstraints,
  dynamics(q, v, p, massMatrix, h, omega, gamma) {
    equations.reportDynamics(q, v, p, massMatrix, h, omega, gamma);
    addWheelDrag(q, v, p, h);
  },
  jacobians: equations.reportJacobians,
  contact,
};

function addWheelDrag(q: Float64Array, v: Float64Array, p: Float64Array, h: Float64Array): void {
  if (p[WHEEL_DRAG] === 0) return;
  equations.wheelDragForce(q, v, p, force);
  for (let i = 0; i < n; i++) h[i]! += force[i]!;
}

/** The board: generated equations, with the wheel drag added only where there is any (see the derivation). */
export const ripstik: System = {
  ...ripstikView,
  mechanics(q, v, p, massMatrix, h) {
    equations.mechanics(q, v, p, massMatrix, h);
    addWheelDrag(q, v, p, h);
  },
  jacobians(q, v, a, p, dq, dv) {
    equations.jacobians(q, v, a, p, dq, dv);
    if (p[WHEEL_DRAG] !== 0) {
      equations.wheelDragJacobians(q, v, p, forceQ, forceV);
      for (let i = 0; i < n * n; i++) {
        dq[i]! -= forceQ[i]!;
        dv[i]! -= forceV[i]!;
      }
    }
  },
  energy: equations.energy,
  poseJacobian: equations.poseJacobian,
  constraintSets: { rolling, report },
  /** Lowest corner of the two plates' prisms. */
  clearance(q, p) {
    ripstikView.poses(q, p, bodyPoses);
    let lowest = Infinity;
    for (const body of PLATES) {
      const o = 12 * body;
      const reach =
        Math.abs(bodyPoses[o + 9]!) * p[PLATE_LENGTH]! +
        Math.abs(bodyPoses[o + 10]!) * p[PLATE_WIDTH]! +
        Math.abs(bodyPoses[o + 11]!) * p[PLATE_THICKNESS]!;
      lowest = Math.min(lowest, bodyPoses[o + 2]! - reach / 2);
    }
    return lowest;
  },
};
