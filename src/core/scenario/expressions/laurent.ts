import { smooth } from './functions.ts';
import { decide, type Node } from './tree.ts';

/**
 * The limit of a formula and of its rate at a point where it has none by its parts (0/0, 1^Infinity): the parts as Laurent
 * series in h > 0, t = t0 + side h, whose leading terms cancel as they do by l'Hôpital's rule, but exactly. Recurrences of
 * Griewank and Walther, Evaluating Derivatives, 2nd ed., SIAM 2008, table 13.2; divisions after the leading powers.
 *
 * NaN where h enters otherwise (log(h), an odd root of h, sin(1/h)), and where terms cancel but for rounding.
 */

/** h^power (c_0 + c_1 h + …) with c_0 other than 0; 0 itself has no coefficients. */
interface Laurent {
  readonly power: number;
  readonly c: readonly number[];
}

/** Coefficients that are kept: each order of h that cancels loses one, two are wanted in the end. */
const TERMS = 14;

const ZERO: Laurent = { power: 0, c: [] };
const NONE: Laurent = { power: 0, c: [NaN] };

const isZero = (a: Laurent): boolean => a.c.length === 0;
const isNone = ({ c }: Laurent): boolean => c[0] !== c[0];
/** Sign for h towards 0. */
const signOf = (a: Laurent): number => (isZero(a) ? 0 : Math.sign(a.c[0]!));

/** Leading zeros become powers; what leaves the range of doubles is cut off. */
function laurent(power: number, all: readonly number[]): Laurent {
  const end = all.findIndex((x) => !Number.isFinite(x));
  if (end === 0) return NONE;
  const c = end < 0 ? all : all.slice(0, end);
  const first = c.findIndex((x) => x !== 0);
  return first < 0 ? ZERO : { power: power + first, c: c.slice(first) };
}

const constant = (x: number): Laurent => laurent(0, [x, ...new Array<number>(TERMS - 1).fill(0)]);
const scaled = (a: Laurent, by: number): Laurent =>
  isNone(a)
    ? a
    : laurent(
        a.power,
        a.c.map((x) => by * x),
      );

/** Of h^0, h^1, …: NaN-free only where no power is negative. */
function taylor(a: Laurent): number[] | null {
  if (isNone(a) || (a.power < 0 && !isZero(a))) return null;
  return [...new Array<number>(isZero(a) ? TERMS : Math.min(a.power, TERMS)).fill(0), ...a.c].slice(0, TERMS);
}

function plus(a: Laurent, b: Laurent): Laurent {
  if (isNone(a) || isZero(b)) return a;
  if (isNone(b) || isZero(a)) return b;
  const power = Math.min(a.power, b.power);
  const end = Math.min(a.power + a.c.length, b.power + b.c.length);
  const at = (s: Laurent, k: number): number => s.c[k - s.power] ?? 0;
  // One is beyond what is known of the other.
  if (end <= power) return a.power < b.power ? a : b;
  return laurent(
    power,
    Array.from({ length: end - power }, (_, k) => at(a, power + k) + at(b, power + k)),
  );
}

const minus = (a: Laurent, b: Laurent): Laurent => plus(a, scaled(b, -1));

function times(a: Laurent, b: Laurent): Laurent {
  if (isNone(a) || isNone(b)) return NONE;
  return laurent(a.power + b.power, product(a.c, b.c));
}

function product(a: readonly number[], b: readonly number[]): number[] {
  return Array.from({ length: Math.min(a.length, b.length) }, (_, k) => {
    let sum = 0;
    for (let j = 0; j <= k; j++) sum += a[j]! * b[k - j]!;
    return sum;
  });
}

function over(a: Laurent, b: Laurent): Laurent {
  if (isNone(a) || isNone(b) || isZero(b)) return NONE;
  const c: number[] = [];
  for (let k = 0; k < Math.min(a.c.length, b.c.length); k++) {
    let sum = a.c[k]!;
    for (let j = 1; j <= k; j++) sum -= b.c[j]! * c[k - j]!;
    c.push(sum / b.c[0]!);
  }
  return laurent(a.power - b.power, c);
}

