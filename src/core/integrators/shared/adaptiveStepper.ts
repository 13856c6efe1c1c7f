import type { NewtonOutcome } from './newton.ts';
import { smallestStep, stepWithin } from './stepControl.ts';
import { zeroCounters, type Counters, type StepFailure, type Stepper, type StepperOptions } from '../contract.ts';

/**
 * The one loop of every method that chooses its steps: try a step of length h from (t, y), take it if its scaled error is
 * at most 1, else try a shorter one, and give up where t would hardly move.
 *
 * A family says what a try is (`attempt`), how much shorter the next one is (`retry`) and what is kept of an accepted step
 * (`accept`). See `adaptiveOneStep.ts` for what one-step methods have in common beyond that.
 */
export abstract class AdaptiveStepper implements Stepper {
  t = 0;
  previousT = 0;
  readonly y: Float64Array;
  readonly counters: Counters;

  protected readonly options: StepperOptions;
  /** Length of the step to try next, s; 0: to be chosen. */
  protected h = 0;
  /** Length of the last accepted step, s; 0 before the first. */
  protected stepTaken = 0;
  /** How Newton's method ended in the last attempt, where there is one. */
  protected outcome: NewtonOutcome = 'converged';

  /**
   * @param dimension n
   * @param counters those that the equations count in, where they do
   */
  protected constructor(dimension: number, options: StepperOptions, counters: Counters = zeroCounters()) {
    this.options = options;
    this.counters = counters;
    this.y = new Float64Array(dimension);
  }

  /** Why the equations had no value, where they say so. */
  protected abstract get reason(): string | null;
  /**
   * Before the first try of a step: f at (t, y), and `h` where it is 0.
   * @param longest length that the step may have at most, s
   */
  protected abstract begin(longest: number): StepFailure | null;
  /**
   * Tries a step.
   * @param h its length, s
   * @param end where it ends, s: t + h but for rounding
   * @returns its scaled error; infinite if there is none
   */
  protected abstract attempt(h: number, end: number): number;
  /**
   * Length for the next try; 0 gives up.
   * @param h length of the try that failed, s
   * @param error its scaled error
   * @param tries failed tries of this step
   */
  protected abstract retry(h: number, error: number, tries: number): number;
  /** Moves `y` to the end of the tried step; `t`, `previousT` and `stepTaken` are moved already. Sets the next `h`. */
  protected abstract accept(h: number, error: number): void;
  abstract interpolate(t: number, out: Float64Array): void;
  abstract stateChanged(): void;
  abstract restart(): void;

  reset(t: number, y: Float64Array): void {
    this.t = this.previousT = t;
    this.y.set(y);
    this.stepTaken = 0;
    this.h = this.options.step ?? 0;
    this.outcome = 'converged';
    Object.assign(this.counters, zeroCounters());
  }

  step(limit: number, maxStep = Infinity): StepFailure | null {
    const most = this.bound(maxStep);
    const left = limit - this.t;
    const failure = this.begin(Math.min(left, most));
    if (failure) return failure;
    const smallest = smallestStep(this.t, left);
    for (let tries = 1; ; tries++) {
      const h = stepWithin(this.h, left, most);
      const end = h === left ? limit : this.t + h;
      if (!(end > this.t)) return 'step-too-small';
      const error = this.attempt(h, end);
      if (error <= 1) {
        this.previousT = this.t;
        this.stepTaken = h;
        this.t = end;
        this.counters.steps++;
        this.accept(h, error);
        return null;
      }
      this.counters.rejected++;
      this.h = this.retry(h, error, tries);
      if (!(this.h > smallest)) return this.failure(error);
    }
  }

  /** The smaller of a step's own upper bound and that of the options, s. */
  protected bound(maxStep: number): number {
    return Math.min(maxStep, this.options.maxStep ?? Infinity);
  }

  /** Name of the failure of an attempt with a scaled error of more than 1. */
  protected failure(error: number): StepFailure {
    if (this.outcome === 'slow') return 'newton';
    return error < Infinity ? 'step-too-small' : (this.reason ?? 'non-finite');
  }

  /** Where a time lies in the last accepted step: 0 at its start, 1 at its end. */
  protected fraction(t: number): number {
    return this.stepTaken > 0 ? (t - this.previousT) / this.stepTaken : 1;
  }
}
