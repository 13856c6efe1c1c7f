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
