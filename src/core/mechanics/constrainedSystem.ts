import { maxAbs, symmetricEigenvalues } from '../linalg/dense.ts';
import { DEPENDENT, saddleKernels, type SaddleKernels } from '../linalg/saddle.ts';
import { DirectAccelerations } from './directAccelerations.ts';
import type { Forcing } from './forcing.ts';
import type { ConstraintSet, System } from '../model/system.ts';

/** Why an acceleration could not be had. */
export type DynamicsFailure = 'mass-matrix-singular' | 'constraint-singular' | 'non-finite';

/**
 * A system with its parameters, constraint set, held coordinates and outside forces bound:
 * evaluates and factors `M a = h + B u + Omega^T lambda`, `Omega a + gamma = 0` at one state.
 *
 * Symbols: n coordinates, m constraint rows, L with M = L L^T, Y = L^-1 Omega^T (kept by rows of Omega),
 * S = Y^T Y = Omega M^-1 Omega^T. One symmetric positive definite solve of order m gives the multipliers
 * (the saddle-point system's Schur complement; Benzi, Golub and Liesen, Acta Numerica 14 (2005), section 5).
 *
 * Where the derivation has written a short way to the accelerations, and for what is held, `prepare`, `acceleration` and
 * `shift` take it, and fall back on the general one at states where it fails. M, Omega and their factors are then those of
 * the last `evaluate` or `prepareFactors`.
 */
export class ConstrainedSystem {
  readonly system: System;
  readonly parameters: Float64Array;
  readonly constraints: ConstraintSet | null;
  readonly n: number;
  readonly m: number;
  /** What nothing moves: frozen coordinates, and the clock. */
  readonly held: readonly number[];
  /** The coordinate whose rate is 1, where there is one. */
  readonly clock: number | undefined;

  /** Mass matrix with held rows and columns replaced by the identity's; after `factor` its lower triangle holds L. */
  readonly massMatrix: Float64Array;
  readonly force: Float64Array;
  readonly omega: Float64Array;
  readonly gamma: Float64Array;
  /** The clock's column of Omega, m: what its rate adds to Omega v. */
  readonly drift: Float64Array;
  readonly heights: Float64Array;
  /** Omega v as last measured, m. */
  readonly slip: Float64Array;
  readonly contactCount: number;
  failure: DynamicsFailure | null = null;

  readonly forcing: Forcing | null;

  private readonly kernels: SaddleKernels;
  private readonly inverse: Float64Array;
  private readonly inverseS: Float64Array;
  private readonly Y: Float64Array;
  private readonly S: Float64Array;
  private readonly row: Float64Array;
  private readonly scaled: Float64Array;
  private readonly scaledUnit: Float64Array;
  private readonly gammaFree: Float64Array;
  /** The state whose factors are at hand, or were found not to exist; see `prepare`. */
  private readonly preparedQ: Float64Array;
  private readonly preparedV: Float64Array;
  private preparedT = NaN;
  /** `told`: the determinant alone, by another engine. */
  private prepared: 'no' | 'direct' | 'factored' | 'failed' | 'told' = 'no';
  /** The short way, where there is one. */
  readonly direct: DirectAccelerations | null;

