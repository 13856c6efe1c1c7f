import { maxAbs } from '../linalg/dense.ts';
import type { ConstrainedSystem } from './constrainedSystem.ts';

/** Heights below this are rounding in metres for a board of a metre; also the goal of the Newton iteration. */
const HEIGHT_GOAL = 1e-15;
/** The same for the velocities of points, m/s. */
const VELOCITY_GOAL = 1e-15;
const MOST_ITERATIONS = 6;

/**
 * Puts a state back on the constraint manifold by the smallest change in the mass metric
 * (Hairer and Wanner, Solving ODEs II, 2nd ed., section VII.2, "projection on the constraint manifold";
 * here with the metric of the kinetic energy): first positions on `heights = 0`, by simplified Newton with
 * the factors of one evaluation, then velocities on `Omega v = 0`.
 */
export class Projection {
  private readonly dynamics: ConstrainedSystem;
  private readonly w: Float64Array;
  private readonly residuals: Float64Array;

  constructor(dynamics: ConstrainedSystem) {
    this.dynamics = dynamics;
    this.w = new Float64Array(dynamics.m);
    this.residuals = new Float64Array(dynamics.m);
  }

  /** Projects q and v in place. False when the constraints are singular there (see `dynamics.failure`). */
  project(t: number, q: Float64Array, v: Float64Array): boolean {
    const d = this.dynamics;
    if (d.m === 0) return true;
    if (!d.prepare(t, q, v)) return false;
    this.positions(q);
    d.refreshOmega(q, v);
    this.velocities(v);
    return true;
  }

  /** Newton with fixed factors; stops when the heights no longer shrink. */
  private positions(q: Float64Array): void {
    const d = this.dynamics;
    const contact = d.constraints?.contact;
    if (!contact) return;
    let last = Infinity;
    for (let i = 0; i < MOST_ITERATIONS; i++) {
      d.refreshHeights(q);
      const size = maxAbs(d.heights);
      if (!(size > HEIGHT_GOAL) || !(size < last)) return;
      last = size;
      this.correctPositions(contact.rows, q);
    }
  }

  /** One step: the smallest displacement in the mass metric, moving along Omega's other rows not at all. */
  private correctPositions(rows: readonly number[], q: Float64Array): void {
    this.w.fill(0);
    for (let i = 0; i < rows.length; i++) this.w[rows[i]!] = -this.dynamics.heights[i]!;
    this.dynamics.solveS(this.w);
    this.dynamics.addWeighted(this.w, q);
  }

  /** Two passes: the second removes what the first left through rounding and slightly old factors. */
  private velocities(v: Float64Array): void {
    const d = this.dynamics;
    let last = Infinity;
    for (let i = 0; i < 3; i++) {
      d.constraintVelocity(v, this.residuals);
      const size = maxAbs(this.residuals);
      if (!(size > VELOCITY_GOAL) || !(size < last)) return;
      last = size;
      for (let r = 0; r < d.m; r++) this.w[r] = -this.residuals[r]!;
      d.solveS(this.w);
      d.addWeighted(this.w, v);
    }
  }

  /** Largest of |Omega v| (m/s) and |heights| (m) at a state. */
  residual(q: Float64Array, v: Float64Array): number {
    const d = this.dynamics;
    if (d.m === 0) return 0;
    d.refreshOmega(q, v);
    d.refreshHeights(q);
    d.constraintVelocity(v, this.residuals);
    return Math.max(maxAbs(this.residuals), maxAbs(d.heights));
  }
}
