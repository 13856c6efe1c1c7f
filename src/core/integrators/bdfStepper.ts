import { BackwardDifferences, GAMMA, MAX_ORDER, valueAt } from './backwardDifferences.ts';
import { zeroCounters, type StepFailure, type Stepper, type StepperOptions } from './contract.ts';
import { allFinite } from './explicitFixed.ts';
import { PATIENT_ITERATIONS, SimplifiedNewton, roundingFloor, tightScale, type NewtonOutcome } from './newton.ts';
import { ScaledLu } from './scaledLu.ts';

/**
 * What `bdf` and `ida` have in common: backward differentiation of order 1 to 5 for F(t, y, y') = 0, with variable
 * order and quasi-constant step.
 *
 * L. F. Shampine, M. W. Reichelt, "The MATLAB ODE Suite", SIAM J. Sci. Comput. 18 (1997), section 2: formulas, error
 * estimates, choice of order; constants as in SciPy's BDF. Step: y = prediction + d and
 * y' = (sum gamma_j D[j] + alpha d) / h, so that cj = alpha / h multiplies dF/dy' in Newton's matrix.
 *
 * A projection moves y by about the local error, O(h^(k+1)). `stateChanged` then moves the whole polynomial with it:
 * D[0] is replaced, the differences stay. The history is then that of z = y - (sum of all moves); its slope is
 * z' = y' between the moves, so the formula loses nothing, and each move enters once, like one more local error. (Had only
 * y_n been replaced, as CVODE does, all D[j] would change by the move, and with them the error estimates.) Such use
 * of projected values keeps the order: E. Eich, SIAM J. Numer. Anal. 30 (1993), "Convergence results for a
 * coordinate projection method". A move far beyond the tolerance is another solution: order 1 again.
 *
 * Not guaranteed: damping of what oscillates fast at orders 3 to 5 (A(alpha)-stable only).
 */

/** Shampine and Reichelt: change no step for less than this gain, so that the factors of the matrix serve on. */
const GROW_FROM = 1.2;
const GROW_MOST = 10;
const SHRINK_MOST = 0.2;
const SAFETY = 0.9;
const MOST_ITERATIONS = 4;
/** After so many rejections of one step the history is no help: order 1 (Brenan, Campbell and Petzold, section 5.2). */
const REJECTIONS_TO_RESTART = 3;
/** A step below this many units in the last place of t cannot advance it reliably. */
const SMALLEST_ULPS = 16;
/** Moves of y beyond so many units of the tolerance begin a new history. */
const RESTART_BEYOND = 100;
/** A spacing closer than this to the step is the step: the last digits of the limit are worth no new factors. */
const SAME_STEP = 1e-12;

/** For measurements: the highest order, and the solution before the start, which then begins at that order. */
export interface BdfTuning {
  maxOrder?: number;
  past?: (t: number, y: Float64Array) => void;
}

export abstract class BdfStepper implements Stepper {
  t = 0;
  previousT = 0;
  readonly y: Float64Array;
  readonly counters = zeroCounters();

  protected readonly options: StepperOptions;
  private readonly tuning: BdfTuning;
  private readonly differential: Uint8Array | null;
  private readonly kappa: readonly number[];
  private readonly maxOrder: number;
  private readonly controlled: boolean;
  private readonly newton: SimplifiedNewton;
  private readonly lu: ScaledLu;
  private readonly history: BackwardDifferences;
  private readonly kept: Float64Array[];
  private keptOrder = 0;
  private stepTaken = 0;
  private h = 0;
  private equalSteps = 0;
  private started = false;
  /** Newton's matrix belongs to this cj; 0 if there is none. */
  private factoredFor = 0;
  /** The derivatives in it were taken during this step. */
  private current = false;
  private tNew = 0;
  private cj = 0;
  private readonly d: Float64Array;
  private readonly predicted: Float64Array;
  private readonly predictedSlope: Float64Array;
  private readonly yNew: Float64Array;
  private readonly slope: Float64Array;
  private readonly increment: Float64Array;
  private readonly scale: Float64Array;

  /**
   * @param differential which components have a derivative in F; null: all. Only these are tested for their error.
   * @param kappa by order: 0 for BDF, or the constants of the NDF
   */
  protected constructor(dimension: number, differential: Uint8Array | null, kappa: readonly number[], options: StepperOptions, tuning: BdfTuning) {
    const vector = (): Float64Array => new Float64Array(dimension);
    this.options = options;
    this.tuning = tuning;
    this.differential = differential;
    this.kappa = kappa;
    this.maxOrder = tuning.maxOrder ?? MAX_ORDER;
    this.controlled = options.rtol < Infinity;
    this.newton = new SimplifiedNewton(this.controlled ? MOST_ITERATIONS : PATIENT_ITERATIONS);
    this.lu = new ScaledLu(dimension, differential);
    this.history = new BackwardDifferences(dimension);
    this.kept = Array.from({ length: MAX_ORDER + 1 }, vector);
    [this.y, this.d, this.predicted, this.predictedSlope] = [vector(), vector(), vector(), vector()];
    [this.yNew, this.slope, this.increment, this.scale] = [vector(), vector(), vector(), vector()];
  }

