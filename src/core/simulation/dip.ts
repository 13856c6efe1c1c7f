/**
 * A dip of a function below zero between two points at which it is positive: it falls at the first, rises at the second,
 * and the least value between is looked for.
 *
 * R. P. Brent, Algorithms for Minimization without Derivatives (1973), chapter 5: parabolas through the three best points,
 * golden sections where a parabola does not help; ended as soon as a value is not positive.
 *
 * Symbols: x the best point so far, w the second best, v the one before, [low, high] where the minimum is, e the step
 * before last. Of several minima between the two points the first that is not positive is found, where they are further
 * apart than two of the `PLACES` looked at first.
 */

const GOLDEN = 0.5 * (3 - Math.sqrt(5));
/** Of the interval: nearer to an end a slope is not looked for. */
const BESIDE = 1e-4;
/** Of the interval: a minimum is not looked for more closely, since a parabola is flat there to rounding. */
const CLOSE = 1e-9;
const MOST_LOOKS = 60;
/** Places between the two points, evenly, among which minima are told apart. */
const PLACES = 12;

/**
 * @param value of the function; evaluated within [low, high]
 * @param low first time, s
 * @param lowValue the function's value there, positive
 * @param high last time, s
 * @param highValue the function's value there, positive
 * @returns a point between at which the function is not positive; null where none was found
 */
export function dipBetween(
  value: (t: number) => number,
  low: number,
  lowValue: number,
  high: number,
  highValue: number,
): number | null {
  const beside = BESIDE * (high - low);
  const close = CLOSE * (high - low);
  if (!(value(low + beside) < lowValue && value(high - beside) < highValue)) return null;
  const times = Array.from({ length: PLACES + 2 }, (_, k) => low + ((high - low) * k) / (PLACES + 1));
  const values = times.map((t, k) => (k === 0 ? lowValue : k > PLACES ? highValue : value(t)));
  for (let k = 0; k <= PLACES + 1; k++) {
    if (!(values[k]! > 0)) return times[k]!;
    // The function falls at the first point and rises at the last: beside a lesser end there is a minimum too.
    if (values[k]! > (values[k - 1] ?? Infinity) || values[k]! > (values[k + 1] ?? Infinity)) continue;
    const dip = leastBetween(value, times[k - 1] ?? low, times[k + 1] ?? high, close);
    if (dip !== null) return dip;
  }
  return null;
}

/** The search itself, where there is one minimum: a point at which the function is not positive, or null. */
function leastBetween(value: (t: number) => number, low: number, high: number, close: number): number | null {
  let x = low + GOLDEN * (high - low);
  let fx = value(x);
  let [w, v, fw, fv] = [x, x, fx, fx];
  let [d, e] = [0, 0];
  for (let look = 0; look < MOST_LOOKS && fx > 0 && Math.max(x - low, high - x) > 2 * close; look++) {
    const middle = 0.5 * (low + high);
    const r = (x - w) * (fx - fv);
    const s = (x - v) * (fx - fw);
    const p = (x - v) * s - (x - w) * r;
    const q = 2 * (s - r);
    const parabola = -p / q;
    const before = e;
    e = d;
    if (Math.abs(parabola) < Math.abs(0.5 * before) && x + parabola > low && x + parabola < high) d = parabola;
    else {
      e = x < middle ? high - x : low - x;
      d = GOLDEN * e;
    }
    const u = x + (Math.abs(d) >= close ? d : Math.sign(middle - x || 1) * close);
    const fu = value(u);
    if (fu <= fx) {
      if (u < x) high = x;
      else low = x;
      [v, fv, w, fw, x, fx] = [w, fw, x, fx, u, fu];
    } else {
      if (u < x) low = u;
      else high = u;
      if (fu <= fw || w === x) [v, fv, w, fw] = [w, fw, u, fu];
      else if (fu <= fv || v === x || v === w) [v, fv] = [u, fu];
    }
  }
  return fx > 0 ? null : x;
}
