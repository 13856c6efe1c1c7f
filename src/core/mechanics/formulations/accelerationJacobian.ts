import type { ConstrainedSystem } from '../constrainedSystem.ts';

/**
 * Exact derivatives of the constrained acceleration a(t, q, v), by implicit differentiation of
 * `M a - h - B u - Omega^T lambda = 0`, `Omega a + gamma = 0` (the implicit function theorem, as for any linear system
 * whose entries depend on the state; Griewank and Walther, Evaluating Derivatives, 2nd ed., section 15.1):
 *
 *     [M  -Omega^T] [da     ]     [d(M a - h) - d(B u) - d(Omega^T lambda)]
 *     [Omega    0 ] [dlambda] = - [d(Omega a + gamma)                     ]
 *
 * with a and lambda fixed on the right. One factorization serves all 2 n columns. Held rows have da = 0.
 */
export class AccelerationJacobian {
  /** da/dq and da/dv, n x n row-major. */
  readonly aq: Float64Array;
  readonly av: Float64Array;
  /** d(Omega v)/dq, m x n. */
  readonly velocityQ: Float64Array;
  readonly a: Float64Array;

  private readonly dynamics: ConstrainedSystem;
  private readonly lambda: Float64Array;
  private readonly forceQ: Float64Array;
  private readonly forceV: Float64Array;
  private readonly rateQ: Float64Array;
  private readonly rateV: Float64Array;
  private readonly column: Float64Array;
  private readonly multipliers: Float64Array;

  constructor(dynamics: ConstrainedSystem) {
    const { n, m } = dynamics;
    this.dynamics = dynamics;
    this.aq = new Float64Array(n * n);
    this.av = new Float64Array(n * n);
    this.velocityQ = new Float64Array(m * n);
    this.a = new Float64Array(n);
    this.lambda = new Float64Array(m);
    this.forceQ = new Float64Array(n * n);
    this.forceV = new Float64Array(n * n);
    this.rateQ = new Float64Array(m * n);
    this.rateV = new Float64Array(m * n);
    this.column = new Float64Array(n);
    this.multipliers = new Float64Array(m);
  }

  /** Evaluates `aq`, `av`, `velocityQ` and `a` at a state; false where there is no acceleration. */
  evaluate(t: number, q: Float64Array, v: Float64Array): boolean {
    const { dynamics: d, a, lambda, aq, av, forceQ, forceV } = this;
    const { n, parameters } = d;
    if (!d.acceleration(t, q, v, a, lambda) || !d.prepareFactors(t, q, v)) return false;
    d.system.jacobians(q, v, a, parameters, aq, av);
    if (d.constraints) {
      d.constraints.jacobians(q, v, a, lambda, parameters, forceQ, this.rateQ, this.rateV, this.velocityQ);
      for (let i = 0; i < n * n; i++) aq[i]! -= forceQ[i]!;
    }
    if (d.forcing?.jacobians) {
      forceQ.fill(0);
      forceV.fill(0);
      d.forcing.jacobians(t, q, v, forceQ, forceV);
      for (let i = 0; i < n * n; i++) {
        aq[i]! -= forceQ[i]!;
        av[i]! -= forceV[i]!;
      }
    }
    for (const i of d.held) {
      aq.fill(0, i * n, (i + 1) * n);
      av.fill(0, i * n, (i + 1) * n);
    }
    this.solveColumns(aq, this.rateQ);
    this.solveColumns(av, this.rateV);
    return true;
  }

  /** Jacobian of [v; a(t, q, v)] with respect to [q, v], 2n x 2n. */
  ofState(t: number, q: Float64Array, v: Float64Array, out: Float64Array): boolean {
    if (!this.evaluate(t, q, v)) return false;
    const { aq, av } = this;
    const { n } = this.dynamics;
    out.fill(0);
    for (let i = 0; i < n; i++) {
      out[i * 2 * n + n + i] = 1;
      const row = (n + i) * 2 * n;
      for (let k = 0; k < n; k++) {
        out[row + k] = aq[i * n + k]!;
        out[row + n + k] = av[i * n + k]!;
      }
    }
    return true;
  }

  /** Replaces the columns of the upper right-hand side by those of da; the rows of `rate` are the lower one. */
  private solveColumns(upper: Float64Array, rate: Float64Array): void {
    const { dynamics: d, column, multipliers } = this;
    const { n, m } = d;
    for (let k = 0; k < n; k++) {
      for (let i = 0; i < n; i++) column[i] = -upper[i * n + k]!;
      for (let r = 0; r < m; r++) multipliers[r] = -rate[r * n + k]!;
      d.solveSaddle(column, multipliers);
      for (let i = 0; i < n; i++) upper[i * n + k] = column[i]!;
    }
  }
}
