import { add, bound, divide, multiply, square } from './intervals.ts';

/**
 * Taylor coefficients u^(k)/k! over an interval of t, each enclosed: what u and its derivatives can be anywhere in it.
 * Recurrences of Moore, Kearfott and Cloud, Introduction to Interval Analysis, SIAM 2009, section 10.1; Griewank and
 * Walther, Evaluating Derivatives, 2nd ed., table 13.2.
 */
export interface Series {
  lo: Float64Array;
  hi: Float64Array;
}

/**
 * Copies all coefficients.
 *
 * @param from read
 * @param to written, of the same order
 */
export function copy(from: Series, to: Series): void {
  to.lo.set(from.lo);
  to.hi.set(from.hi);
}

export const newSeries = (order: number): Series => ({
  lo: new Float64Array(order + 1),
  hi: new Float64Array(order + 1),
});

export type Unary = (u: Series, out: Series) => void;
export type Binary = (u: Series, v: Series, out: Series) => void;

/** The sum that is being made. */
export let lo = 0;
export let hi = 0;
/**
 * Adds weight * u_i * v_j onto it.
 *
 * @param u series
 * @param i place in u
 * @param v series
 * @param j place in v
 * @param weight factor
 */
export function onto(u: Series, i: number, v: Series, j: number, weight = 1): void {
  multiply(u.lo[i]!, u.hi[i]!, v.lo[j]!, v.hi[j]!);
  multiply(bound.lo, bound.hi, weight, weight);
  add(lo, hi, bound.lo, bound.hi);
  lo = bound.lo;
  hi = bound.hi;
}
export const from = (a: number, b: number): void => void ((lo = a), (hi = b));
/**
 * Writes the interval that was computed last as a coefficient.
 *
 * @param out series that is written
 * @param k place of the coefficient
 */
export function put(out: Series, k: number): void {
  out.lo[k] = bound.lo;
  out.hi[k] = bound.hi;
}
/**
 * Writes the sum that was made as a coefficient.
 *
 * @param out series that is written
 * @param k place of the coefficient
 * @param divisor of the sum
 */
export function putSum(out: Series, k: number, divisor = 1): void {
  divide(lo, hi, divisor, divisor);
  put(out, k);
}

export const sum: Binary = (u, v, out) => {
  for (let k = 0; k < out.lo.length; k++) {
    add(u.lo[k]!, u.hi[k]!, v.lo[k]!, v.hi[k]!);
    put(out, k);
  }
};

export const negated: Unary = (u, out) => {
  for (let k = 0; k < out.lo.length; k++) [out.lo[k], out.hi[k]] = [-u.hi[k]! + 0, -u.lo[k]! + 0];
};

export const difference: Binary = (u, v, out) => {
  for (let k = 0; k < out.lo.length; k++) {
    add(u.lo[k]!, u.hi[k]!, -v.hi[k]!, -v.lo[k]!);
    put(out, k);
  }
};

/**
 * factor u.
 *
 * @param u series
 * @param factor constant
 * @param out series that is written
 */
export function scaled(u: Series, factor: number, out: Series): void {
  for (let k = 0; k < out.lo.length; k++) {
    multiply(u.lo[k]!, u.hi[k]!, factor, factor);
    put(out, k);
  }
}

export const times: Binary = (u, v, out) => {
  for (let k = 0; k < out.lo.length; k++) {
    from(0, 0);
    for (let j = 0; j <= k; j++) onto(u, j, v, k - j);
    putSum(out, k);
  }
};

export const squared: Unary = (u, out) => {
  times(u, u, out);
  square(u.lo[0]!, u.hi[0]!);
  put(out, 0);
};

export const quotient: Binary = (u, v, out) => {
  const relative = scratch(out);
  relativeTo(v, relative);
  quotientBy(u, v, relative, out);
};

/**
 * u / v from the coefficients of v beside its first one.
 *
 * @param u series
 * @param v series
 * @param relative coefficients of v beside its first one
 * @param out series that is written
 */
export function quotientBy(u: Series, v: Series, relative: Series, out: Series): void {
  for (let k = 0; k < out.lo.length; k++) {
    divide(u.lo[k]!, u.hi[k]!, v.lo[0]!, v.hi[0]!);
    from(bound.lo, bound.hi);
    for (let j = 1; j <= k; j++) onto(relative, j, out, k - j, -1);
    putSum(out, k);
  }
}

/** Coefficients beside the first one, which is then 1. */
export const relativeTo: Unary = (u, out) => {
  for (let k = 1; k < out.lo.length; k++) {
    divide(u.lo[k]!, u.hi[k]!, u.lo[0]!, u.hi[0]!);
    put(out, k);
  }
  out.lo[0] = out.hi[0] = 1;
};

/**
 * u^p beside its first coefficient, from u beside its own.
 *
 * @param relative coefficients of u beside its first one
 * @param p exponent
 * @param out series that is written
 */
export function relativePower(relative: Series, p: number, out: Series): void {
  out.lo[0] = out.hi[0] = 1;
  for (let k = 1; k < out.lo.length; k++) {
    from(0, 0);
    for (let j = 1; j <= k; j++) onto(relative, j, out, k - j, j * p - (k - j));
    putSum(out, k, k);
  }
}

/**
 * Coefficients from k = 1 on of f with f' = g u' (g in `slope`, whose coefficients may be made on the way).
 *
 * @param u series
 * @param slope g, coefficients below k
 * @param out series that is written
 * @param k place of the coefficient
 * @param sign 1 or -1
 */
export function integrate(u: Series, slope: Series, out: Series, k: number, sign = 1): void {
  from(0, 0);
  for (let j = 1; j <= k; j++) onto(u, j, slope, k - j, sign * j);
  putSum(out, k, k);
}

/**
 * Coefficients from k = 1 on of f with w f' = u'.
 *
 * @param u series
 * @param w series, other than 0
 * @param out series that is written
 */
export function integrateOver(u: Series, w: Series, out: Series): void {
  for (let k = 1; k < out.lo.length; k++) {
    from(0, 0);
    for (let j = 1; j < k; j++) onto(out, j, w, k - j, -j);
    divide(lo, hi, k, k);
    add(u.lo[k]!, u.hi[k]!, bound.lo, bound.hi);
    divide(bound.lo, bound.hi, w.lo[0]!, w.hi[0]!);
    put(out, k);
  }
}

/**
 * The series of a constant.
 *
 * @param x the constant
 * @param out series that is written
 * @returns out
 */
export function constant(x: number, out: Series): Series {
  out.lo.fill(0);
  out.hi.fill(0);
  out.lo[0] = out.hi[0] = x;
  return out;
}

/** Work space, in turn: more at once than any function above and those it calls take. */
const SPACES = 16;
const spaces = new Map<number, { list: Series[]; next: number }>();
/**
 * A series to work in, until the space is given out again.
 *
 * @param like of the order that is wanted
 */
export function scratch(like: Series): Series {
  const order = like.lo.length - 1;
  let space = spaces.get(order);
  if (!space) spaces.set(order, (space = { list: Array.from({ length: SPACES }, () => newSeries(order)), next: 0 }));
  space.next = (space.next + 1) % SPACES;
  return space.list[space.next]!;
}
