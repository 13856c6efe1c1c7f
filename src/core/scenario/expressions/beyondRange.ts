import { decide, type Node } from './tree.ts';
import { smooth } from './functions.ts';

/**
 * Values and rates of an expression where numbers inside leave the range of doubles, as in 1 / (1 + exp(1000)): signed
 * logarithms, whose own logarithms may be too large again (C. W. Clenshaw, F. W. J. Olver, "Beyond floating point",
 * J. ACM 31 (1984), 319-328, for level-index numbers). Their limits are then those of the composition: infinities never
 * appear inside, so neither do 0 * Infinity and Infinity / Infinity.
 *
 * A number of size e^L has a relative error of about 1e-16 |L|, as the argument of `exp` that made it has already; its
 * rate beside itself has not.
 * Not guaranteed: what is left when two numbers beyond e^(1e308) cancel.
 */

/** A double, or sign * exp(log) beyond doubles (log is large and may be negative: then the number is tiny). */
type Wide = number | { readonly sign: number; readonly log: Wide };

/**
 * A value and its rate, or its rate beside itself: of a number e^L with a large L the product of the two would lose that to
 * rounding, and log(cosh(t^4)) needs it.
 */
type Dual = { readonly x: Wide; readonly dx: Wide } | { readonly x: Wide; readonly relative: Wide };

const rateOf = (a: Dual): Wide => ('dx' in a ? a.dx : times(a.x, a.relative));
const relativeOf = (a: Dual): Wide => ('dx' in a ? over(a.dx, a.x) : a.relative);
const isBeyond = (a: Wide): boolean => typeof a !== 'number';

/** Doubles up to here and down to its inverse are kept as such; their products don't leave the range of doubles. */
const WIDEST = 1e150;
const WIDEST_LOG = Math.log(WIDEST);

const signOf = (a: Wide): number => (typeof a === 'number' ? Math.sign(a) : a.sign);
const negative = (a: Wide): Wide => (typeof a === 'number' ? -a : { sign: -a.sign, log: a.log });

/** log |a|, of a number other than 0. */
const logOf = (a: Wide): Wide => (typeof a === 'number' ? Math.log(Math.abs(a)) : a.log);

function fromLog(sign: number, log: Wide): Wide {
  if (typeof log === 'number' && !(Math.abs(log) > WIDEST_LOG)) return sign * Math.exp(log);
  return { sign, log };
}

/**
 * As a double: infinite or 0 where it is beyond them.
 *
 * @param a number of any exponent
 */
export function toDouble(a: Wide): number {
  if (typeof a === 'number') return a;
  return a.sign * (typeof a.log === 'number' ? Math.exp(a.log) : a.log.sign > 0 ? Infinity : 0);
}

function less(a: Wide, b: Wide): boolean {
  if (typeof a === 'number' && typeof b === 'number') return a < b;
  const [s, r] = [signOf(a), signOf(b)];
  if (s !== r || s === 0) return s < r;
  return s > 0 ? less(logOf(a), logOf(b)) : less(logOf(b), logOf(a));
}

const isNaNumber = (a: Wide): boolean => (typeof a === 'number' ? a !== a : isNaNumber(a.log));

function times(a: Wide, b: Wide): Wide {
  if (typeof a === 'number' && typeof b === 'number') {
    const product = a * b;
    const size = Math.abs(product);
    if (product !== product) return NaN;
    if ((size < WIDEST && size > 1 / WIDEST) || a === 0 || b === 0) return a === 0 || b === 0 ? 0 : product;
  }
  if (isNaNumber(a) || isNaNumber(b)) return NaN;
  const sign = signOf(a) * signOf(b);
  return sign === 0 ? 0 : fromLog(sign, plus(logOf(a), logOf(b)));
}

