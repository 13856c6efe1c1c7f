import type { StepFailure } from '../contract.ts';
import { FixedStepper } from '../shared/fixedStepper.ts';
import { hermite, linear } from '../shared/interpolation.ts';

/**
 * Explicit methods of fixed step: Euler's (order 1) and the classical Runge-Kutta method (order 4).
 *
 * Hairer, Nørsett and Wanner, Solving ODEs I, 2nd ed., section II.1 ("the" Runge-Kutta
 * method of order 4). Between steps: the chord for Euler (order 1), and the cubic Hermite polynomial for Runge-Kutta, which is
 * of order 3: its error within one step is O(h^4), as much as the steps themselves leave behind over the whole run.
 *
 * Not guaranteed: any accuracy (`fixedStepper.ts`).
 */

/** y1 = y0 + h f(t0, y0). */
export class Euler extends FixedStepper {
  protected readonly endsWithSlope = false;

  protected advance(h: number): null {
    const { y, yNew, fStart } = this;
    for (let i = 0; i < y.length; i++) yNew[i] = y[i]! + h * fStart[i]!;
    return null;
  }

  interpolate(t: number, out: Float64Array): void {
    linear(this.fraction(t), this.y0, this.y1, out);
  }
}

/** Four stages at 0, 1/2, 1/2, 1; the slope at the end serves the polynomial and is the next step's first stage. */
export class Rk4 extends FixedStepper {
  protected readonly endsWithSlope = true;
  private readonly k2 = this.vector();
  private readonly k3 = this.vector();
  private readonly k4 = this.vector();

  protected advance(h: number): StepFailure | null {
    const { t, yNew, fStart: k1, k2, k3, k4 } = this;
    this.move(h / 2, k1);
    if (!this.f(t + h / 2, yNew, k2)) return this.noValue();
    this.move(h / 2, k2);
    if (!this.f(t + h / 2, yNew, k3)) return this.noValue();
    this.move(h, k3);
    if (!this.f(t + h, yNew, k4)) return this.noValue();
    for (let i = 0; i < yNew.length; i++) {
      yNew[i] = this.y[i]! + (h / 6) * (k1[i]! + 2 * (k2[i]! + k3[i]!) + k4[i]!);
    }
    return this.f(t + h, yNew, this.fEnd) ? null : this.noValue();
  }

  interpolate(t: number, out: Float64Array): void {
    hermite(this.fraction(t), this.stepTaken, this.y0, this.f0, this.y1, this.f1, out);
  }

  /** yNew = y + h k. */
  private move(h: number, k: Float64Array): void {
    for (let i = 0; i < k.length; i++) this.yNew[i] = this.y[i]! + h * k[i]!;
  }
}
