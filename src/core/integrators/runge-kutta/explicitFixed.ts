import { zeroCounters, type OdeProblem, type StepFailure, type Stepper, type StepperOptions } from '../contract.ts';

/**
 * Explicit methods of fixed step: Euler's (order 1) and the classical Runge-Kutta method (order 4).
 *
 * Hairer, Nørsett and Wanner, Solving ODEs I, 2nd ed., section II.1 ("the" Runge-Kutta
 * method of order 4). Between steps: the chord for Euler (order 1), and the cubic Hermite polynomial of
 * section II.6, eq. (6.7) for Runge-Kutta, which is of order 3: its error within one step is O(h^4), as much
 * as the steps themselves leave behind over the whole run.
 *
 * Not guaranteed: any accuracy. No error is estimated, `rtol` and `atol` are not read, and a step beyond the
 * limit of stability grows until it is not finite.
 */

/** Of the order of a thousandth of a second: bodies of hand size at walking speed move a few millimetres. */
export const DEFAULT_STEP = 1e-3;

/** A step that would end within this fraction of itself before the limit is stretched to it. */
const STRETCH = 1.01;

/** The fixed step, or what is left to the limit if the step would end near or beyond it. */
export function fixedStep(options: StepperOptions, left: number): number {
  const h = Math.min(options.step ?? DEFAULT_STEP, options.maxStep ?? Infinity);
  return STRETCH * h >= left ? left : h;
}

export function allFinite(x: Float64Array): boolean {
  let sum = 0;
  // 0 * x is NaN for what is infinite or NaN already, and 0 for everything else.
  for (let i = 0; i < x.length; i++) sum += 0 * x[i]!;
  return sum === 0;
}

/**
 * Cubic Hermite polynomial at the fraction `s` of a step `h` from (y0, f0) to (y1, f1), into `out`;
 * Hairer, Nørsett and Wanner I, eq. (II.6.7).
 */
export function hermite(
  s: number,
  h: number,
  y0: Float64Array,
  f0: Float64Array,
  y1: Float64Array,
  f1: Float64Array,
  out: Float64Array,
): void {
  const r = 1 - s;
  for (let i = 0; i < out.length; i++) {
    const difference = y1[i]! - y0[i]!;
    const bend = r * (h * f0[i]! - difference) - s * (h * f1[i]! - difference);
    out[i] = y0[i]! + s * (difference + r * bend);
  }
}

/** What a family of fixed step leaves open: how `yNew` comes from `y`, and what lies between. */
abstract class ExplicitFixed implements Stepper {
  t = 0;
  previousT = 0;
  readonly y: Float64Array;
  readonly counters = zeroCounters();

  protected readonly problem: OdeProblem;
  private readonly options: StepperOptions;
  /** Ends of the last accepted step, and f there; `y` itself may be moved afterwards. */
  protected readonly y0: Float64Array;
  protected readonly y1: Float64Array;
  protected readonly f0: Float64Array;
  protected readonly f1: Float64Array;
  /** f at `y` for the step being tried. */
  protected readonly fStart: Float64Array;
  protected readonly yNew: Float64Array;
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
    this.yNew = this.vector();
  }

  /** `yNew` and, if the method keeps it, f there into `fEnd`; false where f has no value. */
  protected abstract advance(h: number): boolean;
  /** The method has left f(t + h, yNew) in `fEnd`. */
  protected abstract readonly endsWithSlope: boolean;
  protected abstract readonly fEnd: Float64Array;
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

  step(limit: number): StepFailure | null {
    const { y, yNew } = this;
    const h = fixedStep(this.options, limit - this.t);
    if (!(this.t + h > this.t)) return 'step-too-small';
    if (!this.fresh && !this.f(this.t, y, this.fStart)) return this.problem.failure ?? 'non-finite';
    this.fresh = true;
    if (!this.advance(h)) return this.problem.failure ?? 'non-finite';
    if (!allFinite(yNew) || (this.endsWithSlope && !allFinite(this.fEnd))) return 'non-finite';
    this.previousT = this.t;
    this.stepTaken = h;
    this.t = h === limit - this.t ? limit : this.t + h;
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

  protected vector(): Float64Array {
    return new Float64Array(this.problem.dimension);
  }

  /** Where `t` lies in the last step, from 0 to 1. */
  protected fraction(t: number): number {
    return this.stepTaken > 0 ? (t - this.previousT) / this.stepTaken : 1;
  }
}

/** y1 = y0 + h f(t0, y0). */
export class Euler extends ExplicitFixed {
  protected readonly endsWithSlope = false;
  protected readonly fEnd = this.f1;

  protected advance(h: number): boolean {
    const { y, yNew, fStart } = this;
    for (let i = 0; i < y.length; i++) yNew[i] = y[i]! + h * fStart[i]!;
    return true;
  }

  interpolate(t: number, out: Float64Array): void {
    const s = this.fraction(t);
    for (let i = 0; i < out.length; i++) out[i] = (1 - s) * this.y0[i]! + s * this.y1[i]!;
  }
}

/** Four stages at 0, 1/2, 1/2, 1; the slope at the end serves the polynomial and is the next step's first stage. */
export class Rk4 extends ExplicitFixed {
  protected readonly endsWithSlope = true;
  protected readonly fEnd = this.vector();
  private readonly k2 = this.vector();
  private readonly k3 = this.vector();
  private readonly k4 = this.vector();

  protected advance(h: number): boolean {
    const { t, yNew, fStart: k1, k2, k3, k4 } = this;
    this.move(h / 2, k1);
    if (!this.f(t + h / 2, yNew, k2)) return false;
    this.move(h / 2, k2);
    if (!this.f(t + h / 2, yNew, k3)) return false;
    this.move(h, k3);
    if (!this.f(t + h, yNew, k4)) return false;
    for (let i = 0; i < yNew.length; i++) {
      yNew[i] = this.y[i]! + (h / 6) * (k1[i]! + 2 * (k2[i]! + k3[i]!) + k4[i]!);
    }
    return this.f(t + h, yNew, this.fEnd);
  }

  interpolate(t: number, out: Float64Array): void {
    hermite(this.fraction(t), this.stepTaken, this.y0, this.f0, this.y1, this.f1, out);
  }

  /** yNew = y + h k. */
  private move(h: number, k: Float64Array): void {
    for (let i = 0; i < k.length; i++) this.yNew[i] = this.y[i]! + h * k[i]!;
  }
}
