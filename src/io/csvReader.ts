import Papa from 'papaparse';
import type { SystemMeta } from '../core/systems/types.ts';
import { readHeader, type ColumnUse, type HeaderReading } from './csvHeader.ts';
import { readNumber } from './numbers.ts';

/** A row or cell that could not be used; line and column as a person counts them, 0 and empty for the whole file. */
export interface CsvIssue {
  line: number;
  column: string;
  message: string;
}

export interface CsvOptions {
  systems: Readonly<Record<string, SystemMeta>>;
  /** Answers `needs-time-step`, s. */
  timeStep?: number;
}

export type CsvResult =
  | {
      kind: 'motion';
      systemId: string;
      columns: string[];
      data: Float64Array[];
      rows: number;
      skippedRows: number;
      /** The first of them, at most 1,000. */
      issues: CsvIssue[];
      /** How the file was understood. */
      notes: string[];
      /** JSON of a `# scenario:` comment, or null. */
      scenario: unknown;
    }
  | { kind: 'needs-time-step'; offeredStep: number; columns: number }
  | { kind: 'unusable'; issues: CsvIssue[] };

const MOST_ISSUES = 1000;
/** The report's player drew 60 rows a second. */
const OFFERED_STEP = 1 / 60;
/** Coordinates of the report's own files, which have no header. */
const HEADERLESS_SYSTEM = 'ripstik';

/** Reads CSV text into columns: layout first (separator, header), then row by row without keeping the cells. */
export class CsvReader {
  private readonly options: CsvOptions;
  private readonly issues: CsvIssue[] = [];
  private skipped = 0;
  private notes: string[] = [];
  private scenario: unknown = null;
  private uses: ColumnUse[] = [];
  private systemId = '';
  private ready = false;
  private timed = true;
  private unusable = false;
  private needsStep = 0;
  private decimalComma = false;
  private data: Float64Array[] = [];
  private rows = 0;
  private lastTime = -Infinity;
  private lineNumbers: LineCounter | null = null;

  constructor(options: CsvOptions) {
    this.options = options;
  }

  read(text: string): void {
    const body = text.charCodeAt(0) === 0xfeff ? text.slice(1) : text;
    if (body.trim() === '') return this.refuse(0, '', 'the file is empty');
    if (body.slice(0, 4096).includes('\0')) return this.refuse(0, '', 'this is no text file (or not UTF-8 text); save it as CSV, UTF-8');
    const separator = separatorOf(body);
    this.decimalComma = separator === ';' && /\d,\d/.test(body.slice(0, 65536)) && !/\d\.\d/.test(body.slice(0, 65536));
    if (separator !== ',') this.notes.push(`separated by ${separator === '\t' ? 'tabs' : `"${separator}"`}${this.decimalComma ? ', decimal commas' : ''}`);
    const lines = (this.lineNumbers = new LineCounter(body));
    // Line ends: papaparse takes one kind for the whole file.
    const newline = body.includes('\r\n') ? '\r\n' : body.includes('\n') ? '\n' : '\r';
    Papa.parse<string[]>(body, {
      delimiter: separator,
      newline,
      fastMode: !body.includes('"'),
      step: ({ data, meta }, parser) => {
        this.row(data, lines.lineOfRowEndingAt(meta.cursor));
        if (this.unusable || this.needsStep > 0) parser.abort();
      },
    });
  }

  finish(): CsvResult {
    if (this.needsStep > 0) return { kind: 'needs-time-step', offeredStep: OFFERED_STEP, columns: this.needsStep };
    if (!this.unusable && this.rows === 0) this.refuse(0, '', this.ready ? 'no row could be used' : 'there are no rows of numbers');
    if (this.unusable) return { kind: 'unusable', issues: this.issues };
    if (this.rows === 1) this.notes.push('one row only: it is shown as a still picture');
    return {
      kind: 'motion',
      systemId: this.systemId,
      columns: this.timed ? this.uses.map((u) => u.name) : ['t', ...this.uses.map((u) => u.name)],
      data: this.data.map((column) => column.slice(0, this.rows)),
      rows: this.rows,
      skippedRows: this.skipped,
      issues: this.issues,
      notes: this.notes,
      scenario: this.scenario,
    };
  }

  private row(cells: string[], line: number): void {
    const first = cells[0] ?? '';
    if (cells.length <= 1 && first.trim() === '') return;
    if (first.trimStart().startsWith('#')) return this.comment(cells);
    if (!this.ready) {
      if (!this.layout(cells, line)) return;
    }
    this.numbers(cells, line);
  }

  private comment(cells: readonly string[]): void {
    const text = cells.join(',');
    const match = /^\s*#\s*scenario:\s*(\{.*\})\s*$/.exec(text);
    if (!match || this.scenario !== null || match[1]!.length > 200_000) return;
    try {
      this.scenario = JSON.parse(match[1]!);
    } catch {
      this.notes.push('the scenario in the comments is not readable and was left aside');
    }
  }

