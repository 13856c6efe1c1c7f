/**
 * The least value of a function that has one minimum between two points, looked for only as long as it may be below zero.
 *
 * R. P. Brent, Algorithms for Minimization without Derivatives (1973), chapter 5: parabolas through the three best points,
 * golden sections where a parabola does not help; ended as soon as a value is not positive.
 *
 * Symbols: x the best point so far, w the second best, v the one before, [low, high] where the minimum is, e the step
 * before last.
 */

const GOLDEN = 0.5 * (3 - Math.sqrt(5));
/** Of the interval: a minimum is not looked for more closely, since a parabola is flat there to rounding. */
const CLOSE = 1e-9;
const MOST_LOOKS = 60;

/**
 * @param value of the function; evaluated within (low, high)
 * @param low first time, s
 * @param high last time, s
 * @returns a point between at which the function is not positive; null where none was found
 */
export function leastBetween(value: (t: number) => number, low: number, high: number): number | null {
  const close = CLOSE * (high - low);
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
