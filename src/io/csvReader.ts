import Papa from 'papaparse';
import { LONGEST_FILE } from '../core/scenario/defaults.ts';
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

/** Lines of a header whose quoted titles hold line breaks. */
const LONGEST_HEADER = 50;

/**
 * Reads CSV text into columns: layout first (separator, header), then line by line without keeping the cells.
 * Lines are ours, so that their numbers are right, line ends may be mixed and comments may hold quotes; quoting
 * within a line is papaparse's.
 */
export class CsvReader {
  private readonly options: CsvOptions;
  private readonly timeStep: number | undefined;
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
  private separator = ',';
  private decimalComma = false;
  private data: Float64Array[] = [];
  private rows = 0;
  private lastTime = -Infinity;

  constructor(options: CsvOptions) {
    this.options = options;
    const step = options.timeStep;
    this.timeStep = step !== undefined && step > 0 && step < Infinity ? step : undefined;
  }

  read(text: string): void {
    const body = text.charCodeAt(0) === 0xfeff ? text.slice(1) : text;
    if (!/\S/.test(body)) return this.refuse(0, '', 'the file is empty');
    if (body.slice(0, 4096).includes('\0')) return this.refuse(0, '', 'this is no text file (or not UTF-8 text); save it as CSV, UTF-8');
    const sample = sampleOf(body);
    this.separator = separatorOf(sample);
    this.decimalComma = this.separator !== ',' && hasDecimalCommas(sample);
    if (this.separator !== ',') this.notes.push(`separated by ${this.separator === '\t' ? 'tabs' : `"${this.separator}"`}${this.decimalComma ? ', decimal commas' : ''}`);
    const lines = new Lines(body);
    while (!this.unusable && this.needsStep === 0 && lines.next()) this.line(lines);
  }

  private line(lines: Lines): void {
    const { text, number } = lines;
    if (COMMENT.test(text)) return this.comment(text);
    const quoted = text.includes('"');
    // A number holds no line break, so only the header is read on: a quote left open costs one row, not the file.
    const cells = !quoted ? text.split(this.separator) : this.ready ? this.unquoted(text) : this.unquoted(lines.throughOpenQuotes(LONGEST_HEADER));
    if (cells.every((cell) => cell === '' || cell.trim() === '')) return;
    if (!this.ready && !this.layout(cells, number)) return;
    this.numbers(cells, number);
  }

  private unquoted(text: string): string[] {
    return Papa.parse<string[]>(text, { delimiter: this.separator, newline: '\n' }).data[0] ?? [];
  }