/** a^p, p constant: (c_0 h^n)^p of the leading term, times (1 + …)^p. */
function toThe(a: Laurent, p: number): Laurent {
  if (isNone(a)) return NONE;
  if (isZero(a)) return p > 0 ? ZERO : NONE;
  const power = a.power * p;
  const first = a.c[0]! ** p;
  if (!Number.isInteger(power)) return NONE;
  const c = [1];
  for (let k = 1; k < a.c.length; k++) {
    let sum = 0;
    for (let j = 1; j <= k; j++) sum += (j * p - (k - j)) * (a.c[j]! / a.c[0]!) * c[k - j]!;
    c.push(sum / k);
  }
  return laurent(
    power,
    c.map((x) => first * x),
  );
}

/** f with f' = g and f(0) = first. */
const integral = (first: number, g: readonly number[]): Laurent =>
  laurent(0, [first, ...g.slice(0, TERMS - 1).map((x, k) => x / (k + 1))]);

const rateOf = (a: readonly number[]): number[] => a.slice(1).map((x, k) => (k + 1) * x);

/** f(a) whose slope by a is the series g(a). */
function bySlope(first: number, a: readonly number[], g: Laurent): Laurent {
  const slope = taylor(g);
  return slope ? integral(first, product(rateOf(a), slope)) : NONE;
}

/** Two functions, each the other's slope up to a sign: sin and cos, sinh and cosh. */
function pair(a: readonly number[], s0: number, c0: number, sign: number): [Laurent, Laurent] {
  const [s, c] = [[s0], [c0]];
  for (let k = 1; k < a.length; k++) {
    let [ds, dc] = [0, 0];
    for (let j = 1; j <= k; j++) {
      ds += j * a[j]! * c[k - j]!;
      dc += j * a[j]! * s[k - j]!;
    }
    s.push(ds / k);
    c.push((sign * dc) / k);
  }
  return [laurent(0, s), laurent(0, c)];
}

const ONE = constant(1);

function ofOne(op: string, x: Laurent): Laurent {
  if (isNone(x)) return NONE;
  switch (op) {
    case 'negative':
      return scaled(x, -1);
    case 'sqrt':
      return signOf(x) < 0 ? NONE : toThe(x, 0.5);
    case 'cbrt':
      return scaled(toThe(scaled(x, signOf(x)), 1 / 3), signOf(x));
  }
  const f = smooth.get(op)!.f;
  const a = taylor(x);
  if (!a) return ofInfinite(op, x);
  const first = f(a[0]!);
  switch (op) {
    case 'sin':
      return pair(a, first, smooth.get('cos')!.f(a[0]!), -1)[0];
    case 'cos':
      return pair(a, smooth.get('sin')!.f(a[0]!), first, -1)[1];
    case 'tan':
      return over(ofOne('sin', x), ofOne('cos', x));
    case 'sinh':
      return pair(a, first, Math.cosh(a[0]!), 1)[0];
    case 'cosh':
      return pair(a, Math.sinh(a[0]!), first, 1)[1];
    case 'tanh':
      return Math.abs(a[0]!) > 300 ? constant(first) : over(ofOne('sinh', x), ofOne('cosh', x));
    case 'exp': {
      const c = [first];
      for (let k = 1; k < a.length; k++) {
        let sum = 0;
        for (let j = 1; j <= k; j++) sum += j * a[j]! * c[k - j]!;
        c.push(sum / k);
      }
      return laurent(0, c);
    }
    case 'log':
    case 'ln':
    case 'log10':
    case 'log2': {
      if (!(a[0]! > 0)) return NONE;
      const base = op === 'log10' ? Math.LN10 : op === 'log2' ? Math.LN2 : 1;
      return bySlope(first, a, over(scaled(ONE, 1 / base), x));
    }
    case 'atan':
      return bySlope(first, a, over(ONE, plus(ONE, times(x, x))));
    case 'asin':
    case 'acos': {
      if (!(Math.abs(a[0]!) < 1)) return NONE;
      const slope = toThe(minus(ONE, times(x, x)), -0.5);
      return bySlope(first, a, op === 'asin' ? slope : scaled(slope, -1));
    }
  }
  return NONE;
}

