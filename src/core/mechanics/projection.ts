import { maxAbs } from '../linalg/dense.ts';
import type { ConstrainedSystem } from './constrainedSystem.ts';

/** Heights below this are rounding in metres for a board of a metre; also the goal of the Newton iteration. */
export const HEIGHT_GOAL = 1e-15;
/** The same for the velocities of points, m/s. */
export const VELOCITY_GOAL = 1e-15;
export const MOST_ITERATIONS = 8;
/** What rounding may leave of either where the factors are right, in the same units. */
export const ROUNDING = 1e-13;

/**
 * Puts a state back on the constraint manifold by the smallest change in the mass metric
 * (Hairer and Wanner, Solving ODEs II, 2nd ed., section VII.2, "projection on the constraint manifold";
 * here with the metric of the kinetic energy): first positions on `heights = 0`, then velocities on `Omega v = 0`, both
 * by simplified Newton. At the end of a step the factors of its last stage are tried first.
 */
export class Projection {
  protected readonly dynamics: ConstrainedSystem;
  private readonly w: Float64Array;
  private readonly a: Float64Array;

  constructor(dynamics: ConstrainedSystem) {
    this.dynamics = dynamics;
    this.a = new Float64Array(dynamics.n);
    this.w = new Float64Array(dynamics.m);
  }

  /**
   * Projects q and v in place. False when the constraints are singular there (see `dynamics.failure`).
   * @param near the state is the end of a step: factors at the same time are those of a stage close to it
   */
  project(t: number, q: Float64Array, v: Float64Array, near = false): boolean {
    const d = this.dynamics;
    if (d.m === 0 || (near && d.isFactoredAt(t) && this.iterate(q, v))) return true;
    if (!d.prepare(t, q, v)) return false;
    this.iterate(q, v);
    return true;
  }

  /** @returns whether only rounding is left */
  private iterate(q: Float64Array, v: Float64Array): boolean {
    const d = this.dynamics;
    d.measure(q, v);
    return this.positions(q, v) && this.velocities(q, v);
  }

  /** Newton with fixed factors; stops when the heights no longer shrink. */
  private positions(q: Float64Array, v: Float64Array): boolean {
    const d = this.dynamics;
    const contact = d.constraints?.contact;
    if (!contact) return true;
    let last = Infinity;
    for (let i = 0; i < MOST_ITERATIONS; i++) {
      const size = maxAbs(d.heights);
      if (!(size > HEIGHT_GOAL)) return true;
      if (!(size < last)) return size <= ROUNDING;
      last = size;
      this.correctPositions(contact.rows, q);
      d.measure(q, v);
    }
    return last <= ROUNDING;
  }

  /** One step: the smallest displacement in the mass metric, moving along Omega's other rows not at all. */
  private correctPositions(rows: readonly number[], q: Float64Array): void {
    this.w.fill(0);
    for (let i = 0; i < rows.length; i++) this.w[rows[i]!] = -this.dynamics.heights[i]!;
    this.dynamics.shift(this.w, q);
  }

  /** The same with `Omega v`, which is linear in v: two passes where the factors are of this very state. */
  private velocities(q: Float64Array, v: Float64Array): boolean {
    const d = this.dynamics;
    let last = Infinity;
    for (let i = 0; i < MOST_ITERATIONS; i++) {
      const size = maxAbs(d.slip);
      if (!(size > VELOCITY_GOAL)) return true;
      if (!(size < last)) return size <= ROUNDING;
      last = size;
      for (let r = 0; r < d.m; r++) this.w[r] = -d.slip[r]!;
      d.shift(this.w, v);
      d.measureAgain(q, v);
    }
    return last <= ROUNDING;
  }

  /** Largest of |Omega v| (m/s) and |heights| (m) at a state. */
  residual(q: Float64Array, v: Float64Array): number {
    if (this.dynamics.m === 0) return 0;
    this.dynamics.measure(q, v);
    return this.left;
  }

  /** The same as last measured: at the state that was projected last. */
  get left(): number {
    return Math.max(maxAbs(this.dynamics.slip), maxAbs(this.dynamics.heights));
  }

  /** Multipliers (m) at a state; false where there are none. */
  multipliers(t: number, q: Float64Array, v: Float64Array, lambda: Float64Array): boolean {
    return this.dynamics.acceleration(t, q, v, this.a, lambda);
  }
}
