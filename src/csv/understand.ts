import { sniff } from './containers/sniff.ts';
import { encodingOf } from './encoding/encoding.ts';
import { formOf } from './layout/cells.ts';
import { isMissing } from './layout/errors.ts';
import { layoutOf, type Layout } from './layout/layout.ts';
import { valueOf } from './layout/preamble.ts';
import { meaningOf, type UnderstandOptions } from './meaning.ts';
import { namesColumns } from './names/vocabulary.ts';
import type { Encoding, ImportPlan, Question, Understanding } from './plan.ts';
import { readNumber } from './reading/numbers.ts';
import { doubtsOf } from './units/doubts.ts';

export type { UnderstandOptions } from './meaning.ts';

const MOST_PREVIEW = 20;
/** Share of whole rows below which columns are taken to have times of their own. */
const SPARSE = 0.05;
/** Bytes by which a file is understood. */
export const ENOUGH_TO_DECIDE = 65536;

/**
 * Understands a file from its first bytes (`ENOUGH_TO_DECIDE` are enough; unpacked, where they were gzip's). Never
 * throws for bad input.
 */
export function understand(start: Uint8Array, options: UnderstandOptions): Understanding {
  const container = sniff(start);
  if (container.kind === 'refused') return { kind: 'refused', line: 0, message: container.message };
  const encoding = options.choices?.encoding ?? encodingOf(start);
  const text = new TextDecoder(encoding).decode(start.subarray(0, 4 * ENOUGH_TO_DECIDE));
  const whole = start.length < ENOUGH_TO_DECIDE ? text : text.slice(0, text.lastIndexOf('\n') + 1 || text.length);
  return understandText(whole.replace(/\r\n?/g, '\n'), encoding, options);
}

/** @param text whole lines, each ended by LF, without a byte order mark */
export function understandText(text: string, encoding: Encoding, options: UnderstandOptions): Understanding {
  const choices = options.choices ?? {};
  const layout = layoutOf(text.replace(/^\ufeff/, ''), choices, (cells) => namesColumns(cells, options.systems));
  if (!layout) return { kind: 'refused', line: 0, message: 'there are no rows of numbers' };
  const line = layout.headerLines[0] ?? layout.firstRow;
  const motive =
    valueOf(layout.properties, /^Format Version$/i) !== null && valueOf(layout.properties, /^Take Name$/i) !== null;
  const up = choices.up ?? (motive ? 'y' : 'z');
  const meaning = meaningOf({ layout, choices, options, up });
  if (typeof meaning === 'string') return { kind: 'refused', line, message: meaning };
  const { finding, timing, system, long, bodies, body, only, euler } = meaning;
  const notes = [...layoutNotes(layout), ...meaning.notes, ...finding.notes, ...timing.notes];
  if (motive && system !== null)
    notes.push(
      `Motive's axes${up === 'y' ? ' (Y up) are turned so that Z is up: x = X, y = -Z, z = Y' : ' are taken as they are, Z up'}`,
    );
  const plan: ImportPlan = {
    encoding,
    lineForm: layout.lineForm,
    dress: layout.dress,
    separator: layout.separator,
    decimal: layout.decimal,
    headerLines: layout.headerLines,
    unitsLine: layout.unitsLine,
    firstRow: layout.firstRow,
    width: meaning.width,
    comments: layout.comments,
    properties: layout.properties,
    system,
    columns: finding.columns,
    time: timing.time,
    long,
    runs: 0,
    run: null,
    bodies,
    body,
    only,
    sparse: !long && isSparse(finding.columns, layout),
    euler,
    up,
    rates: choices.rates ?? 'none',
    questions: [],
    notes,
    repeated: finding.repeated,
    preview: layout.rows.slice(0, MOST_PREVIEW).map((row) => row.slice(0, 200)),
    shape: shapeOf(layout),
  };
  return {
    kind: 'plan',
    plan: {
      ...plan,
      questions: [...timing.questions, ...meaning.questions, ...questionsOf(plan, layout, Boolean(options.preferred))],
    },
  };
}