  /**
   * @param parameters values in the order of the meta
   * @param constraintSet id, or `none`
   * @param hold indices of coordinates frozen where they start
   * @param way `general` leaves the short way out: for comparison
   */
  constructor(
    system: System,
    parameters: Float64Array,
    constraintSet: string,
    hold: readonly number[],
    forcing: Forcing | null,
    way: 'shortest' | 'general' = 'shortest',
  ) {
    this.system = system;
    this.parameters = parameters;
    this.constraints = constraintSet === 'none' ? null : (system.constraintSets[constraintSet] ?? null);
    this.n = system.meta.coordinates.length;
    this.m = this.constraints?.rows ?? 0;
    this.clock = system.clock;
    const { clock } = this;
    this.held = clock === undefined || hold.includes(clock) ? hold : [...hold, clock];
    this.forcing = forcing;
    const { n, m } = this;
    this.massMatrix = new Float64Array(n * n);
    this.force = new Float64Array(n);
    this.omega = new Float64Array(m * n);
    this.gamma = new Float64Array(m);
    this.drift = new Float64Array(m);
    this.contactCount = this.constraints?.contact?.count ?? 0;
    this.heights = new Float64Array(this.contactCount);
    this.slip = new Float64Array(m);
    this.kernels = saddleKernels(n, m);
    this.inverse = new Float64Array(n);
    this.inverseS = new Float64Array(m);
    this.Y = new Float64Array(m * n);
    this.S = new Float64Array(m * m);
    this.row = new Float64Array(n);
    this.scaled = new Float64Array(m * m);
    this.scaledUnit = new Float64Array(m * m);
    this.gammaFree = new Float64Array(m);
    this.preparedQ = new Float64Array(n);
    this.preparedV = new Float64Array(n);
    const direct = way === 'shortest' ? this.constraints?.direct : undefined;
    const short = direct && this.held.every((i) => direct.holdable?.includes(i));
    this.direct = short ? new DirectAccelerations(direct, parameters, n, m, forcing, this.held) : null;
  }

  /** Whether the acceleration has exact derivatives here. */
  get differentiable(): boolean {
    return this.forcing === null || this.forcing.jacobians !== undefined;
  }

  /** Evaluates M, force, Omega and gamma at a state. */
  evaluate(t: number, q: Float64Array, v: Float64Array): void {
    if (this.prepared !== 'direct') this.prepared = 'no';
    const { constraints, parameters } = this;
    if (constraints?.dynamics) {
      constraints.dynamics(q, v, parameters, this.massMatrix, this.force, this.omega, this.gamma);
    } else {
      this.system.mechanics(q, v, parameters, this.massMatrix, this.force);
      constraints?.evaluate(q, v, parameters, this.omega, this.gamma);
    }
    this.forcing?.(t, q, v, this.force);
    const { n, m } = this;
    this.keepDrift();
    for (const i of this.held) {
      for (let k = 0; k < n; k++) this.massMatrix[i * n + k] = this.massMatrix[k * n + i] = 0;
      this.massMatrix[i * n + i] = 1;
      this.force[i] = 0;
      for (let r = 0; r < m; r++) this.omega[r * n + i] = 0;
    }
  }

  /** Factors M and S in place. False sets `failure`. */
  factor(): boolean {
    const { m, massMatrix, omega, Y, S, inverse, kernels, scaled } = this;
    if (kernels.mass.factor(massMatrix, inverse, 0) !== 0)
      return this.fail(maxAbs(massMatrix) < Infinity ? 'mass-matrix-singular' : 'non-finite');
    if (m > 0) kernels.rows(massMatrix, inverse, omega, Y, S);
    for (let i = 0; i < m * m; i++) scaled[i] = S[i]!;
    if (kernels.schur.factor(S, this.inverseS, DEPENDENT) !== 0)
      return this.fail(maxAbs(scaled) < Infinity ? 'constraint-singular' : 'non-finite');
    this.failure = null;
    return true;
  }

  /**
   * Smallest eigenvalue of D S D, D scaling S to a unit diagonal: 1 for orthogonal rows, 0 for dependent ones.
   * Infinity without constraints. Valid after `prepare` at the same state, also after a failed one.
   */
  independence(t: number, q: Float64Array, v: Float64Array): number {
    const { m, scaled } = this;
    if (m === 0) return Infinity;
    if (this.prepared === 'direct') this.prepareFactors(t, q, v);
    const S = this.scaledUnit;
    for (let r = 0; r < m; r++) {
      for (let s = 0; s < m; s++)
        S[r * m + s] = scaled[r * m + s]! / Math.sqrt(scaled[r * m + r]! * scaled[s * m + s]!);
    }
    symmetricEigenvalues(S, m);
    let smallest = Infinity;
    for (let r = 0; r < m; r++) smallest = Math.min(smallest, S[r * m + r]!);
    return smallest;
  }

