import type { ColumnUse } from './csvHeader.ts';
import { readNumber } from './numbers.ts';

/** A row or cell that could not be used; line and column as a person counts them, 0 and empty for the whole file. */
export interface CsvIssue {
  line: number;
  column: string;
  message: string;
}

const MOST_ISSUES = 1000;
/** Numbers held of one file: a gigabyte of memory. */
export const MOST_NUMBERS = 128e6;

/** The usable rows of a file as growing columns, and why the others are not used. */
export class RowStore {
  readonly uses: readonly ColumnUse[];
  rows = 0;
  skipped = 0;
  readonly width: number;
  private readonly step: number | null;
  private readonly issues: CsvIssue[] = [];
  private unnamed = 0;
  private readonly data: Float64Array[];
  private expected = 0;
  private readonly current: Float64Array;
  /** Rows of numbers seen, usable or not: time is counted over all of them. */
  private seen = 0;
  private lastLine = 0;
  /** A row that is earlier than the last one but later than the one before: one of the two is out of place. */
  private readonly doubtful: Float64Array;
  private doubtfulLine = 0;

  /** @param step time between rows (s) where it is not read, else null */
  constructor(uses: readonly ColumnUse[], width: number, step: number | null) {
    this.uses = uses;
    this.width = width;
    this.step = step;
    this.data = uses.map(() => new Float64Array(1024));
    this.current = new Float64Array(uses.length);
    this.doubtful = new Float64Array(uses.length);
  }

  row(cells: readonly string[], line: number, decimalComma: boolean): void {
    const time = this.step === null ? 0 : this.seen * this.step;
    this.seen++;
    const { uses, current } = this;
    if (cells.length !== this.width && !this.fits(cells, line, decimalComma)) return;
    for (let c = 0; c < uses.length; c++) {
      const use = uses[c]!;
      const cell = use.index < 0 ? '' : cells[use.index];
      const value = use.index < 0 ? time : cell === undefined ? NaN : readNumber(cell, decimalComma) * use.factor;
      if (value - value !== 0 && !this.gap(cells, cell, use, line, decimalComma)) return;
      current[c] = value;
    }
    this.accept(line);
  }

  /** A row with a finite number in every column of the file. */
  numbers(values: Float64Array, line: number): void {
    const { uses, current, step } = this;
    for (let c = 0; c < uses.length; c++) {
      const { index, factor } = uses[c]!;
      current[c] = index < 0 ? this.seen * step! : values[index]! * factor;
    }
    this.seen++;
    this.accept(line);
  }

  finish(): void {
    this.dropDoubtful();
  }

  /** Views into buffers that may be longer: a copy would take as much memory again. */
  columns(): Float64Array[] {
    return this.data.map((column) => column.subarray(0, this.rows));
  }

  /** In the order of the file; the last one counts those beyond the first 1,000. */
  sortedIssues(): CsvIssue[] {
    const sorted = [...this.issues].sort((a, b) => a.line - b.line);
    if (this.unnamed > 0) sorted.push({ line: 0, column: '', message: `and ${this.unnamed} more` });
    return sorted;
  }

  /** Names something that costs no row. */
  note(line: number, column: string, message: string): void {
    if (this.issues.length < MOST_ISSUES) this.issues.push({ line, column, message });
    else this.unnamed++;
  }

  private skip(line: number, column: string, message: string): false {
    this.skipped++;
    this.note(line, column, message);
    return false;
  }

  /** Cells beyond the header's shift the meaning of a row, unless they are empty. */
  private fits(cells: readonly string[], line: number, decimalComma: boolean): boolean {
    const extra = cells.slice(this.width).some((cell) => cell.trim() !== '');
    if (!extra) return true;
    if (this.retry(cells, line, decimalComma)) return false;
    return this.skip(
      line,
      String(this.width + 1),
      `the row has ${cells.length} cells where there are ${this.width} columns`,
    );
  }

