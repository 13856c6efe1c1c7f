import type { Counters, OdeProblem } from '../contract.ts';
import { power } from '../../elementary/powers.ts';

/**
 * Simplified Newton iteration for implicit methods: one Jacobian serves all iterations and, while they converge
 * fast, further steps.
 *
 * Hairer and Wanner, Solving ODEs II, 2nd ed., section IV.8: rate of convergence theta_k = |dz_k| / |dz_(k-1)|,
 * stopping once eta_k |dz_k| <= kappa tol with eta = theta / (1 - theta); giving up as soon as the
 * iterations that are left would not suffice; eta from the step before at the first iteration,
 * to the power 0.8; reuse of the Jacobian while theta is small. Difference quotients as in the authors' RADAU5.
 *
 * Not guaranteed: convergence. A poor start or matrix gives 'slow', and the caller makes a new matrix or a
 * shorter step.
 */

/** No value: f has none at an iterate, or it is not a number. */
export type NewtonOutcome = 'converged' | 'slow' | 'no-value';

/** Below this rate two digits are won by each iteration: a new Jacobian would cost more than it could save. */
export const REUSE_BELOW = 1e-2;

/** Where the step may not be shortened, Newton's method may go on while the rate is below about 0.6. */
export const MOST_ITERATIONS_FIXED_STEP = 50;

/** Relative accuracy of what is solved as well as it can be, so that a thousand steps do not add up to 1e-11. */
const ROUNDING_TOLERANCE = 1e-14;
/** Size below which a variable counts as zero there, in its own unit. */
const ROUNDING_FLOOR = 1e-3;

/**
 * Weights by which an equation without a tolerance of its own is solved: one unit is ROUNDING_TOLERANCE of the variable.
 * @param y n
 * @param scale n; set
 */
export function roundingScale(y: Float64Array, scale: Float64Array): void {
  for (let i = 0; i < y.length; i++) scale[i] = ROUNDING_TOLERANCE * (ROUNDING_FLOOR + Math.abs(y[i]!));
}

/**
 * Where increments cease to shrink because of rounding, in units of `relative` times the variable: nearly dependent
 * constraints magnify the rounding of forces some thousand times.
 * @param relative tolerance of the variable, relative
 */
export function roundingFloor(relative = ROUNDING_TOLERANCE): number {
  return (1e4 * Number.EPSILON) / relative;
}

export class SimplifiedNewton {
  /** Rate of convergence of the last solve; 0 when one iteration sufficed. */
  theta = 0;
  iterations = 0;
  private readonly most: number;
  private eta = 1;

  constructor(mostIterations: number) {
    this.most = mostIterations;
  }

  reset(): void {
    this.theta = 0;
    this.iterations = 0;
    this.eta = 1;
  }

  /**
   * @param correct one iteration: moves the iterate and returns the scaled norm of the increment, NaN if f has no value
   * @param tolerance bound of the scaled error that is left, kappa tol
   * @param floor increments below it that do not shrink any more are rounding
   */
  solve(correct: () => number, tolerance: number, floor: number): NewtonOutcome {
    let before = 0;
    let rateBefore = 0;
    this.theta = 0;
    this.eta = power(Math.max(this.eta, Number.EPSILON), 0.8);
    for (this.iterations = 1; this.iterations <= this.most; this.iterations++) {
      const size = correct();
      if (!(size < Infinity)) return this.giveUp('no-value');
      if (size === 0) return 'converged';
      if (this.iterations > 1) {
        const rate = size / before;
        const theta = this.iterations === 2 ? rate : Math.sqrt(rate * rateBefore);
        rateBefore = rate;
        if (theta >= 0.99 && size <= floor) return 'converged';
        this.theta = theta;
        if (theta >= 0.99) return this.giveUp('slow');
        this.eta = theta / (1 - theta);
        const reached = this.eta * size * power(theta, this.most - this.iterations);
        if (reached > tolerance && size > floor) return this.giveUp('slow');
      }
      if (this.eta * size <= tolerance) return 'converged';
      before = size;
    }
    return before <= floor ? 'converged' : this.giveUp('slow');
  }

  private giveUp(why: NewtonOutcome): NewtonOutcome {
    this.eta = 1;
    return why;
  }
}

/** df/dy by the problem's own formula, or by forward differences. */
export class Jacobian {
  /** df/dy, dimension x dimension, row-major. */
  readonly matrix: Float64Array;
  private readonly problem: OdeProblem;
  private readonly counters: Counters;
  private readonly moved: Float64Array;
  private readonly slope: Float64Array;

  constructor(problem: OdeProblem, counters: Counters) {
    this.problem = problem;
    this.counters = counters;
    this.matrix = new Float64Array(problem.dimension ** 2);
    this.moved = new Float64Array(problem.dimension);
    this.slope = new Float64Array(problem.dimension);
  }

  /**
   * Fills `matrix`.
   * @param t s
   * @param y n
   * @param f0 f(t, y), n
   * @returns false if there is none
   */
  evaluate(t: number, y: Float64Array, f0: Float64Array): boolean {
    this.counters.jacobians++;
    if (this.problem.jacobian) return this.problem.jacobian(t, y, this.matrix);
    const n = y.length;
    this.moved.set(y);
    for (let j = 0; j < n; j++) {
      const delta = this.displace(t, y, j);
      if (delta === 0) return false;
      for (let i = 0; i < n; i++) this.matrix[i * n + j] = (this.slope[i]! - f0[i]!) / delta;
      this.moved[j] = y[j]!;
    }
    return true;
  }

  /** `slope` = f at y moved in its j-th entry, forwards or, where f has no value, backwards; by how much, or 0. */
  private displace(t: number, y: Float64Array, j: number): number {
    const size = Math.sqrt(Number.EPSILON * Math.max(1e-5, Math.abs(y[j]!)));
    for (let sign = 1; sign >= -1; sign -= 2) {
      this.moved[j] = y[j]! + sign * size;
      this.counters.evaluations++;
      if (this.problem.derivative(t, this.moved, this.slope)) return this.moved[j]! - y[j]!;
    }
    return 0;
  }
}