  /**
   * A lower bound of `independence` at hardly any cost, 0 where the factors don't exist. From det = product of the m
   * eigenvalues, their sum m, and the means' inequality on the other m - 1: smallest >= det ((m - 1) / m)^(m - 1).
   */
  independenceBound(): number {
    const { m, S, scaled } = this;
    if (m === 0) return Infinity;
    if (this.failure) return 0;
    let bound = 1;
    if (this.direct && (this.prepared === 'direct' || this.prepared === 'told')) bound = this.direct.determinant;
    else for (let r = 0; r < m; r++) bound *= (S[r * m + r]! * S[r * m + r]!) / scaled[r * m + r]!;
    for (let r = 1; r < m; r++) bound *= (m - 1) / m;
    return bound;
  }

  /** The same at a state, which is not evaluated again where it was the last: the end of a step. */
  independenceBoundAt(t: number, q: Float64Array, v: Float64Array): number {
    const known = (this.prepared === 'direct' || this.prepared === 'told') && t === this.preparedT;
    if (!known || !this.direct!.isAt(q, v)) this.prepare(t, q, v);
    return this.independenceBound();
  }

  /** After `factor`: a (n) and lambda (m) of the constrained motion. False sets `failure`. */
  solve(a: Float64Array, lambda: Float64Array): boolean {
    for (let i = 0; i < this.n; i++) a[i] = this.force[i]!;
    for (let r = 0; r < this.m; r++) lambda[r] = -this.gamma[r]!;
    this.solveSaddle(a, lambda);
    return maxAbs(a) < Infinity ? true : this.fail('non-finite');
  }

  /**
   * Makes the accelerations of a state ready, unless that is what was done last: a step's end is looked at by the
   * projection, by an event and by the next step's first stage, one after another.
   */
  prepare(t: number, q: Float64Array, v: Float64Array): boolean {
    if (this.isPrepared(t, q, v)) return this.prepared !== 'failed';
    if (this.direct?.ofState(t, q, v)) return this.holdsDirect(t);
    return this.prepareGeneral(t, q, v);
  }

  /** Evaluates and factors M and S at a state, for those who solve with them: `solveSaddle`. */
  prepareFactors(t: number, q: Float64Array, v: Float64Array): boolean {
    if (this.prepared !== 'direct')
      return this.isPrepared(t, q, v) ? this.prepared === 'factored' : this.prepareGeneral(t, q, v);
    this.evaluate(t, q, v);
    return this.factor();
  }

  /** Another engine has evaluated a state at a time (s); see `DirectAccelerations.adopt`. */
  adopt(t: number, y: Float64Array, last: number): void {
    this.direct!.adopt(y, last);
    this.prepared = 'told';
    this.preparedT = t;
    this.failure = null;
  }

  private holdsDirect(t: number): true {
    this.prepared = 'direct';
    this.preparedT = t;
    this.failure = null;
    return true;
  }

  private prepareGeneral(t: number, q: Float64Array, v: Float64Array): boolean {
    this.prepared = 'no';
    this.evaluate(t, q, v);
    const done = this.factor();
    this.prepared = done ? 'factored' : 'failed';
    this.preparedT = t;
    for (let i = 0; i < this.n; i++) {
      this.preparedQ[i] = q[i]!;
      this.preparedV[i] = v[i]!;
    }
    return done;
  }

  /**
   * Takes other values of the parameters, in the order of the meta, into `parameters`.
   * @returns whether it can: which forces act may not depend on them
   */
  renew(values: ArrayLike<number>): boolean {
    const { direct } = this;
    if (direct && (direct.forced || direct.direct.optional?.active(Float64Array.from(values)))) return false;
    this.parameters.set(values);
    direct?.renew();
    this.forget();
    this.failure = null;
    return true;
  }

  /** What acts from outside changed: nothing at hand is of this moment any more. */
  forget(): void {
    this.prepared = 'no';
  }

  /** Whether the factors at hand are of a state at this time. */
  isFactoredAt(t: number): boolean {
    return (this.prepared === 'direct' || this.prepared === 'factored') && t === this.preparedT;
  }

