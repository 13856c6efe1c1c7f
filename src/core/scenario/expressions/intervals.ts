/**
 * Intervals of doubles, rounded outwards: what is known of a number is that it lies between the two bounds. An operation
 * leaves its bounds in `bound`, so that nothing is allocated. (R. E. Moore, R. B. Kearfott, M. J. Cloud, Introduction to
 * Interval Analysis, SIAM 2009, chapters 2 and 5.)
 *
 * Not guaranteed: bounds below 1e-300, which are not widened past 0.
 */
export const bound = { lo: 0, hi: 0 };

/** Twice the unit roundoff for an operation; functions of the platform are good to a few units. */
const OPERATION = 2 ** -52;
const FUNCTION = 2 ** -49;

function set(lo: number, hi: number, widen: number): void {
  bound.lo = lo === Infinity ? Number.MAX_VALUE : lo - Math.abs(lo) * widen;
  bound.hi = hi === -Infinity ? -Number.MAX_VALUE : hi + Math.abs(hi) * widen;
  if (!(bound.lo <= bound.hi)) unbounded();
}

/** Nothing is known. */
export function unbounded(): void {
  bound.lo = -Infinity;
  bound.hi = Infinity;
}

export const add = (a: number, b: number, c: number, d: number): void => set(a + c, b + d, OPERATION);

/** 0 times what has no bound is 0: the bound is a limit, never a number itself. */
const product = (x: number, y: number): number => (x === 0 || y === 0 ? 0 : x * y);

/**
 * [a, b] [c, d].
 *
 * @param a lower bound of the first factor
 * @param b upper bound of the first factor
 * @param c lower bound of the second
 * @param d upper bound of the second
 */
export function multiply(a: number, b: number, c: number, d: number): void {
  const [p, q, r, s] = [product(a, c), product(a, d), product(b, c), product(b, d)];
  set(Math.min(p, q, r, s), Math.max(p, q, r, s), OPERATION);
}

/**
 * [a, b] / [c, d]; unbounded where the divisor may be 0.
 *
 * @param a lower bound of the dividend
 * @param b upper bound of the dividend
 * @param c lower bound of the divisor
 * @param d upper bound of the divisor
 */
export function divide(a: number, b: number, c: number, d: number): void {
  if (c <= 0 && d >= 0) return unbounded();
  const [p, q, r, s] = [a / c, a / d, b / c, b / d];
  set(Math.min(p, q, r, s), Math.max(p, q, r, s), OPERATION);
}

/**
 * [a, b]².
 *
 * @param a lower bound of the argument
 * @param b upper bound of the argument
 */
export function square(a: number, b: number): void {
  const least = a <= 0 && b >= 0 ? 0 : Math.min(a * a, b * b);
  set(least, Math.max(a * a, b * b), OPERATION);
}

/**
 * Of a rising function that is defined on [from, to]; nothing is known where the argument may leave that.
 *
 * @param f rising
 * @param a lower bound of the argument
 * @param b upper bound of the argument
 * @param from where f begins
 * @param to where f ends
 */
export function rising(f: (x: number) => number, a: number, b: number, from = -Infinity, to = Infinity): void {
  if (a < from || b > to) return unbounded();
  set(f(a), f(b), FUNCTION);
}

/**
 * cosh [a, b].
 *
 * @param a lower bound of the argument
 * @param b upper bound of the argument
 */
export function cosh(a: number, b: number): void {
  const least = a <= 0 && b >= 0 ? 1 : Math.min(Math.cosh(a), Math.cosh(b));
  set(least, Math.max(Math.cosh(a), Math.cosh(b)), FUNCTION);
}

/**
 * sin(x + shift pi/2): for an argument within a period by where its crest and trough are.
 *
 * @param a lower bound of x, rad
 * @param b upper bound of x, rad
 * @param shift in quarters of a turn: 0 a sine, 1 a cosine
 */
export function sine(a: number, b: number, shift: number): void {
  // The argument's own last digits decide where large ones are in their period.
  const slack = 4 * OPERATION * Math.max(Math.abs(a), Math.abs(b));
  if (!(b - a + slack < 2 * Math.PI)) return set(-1, 1, 0);
  const quarter = (x: number): number => (2 * x) / Math.PI + shift;
  const contains = (turn: number): boolean =>
    Math.floor((quarter(b + slack) - turn) / 4) > Math.floor((quarter(a - slack) - turn) / 4);
  const f = (x: number): number => (shift === 0 ? Math.sin(x) : Math.cos(x));
  const [p, q] = [f(a), f(b)];
  set(contains(3) ? -1 : Math.min(p, q) - slack, contains(1) ? 1 : Math.max(p, q) + slack, FUNCTION);
  bound.lo = Math.max(-1, bound.lo);
  bound.hi = Math.min(1, bound.hi);
}
