import { isMissing, isSpreadsheetError } from '../layout/errors.ts';
import type { TimeReader } from '../time/reader.ts';
import { isBareGroup } from './grouped.ts';
import { Issues, type CsvIssue } from './issues.ts';
import { readNumber } from './numbers.ts';

/** How one column of a file is used. */
export interface ColumnUse {
  /** Position in the file, 0-based; -1 for a time that is counted, or read from text. */
  index: number;
  /** Canonical name. */
  name: string;
  /** Multiply by this for SI and radians. */
  factor: number;
  /** As written in the file, for messages. */
  title: string;
  /** Without it a row can't be drawn; others may have gaps. */
  needed: boolean;
}

/** What older C libraries print: `1.#QNAN`, `-1.#IND`, `1.#INF`; no remark behind a number. */
const NO_NUMBER = /^[+-]?1\.#[a-z]+\d*$/i;
/** Numbers held of one file: a gigabyte of memory. */
export const MOST_NUMBERS = 128e6;

export interface StoreOptions {
  /** Cells of a row. */
  width: number;
  /** Time between rows (s) where it is not read, else null. */
  step: number | null;
  /** For a time that is no plain number, else null. */
  time: TimeReader | null;
  decimalComma: boolean;
}

/** The usable rows of a file as growing columns, and why the others are not used. Times are put in order later. */
export class RowStore {
  readonly uses: readonly ColumnUse[];
  readonly width: number;
  rows = 0;
  skipped = 0;
  readonly issues = new Issues();
  private readonly options: StoreOptions;
  private readonly data: Float64Array[];
  private expected = 0;
  private readonly current: Float64Array;
  /** Of each use, for lines of plain numbers. */
  private readonly places: Int32Array;
  private readonly factors: Float64Array;
  /** Rows of numbers seen, usable or not: time is counted over all of them. */
  private seen = 0;
  /** First rows and lines of stretches whose lines follow one another. */
  private stretches: { row: number; line: number }[] = [];
  /** Line of a row that would go on with the last stretch. */
  private nextLine = -1;
  /** Lines of separators alone: behind the last row they are nothing. */
  private blank: number[] = [];

  constructor(uses: readonly ColumnUse[], options: StoreOptions) {
    this.uses = uses;
    this.options = options;
    this.width = options.width;
    this.data = uses.map(() => new Float64Array(1024));
    this.current = new Float64Array(uses.length);
    this.places = Int32Array.from(uses, (use) => use.index);
    this.factors = Float64Array.from(uses, (use) => use.factor);
  }

  row(cells: readonly string[], line: number): void {
    const { step, time, decimalComma } = this.options;
    const counted = step === null ? 0 : this.seen * step;
    this.seen++;
    const { uses, current } = this;
    if ((cells[0] ?? '').trim() === '' && cells.every((cell) => cell.trim() === '')) {
      this.blank.push(line);
      return;
    }
    if (this.blank.length > 0) this.nameBlank();
    if (cells.length !== this.width && !this.fits(cells, line)) return;
    for (let c = 0; c < uses.length; c++) {
      const use = uses[c]!;
      const cell = use.index < 0 ? '' : cells[use.index];
      let value = NaN;
      if (c === 0 && time) value = time(cells);
      else if (use.index < 0) value = counted;
      else if (cell !== undefined) value = readNumber(cell, decimalComma) * use.factor;
      if (value - value !== 0) {
        if (!this.gap(cells, cell, use, line)) return;
        value = NaN;
      }
      current[c] = value;
    }
    if (this.empty()) {
      this.skip(line, '', 'the row is empty');
      return;
    }
    this.append(line);
  }

  /** A row with a finite number in every column of the file. */
  numbers(values: Float64Array, line: number): void {
    if (this.blank.length > 0) this.nameBlank();
    const { places, factors } = this;
    const [data, row] = [this.data, this.place(line)];
    for (let c = 0; c < places.length; c++) {
      const place = places[c]!;
      data[c]![row] = place < 0 ? this.seen * this.options.step! : values[place]! * factors[c]!;
    }
    this.seen++;
  }

  /** Views into buffers that may be longer: a copy would take as much memory again. */
  columns(): Float64Array[] {
    return this.data.map((column) => column.subarray(0, this.rows));
  }

