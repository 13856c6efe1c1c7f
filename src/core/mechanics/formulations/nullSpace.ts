import { cholesky, maxAbs, solveLower, solveLowerTransposed } from '../../linalg/dense.ts';
import { luFactor, luSolve } from '../../linalg/lu.ts';
import { qrFull } from '../../linalg/qr.ts';
import { DEPENDENT } from '../../linalg/saddle.ts';
import type { ConstrainedSystem } from '../constrainedSystem.ts';
import { AccelerationJacobian } from './accelerationJacobian.ts';
import type { Formulation } from './contract.ts';

/**
 * Independent speeds by QR: y = [q, s] with s = N0^T v, one number per degree of freedom, so that `Omega v = 0`
 * holds by construction and no multiplier is solved for.
 *
 * S. S. Kim, M. J. Vanderploeg, "QR decomposition for state space representation of constrained mechanical dynamic
 * systems", J. Mechanisms, Transmissions and Automation in Design 108 (1986) 183-188: a transformation is kept over
 * many steps and made anew when it gets poor. The null-space method for the acceleration: Benzi, Golub and Liesen,
 * Acta Numerica 14 (2005), section 6.
 *
 * Symbols: E = [Omega; unit rows of held coordinates] (c x n), k = n - c. QR of E^T at the base of the chart gives
 * the orthonormal Q1 (n x c), across the constraints, and N0 (n x k), along them. Elsewhere
 *
 *     B = E(q) Q1,  T = B^-1 E(q) N0,  N = N0 - Q1 T,   so that  E N = 0 and N0^T N = I;
 *     v = N s,  a = a_p + N s_dot,  a_p = -Q1 B^-1 gamma,  N^T M N s_dot = N^T (h + B u - M a_p).
 *
 * Where a clock's rate is 1 whatever happens, `E v = e` in place of 0, and `v = N s + Q1 B^-1 e`.
 *
 * The singular values of T are the tangents of the angles between the two null spaces (Golub and Van Loan, Matrix
 * Computations, 4th ed., section 6.4.3), so T alone tells how far the chart reaches.
 *
 * Not guaranteed: contact heights. They drift as with multipliers, unless they are projected.
 */

/** The Frobenius norm of T beyond which a new chart is due: no angle above 45 degrees, v at most sqrt(2) times s. */
const CHART_LIMIT = 1;

export class NullSpace implements Formulation {
  readonly dimension: number;
  failure: string | null = null;
  jacobian?: (t: number, y: Float64Array, out: Float64Array) => boolean;
  /** Charts made so far. */
  charts = 0;

  private readonly dynamics: ConstrainedSystem;
  private readonly n: number;
  private readonly c: number;
  private readonly k: number;
  private readonly q: Float64Array;
  private readonly v: Float64Array;
  private readonly ap: Float64Array;
  private readonly rest: Float64Array;
  private readonly z: Float64Array;
  private readonly w: Float64Array;
  private readonly column: Float64Array;
  private readonly E: Float64Array;
  private readonly transposed: Float64Array;
  private readonly Q: Float64Array;
  private readonly B: Float64Array;
  private readonly pivots: Int32Array;
  private readonly T: Float64Array;
  private readonly N: Float64Array;
  private readonly MN: Float64Array;
  private readonly reduced: Float64Array;

  constructor(dynamics: ConstrainedSystem) {
    const n = (this.n = dynamics.n);
    const c = (this.c = dynamics.m + dynamics.held.length);
    const k = (this.k = Math.max(0, n - c));
    this.dynamics = dynamics;
    this.dimension = n + k;
    this.q = new Float64Array(n);
    this.v = new Float64Array(n);
    this.ap = new Float64Array(n);
    this.rest = new Float64Array(n);
    this.z = new Float64Array(k);
    this.w = new Float64Array(c);
    this.column = new Float64Array(n);
    this.E = new Float64Array(c * n);
    this.transposed = new Float64Array(n * c);
    this.Q = new Float64Array(n * n);
    this.B = new Float64Array(c * c);
    this.pivots = new Int32Array(c);
    this.T = new Float64Array(c * k);
    this.N = new Float64Array(n * k);
    this.MN = new Float64Array(n * k);
    this.reduced = new Float64Array(k * k);
    dynamics.held.forEach((i, r) => (this.E[(dynamics.m + r) * n + i] = 1));
    if (dynamics.differentiable) this.jacobian = this.chainRule(new AccelerationJacobian(dynamics));
  }

