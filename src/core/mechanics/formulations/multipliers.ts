import type { ConstrainedSystem } from '../constrainedSystem.ts';
import { AccelerationJacobian } from './accelerationJacobian.ts';
import type { Formulation } from './contract.ts';

/**
 * y = [q, v]; accelerations with Lagrange multipliers, the short way where there is one, else from the Cholesky factors of M
 * and of its Schur complement (`ConstrainedSystem`). The equations of index 1: Hairer and Wanner, Solving ODEs II, 2nd ed., section VII.1, (1.46).
 *
 * Not guaranteed: that `Omega v` stays zero. It drifts linearly, heights quadratically, unless they are projected.
 */
export class Multipliers implements Formulation {
  readonly dimension: number;
  jacobian?: (t: number, y: Float64Array, out: Float64Array) => boolean;

  private readonly dynamics: ConstrainedSystem;
  private readonly n: number;
  private readonly q: Float64Array;
  private readonly v: Float64Array;
  private readonly a: Float64Array;
  private readonly lambda: Float64Array;

  constructor(dynamics: ConstrainedSystem) {
    const n = (this.n = dynamics.n);
    this.dynamics = dynamics;
    this.dimension = 2 * n;
    this.q = new Float64Array(n);
    this.v = new Float64Array(n);
    this.a = new Float64Array(n);
    this.lambda = new Float64Array(dynamics.m);
    if (dynamics.differentiable) {
      const jacobian = new AccelerationJacobian(dynamics);
      this.jacobian = (t, y, out) => {
        this.toState(y, this.q, this.v);
        return jacobian.ofState(t, this.q, this.v, out);
      };
    }
  }

  get failure(): string | null {
    return this.dynamics.failure;
  }

  derivative(t: number, y: Float64Array, out: Float64Array): boolean {
    if (this.dynamics.rate(t, y, out)) return true;
    const { n, q, v, a } = this;
    this.toState(y, q, v);
    if (!this.dynamics.acceleration(t, q, v, a, this.lambda)) return false;
    for (let i = 0; i < n; i++) {
      out[i] = v[i]!;
      out[n + i] = a[i]!;
    }
    return true;
  }

  fromState(q: Float64Array, v: Float64Array, y: Float64Array): void {
    stateToPair(q, v, y);
  }

  toState(y: Float64Array, q: Float64Array, v: Float64Array): void {
    pairToState(y, q, v);
  }

  rebase(): boolean {
    return false;
  }
}

/**
 * y = [q, v], for every formulation that integrates the state as it is.
 *
 * @param q coordinates, n
 * @param v rates, n
 * @param y the pair, 2 n
 */
export function stateToPair(q: Float64Array, v: Float64Array, y: Float64Array): void {
  const n = q.length;
  for (let i = 0; i < n; i++) {
    y[i] = q[i]!;
    y[n + i] = v[i]!;
  }
}

/**
 * [q, v] = y, for every formulation that integrates the state as it is.
 *
 * @param y the pair, 2 n
 * @param q coordinates, n
 * @param v rates, n
 */
export function pairToState(y: Float64Array, q: Float64Array, v: Float64Array): void {
  const n = q.length;
  for (let i = 0; i < n; i++) {
    q[i] = y[i]!;
    v[i] = y[n + i]!;
  }
}
