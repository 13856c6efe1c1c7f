import type { Envelope } from './envelope.ts';

/**
 * A curve over rising times as few points as a picture can show: in each of `buckets` equal spans of [from, to] its
 * least and its largest value, in the order in which they come where that is known cheaply; all points where there are few.
 * Rows before and after the range are kept, so that lines leave the picture. `NaN` marks a gap.
 *
 * @param t rising times, s
 * @param values of the curve, one a time
 * @param envelope of the values
 * @param from first time shown, s
 * @param to last time shown, s
 * @param buckets equal spans of the picture's width
 * @param settled rows whose values no longer change
 */
export function decimated(
  t: Float64Array,
  values: Float64Array,
  envelope: Envelope,
  from: number,
  to: number,
  buckets: number,
  settled = values.length,
): { t: number[]; y: number[] } {
  const first = Math.max(0, upper(t, from) - 1);
  const last = Math.min(t.length, upper(t, to) + 1);
  const out: { t: number[]; y: number[] } = { t: [], y: [] };
  if (last - first <= 4 * buckets) {
    for (let i = first; i < last; i++) {
      out.t.push(t[i]!);
      out.y.push(values[i]!);
    }
    return out;
  }
  const width = (to - from) / buckets;
  for (let b = 0, row = first; b < buckets && row < last; b++) {
    const end = b === buckets - 1 ? last : Math.min(last, Math.max(row + 1, upper(t, from + (b + 1) * width)));
    const [low, high] = envelope.range(values, row, end, settled);
    const at = t[row]!;
    const later = at + 0.5 * (t[end - 1]! - at);
    if (low > high) {
      out.t.push(at);
      out.y.push(NaN);
    } else {
      const rising = values[row]! <= values[end - 1]!;
      out.t.push(at, later);
      out.y.push(rising ? low : high, rising ? high : low);
    }
    row = end;
  }
  return out;
}

/** Index of the first time after `x`. */
function upper(t: Float64Array, x: number): number {
  let low = 0;
  let high = t.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (t[middle]! <= x) low = middle + 1;
    else high = middle;
  }
  return low;
}
