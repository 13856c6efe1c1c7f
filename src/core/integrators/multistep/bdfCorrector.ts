import { GAMMA, type BackwardDifferences } from './backwardDifferences.ts';
import type { BdfEquations } from './bdfEquations.ts';
import type { StepperOptions } from '../contract.ts';
import { allFinite } from '../shared/finite.ts';
import {
  MOST_ITERATIONS_FIXED_STEP,
  SimplifiedNewton,
  roundingFloor,
  roundingScale,
  type NewtonOutcome,
} from '../shared/newton.ts';
import { ScaledLu } from '../shared/scaledLu.ts';

/**
 * One step's equation: F(t, p + d, (sum gamma_j D[j] + alpha d) / h) = 0 for d, by simplified Newton iteration;
 * p is the prediction, alpha = (1 - kappa) gamma_k. Shampine and Reichelt (1997), section 2; the iteration's tolerance is
 * that of SciPy's BDF.
 */

/** More than four iterations cost more than a shorter step. */
export const MOST_ITERATIONS = 4;

/**
 * Increments that do not shrink any more, with derivatives of this very step, are rounding: near dependent constraints it is
 * more than its share of each variable alone tells. So much of the tolerance may then be left, as SUNDIALS' IDA leaves always
 * (its user guide: `nonlin_conv_coef`, 0.33).
 */
const ROUNDING_ACCEPTED = 0.33;

/**
 * Constraints mix the components of y, so each is known no better than to this share of the largest: a tolerance below
 * would shorten the step for ever. Rounding of the solution grows a hundredfold where constraints come near dependence,
 * and the prediction of order 5 makes 2^6 times as much of it.
 */
const RELATIVE_ROUNDING = 4096 * Number.EPSILON;

export class BdfCorrector {
  /** y - prediction. */
  readonly d: Float64Array;
  /** One unit is the tolerance of the component. */
  readonly scale: Float64Array;
  /** The derivatives in the matrix were taken since this was set to false. */
  current = false;
  private readonly equations: BdfEquations;
  private readonly options: StepperOptions;
  private readonly controlled: boolean;
  private readonly newton: SimplifiedNewton;
  private readonly tolerance: number;
  private readonly floor: number;
  private readonly lu: ScaledLu;
  /** The matrix belongs to this cj; 0 if there is none. */
  private factoredFor = 0;
  /** The last solve made its matrix. */
  private fresh = false;
  private t = 0;
  private cj = 0;
  private readonly predicted: Float64Array;
  private readonly predictedSlope: Float64Array;
  private readonly y: Float64Array;
  private readonly slope: Float64Array;
  private readonly increment: Float64Array;

  constructor(equations: BdfEquations, options: StepperOptions) {
    const vector = (): Float64Array => new Float64Array(equations.dimension);
    const { rtol } = options;
    this.equations = equations;
    this.options = options;
    this.controlled = rtol < Infinity;
    this.newton = new SimplifiedNewton(this.controlled ? MOST_ITERATIONS : MOST_ITERATIONS_FIXED_STEP);
    this.tolerance = this.controlled ? Math.max((10 * Number.EPSILON) / rtol, Math.min(0.03, Math.sqrt(rtol))) : 1;
    this.floor = this.controlled ? Math.min(0.1, roundingFloor(rtol)) : roundingFloor();
    this.lu = new ScaledLu(equations.dimension, equations.differential);
    [this.d, this.scale, this.predicted, this.predictedSlope] = [vector(), vector(), vector(), vector()];
    [this.y, this.slope, this.increment] = [vector(), vector(), vector()];
  }

  /** Iterations that the last solve took. */
  get iterations(): number {
    return Math.min(MOST_ITERATIONS, this.newton.iterations);
  }

  reset(): void {
    this.factoredFor = 0;
    this.newton.reset();
  }

  /** The next solve makes a new matrix with new derivatives. */
  forgetMatrix(): void {
    this.factoredFor = 0;
  }

  /**
   * Finds `d`.
   * @param t one spacing beyond the history's newest value, s
   */
  solve(t: number, history: BackwardDifferences): NewtonOutcome {
    const { d, predicted, predictedSlope, y, slope, equations, lu } = this;
    history.predict(predicted, predictedSlope);
    d.fill(0);
    y.set(predicted);
    slope.set(predictedSlope);
    this.t = t;
    this.cj = ((1 - equations.kappa[history.order]!) * GAMMA[history.order]!) / history.spacing;
    this.scaleBy(predicted, history.spacing);
    // How fast the iteration converged with a new matrix says nothing of the next step, when it is old.
    if (this.fresh) this.newton.reset();
    this.fresh = this.factoredFor !== this.cj;
    if (this.fresh) {
      const renew = this.factoredFor === 0;
      this.factoredFor = 0;
      const known = equations.matrix(t, y, slope, this.cj, renew, lu.matrix);
      this.current ||= !equations.matrixIsOld;
      if (!known || !allFinite(lu.matrix)) return 'no-value';
      equations.counters.factorizations++;
      if (!lu.factor(this.cj)) return 'slow';
      this.factoredFor = this.cj;
    }
    const floor = this.controlled && this.current ? Math.max(this.floor, ROUNDING_ACCEPTED) : this.floor;
    return this.newton.solve(this.correct, this.tolerance, floor);
  }

  private readonly correct = (): number => {
    const { d, y, slope, predicted, predictedSlope, increment, scale, cj } = this;
    if (!this.equations.residual(this.t, y, slope, increment)) return NaN;
    this.lu.solve(increment);
    let sum = 0;
    for (let i = 0; i < d.length; i++) {
      d[i]! -= increment[i]!;
      y[i] = predicted[i]! + d[i]!;
      slope[i] = predictedSlope[i]! + cj * d[i]!;
      const part = increment[i]! / scale[i]!;
      sum += part * part;
    }
    return Math.sqrt(sum / d.length);
  };

  /**
   * Sets `scale`. What has no derivative acts on the rest over a step only, by h times its error, and in a
   * system of index 2 is known no better than to rounding / h: its tolerance is divided by h (L. Petzold,
   * P. Lötstedt, SIAM J. Sci. Stat. Comput. 7 (1986), 720-733).
   */
  scaleBy(y: Float64Array, h: number): void {
    const { scale } = this;
    const { differential } = this.equations;
    const { rtol, atol } = this.options;
    if (!this.controlled) roundingScale(y, scale);
    else for (let i = 0; i < y.length; i++) scale[i] = atol + rtol * Math.abs(y[i]!);
    if (!differential) return;
    let largest = 0;
    for (let i = 0; i < y.length; i++) if (differential[i]) largest = Math.max(largest, Math.abs(y[i]!));
    for (let i = 0; i < y.length; i++) {
      if (!differential[i]) scale[i]! /= Math.min(1, h);
      else if (this.controlled) scale[i] = Math.max(scale[i]!, RELATIVE_ROUNDING * largest);
    }
  }

  /**
   * Largest factor |x| / scale of the components that are tested; infinite when not a number. (The usual root mean
   * square lets what moves err by more, the more stands still beside it: sixteen of the hanging board's twenty.)
   */
  norm(x: Float64Array, factor: number): number {
    const { scale } = this;
    const { differential } = this.equations;
    let largest = 0;
    for (let i = 0; i < x.length; i++) {
      if (differential && !differential[i]) continue;
      const size = (factor * Math.abs(x[i]!)) / scale[i]!;
      if (!(size <= largest)) largest = size;
    }
    return largest === largest ? largest : Infinity;
  }
}