  derivative(t: number, y: Float64Array, out: Float64Array): boolean {
    const { n, k, q, v, z } = this;
    if (!this.locate(y)) return false;
    if (!this.speedRates(t)) return false;
    for (let i = 0; i < n; i++) out[i] = v[i]!;
    for (let j = 0; j < k; j++) out[n + j] = z[j]!;
    return maxAbs(q) < Infinity && maxAbs(z) < Infinity ? true : this.fail('non-finite');
  }

  fromState(q: Float64Array, v: Float64Array, y: Float64Array): void {
    const { n, c, k, Q } = this;
    if (this.charts === 0) this.chartAt(q);
    for (let i = 0; i < n; i++) y[i] = q[i]!;
    for (let j = 0; j < k; j++) {
      let sum = 0;
      for (let i = 0; i < n; i++) sum += Q[i * n + c + j]! * v[i]!;
      y[n + j] = sum;
    }
  }

  /** Where the chart ends (`Omega` dependent), v is not a number. */
  toState(y: Float64Array, q: Float64Array, v: Float64Array): void {
    const located = this.locate(y);
    for (let i = 0; i < this.n; i++) {
      q[i] = this.q[i]!;
      v[i] = located ? this.v[i]! : NaN;
    }
  }

  rebase(q: Float64Array): boolean {
    if (this.charts > 0 && this.tangent(q)) {
      let sum = 0;
      for (const x of this.T) sum += x * x;
      if (sum <= CHART_LIMIT * CHART_LIMIT) return false;
    }
    return this.chartAt(q);
  }

  /** New chart with its base at q; false (and the old one stays) where the constraints are dependent. */
  private chartAt(q: Float64Array): boolean {
    const { n, c, E, transposed } = this;
    this.refreshE(q);
    for (let r = 0; r < c; r++) for (let i = 0; i < n; i++) transposed[i * c + r] = E[r * n + i]!;
    const before = this.charts > 0 ? this.Q.slice() : null;
    if (c > n || qrFull(transposed, n, c, this.Q, this.column) < c) {
      if (before) this.Q.set(before);
      return this.fail('constraint-singular');
    }
    this.charts++;
    return true;
  }

  private refreshE(q: Float64Array): void {
    const { dynamics: d, E } = this;
    d.refreshOmega(q, this.v);
    for (let i = 0; i < d.omega.length; i++) E[i] = d.omega[i]!;
  }

  /** B factored, T and N at q. */
  private tangent(q: Float64Array): boolean {
    const { n, c, k, E, Q, B, T, N, w } = this;
    this.refreshE(q);
    for (let r = 0; r < c; r++) {
      for (let j = 0; j < n; j++) {
        let sum = 0;
        for (let i = 0; i < n; i++) sum += E[r * n + i]! * Q[i * n + j]!;
        if (j < c) B[r * c + j] = sum;
        else T[r * k + j - c] = sum;
      }
    }
    if (!luFactor(B, c, this.pivots, DEPENDENT * maxAbs(B))) return this.fail('constraint-singular');
    for (let j = 0; j < k; j++) {
      for (let r = 0; r < c; r++) w[r] = T[r * k + j]!;
      luSolve(B, c, this.pivots, w);
      for (let r = 0; r < c; r++) T[r * k + j] = w[r]!;
    }
    for (let i = 0; i < n; i++) {
      for (let j = 0; j < k; j++) {
        let sum = Q[i * n + c + j]!;
        for (let r = 0; r < c; r++) sum -= Q[i * n + r]! * T[r * k + j]!;
        N[i * k + j] = sum;
      }
    }
    return true;
  }

  /** q, v, N at y. */
  private locate(y: Float64Array): boolean {
    const { n, k, q, v, N } = this;
    for (let i = 0; i < n; i++) q[i] = y[i]!;
    if (!this.tangent(q)) return false;
    for (let i = 0; i < n; i++) {
      let sum = 0;
      for (let j = 0; j < k; j++) sum += N[i * k + j]! * y[n + j]!;
      v[i] = sum;
    }
    if (this.dynamics.clock !== undefined) this.addClock();
    return true;
  }

  /** v += Q1 B^-1 e: a clock's rate is 1, and what moves with it. */
  private addClock(): void {
    const { dynamics: d, n, v, w, column } = this;
    for (let r = 0; r < d.m; r++) w[r] = d.drift[r]!;
    d.held.forEach((i, r) => (w[d.m + r] = i === d.clock ? -1 : 0));
    this.across(w, column);
    for (let i = 0; i < n; i++) v[i]! += column[i]!;
  }