function over(a: Wide, b: Wide): Wide {
  const sign = signOf(a) * signOf(b);
  if (signOf(b) === 0 || sign !== sign) return NaN;
  if (typeof a === 'number' && typeof b === 'number') {
    const quotient = a / b;
    if (Math.abs(quotient) < WIDEST && Math.abs(quotient) > 1 / WIDEST) return quotient;
  }
  return sign === 0 ? 0 : fromLog(sign, plus(logOf(a), negative(logOf(b))));
}

function plus(a: Wide, b: Wide): Wide {
  if (signOf(a) === 0) return b;
  if (signOf(b) === 0) return a;
  if (typeof a === 'number' && !Number.isFinite(a)) return typeof b === 'number' ? a + b : a;
  if (typeof b === 'number' && !Number.isFinite(b)) return b;
  if (typeof a === 'number' && typeof b === 'number' && !(Math.abs(a) + Math.abs(b) > 1e300)) return a + b;
  let [large, small] = [a, b];
  if (less(logOf(a), logOf(b))) [large, small] = [b, a];
  const below = plus(logOf(small), negative(logOf(large)));
  if (typeof below !== 'number') return below.sign < 0 ? large : NaN;
  const same = signOf(a) === signOf(b);
  if (below === 0 && !same) return 0;
  return fromLog(signOf(large), plus(logOf(large), Math.log1p((same ? 1 : -1) * Math.exp(below))));
}

const minus = (a: Wide, b: Wide): Wide => plus(a, negative(b));

function exponential(a: Wide): Wide {
  if (typeof a === 'number') return Math.abs(a) > WIDEST_LOG ? { sign: 1, log: a } : Math.exp(a);
  return isTiny(a) ? 1 : { sign: 1, log: a };
}

const isTiny = (a: Wide): boolean => typeof a !== 'number' && signOf(a.log) < 0;

/** base^exponent from its logarithm; of a negative base for whole exponents only. */
function power(base: Wide, exponent: Wide): Wide {
  if (signOf(exponent) === 0) return 1;
  const sign = signOf(base);
  if (sign === 0) return signOf(exponent) > 0 ? 0 : NaN;
  const plain = toDouble(exponent);
  if (sign < 0 && !Number.isInteger(plain)) return NaN;
  return times(sign < 0 && plain % 2 !== 0 ? -1 : 1, exponential(times(exponent, logOf(base))));
}

/**
 * Value and rate at t; NaN where there is none.
 *
 * @param node root of the formula's tree
 * @param t s
 */
export function dualBeyondRange(node: Node, t: number): { value: number; rate: number } {
  const result = dual(node, t);
  return { value: toDouble(result.x), rate: toDouble(rateOf(result)) };
}

/**
 * log |value| at t; NaN where there is none.
 *
 * @param node root of the formula's tree
 * @param t s
 */
export function logarithmAt(node: Node, t: number): number {
  const { x } = dual(node, t);
  return signOf(x) === 0 ? -Infinity : toDouble(logOf(x));
}

function dual(node: Node, t: number): Dual {
  if (node.op === 'number') return { x: node.x, dx: 0 };
  if (node.op === 't') return { x: t, dx: 1 };
  const a = dual(node.args[0]!, t);
  if (node.op === '?') return dual(node.args[toChoice(node, a.x) ? 1 : 2]!, t);
  const b = node.args[1] ? dual(node.args[1], t) : a;
  const result = decide(node.op) ? switched(node, a, b) : combined(node.op, a, b);
  return node.constant ? { x: result.x, dx: 0 } : result;
}

const toChoice = (node: Node, condition: Wide): boolean =>
  node.decided === node.decided ? node.decided !== 0 : signOf(condition) !== 0;

