import { add, bound, cosh, divide, multiply, rising, sine, square, unbounded } from './intervals.ts';
import {
  lo,
  hi,
  onto,
  from,
  put,
  integrate,
  integrateOver,
  scratch,
  constant,
  copy,
  times,
  squared,
  scaled,
  negated,
  sum,
  quotient,
  type Binary,
  type Series,
  type Unary,
} from './series.ts';

/**
 * Functions of Taylor coefficients over an interval (see `series.ts`), each by the differential equation that it solves.
 */

/** exp(u) beside its first coefficient: as narrow as u, however large exp(u) is. */
export const relativeExp: Unary = (u, out) => {
  out.lo[0] = out.hi[0] = 1;
  for (let k = 1; k < out.lo.length; k++) integrate(u, out, out, k);
};

/**
 * cosh(u) or sinh(u) beside its first coefficient, with the other beside the same. Of sinh for u other than 0.
 *
 * @param op which of the two goes to `out`
 * @param u series
 * @param out series that is written
 */
export function relativeHyperbolic(op: 'cosh' | 'sinh', u: Series, out: Series): void {
  const other = scratch(out);
  rising(Math.tanh, u.lo[0]!, u.hi[0]!);
  if (op === 'sinh') divide(1, 1, bound.lo, bound.hi);
  put(other, 0);
  out.lo[0] = out.hi[0] = 1;
  if (op === 'cosh') pair(u, other, out, 1);
  else pair(u, out, other, 1);
}

const exp: Unary = (u, out) => {
  rising(Math.exp, u.lo[0]!, u.hi[0]!);
  put(out, 0);
  for (let k = 1; k < out.lo.length; k++) integrate(u, out, out, k);
};

const log: Unary = (u, out) => {
  rising(Math.log, u.lo[0]!, u.hi[0]!, 0);
  put(out, 0);
  integrateOver(u, u, out);
};

const scaledLog =
  (base: number): Unary =>
  (u, out) => {
    log(u, out);
    scaled(out, 1 / base, out);
  };

/** sin and cos, or sinh and cosh (sign 1), each the other's slope. */
function pair(u: Series, s: Series, c: Series, sign: number): void {
  for (let k = 1; k < s.lo.length; k++) {
    integrate(u, c, s, k);
    integrate(u, s, c, k, sign);
  }
}

const circular =
  (wanted: 0 | 1): Unary =>
  (u, out) => {
    const other = scratch(out);
    const [s, c] = wanted === 0 ? [out, other] : [other, out];
    sine(u.lo[0]!, u.hi[0]!, 0);
    put(s, 0);
    sine(u.lo[0]!, u.hi[0]!, 1);
    put(c, 0);
    pair(u, s, c, -1);
  };

const hyperbolic =
  (wanted: 0 | 1): Unary =>
  (u, out) => {
    const other = scratch(out);
    const [s, c] = wanted === 0 ? [out, other] : [other, out];
    rising(Math.sinh, u.lo[0]!, u.hi[0]!);
    put(s, 0);
    cosh(u.lo[0]!, u.hi[0]!);
    put(c, 0);
    pair(u, s, c, 1);
  };

/** tan (sign 1) and tanh (sign -1): slope 1 + sign f^2. */
const tangent =
  (f: (x: number) => number, sign: 1 | -1): Unary =>
  (u, out) => {
    const [a, b] = [u.lo[0]!, u.hi[0]!];
    const turn = (x: number): number => Math.floor(x / Math.PI + 0.5);
    if (sign === 1 && !(turn(a) === turn(b) && Math.abs(a) < 1e8 && Math.abs(b) < 1e8)) unbounded();
    else rising(f, a, b);
    put(out, 0);
    const w = scratch(out);
    for (let k = 0; k < out.lo.length - 1; k++) {
      if (k > 0) {
        from(0, 0);
        for (let j = 0; j <= k; j++) onto(out, j, out, k - j, sign);
        add(lo, hi, 0, 0);
      } else if (sign === 1) {
        square(out.lo[0]!, out.hi[0]!);
        add(bound.lo, bound.hi, 1, 1);
      } else {
        // 1 - tanh^2 = 1/cosh^2, which rounding leaves small where tanh is 1.
        cosh(a, b);
        square(bound.lo, bound.hi);
        divide(1, 1, bound.lo, bound.hi);
      }
      put(w, k);
      integrate(u, w, out, k + 1);
    }
  };

/** 1 + sign u^2 into `out`. */
function onePlusSquare(u: Series, sign: number, out: Series): void {
  squared(u, out);
  scaled(out, sign, out);
  add(out.lo[0]!, out.hi[0]!, 1, 1);
  put(out, 0);
}

const atan: Unary = (u, out) => {
  const w = scratch(out);
  onePlusSquare(u, 1, w);
  rising(Math.atan, u.lo[0]!, u.hi[0]!);
  put(out, 0);
  integrateOver(u, w, out);
};

const asin: Unary = (u, out) => {
  const w = scratch(out);
  const r = scratch(out);
  onePlusSquare(u, -1, w);
  sqrt(w, r);
  rising(Math.asin, u.lo[0]!, u.hi[0]!, -1, 1);
  put(out, 0);
  integrateOver(u, r, out);
};

const acos: Unary = (u, out) => {
  asin(u, out);
  negated(out, out);
  add(out.lo[0]!, out.hi[0]!, Math.PI / 2, Math.PI / 2);
  put(out, 0);
};

/** 0 at every t: roots are then 0 too, with all their derivatives. */
const isZero = (u: Series): boolean => u.lo.every((x) => x === 0) && u.hi.every((x) => x === 0);

