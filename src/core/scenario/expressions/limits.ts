/**
 * Values at a point where a formula has none though the function has a limit: sin(t)/t at 0. Neville's extrapolation to
 * h = 0 of values beside the point (Press et al., Numerical Recipes, 3rd ed., section 3.2), from the right, where a run
 * goes on, or else from the left. Exact to about 1e-12 where the function is smooth; slower limits (t^2 log(t)) to 1e-6.
 */

/** The first distance beside |t| or 1; it is halved so often. */
const FIRST = 1 / 16;
const HALVINGS = 26;
/** Columns of the tableau: higher ones would only magnify rounding. */
const COLUMNS = 8;
/** Two extrapolations that differ by less than this, beside the largest value or 1, have settled. */
const SETTLED = 1e-6;

/**
 * lim f(t), or NaN where values beside t do not settle.
 *
 * @param f of t
 * @param t where
 */
export function limitAt(f: (t: number) => number, t: number): number {
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
  return Math.abs(close - far) <= SETTLED * Math.max(1, Math.abs(close)) ? close : NaN;
}

function extrapolated(f: (t: number) => number, t: number, side: number): number {
  let before: number[] = [];
  let best = NaN;
  let least = Infinity;
  for (let k = 0; k < HALVINGS; k++) {
    const value = f(t + side * FIRST * Math.max(1, Math.abs(t)) * 2 ** -k);
    if (!Number.isFinite(value)) return NaN;
    const row = [value];
    for (let j = 1; j <= Math.min(k, COLUMNS); j++) {
      row[j] = row[j - 1]! + (row[j - 1]! - before[j - 1]!) / (2 ** j - 1);
      const change = Math.max(Math.abs(row[j]! - row[j - 1]!), Math.abs(row[j]! - before[j - 1]!));
      if (change < least) {
        least = change;
        best = row[j]!;
      }
    }
    before = row;
  }
  return least <= SETTLED * Math.max(1, Math.abs(best)) ? best : NaN;
}