/** At a pole: what settles there. */
function ofInfinite(op: string, x: Laurent): Laurent {
  switch (op) {
    case 'exp':
      // It falls faster than every power of h rises.
      return signOf(x) < 0 ? ZERO : NONE;
    case 'tanh':
      return constant(signOf(x));
    case 'atan':
      return minus(constant((signOf(x) * Math.PI) / 2), ofOne('atan', over(ONE, x)));
  }
  return NONE;
}

/** atan2: of the two beside the larger power, by its slope (x y' - y x') / (x^2 + y^2). */
function angle(y: Laurent, x: Laurent): Laurent {
  if (isNone(x) || isNone(y) || (isZero(x) && isZero(y))) return NONE;
  const power = Math.min(isZero(x) ? Infinity : x.power, isZero(y) ? Infinity : y.power);
  const shifted = (s: Laurent): Laurent => (isZero(s) ? s : { power: s.power - power, c: s.c });
  const [v, u] = [shifted(y), shifted(x)];
  const [b, a] = [taylor(v)!, taylor(u)!];
  const slope = over(
    minus(laurent(0, product(a, rateOf(b))), laurent(0, product(b, rateOf(a)))),
    plus(times(u, u), times(v, v)),
  );
  const g = taylor(slope);
  // The sign of a zero tells on which side of the jump it is.
  return g ? integral(Math.atan2(b[0]! === 0 ? 0 * signOf(v) : b[0]!, a[0]!), g) : NONE;
}

/** The whole number at or below, for h towards 0. */
function floor(a: Laurent): Laurent {
  const c = taylor(a);
  if (!c) return NONE;
  const whole = Math.floor(c[0]!);
  return constant(whole === c[0] && signOf(minus(a, constant(whole))) < 0 ? whole - 1 : whole);
}

function switched(node: Node, a: Laurent, b: Laurent): Laurent {
  if (isNone(a) || isNone(b)) return NONE;
  const { op, decided } = node;
  const known = decided === decided;
  switch (op) {
    case 'abs':
      return scaled(a, known ? decided : signOf(a) < 0 ? -1 : 1);
    case 'sign':
      return constant(known ? decided : signOf(a));
    case 'floor':
      return known ? constant(decided) : floor(a);
    case 'ceil':
      return known ? constant(decided) : scaled(floor(scaled(a, -1)), -1);
    case 'round':
      return known ? constant(decided) : floor(plus(a, constant(0.5)));
    case 'mod':
      return minus(a, times(b, known ? constant(decided) : floor(over(a, b))));
    default: {
      // Of two, their difference beside 0 tells.
      const d = known ? decided : decide(op)!(signOf(minus(a, b)), 0);
      return op === 'min' || op === 'max' ? (d ? b : a) : constant(d);
    }
  }
}

function series(node: Node, t: number, side: number): Laurent {
  if (node.op === 'number') return constant(node.x);
  if (node.op === 't') return plus(constant(t), laurent(1, [side, ...new Array<number>(TERMS - 1).fill(0)]));
  const part = (i: number): Laurent => (node.args[i] ? series(node.args[i], t, side) : ZERO);
  const a = part(0);
  if (node.op === '?')
    return isNone(a) ? a : part((node.decided === node.decided ? node.decided : signOf(a)) !== 0 ? 1 : 2);
  const b = part(1);
  if (decide(node.op)) return switched(node, a, b);
  switch (node.op) {
    case '+':
      return plus(a, b);
    case '-':
      return minus(a, b);
    case '*':
      return times(a, b);
    case '/':
      return over(a, b);
    case '^':
    case 'pow':
      return node.args[1]!.constant ? toThe(a, b.c[0] ?? 0) : ofOne('exp', times(b, ofOne('log', a)));
    case 'hypot':
      return toThe(plus(times(a, a), times(b, b)), 0.5);
    case 'atan2':
      return angle(a, b);
    default:
      return ofOne(node.op, a);
  }
}

/**
 * Limits of a formula and of its rate from one side; NaN where there is none, or none that series of powers show.
 *
 * @param node root of the formula's tree
 * @param t where, s
 * @param side 1 from later times, -1 from earlier ones
 */
export function limitBySeries(node: Node, t: number, side: number): { value: number; rate: number } {
  const c = taylor(series(node, t, side));
  return { value: c?.[0] ?? NaN, rate: c?.[1] === undefined ? NaN : side * c[1] };
}
