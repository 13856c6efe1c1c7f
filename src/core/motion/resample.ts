import { interpolate } from './interpolation.ts';
import type { Trajectory } from './trajectory.ts';

/**
 * Values of one column at rising times, clamped to the trajectory's rows, as `interpolate` has them.
 *
 * @param trajectory with the column
 * @param name of the column
 * @param times rising, s
 * @param period of an angle (2 pi) whose record may jump by whole turns
 * @returns one value a time, or null where there is no such column or no row
 */
export function resample(trajectory: Trajectory, name: string, times: Float64Array, period = 0): Float64Array | null {
  const y = trajectory.column(name);
  if (!y || y.length === 0) return null;
  const t = trajectory.column('t')!;
  const rate = trajectory.rateOf(name);
  const last = y.length - 1;
  let row = 0;
  return times.map((time) => {
    while (row < last && t[row + 1]! <= time) row++;
    return interpolate(t, y, rate, row, time, period);
  });
}

/**
 * As `resample`, at one time; NaN where a row's value is.
 *
 * @param trajectory with the column
 * @param name of the column
 * @param time s
 * @param period of an angle (2 pi) whose values are equal to whole turns, or 0
 */
export function valueAt(trajectory: Trajectory, name: string, time: number, period = 0): number | null {
  const y = trajectory.column(name);
  if (!y || y.length === 0) return null;
  return interpolate(
    trajectory.column('t')!,
    y,
    trajectory.rateOf(name),
    rowAt(trajectory, time, y.length),
    time,
    period,
  );
}

/**
 * The last of the first `rows` rows with t <= time, the first where there is none.
 *
 * @param trajectory with times
 * @param time s
 * @param rows how many of its rows count
 */
export function rowAt(trajectory: Trajectory, time: number, rows = trajectory.length): number {
  const last = rows - 1;
  if (last < 0) return 0;
  return time >= trajectory.column('t')![last]! ? last : trajectory.locate(time);
}
