import type { DaeProblem } from '../integrators/shared/dae.ts';
import type { ConstrainedSystem } from './constrainedSystem.ts';
import type { StateMap } from './formulations/contract.ts';

/**
 * Mechanics as a fully implicit F(t, y, y') = 0 of index 2 that keeps positions and velocities on the constraints:
 *
 *     q' - v - G^T mu                        = 0     n     G: the rows of Omega that are gradients of heights
 *     M(q) v' - h - B u - Omega^T lambda     = 0     n
 *     Omega v                                = 0     m
 *     heights(q)                             = 0     k
 *
 * y = [q, v, lambda, mu]. The multipliers mu, zero on the exact solution, take up the discretization error that would
 * otherwise violate the heights: C. W. Gear, B. Leimkuhler, G. K. Gupta, "Automatic integration of Euler-Lagrange
 * equations with constraints", J. Comp. Appl. Math. 12-13 (1985), 77-90; Hairer and Wanner, Solving ODEs II, 2nd ed.,
 * section VII.1, "stabilized index 2 formulation". Velocity constraints without heights are of index 2 as they are.
 *
 * Not guaranteed: that dependent constraints are noticed; a step can pass over the moment (the run's event looks for it).
 *
 * Held coordinates have q' = v and v' = 0 with v = 0 at the start; Omega has no columns for them.
 */

/** Share of a coordinate (of at least 1) by which outside forces are differenced that have no exact derivative. */
const DIFFERENCE = Math.sqrt(Number.EPSILON);

export class StabilizedDae implements DaeProblem, StateMap {
  readonly dimension: number;
  readonly differential: Uint8Array;

  private readonly dynamics: ConstrainedSystem;
  private readonly q: Float64Array;
  private readonly v: Float64Array;
  private readonly a: Float64Array;
  private readonly lambda: Float64Array;
  /** mu at the rows of G, 0 elsewhere. */
  private readonly mu: Float64Array;
  private readonly dq: Float64Array;
  private readonly dv: Float64Array;
  private readonly forceQ: Float64Array;
  private readonly forceV: Float64Array;
  private readonly slipQ: Float64Array;
  private readonly velocityQ: Float64Array;
  private readonly rateQ: Float64Array;
  private readonly rateV: Float64Array;
  private readonly force: Float64Array;
  private readonly moved: Float64Array;

  constructor(dynamics: ConstrainedSystem) {
    const { n, m, contactCount: k } = dynamics;
    this.dynamics = dynamics;
    this.dimension = 2 * n + m + k;
    this.differential = new Uint8Array(this.dimension).fill(1, 0, 2 * n);
    const vector = (length: number): Float64Array => new Float64Array(length);
    [this.q, this.v, this.a, this.force, this.moved] = [vector(n), vector(n), vector(n), vector(n), vector(n)];
    [this.lambda, this.mu] = [vector(m), vector(m)];
    [this.dq, this.dv, this.forceQ, this.forceV, this.slipQ] = [
      vector(n * n),
      vector(n * n),
      vector(n * n),
      vector(n * n),
      vector(n * n),
    ];
    [this.velocityQ, this.rateQ, this.rateV] = [vector(m * n), vector(m * n), vector(m * n)];
  }

  get failure(): string | null {
    return this.dynamics.failure;
  }

  /** Sets q and v in y; the multipliers stay. */
  fromState(q: Float64Array, v: Float64Array, y: Float64Array): void {
    y.set(q);
    y.set(v, q.length);
  }

  toState(y: Float64Array, q: Float64Array, v: Float64Array): void {
    const n = q.length;
    for (let i = 0; i < n; i++) {
      q[i] = y[i]!;
      v[i] = y[n + i]!;
    }
  }

  /** y keeps its meaning along a run. */
  rebase(): boolean {
    return false;
  }

  start(t: number, y: Float64Array, yp: Float64Array): boolean {
    const { dynamics: d, q, v, a, lambda } = this;
    this.toState(y, q, v);
    for (const i of d.held) v[i] = i === d.clock ? 1 : 0;
    if (!d.acceleration(t, q, v, a, lambda)) return false;
    this.fromState(q, v, y);
    y.fill(0, 2 * d.n);
    y.set(lambda, 2 * d.n);
    yp.fill(0);
    this.fromState(v, a, yp);
    return true;
  }

  residual(t: number, y: Float64Array, yp: Float64Array, out: Float64Array): boolean {
    const { dynamics: d, v, a, lambda, mu } = this;
    const { n, m } = d;
    this.evaluate(t, y, yp);
    const { massMatrix, force, omega, drift } = d;
    for (let i = 0; i < n; i++) {
      let slip = yp[i]! - v[i]!;
      let balance = -force[i]!;
      for (let j = 0; j < n; j++) balance += massMatrix[i * n + j]! * a[j]!;
      for (let r = 0; r < m; r++) {
        slip -= omega[r * n + i]! * mu[r]!;
        balance -= omega[r * n + i]! * lambda[r]!;
      }
      out[i] = slip;
      out[n + i] = balance;
    }
    for (let r = 0; r < m; r++) {
      let sum = drift[r]!;
      for (let j = 0; j < n; j++) sum += omega[r * n + j]! * v[j]!;
      out[2 * n + r] = sum;
    }
    d.refreshHeights(this.q);
    for (let c = 0; c < d.contactCount; c++) out[2 * n + m + c] = d.heights[c]!;
    return true;
  }