  /** True where a cell without a number only leaves a gap. */
  private gap(
    cells: readonly string[],
    cell: string | undefined,
    use: ColumnUse,
    line: number,
    decimalComma: boolean,
  ): boolean {
    if (this.retry(cells, line, decimalComma)) return false;
    if (use.needed) {
      if (cells.every((c) => c.trim() === '')) return this.skip(line, '', 'the row is empty');
      return this.skip(line, use.title, reasonFor(cell, cells.length, this.width, decimalComma));
    }
    if (cell !== undefined && !/^\s*(nan)?\s*$/i.test(cell))
      this.note(
        line,
        use.title,
        `${reasonFor(cell, cells.length, this.width, decimalComma)}; the row is used without it`,
      );
    return true;
  }

  /** Reads a row again without the `#` remark behind its numbers. */
  private retry(cells: readonly string[], line: number, decimalComma: boolean): boolean {
    const at = cells.findIndex((cell) => cell.includes('#'));
    if (at < 0) return false;
    this.seen--;
    this.row([...cells.slice(0, at), cells[at]!.slice(0, cells[at]!.indexOf('#'))], line, decimalComma);
    return true;
  }

  /** Takes the current row if its time is later than the last one's. */
  private accept(line: number): void {
    const { current, doubtful } = this;
    const t = current[0]!;
    const times = this.data[0]!;
    const last = this.rows > 0 ? times[this.rows - 1]! : -Infinity;
    if (t > last) {
      this.dropDoubtful();
      return this.append(current, line);
    }
    if (this.doubtfulLine > 0 && t > doubtful[0]!) {
      // Two rows in a row agree that the last one is too late: it is the one out of place.
      this.skip(this.lastLine, this.uses[0]!.title, `the time ${last} s is later than that of the rows below`);
      this.rows--;
      this.append(doubtful, this.doubtfulLine);
      this.doubtfulLine = 0;
      return this.append(current, line);
    }
    this.dropDoubtful();
    if (this.rows === 1 || t > times[this.rows - 2]!) {
      doubtful.set(current);
      this.doubtfulLine = line;
    } else this.skipEarly(t, line);
  }

  private dropDoubtful(): void {
    if (this.doubtfulLine > 0) this.skipEarly(this.doubtful[0]!, this.doubtfulLine);
    this.doubtfulLine = 0;
  }

  private skipEarly(t: number, line: number): void {
    this.skip(
      line,
      this.uses[0]!.title,
      `the time ${t} s is not later than ${this.data[0]![this.rows - 1]} s of line ${this.lastLine}`,
    );
  }

  /** There is no room for one more row. */
  get full(): boolean {
    return (this.rows + 1) * this.uses.length > MOST_NUMBERS;
  }

  /** So many rows are to be expected: room for them is made at once. */
  expect(rows: number): void {
    this.expected = Math.min(rows, MOST_NUMBERS / this.uses.length);
  }

  private append(row: Float64Array, line: number): void {
    if (this.rows === this.data[0]!.length) {
      const capacity = Math.max(2 * this.rows, Math.ceil(this.expected));
      // One column after another: never all of them twice.
      for (let c = 0; c < this.data.length; c++) {
        const grown = new Float64Array(capacity);
        grown.set(this.data[c]!);
        this.data[c] = grown;
      }
    }
    for (let c = 0; c < row.length; c++) this.data[c]![this.rows] = row[c]!;
    this.rows++;
    this.lastLine = line;
  }
}

function reasonFor(cell: string | undefined, count: number, width: number, decimalComma: boolean): string {
  if (cell === undefined) return `the cell is missing: the row has ${count} of ${width}`;
  const text = cell.trim();
  if (text === '') return 'the cell is empty';
  const shown = `"${text.length > 24 ? `${text.slice(0, 23)}…` : text}"`;
  if (/^[+-]?(inf(inity)?|∞)$/i.test(text) || Math.abs(+text) === Infinity) return `${shown} is not a finite number`;
  if (decimalComma && text.includes('.')) return `${shown} has a point where the file has decimal commas`;
  return `${shown} is not a number`;
}
