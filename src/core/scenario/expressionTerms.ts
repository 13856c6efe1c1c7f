/**
 * What expressions are compiled to: closures that give a value, or a value and its rate together.
 *
 * Rates are exact, by forward differentiation with dual numbers (Griewank and Walther, Evaluating Derivatives,
 * 2nd ed., SIAM 2008, section 3.1). Every term visits each of its parts once, so that a nested text of a stranger
 * costs no more than its length; nothing is allocated. A term with a rate of zero contributes zero even where its
 * slope is infinite (`sqrt(0 * t)`).
 */
export interface Term {
  readonly constant: boolean;
  value(t: number): number;
  /** The value; its d/dt is left in `rate`. */
  dual(t: number): number;
}

/** d/dt of the term whose `dual` returned last. */
let rate = 0;

/** Exact d/dt of a term. */
export function rateOf(term: Term, t: number): number {
  term.dual(t);
  return rate;
}

export const variable: Term = {
  constant: false,
  value: (t) => t,
  dual(t) {
    rate = 1;
    return t;
  },
};

export function fixed(x: number): Term {
  return {
    constant: true,
    value: () => x,
    dual() {
      rate = 0;
      return x;
    },
  };
}

/** Functions of one argument and their slopes. */
export const unary: ReadonlyMap<string, readonly [f: (x: number) => number, slope: (x: number) => number]> = new Map([
  ['sin', [Math.sin, Math.cos]],
  ['cos', [Math.cos, (x) => -Math.sin(x)]],
  ['tan', [Math.tan, (x) => 1 / Math.cos(x) ** 2]],
  ['asin', [Math.asin, (x) => 1 / Math.sqrt(1 - x * x)]],
  ['acos', [Math.acos, (x) => -1 / Math.sqrt(1 - x * x)]],
  ['atan', [Math.atan, (x) => 1 / (1 + x * x)]],
  ['sinh', [Math.sinh, Math.cosh]],
  ['cosh', [Math.cosh, Math.sinh]],
  ['tanh', [Math.tanh, (x) => 1 / Math.cosh(x) ** 2]],
  ['exp', [Math.exp, Math.exp]],
  ['log', [Math.log, (x) => 1 / x]],
  ['ln', [Math.log, (x) => 1 / x]],
  ['log10', [Math.log10, (x) => 1 / (x * Math.LN10)]],
  ['log2', [Math.log2, (x) => 1 / (x * Math.LN2)]],
  ['sqrt', [Math.sqrt, (x) => 0.5 / Math.sqrt(x)]],
  ['cbrt', [Math.cbrt, (x) => 1 / (3 * Math.cbrt(x) ** 2)]],
  ['abs', [Math.abs, Math.sign]],
  ['sign', [Math.sign, () => 0]],
  ['floor', [Math.floor, () => 0]],
  ['ceil', [Math.ceil, () => 0]],
  ['round', [Math.round, () => 0]],
]);

export function applied([f, slope]: readonly [(x: number) => number, (x: number) => number], a: Term): Term {
  return {
    constant: a.constant,
    value: (t) => f(a.value(t)),
    dual(t) {
      const x = a.dual(t);
      rate = rate === 0 ? 0 : slope(x) * rate;
      return f(x);
    },
  };
}

/** A term of two parts from its value and its rate. */
type Slopes = (x: number, dx: number, y: number, dy: number, value: number) => number;

function binary(f: (x: number, y: number) => number, slopes: Slopes): (a: Term, b: Term) => Term {
  return (a, b) => ({
    constant: a.constant && b.constant,
    value: (t) => f(a.value(t), b.value(t)),
    dual(t) {
      const x = a.dual(t);
      const dx = rate;
      const y = b.dual(t);
      const value = f(x, y);
      rate = slopes(x, dx, y, rate, value);
      return value;
    },
  });
}

const test = (holds: (x: number, y: number) => boolean) =>
  binary(
    (x, y) => (holds(x, y) ? 1 : 0),
    () => 0,
  );

const power = binary(Math.pow, (x, dx, y, dy, value) => {
  const base = dx === 0 || y === 0 ? 0 : y * Math.pow(x, y - 1) * dx;
  return dy === 0 || value === 0 ? base : base + value * Math.log(x) * dy;
});

/** Floored remainder: it has the sign of the divisor, so that mod(t, 2) repeats for negative t as well. */
const modulo = binary(
  (x, y) => x - y * Math.floor(x / y),
  (x, dx, y, dy) => dx - dy * Math.floor(x / y),
);

const hypotenuse = binary(Math.hypot, (x, dx, y, dy, value) => (value === 0 ? 0 : (x * dx + y * dy) / value));

const least = binary(Math.min, (x, dx, y, dy) => (y < x ? dy : dx));
const most = binary(Math.max, (x, dx, y, dy) => (y > x ? dy : dx));

export const operators: ReadonlyMap<string, (a: Term, b: Term) => Term> = new Map([
  [
    '+',
    binary(
      (x, y) => x + y,
      (_x, dx, _y, dy) => dx + dy,
    ),
  ],
  [
    '-',
    binary(
      (x, y) => x - y,
      (_x, dx, _y, dy) => dx - dy,
    ),
  ],
  [
    '*',
    binary(
      (x, y) => x * y,
      (x, dx, y, dy) => dx * y + x * dy,
    ),
  ],
  [
    '/',
    binary(
      (x, y) => x / y,
      (_x, dx, y, dy, value) => (dx - value * dy) / y,
    ),
  ],
  ['^', power],
  ['<', test((x, y) => x < y)],
  ['>', test((x, y) => x > y)],
  ['<=', test((x, y) => x <= y)],
  ['>=', test((x, y) => x >= y)],
  ['==', test((x, y) => x === y)],
  ['!=', test((x, y) => x !== y)],
]);

/** Functions of several arguments: how many they take, and how two of them combine. */
export const several: ReadonlyMap<
  string,
  readonly [fewest: number, most: number, combine: (a: Term, b: Term) => Term]
> = new Map([
  [
    'atan2',
    [2, 2, binary(Math.atan2, (y, dy, x, dx) => (x === 0 && y === 0 ? 0 : (x * dy - y * dx) / (x * x + y * y)))],
  ],
  ['pow', [2, 2, power]],
  ['mod', [2, 2, modulo]],
  ['hypot', [2, 16, hypotenuse]],
  ['min', [1, 16, least]],
  ['max', [1, 16, most]],
]);

export function negated(a: Term): Term {
  return applied([(x) => -x, () => -1], a);
}

/** `condition ? yes : no`; anything but zero is yes. */
export function choice(condition: Term, yes: Term, no: Term): Term {
  return {
    constant: condition.constant && yes.constant && no.constant,
    value: (t) => (condition.value(t) !== 0 ? yes.value(t) : no.value(t)),
    dual: (t) => (condition.value(t) !== 0 ? yes.dual(t) : no.dual(t)),
  };
}