function switched(node: Node, a: Dual, b: Dual): Dual {
  // Beyond doubles every number is whole, and of two numbers the logarithms tell which is larger.
  const [p, q] = less(a.x, b.x) ? [0, 1] : less(b.x, a.x) ? [1, 0] : [0, 0];
  const choose = decide(node.op)!;
  const one = node.op === 'mod' ? over(a.x, b.x) : a.x;
  const whole = toDouble(one);
  const { op } = node;
  if (isNaNumber(a.x) || isNaNumber(b.x)) return { x: NaN, dx: NaN };
  const pairwise = !['sign', 'abs', 'floor', 'ceil', 'round', 'mod'].includes(op);
  const d =
    node.decided === node.decided
      ? node.decided
      : pairwise
        ? choose(p, q)
        : choose(op === 'sign' || op === 'abs' ? signOf(a.x) : whole, 1);
  if (op === 'abs') return d < 0 ? negated(a) : a;
  if (op === 'min' || op === 'max') return d ? b : a;
  if (op === 'mod') return { x: minus(a.x, times(d, b.x)), dx: minus(rateOf(a), times(d, rateOf(b))) };
  return { x: Number.isFinite(d) ? d : a.x, dx: 0 };
}

const negated = (a: Dual): Dual =>
  'dx' in a ? { x: negative(a.x), dx: negative(a.dx) } : { x: negative(a.x), relative: a.relative };

function combined(op: string, a: Dual, b: Dual): Dual {
  const { x } = a;
  const { x: y } = b;
  // Neither is 0, and one is beyond doubles or told beside itself.
  const relatively = signOf(x) * signOf(y) !== 0 && [a, b].some((part) => isBeyond(part.x) || 'relative' in part);
  switch (op) {
    case 'negative':
      return negated(a);
    case '+':
      return sum(a, b);
    case '-':
      return sum(a, negated(b));
    case '*':
      return relatively
        ? { x: times(x, y), relative: plus(relativeOf(a), relativeOf(b)) }
        : { x: times(x, y), dx: plus(times(rateOf(a), y), times(x, rateOf(b))) };
    case '/': {
      const value = over(x, y);
      return relatively
        ? { x: value, relative: minus(relativeOf(a), relativeOf(b)) }
        : { x: value, dx: over(minus(rateOf(a), times(value, rateOf(b))), y) };
    }
    case '^':
    case 'pow':
      return powerOf(a, b);
    case 'hypot': {
      const h = hypotenuse(x, y);
      return { x: h, dx: plus(times(over(x, h), rateOf(a)), times(over(y, h), rateOf(b))) };
    }
    case 'atan2': {
      // Of (y, x), the first two parts in this order.
      const h = hypotenuse(x, y);
      const ratio = over(x, y);
      if (relatively && signOf(y) > 0 && Math.abs(toDouble(ratio)) < SMALL)
        return { x: ratio, relative: minus(relativeOf(a), relativeOf(b)) };
      const angle = Math.atan2(toDouble(over(x, h)), toDouble(over(y, h)));
      return { x: angle, dx: over(minus(times(over(y, h), rateOf(a)), times(over(x, h), rateOf(b))), h) };
    }
    default:
      return ofOne(op, a);
  }
}

/** Below it a number is its own arc tangent. */
const SMALL = 1e-8;

function sum(a: Dual, b: Dual): Dual {
  const x = plus(a.x, b.x);
  if (!isBeyond(x) || signOf(x) === 0) return { x, dx: plus(rateOf(a), rateOf(b)) };
  const share = (part: Dual): Wide =>
    signOf(part.x) === 0 ? over(rateOf(part), x) : times(over(part.x, x), relativeOf(part));
  return { x, relative: plus(share(a), share(b)) };
}