  finish(): CsvResult {
    if (this.needsStep > 0) return { kind: 'needs-time-step', offeredStep: OFFERED_STEP, columns: this.needsStep };
    if (this.unusable || this.rows === 0) {
      const why = this.ready ? 'no row could be used' : 'there are no rows of numbers';
      return { kind: 'unusable', issues: this.issues.length > 0 ? this.issues : [{ line: 0, column: '', message: why }] };
    }
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

  private comment(line: string): void {
    // A spreadsheet quotes the line and doubles the quotes in it when it saves the file again.
    const text = line.trimStart().startsWith('"') ? this.unquoted(line).join(this.separator) : line;
    const match = /^\s*#\s*scenario:\s*(\{.*)$/.exec(text);
    if (!match || this.scenario !== null || match[1]!.length > LONGEST_FILE) return;
    try {
      // A spreadsheet also pads it with separators.
      this.scenario = JSON.parse(match[1]!.slice(0, match[1]!.lastIndexOf('}') + 1));
    } catch {
      this.notes.push('the scenario in the comments is not readable and was left aside');
    }
  }

  /** Decides what the columns mean. True when this row already holds numbers (no header). */
  private layout(cells: readonly string[], line: number): boolean {
    const numeric = cells.filter((c) => Number.isFinite(readNumber(c, this.decimalComma))).length;
    if (numeric > 0 && numeric >= cells.filter((c) => c.trim() !== '').length - 1) return this.headerless(cells, line);
    const reading: HeaderReading | string = readHeader(cells, this.options.systems, systemOf(this.scenario));
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
    let count = cells.length;
    while (count > 0 && cells[count - 1]!.trim() === '') count--;
    if (count !== names.length && count !== names.length + 1) {
      this.skip(line, '', `there is no header, and ${count} columns are neither ${names.length} (coordinates in order) nor ${names.length + 1} (time first)`);
      return false;
    }
    const timed = count === names.length + 1;
    if (!timed && this.timeStep === undefined) {
      this.needsStep = count;
      return false;
    }
    const titles = timed ? ['t', ...names] : names;
    this.begin(HEADERLESS_SYSTEM, titles.map((name, index) => ({ index, name, factor: 1, optional: false, title: `${index + 1} (${name})` })), timed);
    this.notes.push(timed ? 'no header: time, then the coordinates in order (SI, radians)' : `no header: coordinates in order (SI, radians), ${this.timeStep} s apart`);
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
    // A row that can't be used still takes its time.
    if (!this.timed) data[0]![rows] = (rows + this.skipped) * this.timeStep!;
    for (let c = 0; c < uses.length; c++) {
      const use = uses[c]!;
      const cell = cells[use.index];
      const value = cell === undefined ? NaN : readNumber(cell, this.decimalComma) * use.factor;
      if (value - value === 0) {
        data[c + offset]![rows] = value;
      } else if (use.optional) {
        data[c + offset]![rows] = NaN;
      } else {
        return this.skip(line, use.title, reasonFor(cell, this.decimalComma));
      }
    }
    const time = data[0]![rows]!;
    if (!(time > this.lastTime)) return this.skip(line, uses[0]!.title, `the time ${time} s is not after the row before (${this.lastTime} s)`);
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

function reasonFor(cell: string | undefined, decimalComma: boolean): string {
  if (cell === undefined) return 'the cell is missing';
  const text = cell.trim();
  if (text === '') return 'the cell is empty';
  const shown = `"${text.length > 24 ? `${text.slice(0, 23)}…` : text}"`;
  if (/^[+-]?(inf(inity)?|nan)$/i.test(text)) return `${shown} is not a finite number`;
  if (Number.isFinite(readNumber(text, decimalComma)) || Math.abs(+text) === Infinity) return `${shown} is too large`;
  return `${shown} is not a number${decimalComma && text.includes('.') ? '; this file has decimal commas' : ''}`;
}

/** Id that a scenario in the comments names; nothing of it is believed yet. */
function systemOf(scenario: unknown): string | undefined {
  const id = typeof scenario === 'object' && scenario !== null && 'system' in scenario ? scenario.system : undefined;
  return typeof id === 'string' ? id : undefined;
}

const COMMENT = /^\s*(?:"\s*)?#/;

/** The first lines that are no comments. */
function sampleOf(text: string): string[] {
  return text.slice(0, 65536).split(/\r\n|\n|\r/).filter((l) => l.trim() !== '' && !COMMENT.test(l)).slice(0, 200);
}

/** The separator of the first lines of data. */
function separatorOf(sample: readonly string[]): string {
  const lines = sample.slice(0, 5);
  const count = (separator: string): number => lines.reduce((sum, line) => sum + line.split(separator).length - 1, 0);
  // A decimal comma makes commas frequent; semicolons and tabs are never part of a number, so they go first.
  if (count('\t') >= lines.length) return '\t';
  if (count(';') >= lines.length) return ';';
  return ',';
}

function hasDecimalCommas(sample: readonly string[]): boolean {
  const numbers = sample.filter((line) => /^[\d\s.,;eE+\-−–"]*$/.test(line));
  return numbers.some((line) => /\d,\d/.test(line)) && !numbers.some((line) => /\d\.\d/.test(line));
}

/** The lines of a text, ended by \n, \r\n or \r in any mixture. */
class Lines {
  text = '';
  /** 1-based. */
  number = 0;
  private readonly whole: string;
  private passed = 0;
  private at = 0;
  private feed: number;
  private carriage: number;

  constructor(whole: string) {
    this.whole = whole;
    this.feed = this.find('\n', 0);
    this.carriage = this.find('\r', 0);
  }

  next(): boolean {
    if (this.at >= this.whole.length) return false;
    const end = Math.min(this.feed, this.carriage);
    this.text = this.whole.slice(this.at, end);
    this.number = ++this.passed;
    this.at = end + (this.carriage + 1 === this.feed ? 2 : 1);
    if (this.feed < this.at) this.feed = this.find('\n', this.at);
    if (this.carriage < this.at) this.carriage = this.find('\r', this.at);
    return true;
  }

  /** The line, with those after it while a quote is open; alone when none of the next ones closes it. */
  throughOpenQuotes(most: number): string {
    const start = { text: this.text, number: this.number, passed: this.passed, at: this.at, feed: this.feed, carriage: this.carriage };
    const parts = [this.text];
    let open = isOdd(this.text);
    while (open && parts.length < most && this.next()) {
      parts.push(this.text);
      open = open !== isOdd(this.text);
    }
    if (open) {
      Object.assign(this, start);
      return start.text;
    }
    return parts.join('\n');
  }

  private find(end: string, from: number): number {
    const found = this.whole.indexOf(end, from);
    return found < 0 ? this.whole.length : found;
  }
}

function isOdd(text: string): boolean {
  return text.split('"').length % 2 === 0;
}
