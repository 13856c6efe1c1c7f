import { AdaptiveStepper } from './adaptiveStepper.ts';
import { allFinite } from './finite.ts';
import { firstStep, PiController } from './stepControl.ts';
import type { OdeProblem, StepFailure, StepperOptions } from '../contract.ts';

/**
 * What adaptive one-step methods for y' = f(t, y) have in common: the slope at the start of a step, made once, the choice
 * of the first step, and a PI controller for the others.
 */
export abstract class AdaptiveOneStep extends AdaptiveStepper {
  protected readonly problem: OdeProblem;
  /** The end of the step being tried. */
  protected yNew: Float64Array;
  protected readonly error: Float64Array;
  /** `startSlope` is f(t, y). */
  protected fresh = false;
  protected readonly controller: PiController;
  private readonly startOrder: number;
  /** The step is not to be trusted: it was chosen before a jump. */
  private restarted = false;

  /**
   * @param errorOrder the power of h that the error estimate follows
   * @param startOrder order of the method, for the choice of the first step
   */
  protected constructor(problem: OdeProblem, options: StepperOptions, errorOrder: number, startOrder: number) {
    super(problem.dimension, options);
    this.problem = problem;
    this.startOrder = startOrder;
    this.controller = new PiController(errorOrder);
    this.yNew = new Float64Array(problem.dimension);
    this.error = new Float64Array(problem.dimension);
  }

  /** Holds f(t, y) once `fresh`, n. */
  protected abstract get startSlope(): Float64Array;

  protected get reason(): string | null {
    return this.problem.failure;
  }

  override reset(t: number, y: Float64Array): void {
    super.reset(t, y);
    this.fresh = false;
    this.restarted = false;
    this.controller.reset();
  }

  stateChanged(): void {
    this.fresh = false;
  }

  restart(): void {
    this.fresh = false;
    this.restarted = true;
    this.controller.reset();
  }

  protected begin(longest: number): StepFailure | null {
    const failure = this.beginSlope();
    if (failure) return failure;
    if (this.h > 0 && !this.restarted) return null;
    const { rtol, atol } = this.options;
    const f = (t: number, y: Float64Array, out: Float64Array): boolean => this.f(t, y, out);
    const scratch = [this.yNew, this.error] as const;
    const first = firstStep(f, this.t, this.y, this.startSlope, this.startOrder, rtol, atol, scratch, longest);
    this.h = this.h > 0 ? Math.min(this.h, first) : first;
    this.restarted = false;
    return null;
  }

  /** f(t, y), unless it is there. */
  protected beginSlope(): StepFailure | null {
    if (this.fresh) return null;
    if (!this.f(this.t, this.y, this.startSlope)) return this.reason ?? 'non-finite';
    if (!allFinite(this.startSlope)) return 'non-finite';
    this.fresh = true;
    return null;
  }

  protected retry(h: number, error: number, _tries: number): number {
    return h * this.controller.reject(error);
  }

  /**
   * Sets the length of the next step.
   * @param effort factor of at most 1 for a step that took more iterations than others
   */
  protected chooseNext(h: number, error: number, effort: number): void {
    const next = h * this.controller.accept(error) * effort;
    // A step cut short by the limit or its bound says nothing about how long the next may be.
    this.h = h < this.h ? Math.max(this.h, next) : next;
  }

  protected f(t: number, y: Float64Array, out: Float64Array): boolean {
    this.counters.evaluations++;
    return this.problem.derivative(t, y, out);
  }
}
