import { allFinite } from './finite.ts';
import { fixedWithin } from './stepControl.ts';
import { zeroCounters, type OdeProblem, type StepFailure, type Stepper, type StepperOptions } from '../contract.ts';

/**
 * What methods of fixed step have in common; a method says how it advances and what lies between the ends.
 *
 * Not guaranteed: any accuracy. No error is estimated, `rtol` and `atol` are not read, and a step beyond the
 * limit of stability grows until it is not finite.
 */

/** Of the order of a thousandth of a second: bodies of hand size at walking speed move a few millimetres. s */
export const DEFAULT_STEP = 1e-3;

export abstract class FixedStepper implements Stepper {
  t = 0;
  previousT = 0;
  readonly y: Float64Array;
  readonly counters = zeroCounters();

  protected readonly problem: OdeProblem;
  protected readonly options: StepperOptions;
  /** Ends of the last accepted step, and f there; `y` itself may be moved afterwards. */
  protected readonly y0: Float64Array;
  protected readonly y1: Float64Array;
  protected readonly f0: Float64Array;
  protected readonly f1: Float64Array;
  /** f at `y` for the step being tried, and at its end where the method makes it. */
  protected readonly fStart: Float64Array;
  protected readonly fEnd: Float64Array;
  protected readonly yNew: Float64Array;
  /** Length of the last accepted step, s; 0 before the first. */
  protected stepTaken = 0;
  /** `fStart` is f(t, y). */
  private fresh = false;

  constructor(problem: OdeProblem, options: StepperOptions) {
    this.problem = problem;
    this.options = options;
    this.y = this.vector();
    this.y0 = this.vector();
    this.y1 = this.vector();
    this.f0 = this.vector();
    this.f1 = this.vector();
    this.fStart = this.vector();
    this.fEnd = this.vector();
    this.yNew = this.vector();
  }

  /** The method leaves f(t + h, yNew) in `fEnd`. */
  protected abstract readonly endsWithSlope: boolean;
  /**
   * `yNew`, and f there into `fEnd` if the method makes it.
   * @param h length of the step, s
   * @returns null, or why there is none
   */
  protected abstract advance(h: number): StepFailure | null;
  abstract interpolate(t: number, out: Float64Array): void;

  reset(t: number, y: Float64Array): void {
    this.t = this.previousT = t;
    this.y.set(y);
    this.y0.set(y);
    this.y1.set(y);
    this.stepTaken = 0;
    this.fresh = false;
    Object.assign(this.counters, zeroCounters());
  }

  stateChanged(): void {
    this.fresh = false;
  }

  restart(): void {
    this.fresh = false;
  }

  step(limit: number, maxStep = Infinity): StepFailure | null {
    const { y, yNew, options } = this;
    const left = limit - this.t;
    const most = Math.min(maxStep, options.maxStep ?? Infinity);
    const h = fixedWithin(options.step ?? DEFAULT_STEP, left, most);
    if (!(this.t + h > this.t)) return 'step-too-small';
    if (!this.fresh) {
      if (!this.f(this.t, y, this.fStart)) return this.noValue();
      if (!allFinite(this.fStart)) return 'non-finite';
      this.fresh = true;
    }
    const failure = this.advance(h);
    if (failure) return failure;
    if (!allFinite(yNew) || (this.endsWithSlope && !allFinite(this.fEnd))) return 'non-finite';
    this.previousT = this.t;
    this.stepTaken = h;
    this.t = h === left ? limit : this.t + h;
    this.y0.set(y);
    this.y1.set(yNew);
    y.set(yNew);
    this.f0.set(this.fStart);
    this.fresh = this.endsWithSlope;
    if (this.endsWithSlope) {
      this.f1.set(this.fEnd);
      this.fStart.set(this.fEnd);
    }
    this.counters.steps++;
    return null;
  }

  protected f(t: number, y: Float64Array, out: Float64Array): boolean {
    this.counters.evaluations++;
    return this.problem.derivative(t, y, out);
  }

  /** What a step is called that failed because f has no value. */
  protected noValue(): StepFailure {
    return this.problem.failure ?? 'non-finite';
  }

  protected vector(): Float64Array {
    return new Float64Array(this.problem.dimension);
  }

  /** Where a time lies in the last step: 0 at its start, 1 at its end. */
  protected fraction(t: number): number {
    return this.stepTaken > 0 ? (t - this.previousT) / this.stepTaken : 1;
  }
}