  /** Line of a row that was taken. */
  lineOf(row: number): number {
    let [low, high] = [0, this.stretches.length - 1];
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.stretches[middle]!.row <= row) low = middle;
      else high = middle - 1;
    }
    const stretch = this.stretches[low];
    return stretch ? stretch.line + row - stretch.row : 0;
  }

  /** Leaves rows in another order, or fewer of them. */
  reorder(rows: Int32Array): void {
    const lines = Array.from(rows, (row) => this.lineOf(row));
    for (const column of this.data) {
      const old = column.slice(0, this.rows);
      for (let i = 0; i < rows.length; i++) column[i] = old[rows[i]!]!;
    }
    this.rows = rows.length;
    this.stretches = lines.flatMap((line, row) => (row > 0 && line === lines[row - 1]! + 1 ? [] : [{ row, line }]));
  }

  /** Names a row that is not used. */
  skip(line: number, column: string, message: string): false {
    this.skipped++;
    this.issues.add(line, column, message);
    return false;
  }

  sortedIssues(): CsvIssue[] {
    return this.issues.sorted();
  }

  /** There is no room for one more row. */
  get full(): boolean {
    return (this.rows + 1) * this.uses.length > MOST_NUMBERS;
  }

  /** So many rows are to be expected: room for them is made at once. */
  expect(rows: number): void {
    this.expected = Math.min(rows, MOST_NUMBERS / this.uses.length);
  }

  private nameBlank(): void {
    for (const line of this.blank) this.skip(line, '', 'the row is empty');
    this.blank = [];
  }

  /** Nothing but a time. */
  private empty(): boolean {
    for (let c = 1; c < this.current.length; c++) if (this.current[c] === this.current[c]) return false;
    return this.current.length > 1;
  }

  /** Cells beyond the header's shift the meaning of a row, unless they are empty. */
  private fits(cells: readonly string[], line: number): boolean {
    const extra = cells.slice(this.width).some((cell) => cell.trim() !== '');
    if (!extra) return true;
    if (this.retry(cells, line)) return false;
    return this.skip(
      line,
      String(this.width + 1),
      `the row has ${cells.length} cells where there are ${this.width} columns${
        cells.length === 2 * this.width
          ? '; decimal commas between commas? write the file with semicolons, or with points'
          : cells.some((cell, i) => /^\s*[+-]?[1-9]\d{0,2}$/.test(cell) && /^\d{3}(?:\.\d*)?$/.test(cells[i + 1] ?? ''))
            ? '; thousands between commas? write the numbers without them, or in quotes'
            : ''
      }`,
    );
  }

  /** True where a cell without a number only leaves a gap. */
  private gap(cells: readonly string[], cell: string | undefined, use: ColumnUse, line: number): boolean {
    if (this.retry(cells, line)) return false;
    const reason = (): string => reasonFor(cell, cells.length, this.width, this.options.decimalComma);
    if (use.needed) {
      return this.skip(line, use.title, use.index < 0 ? 'there is no time' : reason());
    }
    if (cell !== undefined && !isMissing(cell))
      this.issues.add(line, use.title, `${reason()}; the row is used without it`);
    return true;
  }

  /** Reads a row again without the `#` remark behind its numbers. */
  private retry(cells: readonly string[], line: number): boolean {
    const at = cells.findIndex(
      (cell) => cell.includes('#') && !isSpreadsheetError(cell.trim()) && !NO_NUMBER.test(cell.trim()),
    );
    if (at < 0) return false;
    this.seen--;
    this.row([...cells.slice(0, at), cells[at]!.slice(0, cells[at]!.indexOf('#'))], line);
    return true;
  }

  private append(line: number): void {
    const { current, data } = this;
    const row = this.place(line);
    for (let c = 0; c < current.length; c++) data[c]![row] = current[c]!;
  }

  /** Room for one more row: its number. */
  private place(line: number): number {
    if (this.rows === this.data[0]!.length) {
      const capacity = Math.max(2 * this.rows, Math.ceil(this.expected));
      // One column after another: never all of them twice.
      for (let c = 0; c < this.data.length; c++) {
        const grown = new Float64Array(capacity);
        grown.set(this.data[c]!);
        this.data[c] = grown;
      }
    }
    if (line !== this.nextLine) this.stretches.push({ row: this.rows, line });
    this.nextLine = line + 1;
    return this.rows++;
  }
}

function reasonFor(cell: string | undefined, count: number, width: number, decimalComma: boolean): string {
  if (cell === undefined) return `the cell is missing: the row has ${count} of ${width}`;
  const text = cell.trim();
  if (text === '') return 'the cell is empty';
  const shown = `"${text.length > 24 ? `${text.slice(0, 23)}…` : text}"`;
  if (isSpreadsheetError(text)) return `${shown} is a spreadsheet's error: the cell has no value`;
  if (/^[+-]?(inf(inity)?|∞)$/i.test(text) || /^[+-]?1\.#inf/i.test(text) || Math.abs(+text) === Infinity)
    return `${shown} is not a finite number`;
  if (isBareGroup(text, decimalComma === true)) {
    const whole = text.replace(/[.,]/, '');
    return `${shown} could be ${whole} or ${text.replace(',', '.')}: write it without a thousands separator, or with the file's decimal ${decimalComma ? 'comma' : 'point'}`;
  }
  if (!decimalComma && /^[+-]?\d+,\d+$/.test(text)) return `${shown} has a comma where the file has decimal points`;
  if (decimalComma && text.includes('.')) return `${shown} has a point where the file has decimal commas`;
  return `${shown} is not a number`;
}
