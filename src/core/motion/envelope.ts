/** Rows in a block whose least and largest value are kept. */
const BLOCK = 64;

/**
 * Least and largest values of a growing column over any range of rows, for plots of millions of points: whole blocks
 * are looked up, only the ends of a range are gone through. Values that are not numbers are passed over.
 */
export class Envelope {
  private low: Float64Array = new Float64Array(16);
  private high: Float64Array = new Float64Array(16);
  /** Blocks that are complete. */
  private blocks = 0;

  /** Everything is to be read anew: rows were let go or changed. */
  clear(): void {
    this.blocks = 0;
  }

  /**
   * Range of `values[from..to)`; [Infinity, -Infinity] where there is no number.
   * @param settled rows that will not change any more: only of those are blocks kept
   */
  range(values: Float64Array, from: number, to: number, settled = values.length): [low: number, high: number] {
    this.extend(values, settled);
    let low = Infinity;
    let high = -Infinity;
    const look = (a: number, b: number): void => {
      for (let i = a; i < b; i++) {
        const v = values[i]!;
        if (v < low) low = v;
        if (v > high) high = v;
      }
    };
    const first = Math.ceil(from / BLOCK);
    const last = Math.min(this.blocks, Math.floor(to / BLOCK));
    if (first >= last) look(from, to);
    else {
      look(from, first * BLOCK);
      for (let k = first; k < last; k++) {
        if (this.low[k]! < low) low = this.low[k]!;
        if (this.high[k]! > high) high = this.high[k]!;
      }
      look(last * BLOCK, to);
    }
    return [low, high];
  }

  private extend(values: Float64Array, settled: number): void {
    const whole = Math.floor(Math.min(settled, values.length) / BLOCK);
    if (whole <= this.blocks) return;
    if (whole > this.low.length) {
      const grown = (old: Float64Array): Float64Array => {
        const next = new Float64Array(Math.max(whole, 2 * old.length));
        next.set(old);
        return next;
      };
      this.low = grown(this.low);
      this.high = grown(this.high);
    }
    for (let k = this.blocks; k < whole; k++) {
      let low = Infinity;
      let high = -Infinity;
      for (let i = k * BLOCK; i < (k + 1) * BLOCK; i++) {
        const v = values[i]!;
        if (v < low) low = v;
        if (v > high) high = v;
      }
      this.low[k] = low;
      this.high[k] = high;
    }
    this.blocks = whole;
  }
}

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
