import { stageState, weightedSum } from '../shared/combine.ts';
import { zeroCounters, type OdeProblem, type StepFailure, type Stepper, type StepperOptions } from '../contract.ts';
import { errorNorm, firstStep, PiController, stepWithin } from '../shared/stepControl.ts';

/**
 * Dormand and Prince's explicit Runge-Kutta method of order 5(4), with continuous output of order 4.
 *
 * J. R. Dormand, P. J. Prince, "A family of embedded Runge-Kutta formulae", J. Comp. Appl. Math. 6 (1980);
 * coefficients from Hairer, Nørsett and Wanner, Solving ODEs I, 2nd ed., table II.5.2; dense output from
 * section II.6 (Shampine's, as in the authors' DOPRI5).
 *
 * Not guaranteed: efficiency on stiff problems (no stiffness detection; the step count tells).
 */

const C = [0, 1 / 5, 3 / 10, 4 / 5, 8 / 9, 1, 1] as const;
const A = [
  [],
  [1 / 5],
  [3 / 40, 9 / 40],
  [44 / 45, -56 / 15, 32 / 9],
  [19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729],
  [9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656],
  [35 / 384, 0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84],
] as const;
/** b - b_hat: weights of the error estimate. */
const E = [71 / 57600, 0, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40] as const;
/** Dense output's fifth coefficient. */
const D = [
  -12715105075 / 11282082432,
  0,
  87487479700 / 32700410799,
  -10690763975 / 1880347072,
  701980252875 / 199316789632,
  -1453857185 / 822651844,
  69997945 / 29380423,
] as const;
const STAGES = 7;
const ORDER = 5;

/** A step below this many units in the last place of t cannot advance it reliably. */
const SMALLEST_ULPS = 16;

export class Dopri5 implements Stepper {
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
  private readonly error: Float64Array;
  /** Coefficients of the dense output, made when first asked for: most steps are never looked into. */
  private readonly dense: [Float64Array, Float64Array, Float64Array, Float64Array, Float64Array];
  private denseMade = false;
  private h = 0;
  private stepTaken = 0;
  private fresh = false;

  constructor(problem: OdeProblem, options: StepperOptions) {
    const vector = (): Float64Array => new Float64Array(problem.dimension);
    const slopes = (): Float64Array[] => Array.from({ length: STAGES }, vector);
    this.problem = problem;
    this.options = options;
    this.y = vector();
    this.yNew = vector();
    this.error = vector();
    this.k = slopes();
    this.kept = slopes();
    this.dense = [vector(), vector(), vector(), vector(), vector()];
  }

  reset(t: number, y: Float64Array): void {
    this.t = this.previousT = t;
    this.y.set(y);
    this.h = this.options.step ?? 0;
    this.fresh = false;
    this.controller.reset();
    Object.assign(this.counters, zeroCounters());
  }

  stateChanged(): void {
    this.fresh = false;
  }

  step(limit: number): StepFailure | null {
    const { k, y, yNew, options, counters } = this;
    if (!this.fresh && !this.f(this.t, y, k[0]!)) return this.problem.failure ?? 'non-finite';
    this.fresh = true;
    if (!(this.h > 0)) {
      this.h = firstStep((t, x, out) => this.f(t, x, out), this.t, y, k[0]!, ORDER, options.rtol, options.atol, [
        yNew,
        this.error,
      ]);
    }
    const smallest = SMALLEST_ULPS * Number.EPSILON * Math.max(Math.abs(this.t), Math.abs(limit - this.t));
    for (;;) {
      const h = stepWithin(this.h, limit - this.t, this.options.maxStep ?? Infinity);
      // An evaluation that has no value counts as an error without bound: a shorter step may go around it.
      const error = this.stages(h) ? errorNorm(this.error, y, yNew, options.rtol, options.atol) : Infinity;
      if (error <= 1) {
        this.accept(h, limit, error);
        return null;
      }
      counters.rejected++;
      this.h = h * this.controller.reject(error);
      if (!(this.h > smallest)) return error < Infinity ? 'step-too-small' : (this.problem.failure ?? 'non-finite');
    }
  }

  interpolate(t: number, out: Float64Array): void {
    if (!this.denseMade) this.makeDense();
    const s = (t - this.previousT) / this.stepTaken;
    const r = 1 - s;
    const [r1, r2, r3, r4, r5] = this.dense;
    for (let i = 0; i < out.length; i++) {
      out[i] = r1[i]! + s * (r2[i]! + r * (r3[i]! + s * (r4[i]! + r * r5[i]!)));
    }
  }

  private f(t: number, y: Float64Array, out: Float64Array): boolean {
    this.counters.evaluations++;
    return this.problem.derivative(t, y, out);
  }

  /** Stages 2 to 7, the new state and the error estimate. The seventh stage is the next step's first. */
  private stages(h: number): boolean {
    const { k, y, yNew, error, problem } = this;
    for (let s = 1; s < STAGES; s++) {
      stageState(y, h, A[s]!, k, yNew);
      if (s === STAGES - 1 && problem.project && !problem.project(this.t + h, yNew)) return false;
      if (!this.f(this.t + C[s]! * h, yNew, k[s]!)) return false;
    }
    weightedSum(E, k, error);
    for (let i = 0; i < y.length; i++) error[i]! *= h;
    return true;
  }

  private accept(h: number, limit: number, error: number): void {
    const { k, kept, y, yNew, dense } = this;
    dense[0].set(y);
    dense[1].set(yNew);
    this.denseMade = false;
    this.previousT = this.t;
    this.stepTaken = h;
    this.t = h === limit - this.t ? limit : this.t + h;
    y.set(yNew);
    this.k = kept;
    this.kept = k;
    kept[0]!.set(k[6]!);
    this.counters.steps++;
    // A step cut short by the limit says nothing about how long the next may be.
    const next = h * this.controller.accept(error);
    this.h = h < this.h ? Math.max(this.h, next) : next;
  }

  /** Of the last accepted step, whose two ends wait in the first two coefficients. */
  private makeDense(): void {
    const { kept: k, stepTaken: h } = this;
    const [r1, r2, r3, r4, r5] = this.dense;
    const first = k[0]!;
    const last = k[6]!;
    weightedSum(D, k, r5);
    for (let i = 0; i < r1.length; i++) {
      const difference = r2[i]! - r1[i]!;
      const bulge = h * first[i]! - difference;
      r2[i] = difference;
      r3[i] = bulge;
      r4[i] = difference - h * last[i]! - bulge;
      r5[i]! *= h;
    }
    this.denseMade = true;
  }
}
