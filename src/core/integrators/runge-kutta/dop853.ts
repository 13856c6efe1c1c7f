import { stageState, weightedSum } from '../shared/combine.ts';
import { zeroCounters, type OdeProblem, type StepFailure, type Stepper, type StepperOptions } from '../contract.ts';
import { A, B3, C, D, E5 } from './dop853Coefficients.ts';
import { allFinite, hermite } from './explicitFixed.ts';
import { firstStep, PiController, stepWithin } from '../shared/stepControl.ts';

/**
 * Dormand and Prince's explicit Runge-Kutta method of order 8 with error estimates of orders 5 and 3, and
 * continuous output of order 7.
 *
 * Hairer, Nørsett and Wanner, Solving ODEs I, 2nd ed., section II.10: the error of the step is
 * h |e5|^2 / sqrt(|e5|^2 + 0.01 |e3|^2), so that it falls like h^8; the continuous output is that of
 * section II.10 as in the authors' code DOP853.
 *
 * The continuous output costs three more evaluations, which are made only when `interpolate` is first called
 * after a step. Should f have no value at one of them (it had at the ends), the cubic Hermite polynomial of the
 * step stands in, of order 3.
 *
 * Not guaranteed: efficiency on stiff problems (no stiffness detection; the step count tells), nor below a
 * relative tolerance of about 1e-14, where rounding decides.
 */

/** b minus the weights of the embedded formula of order 3. */
const E3 = A[12]!.map((b, j) => b - ({ 0: B3[0], 8: B3[1], 11: B3[2] }[j] ?? 0));
const STAGES = 12;
const EXTENDED = 16;
const ORDER = 8;

/** A step below this many units in the last place of t cannot advance it reliably. */
const SMALLEST_ULPS = 16;
/** First step where f is not a number near the start, so that its size says nothing. */
const CAUTIOUS_STEP = 1e-6;

/** What stands between the ends of the last accepted step: nothing yet, the continuous output, or its substitute. */
type Dense = 'none' | 'polynomial' | 'hermite';

export class Dop853 implements Stepper {
  t = 0;
  previousT = 0;
  readonly y: Float64Array;
  readonly counters = zeroCounters();
  readonly projects = true;

  private readonly problem: OdeProblem;
  private readonly options: StepperOptions;
  private readonly controller = new PiController(ORDER);
  /** Slopes of the step being tried, and of the last accepted one: they change places when a step is accepted. */
  private k: Float64Array[];
  private kept: Float64Array[];
  private readonly yNew: Float64Array;
  private readonly scratch: Float64Array;
  /** Differences to the formulas of order 5 and 3. */
  private readonly errors: readonly [Float64Array, Float64Array];
  /** Ends of the last accepted step; `y` itself may be moved afterwards. */
  private readonly y0: Float64Array;
  private readonly y1: Float64Array;
  private readonly coefficients: Float64Array[];
  private dense: Dense = 'none';
  private h = 0;
  private stepTaken = 0;
  /** k[0] is f(t, y). */
  private fresh = false;

  constructor(problem: OdeProblem, options: StepperOptions) {
    const vector = (): Float64Array => new Float64Array(problem.dimension);
    const slopes = (): Float64Array[] => Array.from({ length: EXTENDED }, vector);
    this.problem = problem;
    this.options = options;
    this.y = vector();
    this.yNew = vector();
    this.scratch = vector();
    this.errors = [vector(), vector()];
    this.y0 = vector();
    this.y1 = vector();
    this.k = slopes();
    this.kept = slopes();
    this.coefficients = Array.from({ length: 7 }, vector);
  }

  reset(t: number, y: Float64Array): void {
    this.t = this.previousT = t;
    this.y.set(y);
    this.y1.set(y);
    this.stepTaken = 0;
    this.h = this.options.step ?? 0;
    this.fresh = false;
    this.controller.reset();
    Object.assign(this.counters, zeroCounters());
  }

  stateChanged(): void {
    this.fresh = false;
  }

  step(limit: number): StepFailure | null {
    const { y, k, options } = this;
    if (!this.fresh && !this.f(this.t, y, k[0]!)) return this.problem.failure ?? 'non-finite';
    this.fresh = true;
    if (!(this.h > 0)) {
      this.h = firstStep((t, x, out) => this.f(t, x, out), this.t, y, k[0]!, ORDER, options.rtol, options.atol, [
        this.yNew,
        this.scratch,
      ]);
      if (!(this.h > 0)) this.h = CAUTIOUS_STEP;
    }
    const smallest = SMALLEST_ULPS * Number.EPSILON * Math.max(Math.abs(this.t), Math.abs(limit - this.t));
    for (;;) {
      const h = stepWithin(this.h, limit - this.t, this.options.maxStep ?? Infinity);
      // An evaluation that has no value counts as an error without bound: a shorter step may go around it.
      let error = this.stages(h) ? this.errorOf(h) : Infinity;
      // The slope at the new state is made last, for a step that is good otherwise.
      if (error <= 1 && !this.lastSlope(h)) error = Infinity;
      if (error <= 1) {
        this.accept(h, limit, error);
        return null;
      }
      this.counters.rejected++;
      this.h = h * this.controller.reject(error);
      if (!(this.h > smallest)) return error < Infinity ? 'step-too-small' : (this.problem.failure ?? 'non-finite');
    }
  }

