import type { Trajectory } from './trajectory.ts';

/**
 * Values of one column at rising times, clamped to the trajectory's rows: cubic Hermite between rows where the column's
 * rate `<name>_dot` is recorded, straight lines where it is not. A row's own time gives the row's own value.
 *
 * @param times rising, s
 * @param period of an angle (2 pi) whose record may jump by whole turns: the shorter way is then taken between rows
 * @returns one value a time, or null where there is no such column or no row
 */
export function resample(trajectory: Trajectory, name: string, times: Float64Array, period = 0): Float64Array | null {
  const y = trajectory.column(name);
  if (!y || y.length === 0) return null;
  const t = trajectory.column('t')!;
  const rate = trajectory.column(`${name}_dot`);
  const out = new Float64Array(times.length);
  const last = y.length - 1;
  let row = 0;
  for (let k = 0; k < times.length; k++) {
    while (row < last && t[row + 1]! <= times[k]!) row++;
    out[k] = between(t, y, rate, row, times[k]!, period);
  }
  return out;
}

/** As `resample`, at one time, from the two rows about it. */
export function valueAt(trajectory: Trajectory, name: string, time: number, period = 0): number | null {
  const y = trajectory.column(name);
  if (!y || y.length === 0) return null;
  const t = trajectory.column('t')!;
  const row = time >= t[y.length - 1]! ? y.length - 1 : trajectory.locate(time);
  return between(t, y, trajectory.column(`${name}_dot`), row, time, period);
}

/** Between a row and the one after it. */
function between(
  t: Float64Array,
  y: Float64Array,
  rate: Float64Array | undefined,
  row: number,
  time: number,
  period: number,
): number {
  const from = t[row]!;
  if (row === y.length - 1 || time <= from) return y[row]!;
  const span = t[row + 1]! - from;
  const s = (time - from) / span;
  const step = y[row + 1]! - y[row]!;
  const rise = period > 0 ? shorter(step, period) : step;
  const d0 = rate ? rate[row]! * span : rise;
  const d1 = rate ? rate[row + 1]! * span : rise;
  // Hermite's form about the row before: exact at both ends, the chord where a rate is not a number.
  const smooth = s * (d0 + s * (3 * rise - 2 * d0 - d1 + s * (d0 + d1 - 2 * rise)));
  return y[row]! + (Number.isNaN(smooth) ? s * rise : smooth);
}

/** The same angle within half a period of zero. */
export function shorter(angle: number, period: number): number {
  return angle - period * Math.round(angle / period);
}
