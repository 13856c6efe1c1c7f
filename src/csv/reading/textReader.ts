import { systemNamed } from '../../core/scenario/own.ts';
import { eachRecord, LineSource, LONGEST_LINE, withoutComments } from '../layout/lines.ts';
import { undressed } from '../layout/dress.ts';
import { labelledCells, unbracketed, unstamped } from '../layout/logLines.ts';
import { Pivot } from '../layout/long.ts';
import type { Encoding, ImportChoices, ImportPlan } from '../plan.ts';
import { OFFERED_STEP } from '../time/timePlan.ts';
import { timeReaderOf } from '../time/reader.ts';
import { ENOUGH_TO_DECIDE, understandText } from '../understand.ts';
import { finishMotion } from './finish.ts';
import type { CsvOptions, CsvResult } from './result.ts';
import { MOST_NUMBERS, RowStore, type ColumnUse } from './rows.ts';

const LONGEST_SCENARIO = 200_000;
const UNREADABLE = 'the scenario in the comments is not readable and was left aside';

/** Nothing, or a control character at a file's end (Ctrl-Z, zeros). */
function isBlank(cell: string): boolean {
  for (let i = 0; i < cell.length; i++) {
    const code = cell.charCodeAt(i);
    if (code > 32 && code !== 0xa0 && code !== 0xfeff) return false;
  }
  return true;
}

/** Share of control characters from which it is no text; a serial line may begin with a few. */
const FEW_CONTROLS = 0.02;

function isBinary(start: string): boolean {
  let controls = 0;
  for (let i = 0; i < start.length; i++) {
    const code = start.charCodeAt(i);
    if (code < 9 || (code > 13 && code < 32 && code !== 26)) controls++;
  }
  return controls > Math.max(2, FEW_CONTROLS * start.length);
}

/**
 * Reads CSV text, given in pieces, into columns: it is understood from its beginning, then read row by row without
 * keeping cells. Never throws for bad input: `finish` says what could not be used, and why.
 */
export class CsvReader {
  private readonly options: CsvOptions;
  private readonly encoding: Encoding;
  private readonly source = new LineSource();
  private readonly notes: string[] = [];
  private scenario: unknown = null;
  private started = false;
  private undecided = '';
  private line = 1;
  private understood: ImportPlan | null = null;
  private store: RowStore | null = null;
  private pivot: Pivot | null = null;
  /** Set when the file can't be read further. */
  private ended: Exclude<CsvResult, { kind: 'motion' }> | null = null;

  constructor(options: CsvOptions, encoding: Encoding = 'utf-8') {
    this.options = options;
    this.encoding = encoding;
    const step = options.timeStep ?? options.choices?.step;
    if (step !== undefined && !(step > 0 && step < Infinity))
      this.refuse(0, '', `the time step must be a number of seconds greater than 0, not ${step}`);
  }

  push(piece: string): void {
    if (this.ended || piece === '') return;
    // A mark of the encoding, or what a serial line gives when it is opened.
    const text = this.started ? piece : piece.replace(/^[\0-\u0008\ufeff]+/, '');
    this.started ||= text !== '';
    this.undecided += this.source.push(text);
    if (this.source.waiting > LONGEST_LINE)
      return this.refuse(
        this.line,
        '',
        `a line is longer than ${LONGEST_LINE} characters; this is no table of numbers`,
      );
    if (this.understood || this.undecided.length >= ENOUGH_TO_DECIDE) this.block(false);
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

  /** How a line of plain numbers looks from here on, or null where lines take the long way. */
  plan(): { separator: number; width: number } | null {
    const { store, understood } = this;
    if (
      !store ||
      !understood ||
      understood.decimal === ',' ||
      understood.separator === 'blanks' ||
      this.pivot ||
      understood.only ||
      understood.lineForm !== 'plain'
    )
      return null;
    const { form } = understood.time;
    if (form !== 'number' && form !== 'counted') return null;
    return { separator: understood.separator.charCodeAt(0), width: store.width };
  }

  /** The next line as numbers, one per column of the file. */
  numbers(values: Float64Array): void {
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
      this.block(true);
    }
    this.pivot?.finish((cells, line) => this.store?.row(cells, line));
    if (this.ended) return this.ended;
    const { store, understood } = this;
    if (!store || !understood || store.rows === 0) return this.unusable();
    return finishMotion(store, understood, {
      choices: this.options.choices ?? {},
      scenario: this.scenario,
      notes: [...understood.notes, ...this.notes, ...this.unknownNames()],
      system: understood.system === null ? null : (this.options.systems[understood.system] ?? null),
    });
  }

  private unknownNames(): string[] {
    const names = [...(this.pivot?.unknown ?? [])];
    return names.length > 0 ? [`names not among the first rows, left out: ${names.join(', ')}`] : [];
  }

  private unusable(): CsvResult {
    if (this.store)
      return {
        kind: 'unusable',
        issues: [
          {
            line: 0,
            column: '',
            message:
              this.store.skipped > 0 ? 'no row could be used' : 'there are names, and no rows of numbers below them',
          },
          ...this.store.sortedIssues(),
        ],
      };
    return { kind: 'unusable', issues: [{ line: 0, column: '', message: 'there are no rows of numbers' }] };
  }

