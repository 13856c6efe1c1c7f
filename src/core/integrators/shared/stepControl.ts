/**
 * Step size control for embedded methods.
 *
 * PI controller: Hairer and Wanner, Solving ODEs II, 2nd ed., section IV.2, eq. (2.43c) and (2.48), with
 * Gustafsson's constants as used by DOPRI5. Error norm: Hairer, Nørsett and Wanner, Solving ODEs I,
 * 2nd ed., section II.4, eq. (4.10), (4.11).
 */

/** A step may shrink to a fifth and grow tenfold at once; 0.9 leaves room so that few steps are rejected. */
const SAFETY = 0.9;
const SHRINK_MOST = 0.2;
const GROW_MOST = 10;
/** Weight of the previous error; 0.04 is DOPRI5's choice for stability on mildly stiff problems. */
const BETA = 0.04;

export class PiController {
  private readonly exponent: number;
  private lastError = 1e-4;
  private rejectedLast = false;

  /** @param order the order of the error estimate plus one, k in err ~ h^k */
  constructor(order: number) {
    this.exponent = 1 / order - 0.75 * BETA;
  }

  reset(): void {
    this.lastError = 1e-4;
    this.rejectedLast = false;
  }

  /** Factor for the next step after an accepted one with scaled error `error` (<= 1). */
  accept(error: number): number {
    const base = error > 0 ? SAFETY * Math.pow(error, -this.exponent) * Math.pow(this.lastError, BETA) : GROW_MOST;
    const factor = Math.min(this.rejectedLast ? 1 : GROW_MOST, Math.max(SHRINK_MOST, base));
    this.lastError = Math.max(error, 1e-4);
    this.rejectedLast = false;
    return factor;
  }

  /** Factor for trying again after a rejected step. */
  reject(error: number): number {
    this.rejectedLast = true;
    return error < Infinity ? Math.max(SHRINK_MOST, SAFETY * Math.pow(error, -this.exponent)) : SHRINK_MOST;
  }
}

/** Root mean square of error / (atol + rtol max(|y0|, |y1|)); infinite when anything is not a number. */
export function errorNorm(error: Float64Array, y0: Float64Array, y1: Float64Array, rtol: number, atol: number): number {
  let sum = 0;
  for (let i = 0; i < error.length; i++) {
    const r = error[i]! / (atol + rtol * Math.max(Math.abs(y0[i]!), Math.abs(y1[i]!)));
    sum += r * r;
  }
  const norm = Math.sqrt(sum / error.length);
  return norm === norm ? norm : Infinity;
}

/**
 * The step to try when `left` remains to the limit: at most `most`, and stretched by up to 1 % or halved where it would
 * leave a sliver before the limit.
 */
export function stepWithin(h: number, left: number, most: number): number {
  const step = Math.min(h, most);
  if (1.01 * step >= left) return left;
  return 2 * step > left ? left / 2 : step;
}

/**
 * First step of an explicit method of order p: Hairer, Nørsett and Wanner I, section II.4, "Starting step size".
 * `f0` = f(t0, y0); `scratch` holds two vectors; `f(t, y, out)` may fail, then the cautious guess stands.
 */
export function firstStep(
  f: (t: number, y: Float64Array, out: Float64Array) => boolean,
  t0: number,
  y0: Float64Array,
  f0: Float64Array,
  order: number,
  rtol: number,
  atol: number,
  scratch: readonly [Float64Array, Float64Array],
): number {
  const [y1, f1] = scratch;
  const norm = (x: Float64Array, minus?: Float64Array): number => {
    let sum = 0;
    for (let i = 0; i < x.length; i++) {
      const r = (x[i]! - (minus ? minus[i]! : 0)) / (atol + rtol * Math.abs(y0[i]!));
      sum += r * r;
    }
    return Math.sqrt(sum / x.length);
  };
  const d0 = norm(y0);
  const d1 = norm(f0);
  const h0 = d0 < 1e-5 || d1 < 1e-5 ? 1e-6 : (0.01 * d0) / d1;
  for (let i = 0; i < y0.length; i++) y1[i] = y0[i]! + h0 * f0[i]!;
  if (!f(t0 + h0, y1, f1)) return h0;
  const d2 = norm(f1, f0) / h0;
  const steepest = Math.max(d1, d2);
  const h1 = steepest <= 1e-15 ? Math.max(1e-6, h0 * 1e-3) : Math.pow(0.01 / steepest, 1 / (order + 1));
  return Math.min(100 * h0, h1);
}
