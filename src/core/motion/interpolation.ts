/** The one way between rows: cubic Hermite where the rate is recorded, straight lines where it is not (Hairer, Nørsett, Wanner, Solving Ordinary Differential Equations I, II.6: error of order h^4, or h^2). */

export const TURN = 2 * Math.PI;

/**
 * The same angle within half a period of zero.
 *
 * @param angle rad
 * @param period of a turn, rad
 */
export function shorter(angle: number, period: number): number {
  return angle - period * Math.round(angle / period);
}

/**
 * A column between a row and the one after it.
 *
 * @param t times of the rows, s, rising
 * @param y values of the rows
 * @param rate values of `<name>_dot`, or undefined where they are not recorded
 * @param row the last row with t <= time
 * @param time s; before the row, or after the last one, the row's own value is given
 * @param period of a recorded angle that may jump by whole turns, `TURN`: the shorter way is taken, as bodies turn in
 *   the picture; 0 for a computed angle, whose own coordinate tells its turns
 */
export function interpolate(
  t: ArrayLike<number>,
  y: ArrayLike<number>,
  rate: ArrayLike<number> | undefined,
  row: number,
  time: number,
  period = 0,
): number {
  const from = t[row]!;
  if (row >= y.length - 1 || !(time > from)) return y[row]!;
  const span = t[row + 1]! - from;
  const s = Math.min(1, (time - from) / span);
  const step = y[row + 1]! - y[row]!;
  const d0 = rate ? rate[row]! * span : NaN;
  const d1 = rate ? rate[row + 1]! * span : NaN;
  const rise = period > 0 ? shorter(step, period) : step;
  // Hermite's form about the row before: exact at both ends, the chord where a rate is not a number.
  const smooth = s * (d0 + s * (3 * rise - 2 * d0 - d1 + s * (d0 + d1 - 2 * rise)));
  return smooth - smooth === 0 ? y[row]! + smooth : s === 0 ? y[row]! : y[row]! + s * rise;
}
