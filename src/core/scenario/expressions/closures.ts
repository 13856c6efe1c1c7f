import { smooth } from './functions.ts';
import { decide, type Node } from './tree.ts';
import { logarithm, power as powerOf } from '../../elementary/powers.ts';

/**
 * An expression as closures that give a value, or a value and its rate together, in doubles.
 *
 * Rates are exact, by forward differentiation with dual numbers (Griewank and Walther, Evaluating Derivatives,
 * 2nd ed., SIAM 2008, section 3.1). Every part is visited once, so that a nested text of a stranger costs no more than
 * its length; nothing is allocated. A root at 0 of what does not move there (`cbrt(t^3)`, `sqrt(0 * t)`) has no rate by
 * its parts; `limits.ts` finds it.
 *
 * Where a number inside leaves the range of doubles the result may be lost although it is a number (0 * Infinity);
 * `mark.lost` tells, and `beyondRange.ts` computes it again.
 */
export interface Closures {
  value(t: number): number;
  /** The value; its d/dt is left in `mark.rate`. */
  dual(t: number): number;
}

/** What closures leave beside a value. */
export const mark = {
  /** d/dt of the part whose `dual` returned last. */
  rate: 0,
  /** Whether a number left the range of doubles since this was last cleared, so that the result may be wrong. */
  lost: false,
  /** Values and rates of the names of a formula of several variables (`formula.ts`), by the place of the name. */
  values: new Float64Array(0) as ArrayLike<number>,
  rates: new Float64Array(0) as ArrayLike<number>,
};

/** Below it a product may have vanished that another factor would bring back. */
const VANISHING = 1e-290;
/** A factor that can bring back what is below the smallest double: its reach is then above `VANISHING`. */
const LARGE = 1e16;

/** a * b; marks what overflows, and what vanishes beside a large factor. */
function times(a: number, b: number): number {
  const product = a * b;
  const size = Math.abs(product);
  if (!(size >= VANISHING && size < Infinity) && (!(size < 1) || Math.max(Math.abs(a), Math.abs(b)) > LARGE))
    mark.lost = true;
  return product;
}

function over(a: number, b: number): number {
  const quotient = a / b;
  const size = Math.abs(b);
  if (!(Math.abs(quotient) < Infinity) || size < VANISHING || (size < 1 / LARGE && Math.abs(a) < VANISHING))
    mark.lost = true;
  return quotient;
}

/** Marks a value that overflowed. */
function kept(x: number): number {
  if (!(Math.abs(x) < Infinity)) mark.lost = true;
  return x;
}

/**
 * A formula as functions: its value, and its value with its rate.
 *
 * @param node root of the formula's tree
 */
export function closuresOf(node: Node): Closures {
  if (node.op === 'number') return { value: () => node.x, dual: () => ((mark.rate = 0), node.x) };
  if (node.op === 'name')
    return { value: () => mark.values[node.x]!, dual: () => ((mark.rate = mark.rates[node.x]!), mark.values[node.x]!) };
  if (node.op === 't') return { value: (t) => t, dual: (t) => ((mark.rate = 1), t) };
  const parts = node.args.map(closuresOf);
  if (decide(node.op)) return switching(node, parts);
  const one = smooth.get(node.op);
  if (!one) return binary(node.op, parts[0]!, parts[1] ?? parts[0]!);
  const [a] = parts as [Closures];
  // A root brings back what has vanished.
  const root = node.op === 'sqrt' || node.op === 'cbrt';
  const lossy = root || one.f === logarithm;
  const f = (x: number): number => {
    if (lossy && Math.abs(x) < VANISHING) mark.lost = true;
    return kept(one.f(x));
  };
  return {
    value: (t) => f(a.value(t)),
    dual(t) {
      const x = a.dual(t);
      const fx = f(x);
      const dx = mark.rate;
      if (dx !== 0) {
        mark.rate = kept(one.rate(x, dx, fx));
        if (mark.rate === 0 && Math.abs(dx) > LARGE) mark.lost = true;
      } else if (root && fx === 0 && !node.constant) mark.rate = NaN;
      return fx;
    },
  };
}