export const sqrt: Unary = (u, out) => {
  if (isZero(u)) return void constant(0, out);
  rising((x) => Math.sqrt(Math.max(0, x)), u.lo[0]!, u.hi[0]!, -1e-300);
  put(out, 0);
  for (let k = 1; k < out.lo.length; k++) {
    from(u.lo[k]!, u.hi[k]!);
    for (let j = 1; j < k; j++) onto(out, j, out, k - j, -1);
    divide(lo, hi, 2 * out.lo[0]!, 2 * out.hi[0]!);
    put(out, k);
  }
};

/** u^p for u > 0: u f' = p f u'. */
function realPower(u: Series, p: number, out: Series): void {
  if (p > 0 && isZero(u)) return void constant(0, out);
  const [a, b] = [u.lo[0]!, u.hi[0]!];
  const f = (x: number): number => Math.pow(x, p);
  if (p > 0) rising(f, a, b, 0);
  else if (a > 0) {
    rising((x) => -f(x), a, b);
    [bound.lo, bound.hi] = [-bound.hi, -bound.lo];
  } else unbounded();
  put(out, 0);
  for (let k = 1; k < out.lo.length; k++) {
    from(0, 0);
    for (let j = 1; j <= k; j++) onto(u, j, out, k - j, j * p - (k - j));
    divide(lo, hi, k, k);
    divide(bound.lo, bound.hi, a, b);
    put(out, k);
  }
}

/** Whole exponents up to here by repeated products. */
const MOST_FACTORS = 64;

/**
 * u^p.
 *
 * @param u series
 * @param p exponent, constant
 * @param out series that is written
 */
export function power(u: Series, p: number, out: Series): void {
  if (!Number.isInteger(p) || Math.abs(p) > MOST_FACTORS) return realPower(u, p, out);
  if (p < 0) {
    const w = scratch(out);
    power(u, -p, w);
    return quotient(constant(1, scratch(out)), w, out);
  }
  constant(1, out);
  const w = scratch(out);
  const product = scratch(out);
  squared(u, w);
  for (let i = 0; i < Math.floor(p / 2); i++) {
    times(out, w, product);
    copy(product, out);
  }
  if (p % 2 === 0) return;
  times(out, u, w);
  copy(w, out);
}

const cbrt: Unary = (u, out) => {
  if (isZero(u)) return void constant(0, out);
  rising(Math.cbrt, u.lo[0]!, u.hi[0]!);
  put(out, 0);
  const w = scratch(out);
  for (let k = 1; k < out.lo.length; k++) {
    // 3 f^2 f' = u'.
    times(out, out, w);
    from(0, 0);
    for (let j = 1; j < k; j++) onto(out, j, w, k - j, -j);
    divide(lo, hi, k, k);
    add(u.lo[k]! / 3, u.hi[k]! / 3, bound.lo, bound.hi);
    divide(bound.lo, bound.hi, w.lo[0]!, w.hi[0]!);
    put(out, k);
  }
};

export const hypotenuse: Binary = (u, v, out) => {
  const [w, z] = [scratch(out), scratch(out)];
  squared(u, w);
  squared(v, z);
  sum(w, z, w);
  sqrt(w, out);
};

/** atan2(y, x): the slope (x y' - y x') / (x^2 + y^2); nothing is known over the jump behind. */
export const angle: Binary = (y, x, out) => {
  const [w, z, r] = [scratch(out), scratch(out), scratch(out)];
  const around = (num: Series, den: Series, offset: number, sign: number): void => {
    divide(num.lo[0]!, num.hi[0]!, den.lo[0]!, den.hi[0]!);
    rising(Math.atan, bound.lo, bound.hi);
    multiply(bound.lo, bound.hi, sign, sign);
    add(bound.lo, bound.hi, offset, offset);
  };
  if (x.lo[0]! > 0) around(y, x, 0, 1);
  else if (y.lo[0]! > 0) around(x, y, Math.PI / 2, -1);
  else if (y.hi[0]! < 0) around(x, y, -Math.PI / 2, -1);
  else unbounded();
  put(out, 0);
  squared(x, w);
  squared(y, z);
  sum(w, z, r);
  const known = out.lo[0]! > -Infinity;
  // d = (x y' - y x') / r, coefficient by coefficient; out_(k+1) = d_k / (k + 1).
  for (let k = 0; k < out.lo.length - 1; k++) {
    from(0, 0);
    for (let j = 0; j <= k; j++) {
      onto(x, k - j, y, j + 1, j + 1);
      onto(y, k - j, x, j + 1, -(j + 1));
    }
    for (let j = 1; j <= k; j++) onto(r, j, w, k - j, -1);
    if (known) divide(lo, hi, r.lo[0]!, r.hi[0]!);
    else unbounded();
    put(w, k);
    divide(bound.lo, bound.hi, k + 1, k + 1);
    put(out, k + 1);
  }
};

export const unarySeries: ReadonlyMap<string, Unary> = new Map<string, Unary>([
  ['negative', negated],
  ['sin', circular(0)],
  ['cos', circular(1)],
  ['tan', tangent(Math.tan, 1)],
  ['tanh', tangent(Math.tanh, -1)],
  ['asin', asin],
  ['acos', acos],
  ['atan', atan],
  ['sinh', hyperbolic(0)],
  ['cosh', hyperbolic(1)],
  ['exp', exp],
  ['log', log],
  ['ln', log],
  ['log10', scaledLog(Math.LN10)],
  ['log2', scaledLog(Math.LN2)],
  ['sqrt', sqrt],
  ['cbrt', cbrt],
]);

/**
 * u^v, as exp(v log u).
 *
 * @param u series
 * @param v the exponent, series
 * @param out series that is written
 */
export function powerOf(u: Series, v: Series, out: Series): void {
  const w = scratch(out);
  log(u, w);
  const z = scratch(out);
  times(v, w, z);
  exp(z, out);
}