function powerOf(a: Dual, b: Dual): Dual {
  const { x } = a;
  const { x: y } = b;
  const [dx, dy] = [rateOf(a), rateOf(b)];
  const value = power(x, y);
  if (signOf(x) > 0 && (isBeyond(value) || isBeyond(x))) {
    const byBase = signOf(dx) === 0 ? 0 : times(y, relativeOf(a));
    return { x: value, relative: plus(byBase, signOf(dy) === 0 ? 0 : times(dy, logOf(x))) };
  }
  // Of a root at 0 neither its slope nor what is under it tells the rate.
  if (signOf(x) === 0 && signOf(y) > 0 && less(y, 1)) return { x: value, dx: NaN };
  const base = signOf(dx) === 0 || signOf(y) === 0 ? 0 : times(times(y, power(x, minus(y, 1))), dx);
  // Of 0^y with y > 0 there is 0 left: x^y log(x) goes to 0 with x.
  const noLog = signOf(x) < 0 || (signOf(x) === 0 && signOf(y) <= 0);
  const exponent = signOf(dy) === 0 ? 0 : noLog ? NaN : signOf(x) === 0 ? 0 : times(times(value, logOf(x)), dy);
  return { x: value, dx: plus(base, exponent) };
}

function hypotenuse(x: Wide, y: Wide): Wide {
  if (isNaNumber(x) || isNaNumber(y)) return NaN;
  const size = (a: Wide): Wide => times(signOf(a), a);
  const [large, small] = less(size(x), size(y)) ? [size(y), size(x)] : [size(x), size(y)];
  if (signOf(large) === 0) return 0;
  const ratio = toDouble(over(small, large));
  return times(large, Math.sqrt(1 + ratio * ratio));
}

const half = (a: Wide): Wide => times(0.5, a);

/** Functions of one argument: by their exponentials and logarithms where the argument or the result leaves doubles. */
function ofOne(op: string, a: Dual): Dual {
  const { x } = a;
  const dx = rateOf(a);
  const still = signOf(dx) === 0;
  const beside = (value: Wide, relative: () => Wide): Dual =>
    still ? { x: value, dx: 0 } : { x: value, relative: relative() };
  const scaled = (value: Wide, slope: Wide): Dual => ({ x: value, dx: still ? 0 : times(slope, dx) });
  const plain = toDouble(x);
  const size = Math.abs(plain);
  const inverse = (): Wide => over(1, x);
  switch (op) {
    case 'exp': {
      return beside(exponential(x), () => dx);
    }
    case 'sinh':
    case 'cosh': {
      if (size < 300) break;
      const value = half(exponential(times(signOf(x), x)));
      return beside(op === 'sinh' ? times(signOf(x), value) : value, () => times(signOf(x), dx));
    }
    case 'tanh':
      if (size < 300) break;
      return scaled(signOf(x), times(4, exponential(times(-2 * signOf(x), x))));
    case 'log':
    case 'ln':
    case 'log2':
    case 'log10': {
      if (signOf(x) <= 0) return scaled(NaN, NaN);
      const base = op === 'log2' ? Math.LN2 : op === 'log10' ? Math.LN10 : 1;
      return { x: over(logOf(x), base), dx: still ? 0 : over(relativeOf(a), base) };
    }
    case 'sqrt': {
      const value = power(x, 0.5);
      if (signOf(x) === 0) return { x: value, dx: NaN };
      if (isBeyond(x)) return beside(value, () => half(relativeOf(a)));
      return scaled(value, over(0.5, value));
    }
    case 'cbrt': {
      const value = times(signOf(x), power(times(signOf(x), x), 1 / 3));
      if (signOf(x) === 0) return { x: value, dx: NaN };
      if (isBeyond(x)) return beside(value, () => over(relativeOf(a), 3));
      return scaled(value, over(over(over(1 / 3, value), value), 1));
    }
    case 'atan':
      if (size < 1e8) break;
      return scaled(Math.atan(plain), times(inverse(), inverse()));
  }
  const one = smooth.get(op)!;
  // What is too small for a double is its own sine, and the cosine's fall from 1.
  if (isTiny(x))
    return op === 'cos' || op === 'cosh'
      ? scaled(1, op === 'cos' ? negative(x) : x)
      : op === 'acos'
        ? scaled(Math.PI / 2, -1)
        : a;
  const value = one.f(plain);
  return scaled(value, one.rate(plain, 1, value));
}
