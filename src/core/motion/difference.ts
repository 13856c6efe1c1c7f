import { shorter } from './interpolation.ts';
import { resample } from './resample.ts';
import type { Trajectory } from './trajectory.ts';

/** How one column of two runs differs over the time they share. */
export interface Difference {
  /** s, rising. */
  times: Float64Array;
  /** First minus second, in the column's own unit. */
  values: Float64Array;
  /** Square root of the time average of the square. */
  rms: number;
  /** Largest absolute value, and when. */
  max: number;
  maxTime: number;
  /** At the last time that both have. */
  final: number;
}

/** Times closer than this part of the time they share are one: two writers rarely agree on the last digits. */
const SAME_TIME = 1e-9;

/**
 * The rows' times of both within the time they share: as fine as the finer of the two wherever it is, the same whichever
 * comes first.
 *
 * @param a one run
 * @param b another of the same system
 * @returns null where they share no time
 */
export function commonTimes(a: Trajectory, b: Trajectory): Float64Array | null {
  if (a.length === 0 || b.length === 0) return null;
  const start = Math.max(a.start, b.start);
  const end = Math.min(a.end, b.end);
  if (!(start <= end)) return null;
  const [ta, tb] = [a.column('t')!, b.column('t')!];
  const times = new Float64Array(ta.length + tb.length + 2);
  const apart = SAME_TIME * (end - start);
  let count = 0;
  times[count++] = start;
  let i = 0;
  let j = 0;
  while (i < ta.length || j < tb.length) {
    const next = j >= tb.length || (i < ta.length && ta[i]! <= tb[j]!) ? ta[i++]! : tb[j++]!;
    if (next > times[count - 1]! + apart && next < end - apart) times[count++] = next;
  }
  if (end > start) times[count++] = end;
  return times.slice(0, count);
}

/**
 * One column of a run less that of another, over the times they share.
 *
 * @param a one run
 * @param b another of the same system
 * @param name of the column
 * @param period 2 pi to count angles that differ by whole turns as equal; 0 to take them as recorded
 * @param times as made by `commonTimes`
 * @returns null where either has no such column or they share no time
 */
export function differenceOf(
  a: Trajectory,
  b: Trajectory,
  name: string,
  period = 0,
  times = commonTimes(a, b),
): Difference | null {
  const first = times && resample(a, name, times, period);
  const second = times && resample(b, name, times, period);
  if (!first || !second) return null;
  const values = first.map((x, k) => (period > 0 ? shorter(x - second[k]!, period) : x - second[k]!));
  return { times, values, ...normsOf(times, values) };
}

function normsOf(times: Float64Array, values: Float64Array): Pick<Difference, 'rms' | 'max' | 'maxTime' | 'final'> {
  let integral = 0;
  let length = 0;
  let max = -1;
  let maxTime = NaN;
  for (let k = 0; k < values.length; k++) {
    const size = Math.abs(values[k]!);
    if (size > max) {
      max = size;
      maxTime = times[k]!;
    }
    if (k === 0) continue;
    const [before, now] = [values[k - 1]!, values[k]!];
    const span = times[k]! - times[k - 1]!;
    // The square of a straight line, integrated exactly; a gap in either record is left out.
    const part = (span * (before * before + before * now + now * now)) / 3;
    if (!Number.isFinite(part)) continue;
    integral += part;
    length += span;
  }
  const final = values[values.length - 1]!;
  return { rms: length > 0 ? Math.sqrt(integral / length) : Math.abs(final), max: max < 0 ? NaN : max, maxTime, final };
}