  interpolate(t: number, out: Float64Array): void {
    if (!(this.stepTaken > 0)) {
      out.set(this.y1);
      return;
    }
    if (this.dense === 'none') this.dense = this.extend() ? 'polynomial' : 'hermite';
    const s = (t - this.previousT) / this.stepTaken;
    const r = 1 - s;
    if (this.dense === 'hermite') {
      hermite(s, this.stepTaken, this.y0, this.kept[0]!, this.y1, this.kept[STAGES]!, out);
      return;
    }
    const p = this.coefficients;
    for (let i = 0; i < out.length; i++) {
      const high = p[3]![i]! + s * (p[4]![i]! + r * (p[5]![i]! + s * p[6]![i]!));
      out[i] = this.y0[i]! + s * (p[0]![i]! + r * (p[1]![i]! + s * (p[2]![i]! + r * high)));
    }
  }

  private f(t: number, y: Float64Array, out: Float64Array): boolean {
    this.counters.evaluations++;
    return this.problem.derivative(t, y, out);
  }

  private lastSlope(h: number): boolean {
    const { problem, yNew, k } = this;
    const t = this.t + h;
    return (!problem.project || problem.project(t, yNew)) && this.f(t, yNew, k[STAGES]!) && allFinite(k[STAGES]!);
  }

  /** Stages 2 to 12 and the new state. */
  private stages(h: number): boolean {
    const { k, y, yNew } = this;
    for (let s = 1; s < STAGES; s++) {
      stageState(y, h, A[s]!, k, yNew);
      if (!this.f(this.t + C[s]! * h, yNew, k[s]!)) return false;
    }
    stageState(y, h, A[STAGES]!, k, yNew);
    return true;
  }

  /** Scaled error of the step, to be at most 1; infinite when anything is not a number. */
  private errorOf(h: number): number {
    const { k, y, yNew, errors } = this;
    const [e5, e3] = errors;
    const { rtol, atol } = this.options;
    weightedSum(E5, k, e5);
    weightedSum(E3, k, e3);
    let fifth = 0;
    let third = 0;
    for (let i = 0; i < y.length; i++) {
      const scale = atol + rtol * Math.max(Math.abs(y[i]!), Math.abs(yNew[i]!));
      fifth += (e5[i]! / scale) ** 2;
      third += (e3[i]! / scale) ** 2;
    }
    if (fifth === 0 && third === 0) return 0;
    const error = (h * fifth) / Math.sqrt((fifth + 0.01 * third) * y.length);
    return error === error ? error : Infinity;
  }

  private accept(h: number, limit: number, error: number): void {
    const { k, kept } = this;
    this.previousT = this.t;
    this.stepTaken = h;
    this.t = h === limit - this.t ? limit : this.t + h;
    this.y0.set(this.y);
    this.y1.set(this.yNew);
    this.y.set(this.yNew);
    this.k = kept;
    this.kept = k;
    this.k[0]!.set(k[STAGES]!);
    this.dense = 'none';
    this.counters.steps++;
    // A step cut short by the limit says nothing about how long the next may be.
    const next = h * this.controller.accept(error);
    this.h = h < this.h ? Math.max(this.h, next) : next;
  }

  /** The three more slopes and the seven coefficients of the continuous output of the last accepted step. */
  private extend(): boolean {
    const { kept: k, y0, y1, stepTaken: h, coefficients: p } = this;
    for (let s = STAGES + 1; s < EXTENDED; s++) {
      stageState(y0, h, A[s]!, k, this.scratch);
      if (!this.f(this.previousT + C[s]! * h, this.scratch, k[s]!) || !allFinite(k[s]!)) return false;
    }
    const first = k[0]!;
    const last = k[STAGES]!;
    for (let c = 0; c < D.length; c++) weightedSum(D[c]!, k, p[3 + c]!);
    for (let i = 0; i < y0.length; i++) {
      const difference = y1[i]! - y0[i]!;
      const bulge = h * first[i]! - difference;
      p[0]![i] = difference;
      p[1]![i] = bulge;
      p[2]![i] = difference - h * last[i]! - bulge;
      for (let c = 0; c < D.length; c++) p[3 + c]![i]! *= h;
    }
    return true;
  }
}