  /** x = -Q1 B^-1 w, for what the constraints ask for on their own; w (c) is overwritten. */
  private across(w: Float64Array, x: Float64Array): void {
    const { n, c, Q } = this;
    luSolve(this.B, c, this.pivots, w);
    for (let i = 0; i < n; i++) {
      let sum = 0;
      for (let r = 0; r < c; r++) sum -= Q[i * n + r]! * w[r]!;
      x[i] = sum;
    }
  }

  /** s_dot into `z`, at the q, v and N of `locate`. */
  private speedRates(t: number): boolean {
    const { dynamics: d, n, k, ap, rest, N, MN, reduced, z, w } = this;
    d.evaluate(t, this.q, this.v);
    const M = d.massMatrix;
    w.fill(0);
    for (let r = 0; r < d.m; r++) w[r] = d.gamma[r]!;
    this.across(w, ap);
    for (let i = 0; i < n; i++) {
      let sum = d.force[i]!;
      for (let l = 0; l < n; l++) sum -= M[i * n + l]! * ap[l]!;
      rest[i] = sum;
      for (let j = 0; j < k; j++) {
        let product = 0;
        for (let l = 0; l < n; l++) product += M[i * n + l]! * N[l * k + j]!;
        MN[i * k + j] = product;
      }
    }
    for (let j = 0; j < k; j++) {
      let sum = 0;
      for (let i = 0; i < n; i++) sum += N[i * k + j]! * rest[i]!;
      z[j] = sum;
      for (let l = 0; l <= j; l++) {
        let product = 0;
        for (let i = 0; i < n; i++) product += N[i * k + j]! * MN[i * k + l]!;
        reduced[j * k + l] = product;
      }
    }
    if (cholesky(reduced, k) !== 0)
      return this.fail(maxAbs(reduced) < Infinity ? 'mass-matrix-singular' : 'non-finite');
    solveLower(reduced, k, z);
    solveLowerTransposed(reduced, k, z);
    this.failure = null;
    return true;
  }

  /**
   * J = [v_q, N; N0^T (a_q + a_v v_q), N0^T a_v N], v_q = -Q1 B^-1 d(E v)/dq: exact, through the derivatives of
   * the same acceleration as a function of q and v.
   */
  private chainRule(acceleration: AccelerationJacobian): (t: number, y: Float64Array, out: Float64Array) => boolean {
    const { n, k, dynamics: d, N, w, column } = this;
    const size = n + k;
    /** dv/dy, n x (n + k). */
    const vy = new Float64Array(n * size);
    const ay = new Float64Array(n * size);
    return (t, y, out) => {
      if (!this.locate(y)) return false;
      if (!acceleration.evaluate(t, this.q, this.v)) return this.fail(d.failure ?? 'non-finite');
      const { aq, av, velocityQ } = acceleration;
      for (let l = 0; l < n; l++) {
        w.fill(0);
        for (let r = 0; r < d.m; r++) w[r] = velocityQ[r * n + l]!;
        this.across(w, column);
        for (let i = 0; i < n; i++) vy[i * size + l] = column[i]!;
      }
      for (let i = 0; i < n; i++) for (let j = 0; j < k; j++) vy[i * size + n + j] = N[i * k + j]!;
      for (let i = 0; i < n; i++) {
        for (let l = 0; l < size; l++) {
          let sum = l < n ? aq[i * n + l]! : 0;
          for (let j = 0; j < n; j++) sum += av[i * n + j]! * vy[j * size + l]!;
          ay[i * size + l] = sum;
          out[i * size + l] = vy[i * size + l]!;
        }
      }
      this.alongChart(ay, out, size);
      return true;
    };
  }

  /** Rows n to n + k of `out` = N0^T ay. */
  private alongChart(ay: Float64Array, out: Float64Array, size: number): void {
    const { n, c, k, Q } = this;
    for (let j = 0; j < k; j++) {
      for (let l = 0; l < size; l++) {
        let sum = 0;
        for (let i = 0; i < n; i++) sum += Q[i * n + c + j]! * ay[i * size + l]!;
        out[(n + j) * size + l] = sum;
      }
    }
  }

  private fail(reason: string): false {
    this.failure = reason;
    return false;
  }
}
