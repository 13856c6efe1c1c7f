import type { SystemMeta } from '../core/model/system.ts';
import { namesColumns, readHeader, type ColumnUse } from './csvHeader.ts';
import { MOST_NUMBERS, RowStore, type CsvIssue } from './csvRows.ts';
import { decimalsOf, eachRecord, LineSource, LONGEST_LINE, separatorOf, withoutComments } from './csvText.ts';
import { readNumber } from './numbers.ts';

export type { CsvIssue } from './csvRows.ts';

export interface CsvOptions {
  systems: Readonly<Record<string, SystemMeta>>;
  /** Answers `needs-time-step`, s. */
  timeStep?: number;
}

export type CsvResult =
  | {
      kind: 'motion';
      systemId: string;
      /** `t`, coordinates, velocities, then what else was recognised. */
      columns: string[];
      data: Float64Array[];
      rows: number;
      skippedRows: number;
      /** In the order of the file, the first 1,000. */
      issues: CsvIssue[];
      /** How the file was understood. */
      notes: string[];
      /** JSON of a `# scenario:` comment, unchecked, or null. */
      scenario: unknown;
    }
  | { kind: 'needs-time-step'; offeredStep: number; columns: number }
  | { kind: 'unusable'; issues: CsvIssue[] };

/** The report's player drew 60 rows a second. */
const OFFERED_STEP = 1 / 60;
/** Text looked at before the separator is decided. */
export const ENOUGH_TO_DECIDE = 65536;
const LONGEST_SCENARIO = 200_000;

/**
 * Reads CSV text, given in pieces, into columns: separator and header first, then row by row without keeping cells.
 * Never throws for bad input: `finish` says what could not be used, and why.
 */
export class CsvReader {
  private readonly options: CsvOptions;
  private readonly source = new LineSource();
  private readonly notes: string[] = [];
  private scenario: unknown = null;
  private lastComment: { text: string; line: number } | null = null;
  private started = false;
  private undecided = '';
  private separator = '';
  private decimals: 'comma' | 'point' | null = null;
  private line = 1;
  private store: RowStore | null = null;
  private systemId = '';
  /** Set when the file can't be read further. */
  private ended: Exclude<CsvResult, { kind: 'motion' }> | null = null;

  constructor(options: CsvOptions) {
    this.options = options;
    const { timeStep } = options;
    if (timeStep !== undefined && !(timeStep > 0 && timeStep < Infinity))
      this.refuse(0, '', `the time step must be a number of seconds greater than 0, not ${timeStep}`);
  }

  push(piece: string): void {
    if (this.ended || piece === '') return;
    const text = this.started || piece.charCodeAt(0) !== 0xfeff ? piece : piece.slice(1);
    this.started = true;
    this.undecided += this.source.push(text);
    if (this.source.waiting > LONGEST_LINE)
      return this.refuse(
        this.line,
        '',
        `a line is longer than ${LONGEST_LINE} characters; this is no table of numbers`,
      );
    if (this.separator !== '' || this.undecided.length >= ENOUGH_TO_DECIDE) this.block();
  }

  get rows(): number {
    return this.store?.rows ?? 0;
  }

  /** The file can't be read further: `finish` says why. */
  get over(): boolean {
    return this.ended !== null;
  }

  /** What the columns mean is known, and no text waits. */
  get decided(): boolean {
    return this.store !== null && this.ended === null;
  }

  /** How a line of plain numbers looks from here on, or null where decimals are written with commas. */
  plan(): { separator: number; width: number } | null {
    if (!this.store || this.decimals === 'comma') return null;
    return { separator: this.separator.charCodeAt(0), width: this.store.width };
  }

  /** The next line as numbers, one per column of the file; `pointed` where one of those so far had a decimal point. */
  numbers(values: Float64Array, pointed: boolean): void {
    if (pointed) this.decimals ??= 'point';
    this.store!.numbers(values, this.line++);
    if (this.store!.full) this.tooMany();
  }

  /** So many rows are to be expected in all. */
  expect(rows: number): void {
    this.store?.expect(rows);
  }

  private tooMany(): void {
    this.refuse(
      this.line,
      '',
      `more than ${MOST_NUMBERS / 1e6} million numbers are more than this page holds (${this.store!.rows} rows so far); export fewer rows or columns`,
    );
  }

  finish(): CsvResult {
    if (!this.ended) {
      this.undecided += this.source.finish();
      this.block();
    }
    if (this.ended) return this.ended;
    this.store?.finish();
    if (!this.store || this.store.rows === 0) return this.unusable();
    const { store } = this;
    if (store.rows === 1) this.notes.push('one usable row only: it is shown as a still picture');
    return {
      kind: 'motion',
      systemId: this.systemId,
      columns: store.uses.map((u) => u.name),
      data: store.columns(),
      rows: store.rows,
      skippedRows: store.skipped,
      issues: store.sortedIssues(),
      notes: this.notes,
      scenario: this.scenario,
    };
  }

  private unusable(): CsvResult {
    if (this.store)
      return {
        kind: 'unusable',
        issues: [{ line: 0, column: '', message: 'no row could be used' }, ...this.store.sortedIssues()],
      };
    return { kind: 'unusable', issues: [{ line: 0, column: '', message: 'there are no rows of numbers' }] };
  }

