import type { DirectDynamics } from '../model/system.ts';
import type { Forcing } from './forcing.ts';

/**
 * The short way of a constraint set (derivation/direct.py) with parameters and outside forces bound: the accelerations of
 * one state after another, and what they leave for the projection. It holds the last state that it was asked about.
 */
export class DirectAccelerations {
  /** Of the state last evaluated: [v, a] and the multipliers. */
  readonly rate: Float64Array;
  readonly lambda: Float64Array;

  readonly direct: DirectDynamics;
  private readonly parameters: Float64Array;
  private readonly forcing: Forcing | null;
  /** Forces act from outside. */
  readonly forced: boolean;
  /** What `prepare` makes of the parameters. */
  readonly constants: Float64Array;
  /** The parameters, then what of the holdable coordinates is held. */
  private readonly given: Float64Array;
  private readonly force: Float64Array;
  private readonly factors: Float64Array;
  /** [q, v] of the state last evaluated, with both halves as arrays of their own for those who act from outside. */
  private readonly y: Float64Array;
  /** `rate` is of that state too. */
  private complete = false;
  private readonly q: Float64Array;
  private readonly v: Float64Array;

  /**
   * @param n coordinates
   * @param m constraint rows
   * @param held indices of coordinates, all of them holdable
   */
  constructor(
    direct: DirectDynamics,
    parameters: Float64Array,
    n: number,
    m: number,
    forcing: Forcing | null,
    held: readonly number[] = [],
  ) {
    this.direct = direct;
    this.parameters = parameters;
    this.forcing = forcing;
    this.forced = forcing !== null || (direct.optional?.active(parameters) ?? false);
    this.constants = new Float64Array(direct.constantCount);
    const flags = (direct.holdable ?? []).map((i) => (held.includes(i) ? 1 : 0));
    this.given = Float64Array.from([...parameters, ...flags]);
    this.renew();
    this.force = new Float64Array(n);
    this.factors = new Float64Array(direct.factorCount);
    this.rate = new Float64Array(2 * n);
    this.lambda = new Float64Array(m);
    this.y = new Float64Array(2 * n);
    this.q = this.y.subarray(0, n);
    this.v = this.y.subarray(n);
  }

  /** The parameters' values have changed. */
  renew(): void {
    this.given.set(this.parameters);
    this.direct.prepare(this.given, this.constants);
  }

  /** Whether q and v are the state last evaluated: the determinant is theirs. */
  isAt(q: Float64Array, v: Float64Array): boolean {
    const { y } = this;
    const n = q.length;
    for (let i = 0; i < n; i++) if (q[i] !== y[i] || v[i] !== y[n + i]) return false;
    return true;
  }

  /** Whether `rate` and everything else is of this state. */
  holds(q: Float64Array, v: Float64Array): boolean {
    return this.complete && this.isAt(q, v);
  }

  /** The same for y = [q, v]. */
  holdsPair(y: Float64Array): boolean {
    if (!this.complete) return false;
    for (let i = 0; i < y.length; i++) if (y[i] !== this.y[i]) return false;
    return true;
  }

  /** Evaluates at a state; false where there is no acceleration this way. */
  ofState(t: number, q: Float64Array, v: Float64Array): boolean {
    const { y } = this;
    const n = q.length;
    for (let i = 0; i < n; i++) {
      y[i] = q[i]!;
      y[n + i] = v[i]!;
    }
    this.complete = true;
    return this.evaluate(t, y, this.rate);
  }

  /** The same at y = [q, v], straight into `rate` (2 n), which is not held. */
  ofPair(t: number, y: Float64Array, rate: Float64Array): boolean {
    for (let i = 0; i < y.length; i++) this.y[i] = y[i]!;
    this.complete = false;
    return this.evaluate(t, y, rate);
  }

  /**
   * Another engine has evaluated a state: of that, nothing but this is held.
   * @param y [q, v]
   * @param last of its factors, the inverse of the determinant
   */
  adopt(y: Float64Array, last: number): void {
    for (let i = 0; i < y.length; i++) this.y[i] = y[i]!;
    this.complete = false;
    this.factors[this.factors.length - 1] = last;
  }

  /** Generalized forces from outside at a state into `force` (n). */
  forces(t: number, q: Float64Array, v: Float64Array, force: Float64Array): void {
    force.fill(0);
    this.direct.optional?.add(q, v, this.parameters, force);
    this.forcing?.(t, q, v, force);
  }

  private evaluate(t: number, y: Float64Array, rate: Float64Array): boolean {
    const { direct, force, q, v } = this;
    if (this.forced) this.forces(t, q, v, force);
    if (!direct.accelerations(y, this.constants, force, rate, this.lambda, this.factors)) return false;
    // One acceleration that is no number makes this none.
    let sum = 0;
    for (let i = q.length; i < rate.length; i++) sum += rate[i]!;
    return sum - sum === 0;
  }

  /** Adds to x the smallest change in the mass metric that changes Omega x by `change`. */
  shift(change: Float64Array, x: Float64Array): void {
    this.direct.shift(this.factors, change, x);
  }

  /** Omega v into `slip` (m) and the heights of the contact points into `heights`, at any state. */
  measure(q: Float64Array, v: Float64Array, slip: Float64Array, heights: Float64Array): void {
    this.direct.slip(q, v, this.constants, slip, heights);
  }

  /** det of S = Omega M^-1 Omega^T scaled to a unit diagonal, at the state last evaluated. */
  get determinant(): number {
    return 1 / this.factors[this.factors.length - 1]!;
  }
}