  /** Reads the whole lines there are, once it is known what they are. */
  private block(last: boolean): void {
    const text = this.undecided;
    if (text === '') return;
    // A logger without power leaves zeros at the end: those are no text, and no sign of another kind of file.
    if (!this.understood && isBinary(text.slice(0, 4096).replace(/\n\0[\0\s]*$/, '')))
      return this.refuse(0, '', 'this is no text file (or not UTF-8 text); save it as CSV, UTF-8');
    if (!this.understood) {
      const end = last ? text.length : text.indexOf('\n', ENOUGH_TO_DECIDE - 1) + 1;
      if (end <= 0) return;
      this.comments(text.slice(0, end));
      // Comments alone decide nothing: they may be long.
      if (!last && text.length < 4 * LONGEST_SCENARIO && withoutComments(text, () => undefined).trim() === '') return;
      this.decide(text.slice(0, end));
      if (this.ended) return;
    }
    this.undecided = '';
    let comments = 0;
    const rows = withoutComments(text, (comment) => {
      comments++;
      this.comment(comment);
    });
    if (comments > 0 && this.scenario === null && /#\s*scenario:/.test(text) && !this.notes.includes(UNREADABLE))
      this.notes.push(UNREADABLE);
    this.records(rows);
    for (let at = text.indexOf('\n'); at >= 0; at = text.indexOf('\n', at + 1)) this.line++;
  }

  private records(rows: string): void {
    const { store, understood } = this;
    if (!store || !understood) return;
    const { only } = understood;
    const { lineForm, separator, dress, decimal } = understood;
    const sink = (given: string[], line: number): void => {
      const cells = dress ? undressed(given, dress, decimal === ',') : given;
      if (only && (cells[only.column] ?? '').trim() !== only.value) return;
      if (this.ended || line < understood.firstRow || (cells.length <= 1 && isBlank(cells[0] ?? ''))) return;
      if (this.pivot) this.pivot.push(cells, line);
      else store.row(cells, line);
      if (store.full) this.tooMany();
    };
    if (lineForm === 'labelled') {
      const labels = understood.columns.map((c) => c.title);
      for (const [i, line] of rows.split('\n').entries()) sink(labelledCells(line, labels), this.line + i);
    } else {
      const inner =
        lineForm === 'stamped' ? unstamped(rows, separator) : lineForm === 'bracketed' ? unbracketed(rows) : rows;
      eachRecord(inner, separator, this.line, sink);
    }
  }

  private comments(text: string): void {
    withoutComments(text, (comment) => this.comment(comment));
  }

  private comment(text: string): void {
    const json = /^#\s*scenario:\s*(\{.*\})\s*$/.exec(text)?.[1];
    if (json === undefined || this.scenario !== null || json.length > LONGEST_SCENARIO) return;
    try {
      this.scenario = JSON.parse(json);
    } catch {
      // Said in a note: the numbers play without it.
    }
  }

  /** Decides what the columns mean. */
  private decide(text: string): void {
    const { systems, timeStep, data, unasked } = this.options;
    const named = systemNamed(this.scenario);
    const choices = { ...(timeStep === undefined ? {} : { step: timeStep }), ...this.options.choices };
    const answer = understandText(text, this.encoding, {
      systems,
      choices,
      data: data === true,
      preferred: named ?? this.options.preferred ?? null,
    });
    if (answer.kind === 'refused') return this.refuse(answer.line, '', answer.message);
    const { plan } = answer;
    if (!unasked && plan.questions.some((q) => q.id === 'time-step')) {
      this.ended = { kind: 'needs-time-step', offeredStep: OFFERED_STEP, columns: plan.width };
      return;
    }
    this.begin(plan, choices);
  }

  private begin(plan: ImportPlan, choices: ImportChoices): void {
    this.understood = plan;
    const reader = timeReaderOf(plan.time, choices, plan.decimal === ',');
    const [time] = plan.time.columns;
    const timeUse: ColumnUse = {
      index: plan.time.form === 'number' ? time! : -1,
      name: 't',
      factor: plan.time.form === 'number' ? plan.time.factor : 1,
      title: plan.columns.find((c) => c.index === time)?.title || 't',
      needed: true,
    };
    const uses = plan.columns
      .filter((c) => c.name !== null && c.role !== 'time')
      .map((c) => ({
        index: c.index,
        name: c.name!,
        factor: c.factor,
        title: c.title || c.source,
        needed: !plan.sparse && (c.role === 'coordinate' || c.role === 'rate' || c.role === 'attitude'),
      }));
    const canon = this.options.systems[plan.system ?? '']?.coordinates.map((q) => q.name) ?? [];
    const order = [...canon, ...canon.map((name) => `${name}_dot`)];
    const rank = (use: ColumnUse): number =>
      order.includes(use.name) ? order.indexOf(use.name) : order.length + use.index;
    this.store = new RowStore([timeUse, ...uses.sort((a, b) => rank(a) - rank(b))], {
      width: plan.width,
      step: plan.time.form === 'counted' ? plan.time.step : null,
      time: reader,
      decimalComma: plan.decimal === ',',
    });
    if (plan.long) this.pivot = new Pivot(plan.long);
    for (const { title, message } of plan.repeated) this.store.issues.add(plan.headerLines.at(-1) ?? 1, title, message);
  }

  private refuse(line: number, column: string, message: string): void {
    this.ended = { kind: 'unusable', issues: [{ line, column, message }] };
  }
}