  private isPrepared(t: number, q: Float64Array, v: Float64Array): boolean {
    if (this.prepared === 'no' || this.prepared === 'told' || t !== this.preparedT) return false;
    if (this.direct && this.prepared === 'direct') return this.direct.holds(q, v);
    const { n, preparedQ, preparedV } = this;
    for (let i = 0; i < n; i++) if (q[i] !== preparedQ[i] || v[i] !== preparedV[i]) return false;
    return true;
  }

  /** Evaluate, factor and solve at one state. */
  acceleration(t: number, q: Float64Array, v: Float64Array, a: Float64Array, lambda: Float64Array): boolean {
    if (!this.prepare(t, q, v)) return false;
    if (!this.direct || this.prepared !== 'direct') return this.solve(a, lambda);
    const { n, direct } = this;
    for (let i = 0; i < n; i++) a[i] = direct.rate[n + i]!;
    for (let r = 0; r < this.m; r++) lambda[r] = direct.lambda[r]!;
    return true;
  }

  /**
   * [v, a] of y = [q, v] in one go, without a copy, where there is a short way.
   * @returns whether it was taken; if not, ask for the acceleration
   */
  rate(t: number, y: Float64Array, out: Float64Array): boolean {
    const { direct } = this;
    if (!direct) return false;
    if (this.prepared === 'direct' && t === this.preparedT && direct.holdsPair(y)) {
      out.set(direct.rate);
      return true;
    }
    if (!direct.ofPair(t, y, out)) {
      this.prepared = 'no';
      return false;
    }
    return this.holdsDirect(t);
  }

  /**
   * After `factor`: solves `M x - Omega^T y = f`, `Omega x = g` for x in place of f (n) and y in place of g (m).
   * `solve` is the same with f the force and g = -gamma.
   */
  solveSaddle(f: Float64Array, g: Float64Array): void {
    this.kernels.solve(this.massMatrix, this.inverse, this.Y, this.S, this.inverseS, f, g);
  }

  /** After `prepare`: adds to x (n) the smallest change in the mass metric that changes Omega x by `change` (m; used up). */
  shift(change: Float64Array, x: Float64Array): void {
    if (this.direct && this.prepared === 'direct') return this.direct.shift(change, x);
    const { n, row } = this;
    for (let k = 0; k < n; k++) row[k] = 0;
    this.solveSaddle(row, change);
    for (let k = 0; k < n; k++) x[k]! += row[k]!;
  }

  /** Heights of the contact points at q into `heights`. */
  refreshHeights(q: Float64Array): void {
    this.constraints?.contact?.heights(q, this.parameters, this.heights);
  }

  /** Omega(q) v into `slip` and the heights into `heights`. */
  measure(q: Float64Array, v: Float64Array): void {
    if (this.direct) return this.direct.measure(q, v, this.slip, this.heights);
    this.refreshHeights(q);
    this.refreshOmega(q, v);
    this.constraintVelocity(v, this.slip);
  }

  /** `slip` anew where only v has changed since `measure`. */
  measureAgain(q: Float64Array, v: Float64Array): void {
    if (this.direct) this.measure(q, v);
    else this.constraintVelocity(v, this.slip);
  }

  private keepDrift(): void {
    const { n, m, clock, drift, omega } = this;
    if (clock !== undefined) for (let r = 0; r < m; r++) drift[r] = omega[r * n + clock]!;
  }

  /** Omega(q) as last evaluated, times v, into out (m). */
  constraintVelocity(v: Float64Array, out: Float64Array): void {
    const { n, m, omega, drift } = this;
    for (let r = 0; r < m; r++) {
      let sum = drift[r]!;
      for (let k = 0; k < n; k++) sum += omega[r * n + k]! * v[k]!;
      out[r] = sum;
    }
  }

  /** Re-evaluates Omega alone (held columns cleared), keeping the factors. */
  refreshOmega(q: Float64Array, v: Float64Array): void {
    if (!this.constraints) return;
    this.constraints.evaluate(q, v, this.parameters, this.omega, this.gammaFree);
    this.keepDrift();
    for (const i of this.held) for (let r = 0; r < this.m; r++) this.omega[r * this.n + i] = 0;
  }

  private fail(reason: DynamicsFailure): false {
    this.failure = reason;
    return false;
  }
}
