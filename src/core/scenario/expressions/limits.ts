import { limitBySeries } from './laurent.ts';
import type { Node } from './tree.ts';

/**
 * Values at a point where a formula has none though the function has a limit, as sin(t)/t at 0: from the right, where a run
 * goes on, or else from the left. By series where they show it; else (t log(t), an odd root) Neville's extrapolation to h = 0
 * of values beside the point (Press et al., Numerical Recipes, 3rd ed., section 3.2), to about 1e-6.
 */

/** The first distance beside |t| or 1; it is halved so often. */
const FIRST = 1 / 16;
const HALVINGS = 40;
/** Columns of the tableau: higher ones would only magnify rounding. */
const COLUMNS = 8;
/** Two extrapolations that differ by less than this, beside the largest value, have settled. */
const SETTLED = 1e-6;
/**
 * Beside the smallest distances rounding leaves steps, on which extrapolations agree with each other and with nothing else:
 * cos(h) is 1 below 1e-8. So a limit has to be near the values at some distance too, as far as slow limits come there.
 */
const MIDDLE = [12, 14, 16] as const;
const NEAR = 0.05;

/**
 * lim f(t), or NaN where there is none that is found.
 *
 * @param tree of the formula
 * @param which its value or its rate
 * @param f the same, of t
 * @param t where
 */
export function limitOf(tree: Node, which: 'value' | 'rate', f: (t: number) => number, t: number): number {
  for (const side of [1, -1]) {
    const limit = limitBySeries(tree, t, side)[which];
    if (limit === limit) return limit;
  }
  for (const limit of [extrapolated, neighbour]) {
    for (const side of [1, -1]) {
      const value = limit(f, t, side);
      if (value === value) return value;
    }
  }
  return NaN;
}

/** A value some last digits aside: a root's end, where rounding has put t outside. */
function neighbour(f: (t: number) => number, t: number, side: number): number {
  const ulp = Number.EPSILON * Math.max(1, Math.abs(t)) * side;
  const [close, far] = [f(t + 4 * ulp), f(t + 64 * ulp)];
  return Math.abs(close - far) <= SETTLED * Math.abs(close) ? close : NaN;
}

function extrapolated(f: (t: number) => number, t: number, side: number): number {
  const values = Array.from({ length: HALVINGS }, (_, k) => f(t + side * FIRST * Math.max(1, Math.abs(t)) * 2 ** -k));
  if (!values.every(Number.isFinite)) return NaN;
  const size = Math.max(...values.slice(0, COLUMNS).map(Math.abs));
  const near = (limit: number): boolean => MIDDLE.every((k) => Math.abs(values[k]! - limit) <= NEAR * size);
  let before: number[] = [];
  let best = NaN;
  let least = Infinity;
  for (const [k, value] of values.entries()) {
    const row = [value];
    for (let j = 1; j <= Math.min(k, COLUMNS); j++) {
      row[j] = row[j - 1]! + (row[j - 1]! - before[j - 1]!) / (2 ** j - 1);
      const change = Math.max(Math.abs(row[j]! - row[j - 1]!), Math.abs(row[j]! - before[j - 1]!));
      if (change < least && near(row[j]!)) {
        least = change;
        best = row[j]!;
      }
    }
    before = row;
  }
  return least <= SETTLED * size ? best : NaN;
}