function layoutNotes(layout: Layout): string[] {
  const notes: string[] = [];
  const marks = { ';': 'semicolons', '\t': 'tabs', '|': 'upright bars', blanks: 'blanks' } as Record<string, string>;
  if (layout.lineForm === 'labelled') notes.push('every value has its name beside it');
  if (layout.lineForm === 'bracketed') notes.push('rows stand between brackets or bars');
  if (layout.dress?.text) notes.push('numbers are marked as text');
  if (layout.dress?.grouped) notes.push('thousands are in groups');
  if (layout.dress?.units.some((unit) => unit !== '')) notes.push('units stand behind the numbers');
  if (layout.lineForm === 'stamped') notes.push('a clock and an arrow stand before each row');
  if (layout.separator !== ',') notes.push(`separated by ${marks[layout.separator] ?? `"${layout.separator}"`}`);
  if (layout.decimal === ',') notes.push('decimal commas');
  if (layout.unitsLine !== null) notes.push(`units are in line ${layout.unitsLine}`);
  const first = layout.headerLines[0];
  if (first !== undefined && first > 1 && layout.properties.length > 0)
    notes.push(`the header is in ${linesOf(layout.headerLines)}`);
  return notes;
}

function linesOf(lines: readonly number[]): string {
  const [first, last] = [lines[0]!, lines.at(-1)!];
  if (lines.length === 1) return `line ${first}`;
  return last - first === lines.length - 1 ? `lines ${first} to ${last}` : `lines ${lines.join(', ')}`;
}

/** Hardly a row is whole, though every coordinate has values: sensors wrote at times of their own. */
function isSparse(columns: ImportPlan['columns'], { rows, decimal }: Layout): boolean {
  const needed = columns.filter((c) => c.role === 'coordinate' || c.role === 'rate' || c.role === 'attitude');
  const there = (row: readonly string[], index: number): boolean =>
    formOf(row[index] ?? '', decimal === ',') === 'number';
  if (needed.length < 2 || rows.length < 10) return false;
  let whole = 0;
  for (const row of rows) if (needed.every((c) => there(row, c.index)) && ++whole >= SPARSE * rows.length) return false;
  return needed.every(({ index }) => {
    const filled = rows.filter((row) => !isMissing(row[index] ?? ''));
    return filled.length >= 3 && filled.every((row) => there(row, index));
  });
}

/** What the first rows leave open. */
function questionsOf(plan: ImportPlan, layout: Layout, known: boolean): Question[] {
  if (plan.system === null || plan.long || known) return [];
  const comma = plan.decimal === ',';
  const { only } = plan;
  const rows = only ? layout.rows.filter((row) => (row[only.column] ?? '').trim() === only.value) : layout.rows;
  const numbers = (index: number): Float64Array =>
    Float64Array.from(rows, (row) => readNumber(row[index] ?? '', comma));
  const unsaid = plan.columns
    .filter((c) => c.role === 'coordinate' && c.unit === '' && c.unitFrom === 'none')
    .map((c) => ({ name: c.name!, kind: c.kind as 'length' | 'angle', data: numbers(c.index) }));
  const [time] = plan.time.columns;
  const t =
    time !== undefined && (plan.time.form === 'number' || plan.time.form === 'epoch')
      ? numbers(time).map((x) => x * plan.time.factor)
      : Float64Array.from(rows, (_, i) => i * (plan.time.step ?? 0.01));
  return doubtsOf(unsaid, t);
}

/** The same for files that the same program wrote: names, units and marks, not numbers. */
function shapeOf(layout: Layout): string {
  const titles = layout.titles?.map((title) => title.trim()) ?? [`${layout.width} columns`];
  const text = [layout.separator, layout.decimal, ...titles, '/', ...(layout.units ?? [])].join('\u001f');
  let [a, b] = [0x811c9dc5, 0x1000193];
  for (let i = 0; i < text.length; i++) {
    a = Math.imul(a ^ text.charCodeAt(i), 0x01000193);
    b = Math.imul(b ^ text.charCodeAt(i), 0x85ebca6b) ^ (b >>> 13);
  }
  return `${layout.width}-${(a >>> 0).toString(36)}${(b >>> 0).toString(36)}`;
}
