/**
 * Times that do not rise from row to row, and what a person meant: rows the wrong way round, shuffled, several runs one
 * after another, a clock that was set late, one that counts whole seconds, rows doubled at events, single rows out of
 * place. What can be kept is kept, and said.
 */

export interface Order {
  /** Rows to keep, in their new order; null: all of them as they are. */
  rows: Int32Array | null;
  /** Rows left out one by one, and why. */
  dropped: { row: number; message: string }[];
  notes: string[];
  /** First rows of the runs found, where there are several. */
  runs: number[];
}

/** Share of equal neighbours from which a clock is called coarse. */
const COARSE = 0.4;
/** Share of falling neighbours from which a file runs backwards. */
const BACKWARDS = 0.9;
/** Single rows out of place that are left out; more of them were shuffled. */
const FEW = 0.02;
/** Jumps so many typical steps long, and so many seconds, are a clock being set. */
const JUMP = 1e5;
const LONG = 1e6;
/** Rows before a clock is set, at most this share. */
const EARLY = 0.5;
const MOST_RUNS = 100;

/**
 * @param t times of n rows, s; changed in place where a clock is mended
 * @param same whether two rows hold the same numbers
 * @param run which of several runs is wanted, from 1
 */
export function orderOf(t: Float64Array, same: (a: number, b: number) => boolean, run = 1): Order {
  const order: Order = { rows: null, dropped: [], notes: [], runs: [] };
  const n = t.length;
  if (n < 2) return order;
  let [falls, equals] = count(t);
  if (falls === 0 && equals === 0) {
    lateClock(t, order);
    return order;
  }
  let rows: Int32Array = Int32Array.from({ length: n }, (_, i) => i);
  if (falls >= BACKWARDS * (n - 1) || (falls > 0 && falls + equals === n - 1)) {
    rows.reverse();
    order.notes.push('the times run backwards: the rows are turned round');
  } else if (falls > 0) rows = unfallen(t, order, run);
  [falls, equals] = count(t, rows);
  if (equals > 0) rows = untied(t, rows, order, same);
  order.rows = rows;
  return order;
}

function count(t: Float64Array, rows?: Int32Array): [falls: number, equals: number] {
  let [falls, equals] = [0, 0];
  const n = rows ? rows.length : t.length;
  for (let i = 1; i < n; i++) {
    const step = rows ? t[rows[i]!]! - t[rows[i - 1]!]! : t[i]! - t[i - 1]!;
    if (step < 0) falls++;
    else if (step === 0) equals++;
  }
  return [falls, equals];
}

/** Median of the steps forwards. */
export function typicalStep(t: ArrayLike<number>, from = 0, to = t.length): number {
  const steps: number[] = [];
  const stride = Math.max(1, Math.floor((to - from) / 5000));
  for (let i = from + 1; i < to; i += stride) if (t[i]! > t[i - 1]!) steps.push(t[i]! - t[i - 1]!);
  steps.sort((a, b) => a - b);
  return steps[steps.length >> 1] ?? 0;
}

/** A rising time that leaps by years after its first rows: they were written before the clock was set. */
function lateClock(t: Float64Array, order: Order): void {
  const step = typicalStep(t);
  for (let i = 1; i <= EARLY * t.length; i++)
    if (t[i]! - t[i - 1]! > Math.max(JUMP * step, LONG)) return shiftFirst(t, i, step, order);
}

function shiftFirst(t: Float64Array, rows: number, step: number, order: Order): void {
  const by = t[rows]! - step - t[rows - 1]!;
  for (let i = 0; i < rows; i++) t[i]! += by;
  order.notes.push(
    `the clock was set after the first ${rows === 1 ? 'row' : `${rows} rows`}: they are put before the others, one step apart`,
  );
}

function unfallen(t: Float64Array, order: Order, run: number): Int32Array {
  const n = t.length;
  const falls: number[] = [];
  for (let i = 1; i < n; i++) if (t[i]! < t[i - 1]!) falls.push(i);
  const all = (): Int32Array => Int32Array.from({ length: n }, (_, i) => i);
  const step = typicalStep(t);
  // One fall, far down, soon: a clock that was set.
  const [fall] = falls;
  if (falls.length === 1 && fall! <= EARLY * n && fall! < n - 1) {
    const drop = t[fall! - 1]! - t[fall!]!;
    if (t[0]! > t[n - 1]! && drop > JUMP * step && drop > LONG) {
      shiftFirst(t, fall!, step, order);
      return all();
    }
  }
  const starts = [0, ...falls];
  const lengthOf = (i: number): number => (starts[i + 1] ?? n) - starts[i]!;
  const early = (i: number): boolean => t[starts[i]!]! - t[0]! <= 10 * step + 0.1 * (t[starts[1]! - 1]! - t[0]!);
  if (starts.length <= MOST_RUNS && starts.every((_, i) => lengthOf(i) > 2 && early(i))) {
    order.runs = starts;
    const chosen = Math.min(Math.max(1, run), starts.length) - 1;
    order.notes.push(
      `the times start again ${starts.length === 2 ? 'once' : `${starts.length - 1} times`}: the file holds ${starts.length} runs, and run ${chosen + 1} (${lengthOf(chosen)} rows) is taken`,
    );
    return Int32Array.from({ length: lengthOf(chosen) }, (_, i) => starts[chosen]! + i);
  }
  const kept = rising(t);
  const out = n - kept.length;
  let equal = 0;
  for (let i = 1; i < n; i++) if (t[i] === t[i - 1]) equal++;
  if (out - equal <= Math.max(1, FEW * n)) {
    const inside = new Set(kept);
    let last = -1;
    for (let i = 0; i < n; i++) {
      if (inside.has(i)) last = i;
      // Rows with the time of their neighbour are another matter.
      else if (last >= 0 && t[i] === t[last]) inside.add(i);
      else
        order.dropped.push({
          row: i,
          message:
            last < 0 || t[i]! > t[last]!
              ? `the time ${t[i]} s is later than that of the rows below`
              : `the time ${t[i]} s is not later than ${t[last]} s`,
        });
    }
    return Int32Array.from(inside).sort();
  }
  order.notes.push('the rows are not in the order of their times: they are sorted by time');
  return all().sort((a, b) => t[a]! - t[b]! || a - b);
}

