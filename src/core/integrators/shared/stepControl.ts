/**
 * Step size control for embedded methods.
 *
 * PI controller: Hairer and Wanner, Solving ODEs II, 2nd ed., section IV.2, eq. (2.43c) and (2.48), with
 * Gustafsson's constants as used by DOPRI5. Error norm: Hairer, Nørsett and Wanner, Solving ODEs I,
 * 2nd ed., section II.4, eq. (4.10), (4.11).
 */
import { power } from '../../elementary/powers.ts';

/** A step may shrink to a fifth and grow tenfold at once; 0.9 leaves room so that few steps are rejected. */
export const SAFETY = 0.9;
export const SHRINK_MOST = 0.2;
export const GROW_MOST = 10;
/** Weight of the previous error; 0.04 is DOPRI5's choice for stability on mildly stiff problems. */
export const BETA = 0.04;
/** The controller takes no error for smaller than this. */
export const LEAST_ERROR = 1e-4;

/** @param order the order of the error estimate plus one, k in err ~ h^k */
export const piExponent = (order: number): number => 1 / order - 0.75 * BETA;

/** A step below this many units in the last place of t cannot advance it reliably. */
export const SMALLEST_ULPS = 16;
/** First step where f is not a number near the start, so that its size says nothing. */
const CAUTIOUS_STEP = 1e-6;
/** A step that would end within this fraction of itself before the limit is stretched to it, as far as its bound allows. */
export const STRETCH = 1.01;
/** Many equal steps, as long as their bound, miss the limit by rounding: this much longer is as long as the bound. */
export const STEP_ROUNDING = 1 + 1e-6;

export class PiController {
  private readonly exponent: number;
  /** Of the last accepted step. */
  lastError = LEAST_ERROR;
  private rejectedLast = false;

  /** @param order the order of the error estimate plus one, k in err ~ h^k */
  constructor(order: number) {
    this.exponent = piExponent(order);
  }

  reset(): void {
    this.lastError = LEAST_ERROR;
    this.rejectedLast = false;
  }

  /**
   * Factor for the next step after an accepted one.
   * @param error scaled error, at most 1
   */
  accept(error: number): number {
    const base = error > 0 ? SAFETY * power(error, -this.exponent) * power(this.lastError, BETA) : GROW_MOST;
    const factor = Math.min(this.rejectedLast ? 1 : GROW_MOST, Math.max(SHRINK_MOST, base));
    this.lastError = Math.max(error, LEAST_ERROR);
    this.rejectedLast = false;
    return factor;
  }

  /**
   * Factor for trying again after a rejected step.
   * @param error scaled error, more than 1; infinite where there was no value
   */
  reject(error: number): number {
    this.rejectedLast = true;
    return error < Infinity ? Math.max(SHRINK_MOST, SAFETY * power(error, -this.exponent)) : SHRINK_MOST;
  }
}

/**
 * Root mean square of h error / (atol + rtol max(|y0|, |y1|)); infinite when anything is not a number.
 *
 * @param error error estimate divided by h, n
 * @param h length of the step, s; 1 where `error` is the whole
 * @param y0 start of the step, n
 * @param y1 end of the step, n
 * @param rtol relative tolerance
 * @param atol absolute tolerance, in the state's own units
 */
export function errorNorm(
  error: Float64Array,
  h: number,
  y0: Float64Array,
  y1: Float64Array,
  rtol: number,
  atol: number,
): number {
  let sum = 0;
  for (let i = 0; i < error.length; i++) {
    const r = (h * error[i]!) / (atol + rtol * Math.max(Math.abs(y0[i]!), Math.abs(y1[i]!)));
    sum += r * r;
  }
  const norm = Math.sqrt(sum / error.length);
  return norm === norm ? norm : Infinity;
}

/**
 * Norm of two estimates that falls by an order faster than either: h e^2 / sqrt(e^2 + 0.01 e_low^2), as in DOP853; Hairer,
 * Nørsett and Wanner I, section II.10. Infinite when anything is not a number.
 *
 * @param error estimate of high order divided by h, n
 * @param low estimate of low order divided by h, n
 * @param h length of the step, s
 * @param y0 start of the step, n
 * @param y1 end of the step, n
 * @param rtol relative tolerance
 * @param atol absolute tolerance, in the state's own units
 */
export function pairedErrorNorm(
  error: Float64Array,
  low: Float64Array,
  h: number,
  y0: Float64Array,
  y1: Float64Array,
  rtol: number,
  atol: number,
): number {
  let high = 0;
  let lower = 0;
  for (let i = 0; i < error.length; i++) {
    const scale = atol + rtol * Math.max(Math.abs(y0[i]!), Math.abs(y1[i]!));
    const e = error[i]! / scale;
    const l = low[i]! / scale;
    high += e * e;
    lower += l * l;
  }
  if (high === 0 && lower === 0) return 0;
  const norm = (h * high) / Math.sqrt((high + 0.01 * lower) * error.length);
  return norm === norm ? norm : Infinity;
}

/**
 * The step to try: at most `most`, and stretched by up to 1 % or halved where it would leave a sliver before the limit.
 * @param h length wished for, s
 * @param left time to the limit, s
 * @param most upper bound, s
 */
export function stepWithin(h: number, left: number, most: number): number {
  const step = Math.min(h, most);
  if (reaches(step, left, most)) return left;
  return 2 * step > left ? left / 2 : step;
}

/**
 * The same for methods of fixed step, which is never halved.
 * @param h the step, s
 * @param left time to the limit, s
 * @param most upper bound, s
 */
export function fixedWithin(h: number, left: number, most: number): number {
  const step = Math.min(h, most);
  return reaches(step, left, most) ? left : step;
}

function reaches(step: number, left: number, most: number): boolean {
  return STRETCH * step >= left && left <= STEP_ROUNDING * most;
}

/**
 * Length at and below which a step is too small.
 * @param t time, s
 * @param left time to the limit, s
 */
export function smallestStep(t: number, left: number): number {
  return SMALLEST_ULPS * Number.EPSILON * Math.max(Math.abs(t), Math.abs(left));
}

/**
 * First step of an explicit method: Hairer, Nørsett and Wanner I, section II.4, "Starting step size".
 * @param f derivative; where it has no value the cautious guess stands
 * @param t0 s
 * @param y0 n
 * @param f0 f(t0, y0), n
 * @param order of the method
 * @param rtol relative tolerance
 * @param atol absolute tolerance, in the unit of each component
 * @param scratch two vectors of n
 * @param longest f is looked at no further ahead than this, s
 * @returns s, more than 0
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
  longest = Infinity,
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
  const h0 = Math.min(longest, d0 < 1e-5 || d1 < 1e-5 ? 1e-6 : (0.01 * d0) / d1);
  for (let i = 0; i < y0.length; i++) y1[i] = y0[i]! + h0 * f0[i]!;
  if (!f(t0 + h0, y1, f1)) return h0 > 0 ? h0 : CAUTIOUS_STEP;
  const d2 = norm(f1, f0) / h0;
  const steepest = Math.max(d1, d2);
  const h1 = steepest <= 1e-15 ? Math.max(1e-6, h0 * 1e-3) : power(0.01 / steepest, 1 / (order + 1));
  const h = Math.min(100 * h0, h1);
  return h > 0 ? h : CAUTIOUS_STEP;
}
