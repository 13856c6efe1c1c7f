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
  /** Coordinates (n) that it holds the state at when t = 0, where it is a regulator about one point. */
  readonly point?: Float64Array;
  /** What counts, by past inputs (newest first, those of one moment in the controller's order), off what is asked. */
  readonly past?: Float64Array;
  /** The same by what the lagging actuators give now, in the controller's order. */
  readonly acting?: Float64Array;
  /** What the state is estimated by, one for all inputs of a controller; without it the state itself is known. */
  readonly estimator?: Estimator | null;
  /** What asks all inputs of a controller at once, where it has a memory of its own: then `asked` is not. */
  readonly program?: Program;
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

/** A controller with a memory, one for all its inputs. */
export interface Program {
  /** As a run goes on: what is asked of each input, in the controller's order, into `out`. */
  begin(): (t: number, q: Float64Array, v: Float64Array, out: Float64Array) => void;
}

/** Estimates the state from what sensors read at each sample. */
export interface Estimator {
  begin(): Estimate;
}

/** An estimate as its run goes on: at each sample `measure`, then `predict`. */
export interface Estimate {
  /** The state as far as it is known. */
  readonly q: Float64Array;
  readonly v: Float64Array;
  /** The state is known, as that of a row that a run goes on from. */
  know(t: number, q: ArrayLike<number>, v: ArrayLike<number>): void;
  /** The sensors read the state at t, the k-th sample (from 0). */
  measure(k: number, t: number, q: ArrayLike<number>, v: ArrayLike<number>): void;
  /** Takes what the sensors read at t, less what they would read of the steady motion. */
  correct(t: number, read: ArrayLike<number>): void;
  /** Goes on to the next sample, these inputs having been asked at the last. */
  predict(asked: ArrayLike<number>): void;
  /** All inputs on their way, and what actuators give, are these. */
  fill(inputs: ArrayLike<number>): void;
}
