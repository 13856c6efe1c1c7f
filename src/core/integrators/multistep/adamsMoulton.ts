import type { OdeProblem, StepFailure, StepperOptions } from '../contract.ts';
import { luFactor, luSolve } from '../../linalg/lu.ts';
import { FixedStepper } from '../shared/fixedStepper.ts';
import { hermite } from '../shared/interpolation.ts';
import {
  Jacobian,
  MOST_ITERATIONS_FIXED_STEP,
  REUSE_BELOW,
  SimplifiedNewton,
  roundingFloor,
  roundingScale,
  type NewtonOutcome,
} from '../shared/newton.ts';

/**
 * The implicit Adams method of one step (Adams-Moulton, k = 1), which is the trapezoidal rule:
 * y1 = y0 + h/2 (f(t0, y0) + f(t1, y1)), order 2, fixed step.
 *
 * Hairer, Nørsett and Wanner, Solving ODEs I, 2nd ed., section III.1 (implicit Adams methods); stability: Hairer and Wanner,
 * Solving ODEs II, 2nd ed., section IV.3: A-stable with |R(infinity)| = 1. Between steps the cubic Hermite
 * polynomial, which is here the quadratic that has the slopes of f at both ends, of order 2.
 *
 * The equation is solved to relative 1e-14 or to rounding, whatever `rtol` says; no error is estimated.
 *
 * Not guaranteed: damping. What is stiff and not resolved rings with a sign that changes at each step and dies out
 * slowly, and between the steps the polynomial swings h |df/dy| / 8 times as far.
 */

const MOST_ITERATIONS = 10;

export class AdamsMoulton extends FixedStepper {
  protected readonly endsWithSlope = true;
  private readonly n: number;
  private readonly newton = new SimplifiedNewton(MOST_ITERATIONS);
  private readonly newtonAnew = new SimplifiedNewton(MOST_ITERATIONS_FIXED_STEP);
  private readonly jacobian: Jacobian;
  /** I - h/2 J, factored, for the step `factoredFor`; 0 if it is not to be used. */
  private readonly matrix: Float64Array;
  private readonly pivots: Int32Array;
  private factoredFor = 0;
  /** The Jacobian is good enough to be used again. */
  private known = false;
  /** The last step's increment may start the next iteration. */
  private guess = false;
  private readonly scale: Float64Array;
  /** y1 - y0 of the step being tried. */
  private readonly z: Float64Array;
  private readonly increment: Float64Array;
  private h = 0;

  constructor(problem: OdeProblem, options: StepperOptions) {
    super(problem, options);
    this.n = problem.dimension;
    this.jacobian = new Jacobian(problem, this.counters);
    this.matrix = new Float64Array(this.n * this.n);
    this.pivots = new Int32Array(this.n);
    this.scale = this.vector();
    this.z = this.vector();
    this.increment = this.vector();
  }

  override reset(t: number, y: Float64Array): void {
    super.reset(t, y);
    this.forget();
  }

  /** A moved state keeps the Jacobian: it decides how fast Newton's method converges, not to what. A jump does not. */
  override restart(): void {
    super.restart();
    this.forget();
  }

  protected advance(h: number): StepFailure | null {
    const { y } = this;
    this.h = h;
    roundingScale(y, this.scale);
    let outcome = this.solve(this.known, this.guess && this.stepTaken > 0);
    // Once more with what belongs to this step alone: its own Jacobian, and no guess.
    if (outcome !== 'converged') outcome = this.solve(false, false);
    if (outcome === 'slow') return 'newton';
    if (outcome === 'no-value') return this.noValue();
    for (let i = 0; i < y.length; i++) this.yNew[i] = y[i]! + this.z[i]!;
    if (!this.f(this.t + h, this.yNew, this.fEnd)) return this.noValue();
    this.guess = true;
    return null;
  }

  interpolate(t: number, out: Float64Array): void {
    hermite(this.fraction(t), this.stepTaken, this.y0, this.f0, this.y1, this.f1, out);
  }

  private forget(): void {
    this.factoredFor = 0;
    this.known = false;
    this.guess = false;
  }

  /** `z` by Newton's method, with the Jacobian at hand or a new one, from the last step's increment or from zero. */
  private solve(reuse: boolean, guess: boolean): NewtonOutcome {
    if (!reuse) {
      this.factoredFor = 0;
      if (!this.jacobian.evaluate(this.t, this.y, this.fStart)) return 'no-value';
    }
    if (this.factoredFor !== this.h && !this.factor()) return 'slow';
    const ratio = guess ? this.h / this.stepTaken : 0;
    for (let i = 0; i < this.n; i++) this.z[i] = guess ? ratio * (this.y1[i]! - this.y0[i]!) : 0;
    const newton = guess ? this.newton : this.newtonAnew;
    // No estimate of the rate is carried over: what is left at the end of one iteration is not looked at again.
    newton.reset();
    const outcome = newton.solve(this.correct, 1, roundingFloor());
    this.known = outcome === 'converged' && newton.theta < REUSE_BELOW;
    return outcome;
  }

  private factor(): boolean {
    const { matrix, n, h } = this;
    const J = this.jacobian.matrix;
    for (let i = 0; i < n * n; i++) matrix[i] = -0.5 * h * J[i]!;
    for (let i = 0; i < n; i++) matrix[i * n + i]! += 1;
    this.counters.factorizations++;
    this.factoredFor = 0;
    if (!luFactor(matrix, n, this.pivots)) return false;
    this.factoredFor = h;
    return true;
  }

  private readonly correct = (): number => {
    const { n, h, z, increment, scale } = this;
    for (let i = 0; i < n; i++) this.yNew[i] = this.y[i]! + z[i]!;
    if (!this.f(this.t + h, this.yNew, this.fEnd)) return NaN;
    for (let i = 0; i < n; i++) increment[i] = 0.5 * h * (this.fStart[i]! + this.fEnd[i]!) - z[i]!;
    luSolve(this.matrix, n, this.pivots, increment);
    let sum = 0;
    for (let i = 0; i < n; i++) {
      z[i]! += increment[i]!;
      const part = increment[i]! / scale[i]!;
      sum += part * part;
    }
    return Math.sqrt(sum / n);
  };
}
