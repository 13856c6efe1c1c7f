import type { ConstraintSet } from './types.ts';

/** What the derivation writes for a set of rows without contact heights. */
interface GeneratedRows {
  rollingConstraints: ConstraintSet['evaluate'];
  rollingDynamics: NonNullable<ConstraintSet['dynamics']>;
  rollingJacobians: ConstraintSet['jacobians'];
}

/** The set `rolling` of a system whose constraints are velocities alone: nothing is kept at a height. */
export function rollingRows(equations: GeneratedRows, rows: number): ConstraintSet {
  return {
    id: 'rolling',
    label: 'rolling',
    rows,
    evaluate: equations.rollingConstraints,
    dynamics: equations.rollingDynamics,
    jacobians: equations.rollingJacobians,
    contact: null,
  };
}