  /** Derivative at (t, y), and the components of y that follow from the others. */
  protected abstract begin(t: number, y: Float64Array, slope: Float64Array): boolean;
  protected abstract firstStep(t: number, y: Float64Array, slope: Float64Array): number;
  protected abstract residual(t: number, y: Float64Array, slope: Float64Array, out: Float64Array): boolean;
  /** dF/dy + cj dF/dy'; its derivatives at this state if `renew`, else older ones will do. */
  protected abstract matrix(t: number, y: Float64Array, slope: Float64Array, cj: number, renew: boolean, out: Float64Array): boolean;
  /** Whether `matrix` used older derivatives. */
  protected abstract readonly matrixIsOld: boolean;
  protected abstract readonly problemFailure: string | null;

  reset(t: number, y: Float64Array): void {
    this.t = this.previousT = t;
    this.y.set(y);
    this.kept[0]!.set(y);
    this.keptOrder = this.stepTaken = 0;
    this.h = this.options.step ?? 0;
    this.started = false;
    Object.assign(this.counters, zeroCounters());
  }

  stateChanged(): void {
    if (!this.started) return;
    const { y, d } = this;
    const newest = this.history.D[0]!;
    for (let i = 0; i < y.length; i++) d[i] = y[i]! - newest[i]!;
    if (this.controlled && !(this.norm(d, 1) <= RESTART_BEYOND)) {
      this.started = false;
      this.h = this.options.step ?? 0;
    }
    newest.set(y);
  }

  step(limit: number): StepFailure | null {
    if (!this.started && !this.start()) return this.problemFailure ?? 'non-finite';
    const smallest = SMALLEST_ULPS * Number.EPSILON * Math.max(Math.abs(this.t), Math.abs(limit - this.t));
    this.current = false;
    for (let rejections = 1; ; rejections++) {
      const h = this.setStep(limit);
      if (!(this.t + h > this.t)) return 'step-too-small';
      const outcome = this.solve(h);
      const error = outcome === 'converged' ? this.norm(this.d, this.errorConstant(this.history.order)) : Infinity;
      if (outcome === 'converged' && (error <= 1 || !this.controlled)) {
        this.accept(h, error);
        return null;
      }
      this.counters.rejected++;
      if (outcome === 'converged') this.h = h * this.shrink(error, rejections);
      else if (this.current) this.h = h / 2;
      else this.factoredFor = 0;
      if (this.h > smallest) continue;
      if (outcome === 'converged') return 'step-too-small';
      return outcome === 'slow' ? (this.problemFailure ?? 'newton') : (this.problemFailure ?? 'non-finite');
    }
  }

  interpolate(t: number, out: Float64Array): void {
    const s = this.stepTaken > 0 ? (t - this.previousT) / this.stepTaken - 1 : 0;
    valueAt(this.kept, this.keptOrder, s, out);
  }

  private start(): boolean {
    const { y, slope, history, tuning, maxOrder } = this;
    if (!this.begin(this.t, y, slope) || !allFinite(slope) || !allFinite(y)) return false;
    if (this.keptOrder === 0) this.kept[0]!.set(y);
    this.controlled ? this.scaleBy(y, 1) : tightScale(y, this.scale);
    if (!(this.h > 0)) this.h = this.firstStep(this.t, y, slope);
    this.h = Math.min(this.h, this.options.maxStep ?? Infinity);
    if (tuning.past) {
      const values = Array.from({ length: maxOrder + 1 }, () => y.slice());
      for (let j = 1; j <= maxOrder; j++) tuning.past(this.t - j * this.h, values[j]!);
      history.startFrom(values, maxOrder, this.h);
    } else history.start(y, slope, this.h);
    this.equalSteps = this.factoredFor = 0;
    this.newton.reset();
    return (this.started = true);
  }

  /** The step to try: at most maxStep, stretched or halved so that no sliver is left before the limit. */
  private setStep(limit: number): number {
    const left = limit - this.t;
    let h = Math.min(this.h, this.options.maxStep ?? Infinity);
    const last = h >= left || 1.01 * h >= left;
    if (last) h = left;
    else if (2 * h > left && Math.abs(left / 2 / h - 1) > SAME_STEP) h = left / 2;
    this.tNew = last ? limit : this.t + h;
    if (Math.abs(h / this.history.spacing - 1) > SAME_STEP) {
      this.history.respace(h);
      this.equalSteps = 0;
    }
    return (this.h = this.history.spacing);
  }