  /** Decides what the columns mean. True when this row already holds numbers (no header). */
  private layout(cells: readonly string[], line: number): boolean {
    const numeric = cells.filter((c) => Number.isFinite(readNumber(c, this.decimalComma))).length;
    if (numeric > 0 && numeric >= cells.filter((c) => c.trim() !== '').length - 1) return this.headerless(cells, line);
    const reading: HeaderReading | string = readHeader(cells, this.options.systems);
    if (typeof reading === 'string') {
      this.refuse(line, '', reading);
      return false;
    }
    this.begin(reading.systemId, reading.uses, true);
    this.notes.push(...reading.notes);
    return false;
  }

  /** The report's own files: 10 columns of coordinates, or 11 with the time first. */
  private headerless(cells: readonly string[], line: number): boolean {
    const meta = this.options.systems[HEADERLESS_SYSTEM];
    const names = meta?.coordinates.map((q) => q.name) ?? [];
    const count = cells.at(-1)!.trim() === '' ? cells.length - 1 : cells.length;
    if (count !== names.length && count !== names.length + 1) {
      this.refuse(line, '', `there is no header, and ${count} columns are neither ${names.length} (coordinates in order) nor ${names.length + 1} (time first)`);
      return false;
    }
    const timed = count === names.length + 1;
    if (!timed && this.options.timeStep === undefined) {
      this.needsStep = count;
      return false;
    }
    const titles = timed ? ['t', ...names] : names;
    this.begin(HEADERLESS_SYSTEM, titles.map((name, index) => ({ index, name, factor: 1, title: String(index + 1) })), timed);
    this.notes.push(timed ? 'no header: time, then the coordinates in order (SI, radians)' : `no header: coordinates in order (SI, radians), ${this.options.timeStep} s apart`);
    return true;
  }

  private begin(systemId: string, uses: ColumnUse[], timed: boolean): void {
    this.systemId = systemId;
    this.uses = uses;
    this.timed = timed;
    this.data = Array.from({ length: uses.length + (timed ? 0 : 1) }, () => new Float64Array(1024));
    this.ready = true;
  }

  private numbers(cells: readonly string[], line: number): void {
    if (this.rows === this.data[0]!.length) this.grow();
    const { uses, data, rows } = this;
    const offset = this.timed ? 0 : 1;
    if (!this.timed) data[0]![rows] = rows * this.options.timeStep!;
    for (let c = 0; c < uses.length; c++) {
      const use = uses[c]!;
      const cell = cells[use.index];
      const value = cell === undefined ? NaN : readNumber(cell, this.decimalComma);
      if (value !== value) {
        // Multipliers and energies may be unknown for a row; without a coordinate or the time it can't be drawn.
        if (/^(lambda_\d|energy|residual)$/.test(use.name)) {
          data[c + offset]![rows] = NaN;
          continue;
        }
        return this.skip(line, use.title, reasonFor(cell));
      }
      data[c + offset]![rows] = value * use.factor;
    }
    const time = data[0]![rows]!;
    if (!(time > this.lastTime)) return this.skip(line, this.uses[0]!.title, `the time ${time} s is not after the row before (${this.lastTime} s)`);
    this.lastTime = time;
    this.rows++;
  }

  private skip(line: number, column: string, message: string): void {
    this.skipped++;
    if (this.issues.length < MOST_ISSUES) this.issues.push({ line, column, message });
  }

  private refuse(line: number, column: string, message: string): void {
    this.unusable = true;
    this.issues.push({ line, column, message });
  }

  private grow(): void {
    this.data = this.data.map((old) => {
      const grown = new Float64Array(2 * old.length);
      grown.set(old);
      return grown;
    });
  }
}

function reasonFor(cell: string | undefined): string {
  if (cell === undefined) return 'the cell is missing';
  const text = cell.trim();
  if (text === '') return 'the cell is empty';
  if (/^[+-]?(inf(inity)?|nan)$/i.test(text) || Math.abs(+text) === Infinity) return `"${text}" is not a finite number`;
  return `"${text.length > 24 ? `${text.slice(0, 23)}…` : text}" is not a number`;
}

/** The separator that splits the first lines of data into most cells. */
function separatorOf(text: string): string {
  const lines = text.slice(0, 65536).split(/\r\n|\n|\r/).filter((l) => l.trim() !== '' && !l.trimStart().startsWith('#')).slice(0, 5);
  const count = (separator: string): number => lines.reduce((sum, line) => sum + line.split(separator).length - 1, 0);
  // A decimal comma makes commas frequent; semicolons and tabs are never part of a number, so they go first.
  if (count('\t') >= lines.length) return '\t';
  if (count(';') >= lines.length) return ';';
  return ',';
}

/** Line numbers for character positions that only grow. */
class LineCounter {
  private readonly text: string;
  private at = 0;
  private line = 1;
  private rowStart = 1;

  constructor(text: string) {
    this.text = text;
  }

  /** 1-based line on which the row that ends at a character position began. */
  lineOfRowEndingAt(cursor: number): number {
    const start = this.rowStart;
    for (; this.at < cursor; this.at++) {
      const c = this.text.charCodeAt(this.at);
      if (c === 10 || (c === 13 && this.text.charCodeAt(this.at + 1) !== 10)) this.line++;
    }
    this.rowStart = this.line;
    return start;
  }
}
