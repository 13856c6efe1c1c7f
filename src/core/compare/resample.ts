import type { Trajectory } from '../trajectory/trajectory.ts';

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
    const time = times[k]!;
    while (row < last && t[row + 1]! <= time) row++;
    const from = t[row]!;
    if (row === last || time <= from) {
      out[k] = y[row]!;
      continue;
    }
    const span = t[row + 1]! - from;
    const s = (time - from) / span;
    const rise = period > 0 ? shorter(y[row + 1]! - y[row]!, period) : y[row + 1]! - y[row]!;
    const [d0, d1] = rate ? [rate[row]! * span, rate[row + 1]! * span] : [rise, rise];
    // Hermite's form about the row before: exact at both ends, the chord where a rate is not a number.
    const smooth = s * (d0 + s * (3 * rise - 2 * d0 - d1 + s * (d0 + d1 - 2 * rise)));
    out[k] = y[row]! + (Number.isNaN(smooth) ? s * rise : smooth);
  }
  return out;
}

/** The same angle within half a period of zero. */
export function shorter(angle: number, period: number): number {
  return angle - period * Math.round(angle / period);
}
