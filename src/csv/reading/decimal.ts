/**
 * Decimal numbers from bytes to doubles, correctly rounded, without making a string of each.
 *
 * Up to 19 digits are gathered as two whole numbers, which a pair of doubles holds exactly. Divided by a power of ten
 * that is exact too (10^22 at the most), the quotient comes with an error bound of about 2^-100; where that decides
 * the rounding, as it nearly always does, the nearest double is known (W. D. Clinger, "How to read floating point
 * numbers accurately", PLDI 1990, the fast path; T. J. Dekker, "A floating-point technique for extending the
 * available precision", Numer. Math. 18 (1971), for the exact product). Else the text decides.
 */

/** 10^0 to 10^22, all exact. */
const POWERS = Float64Array.from({ length: 23 }, (_, k) => Number(`1e${k}`));
const MOST_POWER = POWERS.length - 1;
/** Digits of the first whole number; with those of the second it is still below 2^64. */
const HIGH_DIGITS = 15;
/** Digits of which any number fits 32 bits. */
const FIRST_DIGITS = 8;
const MOST_DIGITS = 19;
/** 2^27 + 1. */
const SPLITTER = 134217729;
/** More than the pair's quotient can be wrong by, relative. */
const DOUBT = 2 ** -98;

const [DOT, MINUS, PLUS, ZERO, NINE, E, LOWER] = [46, 45, 43, 48, 57, 69, 32] as const;
const decoder = new TextDecoder();

/** Reads one cell after another; `at` is where the last one ended. */
export class DecimalReader {
  /** After `read`: the first byte that does not belong to the number. */
  at = 0;

  /**
   * A number that begins at `from`: `[+-] digits [. digits] [e [+-] digits]`, ended by any other byte.
   * @returns its value, or NaN where there is none or it is not finite
   */
  read(bytes: Uint8Array, from: number, to: number): number {
    let i = from;
    const sign = bytes[i];
    if (sign === MINUS || sign === PLUS) i++;
    // Three whole numbers of 8, 7 and 4 digits: each fits 32 bits, which are counted faster than doubles.
    let a = 0;
    let b = 0;
    let low = 0;
    let digits = 0;
    let point = -1;
    const first = i;
    for (; i < to; i++) {
      const c = bytes[i]! - ZERO;
      if (c >= 0 && c <= 9) {
        if (digits < FIRST_DIGITS) {
          a = (10 * a + c) | 0;
          // Leading zeros say nothing.
          if (a !== 0) digits++;
        } else {
          if (digits < HIGH_DIGITS) b = (10 * b + c) | 0;
          else low = (10 * low + c) | 0;
          digits++;
        }
      } else if (c === DOT - ZERO && point < 0) point = i;
      else break;
    }
    const scale = point < 0 ? 0 : i - point - 1;
    let any = i - first > (point < 0 ? 0 : 1);
    let exponent = 0;
    if (any && i < to && (bytes[i]! | LOWER) === (E | LOWER)) {
      let negative = false;
      i++;
      if (bytes[i] === MINUS || bytes[i] === PLUS) negative = bytes[i++] === MINUS;
      const power = i;
      for (; i < to && bytes[i]! >= ZERO && bytes[i]! <= NINE; i++)
        exponent = Math.min(1e6, 10 * exponent + (bytes[i]! - ZERO));
      if (i === power) any = false;
      if (negative) exponent = -exponent;
    }
    this.at = i;
    if (!any) return NaN;
    const lowDigits = digits > HIGH_DIGITS ? digits - HIGH_DIGITS : 0;
    const high = digits > FIRST_DIGITS ? a * POWERS[digits - lowDigits - FIRST_DIGITS]! + b : a;
    const value = digits > MOST_DIGITS ? NaN : nearest(high, low, lowDigits, exponent - scale);
    if (value !== value) {
      const text = +decoder.decode(bytes.subarray(from, i));
      return text - text === 0 ? text : NaN;
    }
    return sign === MINUS ? -value : value;
  }
}

/** (high 10^lowDigits + low) 10^power, correctly rounded, or NaN where that is not certain. */
function nearest(high: number, low: number, lowDigits: number, power: number): number {
  if (lowDigits === 0) {
    if (high === 0) return 0;
    if (power >= -MOST_POWER && power <= 0) return high / POWERS[-power]!;
    // 15 digits times 10^7 are below 10^22: both factors are exact.
    return power > 0 && power <= MOST_POWER ? high * POWERS[power]! : NaN;
  }
  if (power < -MOST_POWER || power > 0) return NaN;
  // The whole number as a pair: a + b exactly.
  const shift = POWERS[lowDigits]!;
  const product = high * shift;
  const rest = productError(high, shift, product) + low;
  const a = product + rest;
  const b = rest - (a - product);
  const divisor = POWERS[-power]!;
  const q = a / divisor;
  const back = q * divisor;
  const r = a - back - productError(q, divisor, back) + b;
  const correction = r / divisor;
  const doubt = q * DOUBT;
  const value = q + (correction - doubt);
  return value === q + (correction + doubt) ? value : NaN;
}

/** a b - product exactly, where product is a b rounded. */
function productError(a: number, b: number, product: number): number {
  const as = SPLITTER * a;
  const ah = as - (as - a);
  const al = a - ah;
  const bs = SPLITTER * b;
  const bh = bs - (bs - b);
  const bl = b - bh;
  return ah * bh - product + ah * bl + al * bh + al * bl;
}
