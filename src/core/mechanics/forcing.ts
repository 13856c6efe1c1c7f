/** Forces from outside, and what a controller asks: the mechanics sees no more of a scenario than these. */

/** Generalized forces from outside: added onto `force` (n) at time t and state q, v. */
export interface Forcing {
  (t: number, q: Float64Array, v: Float64Array, force: Float64Array): void;
  /** Adds their exact derivatives onto `forceQ` and `forceV` (n x n each). Without it there is no exact Jacobian. */
  jacobians?(t: number, q: Float64Array, v: Float64Array, forceQ: Float64Array, forceV: Float64Array): void;
}

/** What a controller asks of one input, from the state. */
export interface Feedback {
  /** Before any limit. */
  asked(t: number, q: Float64Array, v: Float64Array): number;
  /** The most that the input gives, either way. */
  readonly limit: number;
  /** What counts, by past inputs (newest first, those of one moment in the controller's order), off what is asked. */
  readonly past?: Float64Array;
  /** Adds the derivatives of what is asked by q and by v, times `weight`, onto a row (n entries from `row` on) of each. */
  addSlopes(
    t: number,
    q: Float64Array,
    v: Float64Array,
    weight: number,
    row: number,
    forceQ: Float64Array,
    forceV: Float64Array,
  ): void;
}
