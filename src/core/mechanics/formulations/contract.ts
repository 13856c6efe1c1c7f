import type { OdeProblem } from '../../integrators/contract.ts';

/** Which numbers are integrated: how a state becomes y and comes back. */
export interface StateMap {
  /** y of a state whose velocities meet the constraints. */
  fromState(q: Float64Array, v: Float64Array, y: Float64Array): void;
  /** q and v of y; also of y between the ends of a step. */
  toState(y: Float64Array, q: Float64Array, v: Float64Array): void;
  /**
   * Asked after each accepted step, once nothing more is read from within it: q and v are its (projected) end.
   * @returns whether the meaning of y changed: then take y from `fromState` anew and restart the stepper
   */
  rebase(q: Float64Array, v: Float64Array): boolean;
}

/**
 * What every formulation is: mechanics made into `y' = f(t, y)`, which any stepper can advance. It decides how
 * the acceleration is obtained and which numbers are integrated; it knows nothing of steps.
 */
export interface Formulation extends OdeProblem, StateMap {}