  /** Reads the whole lines there are. */
  private block(): void {
    const text = this.undecided;
    this.undecided = '';
    if (text === '') return;
    if (this.separator === '' && text.slice(0, 4096).includes('\0'))
      return this.refuse(0, '', 'this is no text file (or not UTF-8 text); save it as CSV, UTF-8');
    let comments = 0;
    const rows = withoutComments(text, (comment) => {
      comments++;
      this.comment(comment);
    });
    if (this.separator === '' && rows.trim() !== '') {
      this.separator = separatorOf(rows);
      if (this.separator !== ',') this.notes.push(`separated by ${this.separator === '\t' ? 'tabs' : 'semicolons'}`);
    }
    if (comments > 0 && this.scenario === null && /#\s*scenario:/.test(text) && !this.notes.includes(UNREADABLE))
      this.notes.push(UNREADABLE);
    if (this.separator !== '') this.records(rows);
    for (let at = text.indexOf('\n'); at >= 0; at = text.indexOf('\n', at + 1)) this.line++;
  }

  private records(rows: string): void {
    if (this.decimals === null) {
      this.decimals = decimalsOf(rows, this.separator);
      if (this.decimals === 'comma') this.notes.push('decimal commas');
    }
    eachRecord(rows, this.separator, this.line, (cells, line) => {
      if (this.ended || (cells.length <= 1 && (cells[0] ?? '').trim() === '')) return;
      if (this.store || this.layout(cells, line)) this.store?.row(cells, line, this.decimals === 'comma');
      if (this.store?.full) this.tooMany();
    });
  }

  private comment(text: string): void {
    const plain = text.replace(/^#\s*/, '');
    if (this.store === null) this.lastComment = { text: plain, line: this.line };
    const json = /^scenario:\s*(\{.*\})\s*$/.exec(plain)?.[1];
    if (json === undefined || this.scenario !== null || json.length > LONGEST_SCENARIO) return;
    try {
      this.scenario = JSON.parse(json);
    } catch {
      // Said in a note: the numbers play without it.
    }
  }

  /** Decides what the columns mean. True when this row already holds numbers (no header). */
  private layout(cells: readonly string[], line: number): boolean {
    const filled = cells.filter((c) => c.trim() !== '');
    const numeric = filled.filter((c) => !Number.isNaN(readNumber(c, this.decimals === 'comma'))).length;
    const isHeader = 2 * numeric < filled.length || namesColumns(filled, this.options.systems);
    if (isHeader) {
      this.header(cells, line);
      return false;
    }
    // numpy.savetxt writes its header as a comment.
    const commented = this.lastComment?.text.split(this.separator);
    if (commented && commented.length === cells.length && namesColumns(commented, this.options.systems)) {
      this.header(commented, line);
      return this.store !== null;
    }
    return this.headerless(cells, line);
  }

  private header(cells: readonly string[], line: number): void {
    const named = (this.scenario as { system?: unknown } | null)?.system;
    const reading = readHeader(cells, this.options.systems, typeof named === 'string' ? named : null);
    if (typeof reading === 'string') return this.refuse(line, '', reading);
    const timed = reading.uses[0]!.name === 't';
    if (!this.begin(reading.systemId, reading.uses, timed, cells.length)) return;
    this.notes.push(...reading.notes);
    if (!timed) this.notes.push(`no time column: rows ${this.options.timeStep} s apart`);
    for (const { title, message } of reading.repeated) this.store!.note(line, title, message);
  }

  /** A file of numbers alone: the coordinates in order, or the time before them, of a system that has such files. */
  private headerless(cells: readonly string[], line: number): boolean {
    const system = Object.values(this.options.systems).find((meta) => meta.headerless);
    const names = system?.coordinates.map((q) => q.name) ?? [];
    const count = cells.at(-1)!.trim() === '' ? cells.length - 1 : cells.length;
    if (!system || (count !== names.length && count !== names.length + 1)) {
      this.refuse(
        line,
        '',
        `there is no header row, and ${count} columns are neither ${names.length} (coordinates in order) nor ${names.length + 1} (time first)`,
      );
      return false;
    }
    const timed = count > names.length;
    const uses = (timed ? ['t', ...names] : names).map((name, index) => ({
      index,
      name,
      factor: 1,
      title: String(index + 1),
      needed: true,
    }));
    if (!this.begin(system.id, uses, timed, count)) return false;
    this.notes.push(
      timed
        ? 'no header: time, then the coordinates in order (SI, radians)'
        : `no header: the coordinates in order (SI, radians), rows ${this.options.timeStep} s apart`,
    );
    return true;
  }

  private begin(systemId: string, uses: ColumnUse[], timed: boolean, width: number): boolean {
    const { timeStep } = this.options;
    if (!timed && timeStep === undefined) {
      this.ended = { kind: 'needs-time-step', offeredStep: OFFERED_STEP, columns: width };
      return false;
    }
    const counted: ColumnUse = { index: -1, name: 't', factor: 1, title: 't', needed: true };
    this.systemId = systemId;
    this.store = new RowStore(timed ? uses : [counted, ...uses], width, timed ? null : timeStep!);
    return true;
  }

  private refuse(line: number, column: string, message: string): void {
    this.ended = { kind: 'unusable', issues: [{ line, column, message }] };
  }
}

const UNREADABLE = 'the scenario in the comments is not readable and was left aside';