/** The value from what a switch has decided: of its parts, or of its own. */
function switching(node: Node, parts: Closures[]): Closures {
  const { op } = node;
  const choose = decide(op)!;
  const a = parts[0]!;
  const b = parts[1] ?? a;
  const is = (x: number, y: number): number => (node.decided === node.decided ? node.decided : choose(x, y));
  switch (op) {
    case '?': {
      const no = parts[2]!;
      const side = (t: number): Closures =>
        (node.decided === node.decided ? node.decided !== 0 : a.value(t) !== 0) ? b : no;
      return { value: (t) => side(t).value(t), dual: (t) => side(t).dual(t) };
    }
    case 'min':
    case 'max': {
      const pick = op === 'min' ? Math.min : Math.max;
      return {
        value: (t) => pick(a.value(t), b.value(t)),
        dual(t) {
          const x = a.dual(t);
          const dx = mark.rate;
          const y = b.dual(t);
          if (!is(x, y)) mark.rate = dx;
          return pick(x, y);
        },
      };
    }
    case 'mod':
      return {
        value(t) {
          const x = a.value(t);
          const y = b.value(t);
          return x - times(y, is(x, y));
        },
        dual(t) {
          const x = a.dual(t);
          const dx = mark.rate;
          const y = b.dual(t);
          const n = is(x, y);
          mark.rate = dx - times(mark.rate, n);
          return x - times(y, n);
        },
      };
    case 'abs':
      // The value is that of either side at the switch itself; only the rate has two.
      return {
        value: (t) => Math.abs(a.value(t)),
        dual(t) {
          const x = a.dual(t);
          mark.rate *= is(x, 0);
          return Math.abs(x);
        },
      };
    default: {
      const value = (t: number): number =>
        node.decided === node.decided ? node.decided : choose(a.value(t), b.value(t));
      return {
        value,
        dual(t) {
          const x = value(t);
          mark.rate = 0;
          return x;
        },
      };
    }
  }
}

/** f(x, y), and its rate from x, dx, y, dy and f(x, y). */
type Operation = readonly [
  f: (x: number, y: number) => number,
  rate: (x: number, dx: number, y: number, dy: number, value: number) => number,
];

const power: Operation = [
  (x, y) => {
    if (Math.abs(x) < VANISHING) mark.lost = true;
    return kept(powerOf(x, y));
  },
  (x, dx, y, dy, value) => {
    if (x === 0 && y > 0 && y < 1) return NaN;
    const base = dx === 0 || y === 0 ? 0 : times(times(y, kept(powerOf(x, y - 1))), dx);
    return dy === 0 || (value === 0 && x === 0) ? base : base + times(times(value, logarithm(x)), dy);
  },
];

const operations: ReadonlyMap<string, Operation> = new Map<string, Operation>([
  ['+', [(x, y) => kept(x + y), (_x, dx, _y, dy) => kept(dx + dy)]],
  ['-', [(x, y) => kept(x - y), (_x, dx, _y, dy) => kept(dx - dy)]],
  ['*', [times, (x, dx, y, dy) => kept((dx === 0 ? 0 : times(dx, y)) + (dy === 0 ? 0 : times(x, dy)))]],
  ['/', [over, (_x, dx, y, dy, value) => (dy === 0 ? (dx === 0 ? 0 : over(dx, y)) : over(dx - times(value, dy), y))]],
  ['^', power],
  ['pow', power],
  [
    'hypot',
    [
      (x, y) => kept(Math.hypot(x, y)),
      (x, dx, y, dy, h) => (h === 0 ? (dx === 0 && dy === 0 ? 0 : NaN) : kept((x / h) * dx + (y / h) * dy)),
    ],
  ],
  [
    'atan2',
    [
      Math.atan2,
      (y, dy, x, dx) => {
        const h = Math.hypot(x, y);
        return h === 0 ? (dx === 0 && dy === 0 ? 0 : NaN) : kept(over((x / h) * dy - (y / h) * dx, h));
      },
    ],
  ],
]);

function binary(op: string, a: Closures, b: Closures): Closures {
  if (op === 'negative')
    return {
      value: (t) => -a.value(t),
      dual(t) {
        const x = a.dual(t);
        mark.rate = -mark.rate;
        return -x;
      },
    };
  const [f, rate] = operations.get(op)!;
  return {
    value: (t) => f(a.value(t), b.value(t)),
    dual(t) {
      const x = a.dual(t);
      const dx = mark.rate;
      const y = b.dual(t);
      const value = f(x, y);
      mark.rate = rate(x, dx, y, mark.rate, value);
      return value;
    },
  };
}
