/** Numbers held of a motion that grows (192 MB): an hour at 1 kHz stays in memory, thinned. */
const MOST_HELD = 24e6;

/**
 * A motion as columns of numbers: what a live run, a CSV file and a comparison look like to every view.
 * Rows are appended; `column()` returns a view that is valid until the next `append`. When there would be more than it
 * may hold, every second row is let go, and of those to come only each `stride`-th is kept, and always the newest.
 */
export class Trajectory {
  readonly columns: readonly string[];
  /** Rises when rows were let go: what was made from row numbers is to be made anew. */
  generation = 0;
  /** From a file, whose angles may jump by whole turns from row to row: the shorter way is taken between rows. */
  recorded = false;
  /** Straight lines between rows, though rates are known: what a method has between two steps of a stiff equation is no more than that. */
  straight = false;
  /** One row in so many is kept. */
  stride = 1;
  private data: Float64Array[];
  /** Every second row of `data`, made little by little before they are all that is kept: thinning at once would stop the page. */
  private thinner: Float64Array[] | null = null;
  private prepared = 0;
  private count = 0;
  private seen = 0;
  /** The last row stands between two kept ones, until the next comes. */
  private loose = false;
  private readonly most: number;
  private readonly index: ReadonlyMap<string, number>;

  /**
   * @param columns names; the first must be `t` (seconds, increasing)
   * @param capacity rows to make room for at once
   * @param most rows held
   */
  constructor(columns: readonly string[], capacity = 1024, most = Math.floor(MOST_HELD / columns.length)) {
    if (columns[0] !== 't') throw new Error('the first column of a trajectory is t');
    this.columns = columns;
    this.most = Math.max(2, most);
    this.index = new Map(columns.map((name, i) => [name, i]));
    const room = Math.min(capacity, this.most);
    this.data = columns.map(() => new Float64Array(room));
  }

  /** A trajectory of columns that are handed over, not copied; all of one length. */
  static of(columns: readonly string[], data: readonly Float64Array[]): Trajectory {
    const made = new Trajectory(columns, 0);
    if (data.length !== columns.length || data.some((column) => column.length !== data[0]!.length))
      throw new Error('the columns are not of one length');
    made.data = [...data];
    made.count = made.seen = data[0]!.length;
    return made;
  }

  /** The rates of a column, for what bends between rows; undefined where they are not known, or not to be used. */
  rateOf(name: string): Float64Array | undefined {
    return this.straight ? undefined : this.column(`${name}_dot`);
  }

  get length(): number {
    return this.count;
  }

  /** Rows that stay as they are while none is let go: all, or all but the newest. */
  get settled(): number {
    return this.loose ? this.count - 1 : this.count;
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
    let from = 0;
    while (from < rows) {
      this.dropLoose();
      while (this.count >= this.most) this.thin();
      const room = this.most - this.count;
      const taken = Math.min(rows - from, room * this.stride);
      this.take(chunk, from, from + taken);
      from += taken;
      // As many rows as came: half of all are ready when there is no more room.
      if (2 * this.settled > this.most) this.prepare(this.prepared + taken);
    }
  }

  /** Takes the rows of a chunk that fall on the stride, and the last one. */
  private take(chunk: readonly Float64Array[], from: number, to: number): void {
    const { stride, seen, count } = this;
    const first = from + ((stride - (seen % stride)) % stride);
    const kept = Math.max(0, Math.ceil((to - first) / stride));
    const loose = kept === 0 || first + (kept - 1) * stride !== to - 1;
    this.reserve(count + kept + (loose ? 1 : 0));
    for (let c = 0; c < chunk.length; c++) {
      const column = this.data[c]!;
      if (stride === 1) column.set(chunk[c]!.subarray(from, to), count);
      else for (let k = 0; k < kept; k++) column[count + k] = chunk[c]![first + k * stride]!;
      if (loose) column[count + kept] = chunk[c]![to - 1]!;
    }
    this.count = count + kept + (loose ? 1 : 0);
    this.seen = seen + to - from;
    this.loose = loose;
  }

  private dropLoose(): void {
    if (this.loose) this.count--;
    this.loose = false;
  }

  /** Copies every second row, up to so many of them. */
  private prepare(rows: number): void {
    const room = this.data[0]!.length;
    const to = Math.min(rows, Math.ceil(this.settled / 2));
    this.thinner ??= this.data.map(() => new Float64Array(room));
    for (let c = 0; c < this.data.length; c++) everySecond(this.data[c]!, this.thinner[c]!, this.prepared, to);
    this.prepared = Math.max(this.prepared, to);
  }

  /** Lets every second row go. */
  private thin(): void {
    this.prepare(this.count);
    this.data = this.thinner!;
    this.count = this.prepared;
    this.thinner = null;
    this.prepared = 0;
    this.stride *= 2;
    this.generation++;
  }

  private reserve(rows: number): void {
    if (rows <= this.data[0]!.length) return;
    this.thinner = null;
    this.prepared = 0;
    const capacity = Math.max(rows, 2 * this.data[0]!.length);
    for (let c = 0; c < this.data.length; c++) {
      const grown = new Float64Array(capacity);
      grown.set(this.data[c]!.subarray(0, this.count));
      this.data[c] = grown;
    }
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

function everySecond(of: Float64Array, into: Float64Array, from: number, to: number): void {
  for (let k = from; k < to; k++) into[k] = of[2 * k]!;
}
