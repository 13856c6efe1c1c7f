/**
 * What every stepper is: a way to advance `y' = f(t, y)` in time. It knows nothing of mechanics.
 * Rules for adding one: README.md beside this file.
 */

/** Why a step could not be taken. Ids are permanent; problems may add their own (`constraint-singular`, …). */
export type StepFailure = 'step-too-small' | 'non-finite' | 'newton' | (string & {});

export interface OdeProblem {
  readonly dimension: number;
  /** f(t, y) into `out`; false where it has no value, with the reason in `failure`. */
  derivative(t: number, y: Float64Array, out: Float64Array): boolean;
  /** Exact df/dy (dimension x dimension, row-major) where the problem has one; implicit methods else use differences. */
  jacobian?(t: number, y: Float64Array, out: Float64Array): boolean;
  /**
   * Moves y, the proposed end of a step, in place onto the manifold that holds the solutions; false where it cannot. A
   * stepper that evaluates f at the end of its steps calls it before it does so (and says that it `projects`).
   */
  project?(t: number, y: Float64Array): boolean;
  readonly failure: string | null;
}

export interface Counters {
  /** Accepted steps. */
  steps: number;
  rejected: number;
  /** Calls of f. */
  evaluations: number;
  jacobians: number;
  factorizations: number;
}

export interface StepperOptions {
  rtol: number;
  atol: number;
  /** Fixed-step methods: the step. Adaptive ones: the first step (chosen when absent). s */
  step?: number;
  maxStep?: number;
  /** Collocation methods. */
  stages?: number;
}

export interface Stepper {
  /** Time and state at the end of the last accepted step; `y` may be changed in place, then call `stateChanged`. */
  readonly t: number;
  readonly y: Float64Array;
  /** Start of the last accepted step. */
  readonly previousT: number;
  readonly counters: Counters;
  /** Its steps end where `problem.project` puts them: nobody else need project them. */
  readonly projects?: true;
  /** Starts anew at (t, y). */
  reset(t: number, y: Float64Array): void;
  /** One accepted step that ends at `limit` at the latest (exactly there if it would come close). Null, or why not. */
  step(limit: number): StepFailure | null;
  /** State at a time within the last accepted step, by the method's own dense output. */
  interpolate(t: number, out: Float64Array): void;
  /** `y` was moved (projected, or pushed): what was kept of it for the next step is stale. */
  stateChanged(): void;
}

export function zeroCounters(): Counters {
  return { steps: 0, rejected: 0, evaluations: 0, jacobians: 0, factorizations: 0 };
}
