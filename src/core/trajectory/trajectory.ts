/**
 * A motion as columns of numbers: what a live run, a CSV file and a comparison look like to every view.
 * Rows are only ever appended; `column()` returns a view that is valid until the next `append`.
 */
export class Trajectory {
  readonly columns: readonly string[];
  private data: Float64Array[];
  private count = 0;
  private readonly index: ReadonlyMap<string, number>;

  /** @param columns names; the first must be `t` (seconds, increasing). */
  constructor(columns: readonly string[], capacity = 1024) {
    if (columns[0] !== 't') throw new Error('the first column of a trajectory is t');
    this.columns = columns;
    this.index = new Map(columns.map((name, i) => [name, i]));
    this.data = columns.map(() => new Float64Array(capacity));
  }

  /** A trajectory of columns that are handed over, not copied; all of one length. */
  static of(columns: readonly string[], data: readonly Float64Array[]): Trajectory {
    const made = new Trajectory(columns, 0);
    if (data.length !== columns.length || data.some((column) => column.length !== data[0]!.length)) throw new Error('the columns are not of one length');
    made.data = [...data];
    made.count = data[0]!.length;
    return made;
  }

  get length(): number {
    return this.count;
  }

  get start(): number {
    return this.count > 0 ? this.data[0]![0]! : 0;
  }

  /** Time of the last row (0 when empty). */
  get end(): number {
    return this.count > 0 ? this.data[0]![this.count - 1]! : 0;
  }

  has(name: string): boolean {
    return this.index.has(name);
  }

  /** Values of one column, or undefined if there is no such column. Do not write to it. */
  column(name: string): Float64Array | undefined {
    const i = this.index.get(name);
    return i === undefined ? undefined : this.data[i]!.subarray(0, this.count);
  }

  /** Appends `rows` rows given column by column. */
  append(chunk: readonly Float64Array[], rows: number): void {
    if (chunk.length !== this.columns.length) {
      throw new Error(`a chunk of ${chunk.length} columns does not fit a trajectory of ${this.columns.length}`);
    }
    const needed = this.count + rows;
    if (needed > this.data[0]!.length) {
      const capacity = Math.max(needed, 2 * this.data[0]!.length);
      this.data = this.data.map((old) => {
        const grown = new Float64Array(capacity);
        grown.set(old.subarray(0, this.count));
        return grown;
      });
    }
    for (let c = 0; c < chunk.length; c++) this.data[c]!.set(chunk[c]!.subarray(0, rows), this.count);
    this.count = needed;
  }

  /** Index of the last row with t <= time, in 0 .. length - 2 (0 when there are fewer than two rows). */
  locate(time: number): number {
    const t = this.data[0]!;
    let low = 0;
    let high = Math.max(0, this.count - 2);
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (t[middle]! <= time) low = middle;
      else high = middle - 1;
    }
    return low;
  }
}