  private solve(h: number): NewtonOutcome {
    const { history, d, predicted, predictedSlope, yNew, slope } = this;
    history.predict(predicted, predictedSlope);
    d.fill(0);
    yNew.set(predicted);
    slope.set(predictedSlope);
    this.cj = ((1 - this.kappa[history.order]!) * GAMMA[history.order]!) / h;
    this.scaleBy(predicted, h);
    if (this.factoredFor !== this.cj) {
      const renew = this.factoredFor === 0;
      this.factoredFor = 0;
      const known = this.matrix(this.tNew, yNew, slope, this.cj, renew, this.lu.matrix);
      this.current ||= !this.matrixIsOld;
      if (!known) return 'no-value';
      this.counters.factorizations++;
      if (!this.lu.factor(this.cj)) return 'slow';
      this.factoredFor = this.cj;
    }
    const { rtol } = this.options;
    return this.controlled
      ? this.newton.solve(this.correct, Math.max((10 * Number.EPSILON) / rtol, Math.min(0.03, Math.sqrt(rtol))), Math.min(0.1, roundingFloor(rtol)))
      : this.newton.solve(this.correct, 1, roundingFloor());
  }

  /** One iteration of Newton's method for d. */
  private readonly correct = (): number => {
    const { d, yNew, slope, predicted, predictedSlope, increment, scale, cj } = this;
    if (!this.residual(this.tNew, yNew, slope, increment)) return NaN;
    this.lu.solve(increment);
    let sum = 0;
    for (let i = 0; i < d.length; i++) {
      d[i]! -= increment[i]!;
      yNew[i] = predicted[i]! + d[i]!;
      slope[i] = predictedSlope[i]! + cj * d[i]!;
      sum += (increment[i]! / scale[i]!) ** 2;
    }
    return Math.sqrt(sum / d.length);
  };

  /**
   * Weights of Newton's method, and of the test where it looks. What has no derivative acts on the others over a
   * step only, by h times its error, and is known no better than to rounding / h in a system of index 2: it is
   * weighted by h (L. Petzold, P. Lötstedt, SIAM J. Sci. Stat. Comput. 7 (1986), 720-733).
   */
  private scaleBy(y: Float64Array, h: number): void {
    const { scale, differential } = this;
    const { rtol, atol } = this.options;
    if (!this.controlled) tightScale(y, scale);
    else for (let i = 0; i < y.length; i++) scale[i] = atol + rtol * Math.abs(y[i]!);
    if (differential) for (let i = 0; i < y.length; i++) if (!differential[i]) scale[i]! /= Math.min(1, h);
  }

  /** Root mean square of factor x / scale over the components that are tested; infinite when not a number. */
  private norm(x: Float64Array, factor: number): number {
    const { scale, differential } = this;
    let sum = 0;
    let count = 0;
    for (let i = 0; i < x.length; i++) {
      if (differential && !differential[i]) continue;
      sum += ((factor * x[i]!) / scale[i]!) ** 2;
      count++;
    }
    const norm = Math.sqrt(sum / Math.max(1, count));
    return norm === norm ? norm : Infinity;
  }

  private errorConstant(order: number): number {
    return this.kappa[order]! * GAMMA[order]! + 1 / (order + 1);
  }

  /** Room left below the longest step that would pass, more of it where Newton's method was slow. */
  private get safety(): number {
    return (SAFETY * (2 * MOST_ITERATIONS + 1)) / (2 * MOST_ITERATIONS + Math.min(MOST_ITERATIONS, this.newton.iterations));
  }

  private shrink(error: number, rejections: number): number {
    const { history } = this;
    const factor = error < Infinity ? Math.max(SHRINK_MOST, this.safety * Math.pow(error, -1 / (history.order + 1))) : SHRINK_MOST;
    if (rejections < REJECTIONS_TO_RESTART) return factor;
    if (!this.tuning.past) history.order = 1;
    return Math.min(factor, 0.5);
  }

  private accept(h: number, error: number): void {
    const { history, y, kept } = this;
    this.previousT = this.t;
    this.stepTaken = h;
    this.t = this.tNew;
    history.advance(this.d);
    this.keptOrder = history.order;
    for (let j = 0; j <= history.order; j++) kept[j]!.set(history.D[j]!);
    y.set(history.D[0]!);
    this.counters.steps++;
    this.equalSteps++;
    if (this.equalSteps > history.order) this.chooseNext(h, error);
  }

  /** Order and step for the next steps: the order among k - 1, k, k + 1 that allows the longest. */
  private chooseNext(h: number, error: number): void {
    const { history, maxOrder } = this;
    const { order, D } = history;
    if (!this.controlled) {
      history.order = Math.min(maxOrder, order + 1);
      return;
    }
    const reach = (k: number, e: number): number => Math.pow(e, -1 / (k + 1));
    let [best, factor] = [order, reach(order, error)];
    for (const k of [order - 1, order + 1]) {
      if (k < 1 || k > maxOrder) continue;
      const other = reach(k, this.norm(D[k + 1]!, this.errorConstant(k)));
      if (other > factor) [best, factor] = [k, other];
    }
    factor = Math.min(GROW_MOST, this.safety * factor);
    if (factor >= 1 && factor < GROW_FROM) return;
    history.order = best;
    this.h = h * factor;
    this.equalSteps = 0;
  }
}