  jacobian(t: number, y: Float64Array, yp: Float64Array, cj: number, out: Float64Array): boolean {
    const { dynamics: d, q, v, a, dq, dv, forceQ, slipQ } = this;
    const { n, m } = d;
    this.evaluate(t, y, yp);
    d.system.jacobians(q, v, a, d.parameters, dq, dv);
    this.constraintJacobians();
    for (let i = 0; i < n * n; i++) dq[i]! -= forceQ[i]!;
    this.subtractForcing(t);
    for (const i of d.held) for (const x of [dq, dv, slipQ]) x.fill(0, i * n, (i + 1) * n);
    out.fill(0);
    const size = this.dimension;
    for (let i = 0; i < n; i++) {
      const [slip, balance] = [i * size, (n + i) * size];
      for (let j = 0; j < n; j++) {
        out[slip + j] = -slipQ[i * n + j]!;
        out[balance + j] = dq[i * n + j]!;
        out[balance + n + j] = dv[i * n + j]! + cj * d.massMatrix[i * n + j]!;
      }
      out[slip + i]! += cj;
      out[slip + n + i] = -1;
      for (let r = 0; r < m; r++) out[balance + 2 * n + r] = -d.omega[r * n + i]!;
    }
    this.constraintRows(out);
    // The factors are wanted only for a name, should the constraints have become dependent.
    return d.factor();
  }

  /** The columns of mu, and the rows of Omega v and of the heights. */
  private constraintRows(out: Float64Array): void {
    const { dynamics: d, velocityQ, dimension: size } = this;
    const { n, m, omega } = d;
    for (let r = 0; r < m; r++) {
      const row = (2 * n + r) * size;
      for (let j = 0; j < n; j++) {
        out[row + j] = velocityQ[r * n + j]!;
        out[row + n + j] = omega[r * n + j]!;
      }
    }
    d.constraints?.contact?.rows.forEach((r, c) => {
      const last = 2 * n + m + c;
      for (let j = 0; j < n; j++) {
        out[j * size + last] = -omega[r * n + j]!;
        out[last * size + j] = omega[r * n + j]!;
      }
    });
  }

  /** M, forces, Omega at y; v' into `a`, multipliers into `lambda` and `mu`. */
  private evaluate(t: number, y: Float64Array, yp: Float64Array): void {
    const { dynamics: d, q, v, a, lambda, mu } = this;
    const { n, m } = d;
    this.toState(y, q, v);
    for (let i = 0; i < n; i++) a[i] = yp[n + i]!;
    for (let r = 0; r < m; r++) lambda[r] = y[2 * n + r]!;
    d.constraints?.contact?.rows.forEach((row, c) => (mu[row] = y[2 * n + m + c]!));
    d.evaluate(t, q, v);
  }

  /** d(Omega^T lambda)/dq, d(G^T mu)/dq and d(Omega v)/dq. */
  private constraintJacobians(): void {
    const { q, v, a, lambda, mu, forceQ, slipQ, rateQ, rateV, velocityQ } = this;
    const { constraints, parameters } = this.dynamics;
    if (!constraints) return;
    constraints.jacobians(q, v, a, mu, parameters, slipQ, rateQ, rateV, velocityQ);
    constraints.jacobians(q, v, a, lambda, parameters, forceQ, rateQ, rateV, velocityQ);
  }

  /** Subtracts d(B u)/dq and d(B u)/dv from `dq` and `dv`: exact, or by forward differences of the outside forces alone. */
  private subtractForcing(t: number): void {
    const {
      q,
      v,
      dq,
      dv,
      forceQ,
      forceV,
      force,
      moved,
      dynamics: { forcing, n },
    } = this;
    if (!forcing) return;
    if (forcing.jacobians) {
      forceQ.fill(0);
      forceV.fill(0);
      forcing.jacobians(t, q, v, forceQ, forceV);
      for (let i = 0; i < n * n; i++) {
        dq[i]! -= forceQ[i]!;
        dv[i]! -= forceV[i]!;
      }
      return;
    }
    force.fill(0);
    forcing(t, q, v, force);
    for (const [x, derivative] of [
      [q, dq],
      [v, dv],
    ] as const) {
      for (let j = 0; j < n; j++) {
        const kept = x[j]!;
        x[j] = kept + DIFFERENCE * Math.max(1, Math.abs(kept));
        const delta = x[j]! - kept;
        moved.fill(0);
        forcing(t, q, v, moved);
        for (let i = 0; i < n; i++) derivative[i * n + j]! -= (moved[i]! - force[i]!) / delta;
        x[j] = kept;
      }
    }
  }
}