/**
 * Rows of a longest rising sequence (patience sorting; Fredman 1975): what must be left out is least. From the end, so
 * that of two rows that exclude each other the first stays.
 */
function rising(t: Float64Array): Int32Array {
  const heads: number[] = [];
  const after = new Int32Array(t.length);
  for (let i = t.length - 1; i >= 0; i--) {
    let [low, high] = [0, heads.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (t[heads[middle]!]! > t[i]!) low = middle + 1;
      else high = middle;
    }
    after[i] = low > 0 ? heads[low - 1]! : -1;
    heads[low] = i;
  }
  const kept = new Int32Array(heads.length);
  for (let k = 0, i = heads.at(-1) ?? -1; k < kept.length; k++, i = after[i]!) kept[k] = i;
  return kept;
}

/** Equal times: a coarse clock is spread, equal rows are one, rows at an event stay both. */
function untied(t: Float64Array, rows: Int32Array, order: Order, same: (a: number, b: number) => boolean): Int32Array {
  const groups: number[] = [0];
  for (let i = 1; i < rows.length; i++) if (t[rows[i]!]! !== t[rows[i - 1]!]!) groups.push(i);
  const equals = rows.length - groups.length;
  if (groups.length === 1 && rows.length > 3) {
    for (let i = 0; i < rows.length; i++) t[rows[i]!] = t[rows[0]!]! + i / 60;
    order.notes.push(
      'all times are the same (too few digits?): the rows are put 1/60 s apart; another column or a step can be chosen',
    );
    return rows;
  }
  let copies = 0;
  for (let i = 1; i < rows.length; i++) if (t[rows[i]!]! === t[rows[i - 1]!]! && same(rows[i]!, rows[i - 1]!)) copies++;
  if (equals >= COARSE * rows.length && groups.length > 1 && copies < equals / 2) {
    spread(t, rows, groups);
    order.notes.push(
      `the clock counts in steps of ${+typicalStep(groups.map((g) => t[rows[g]!]!)).toPrecision(6)} s with about ${groupSize(groups, rows.length)} rows each: rows are spread evenly between its steps`,
    );
    return rows;
  }
  const kept: number[] = [];
  let events = 0;
  for (const row of rows) {
    const last = kept.at(-1);
    if (last !== undefined && t[row]! <= t[last]!) {
      if (same(row, last)) {
        order.dropped.push({
          row,
          message: `the time ${t[row]} s is not later than ${t[last]} s of the same row before`,
        });
        continue;
      }
      t[row] = nextUp(t[last]!);
      events++;
    }
    kept.push(row);
  }
  if (events > 0)
    order.notes.push(
      `${events} ${events === 1 ? 'row has' : 'rows have'} the time of the row before (an event): both are kept, the second at once after the first`,
    );
  return Int32Array.from(kept);
}

/** Rows of most readings. */
function groupSize(groups: readonly number[], rows: number): number {
  const sizes = groups.map((g, k) => (groups[k + 1] ?? rows) - g).sort((a, b) => a - b);
  return sizes[sizes.length >> 1]!;
}

/** Gives rows of one reading of a coarse clock times evenly between it and the next. The first and last reading may be partial. */
function spread(t: Float64Array, rows: Int32Array, groups: readonly number[]): void {
  const sizes = groups.map((g, k) => (groups[k + 1] ?? rows.length) - g);
  const inner = sizes.slice(1, -1);
  const typical = inner.length > 0 ? [...inner].sort((a, b) => a - b)[inner.length >> 1]! : Math.max(...sizes);
  const values = groups.map((g) => t[rows[g]!]!);
  const tick = typicalStep(values);
  const last = groups.length - 1;
  for (let k = 0; k <= last; k++) {
    const size = sizes[k]!;
    const [from, to] = [values[k]!, k < last ? values[k + 1]! : values[k]! + tick];
    // A recording may begin and end between two readings.
    const whole = k === 0 || k === last ? Math.max(size, typical) : size;
    const missing = k === 0 ? whole - size : 0;
    for (let j = 0; j < size; j++) t[rows[groups[k]! + j]!] = from + ((j + missing) * (to - from)) / whole;
  }
}

const [float, bits] = (() => {
  const one = new Float64Array(1);
  return [one, new BigInt64Array(one.buffer)] as const;
})();

/** The next larger double. */
function nextUp(x: number): number {
  float[0] = x === 0 ? 0 : x;
  bits[0]! += x >= 0 ? 1n : -1n;
  return float[0];
}
