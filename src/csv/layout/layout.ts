import type { ImportChoices, Separator } from '../plan.ts';
import { timeRank } from '../time/timeNames.ts';
import { isUnit } from '../units/units.ts';
import { blankTitles, cellsOf, formOf } from './cells.ts';
import { dressOf, undressed, type Dress } from './dress.ts';
import { isMissing } from './errors.ts';
import {
  labelledCells,
  labelsOf,
  lineFormOf,
  unbracketed,
  unstamped,
  withoutStamp,
  type LineForm,
} from './logLines.ts';
import { isComment, recordLength, COMMENT } from './records.ts';
import { propertiesOf, type Property } from './preamble.ts';
import { isBareGroup } from '../reading/grouped.ts';
import { marksOf } from './separator.ts';

/** Where the table of a file begins, and what stands above it. */
export interface Layout {
  lineForm: LineForm;
  separator: Separator;
  decimal: '.' | ',';
  headerLines: number[];
  unitsLine: number | null;
  firstRow: number;
  width: number;
  /** Cells of the names' line, null without one. */
  titles: string[] | null;
  /** Names of the groups a column stands in, outermost first. */
  groups: string[][];
  units: string[] | null;
  comments: string[];
  properties: Property[];
  /** What stands around the numbers of cells; null where nothing does. */
  dress: Dress | null;
  /** Cells of the first rows of numbers. */
  rows: string[][];
}

interface Line {
  number: number;
  text: string;
  comment: boolean;
  cells: string[];
}

/** Rows of a sample that are kept as cells. */
const MOST_ROWS = 1000;
/** Lines that may stand between the header and the first whole row. */
const REACH = 60;
/** Rows by which it is seen what stands around numbers. */
const MOST_DRESSED = 100;

/**
 * @param text whole lines of a file's beginning
 * @param names whether cells name columns: how many of them
 * @returns null where there is no row and no header
 */
export function layoutOf(
  text: string,
  choices: ImportChoices,
  names: (cells: readonly string[]) => number,
): Layout | null {
  const all = linesOf(text);
  const told = /^["']?sep=(.)["']?\s*$/i.exec(all[0]?.text ?? '');
  if (told) all[0]!.text = '';
  const plain = all.filter((line) => !line.comment && line.text.trim() !== '');
  if (plain.length === 0) return null;
  const lineForm = lineFormOf(plain.map((line) => line.text));
  if (lineForm === 'labelled') return labelled(plain);
  const inner = (text: string): string =>
    lineForm === 'stamped' ? withoutStamp(text) : lineForm === 'bracketed' ? unbracketed(text) : text;
  const marks = marksOf(
    plain.map((line) => inner(line.text)).filter((text) => text.trim() !== ''),
    { ...(told ? { separator: told[1] as Separator } : {}), ...choices },
  );
  const { separator, decimal } = marks;
  const textOf = ({ text }: { text: string }): string =>
    lineForm === 'stamped' ? unstamped(text, separator) : inner(text);
  const dressed: Line[] = plain.flatMap((line) => {
    const text = textOf(line);
    return text.trim() === '' ? [] : [{ ...line, text, cells: cellsOf(text, separator) }];
  });
  const dress = dressOf(
    dressed
      .slice(1)
      .slice(-MOST_DRESSED)
      .map((line) => line.cells),
    dressed[0]?.cells ?? [],
    decimal === ',',
  );
  const lines = dress
    ? dressed.map((line) => ({ ...line, cells: undressed(line.cells, dress, decimal === ',') }))
    : dressed;
  const first = firstRowOf(lines, decimal === ',');
  const header = headerOf(lines, first, choices, names);
  const commented =
    header < 0 && choices.headerLine === undefined ? commentedHeader(all, lines, first, separator, names) : null;
  const body = header >= 0 ? header + 1 : Math.max(first, 0);
  const titles = header >= 0 ? titlesOf(lines[header]!, lines[first], separator) : (commented?.cells ?? null);
  if (titles && lineForm === 'stamped') titles[0] = '';
  let next = body;
  const headerLines = header >= 0 ? [lines[header]!.number] : commented ? [commented.number] : [];
  let units: string[] | null = null;
  let unitsLine: number | null = null;
  if (titles)
    for (; next < lines.length && next < body + 4; next++) {
      const { cells, number } = lines[next]!;
      if (!units && isUnitsBelow(cells) && !isIndexName(cells, titles))
        [units, unitsLine] = [unitCells(cells, titles.length), number];
      else if (fillsTitles(cells, titles)) headerLines.push(number);
      else if (next >= first || !isRemarks(cells, decimal === ',')) break;
    }
  const above = header > 0 ? lines[header - 1]! : null;
  // Markers' files name the axes below: `Frame#, Time, front` above `, , X1, Y1, Z1`.
  if (titles && above && fillsFromAbove(above.cells, titles)) headerLines.push(above.number);
  if (
    titles &&
    !units &&
    above &&
    isUnitsRow(above.cells) &&
    trimmed(above.cells) > 1 &&
    above.cells.length === titles.length
  )
    [units, unitsLine] = [above.cells, above.number];
  if (commented?.units) ({ units, unitsLine } = commented);
  if (!units && dress?.units.some((unit) => unit !== '')) units = [...dress.units];
  const rows = lines.slice(next, next + MOST_ROWS).map((line) => line.cells);
  if (rows.length === 0 && !titles) return null;
  const width = titles ? widthWith(titles, rows) : trimmed(lines[next]!.cells);
  const groups = titles && header > 0 ? groupsOf(lines, header, titles, headerLines) : [];
  const before = all.filter((line) => line.number < (lines[next]?.number ?? Infinity));
  const used = new Set([...headerLines, unitsLine]);
  return {
    ...marks,
    lineForm,
    dress,
    headerLines: headerLines.sort((a, b) => a - b),
    unitsLine,
    firstRow: lines[next]?.number ?? (lines.at(-1)?.number ?? 0) + 1,
    width,
    titles,
    groups,
    units,
    comments: [...new Set(all.filter((l) => l.comment).map((l) => COMMENT.exec(l.text)![2]!))],
    properties: propertiesOf(
      before
        .filter((line) => !used.has(line.number))
        .map((line) => ({ text: line.text, cells: line.comment ? [] : cellsOf(line.text, separator) })),
    ),
    rows,
  };
}

/** Every value has its name beside it: no header, no separator. */
function labelled(plain: readonly { number: number; text: string }[]): Layout {
  const labels = labelsOf(plain.map((line) => line.text));
  return {
    lineForm: 'labelled',
    dress: null,
    separator: ',',
    decimal: '.',
    headerLines: [],
    unitsLine: null,
    firstRow: plain[0]!.number,
    width: labels.length,
    titles: labels,
    groups: [],
    units: null,
    comments: [],
    properties: [],
    rows: plain.slice(0, MOST_ROWS).map((line) => labelledCells(line.text, labels)),
  };
}

/** Lines with their numbers; a quoted cell may hold line ends. */
function linesOf(text: string): { number: number; text: string; comment: boolean }[] {
  const raw = text.split('\n');
  if (!text.includes('"')) return raw.map((line, i) => ({ number: i + 1, text: line, comment: isComment(line) }));
  const lines: { number: number; text: string; comment: boolean }[] = [];
  for (let i = 0; i < raw.length;) {
    const comment = isComment(raw[i]!);
    const length = comment ? 1 : recordLength(raw, i);
    lines.push({ number: i + 1, text: raw.slice(i, i + length).join('\n'), comment });
    i += length;
  }
  return lines;
}

/** Cells without the empty ones at the end. */
function trimmed(cells: readonly string[]): number {
  let width = cells.length;
  while (width > 1 && cells[width - 1]!.trim() === '') width--;
  return width;
}

/** Words, or whole numbers one after another: a comma of thousands makes a row longer too. */
function areRowNames(rows: readonly string[][]): boolean {
  const names = rows.map((row) => row[0]!.trim());
  return (
    names.every((name) => formOf(name, false) === 'text') ||
    names.every((name, i) => /^\d+$/.test(name) && (i === 0 || +name > +names[i - 1]!))
  );
}

/** R's tables have one title less than columns: the first holds the rows' names. */
function widthWith(titles: string[], rows: readonly string[][]): number {
  const longer = rows.filter((row) => row.length === titles.length + 1 && row.at(-1)!.trim() !== '').length;
  const led = (): boolean => rows.every((row) => row[0]!.trim() === '');
  if (
    rows.length > 0 &&
    longer === rows.length &&
    titles.every((title) => title.trim() !== '') &&
    (areRowNames(rows) || led())
  )
    titles.unshift('');
  return titles.length;
}

/** Index of the first line that is a row of the table: most of its cells are numbers, and it is as wide as most rows. */
function firstRowOf(lines: readonly Line[], comma: boolean): number {
  const forms = lines.slice(0, MOST_ROWS).map(({ cells }) => {
    let [numbers, others] = [0, 0];
    for (const cell of cells) {
      const form = formOf(cell, comma);
      if (form === 'number' || form === 'time' || isBareGroup(cell.trim(), comma)) numbers++;
      else if (form === 'text' || (form === 'missing' && /^[a-z]/i.test(cell.trim()) && cell.trim().length === 0))
        others++;
    }
    return { row: numbers > 0 && numbers >= others, width: trimmed(cells), text: formOf(cells[0]!, comma) === 'text' };
  });
  const widths = new Map<number, number>();
  for (const { row, width } of forms) if (row) widths.set(width, (widths.get(width) ?? 0) + width);
  const width = [...widths].sort((a, b) => b[1] - a[1])[0]?.[0];
  const own = forms.filter((form) => form.row && form.width === width);
  // Lines of a name and a number stand above a table of two columns.
  const texts = own.filter((form) => form.text).length > own.length / 2;
  const isRow = (form: (typeof forms)[number]): boolean => form.row && form.width === width && form.text === texts;
  // Numbers above the names (a row of ids, say) are alone among words.
  const followed = (i: number): boolean => {
    const next = forms.slice(i + 1, i + 4);
    return next.filter((form) => form.row).length * 2 >= next.length;
  };
  const index = forms.findIndex((form, i) => isRow(form) && followed(i));
  return index >= 0 ? index : forms.findIndex(isRow);
}

function titlesOf({ text, cells }: Line, row: Line | undefined, separator: Separator): string[] {
  if (separator === 'blanks' && row) return blankTitles(text, trimmed(row.cells));
  const width = row ? trimmed(row.cells) : cells.length;
  const joined = cells.length > width ? withUnits(cells) : cells;
  if (joined.length === width && joined !== cells) return joined;
  // `ChannelTitle=` before the names is none of them.
  const [key, ...names] = cells;
  if (!/^[A-Za-z][\w ]{2,30}=$/.test(key!.trim())) return [...cells];
  return row && trimmed(row.cells) < cells.length ? names : ['', ...names];
}

/** `x, mm` between commas, and no quotes: a unit belongs to the name before. */
function withUnits(cells: readonly string[]): string[] {
  const joined: string[] = [];
  for (let i = 0; i < cells.length; i++) {
    const unit = (cells[i + 1] ?? '').trim();
    const has = cells[i]!.trim() !== '' && unit !== '' && isUnit(unit);
    joined.push(has ? `${cells[i++]!} [${unit}]` : cells[i]!);
  }
  return joined;
}

/** Index of the line with the names, or -1. */
function headerOf(
  lines: readonly Line[],
  first: number,
  choices: ImportChoices,
  names: (cells: readonly string[]) => number,
): number {
  if (choices.headerLine !== undefined) return lines.findIndex((line) => line.number === choices.headerLine);
  const from = first < 0 ? Math.min(lines.length, REACH) : first;
  let best = { index: -1, hits: 0 };
  for (let i = Math.min(from, lines.length - 1); i >= Math.max(0, from - REACH); i--) {
    const hits = names(lines[i]!.cells);
    // The first row itself may be one: numbers as titles beside a name.
    if (
      i === first &&
      (hits === 0 || lines[i]!.cells.filter((cell) => /^(?:number|time)$/.test(formOf(cell, false))).length > hits)
    )
      continue;
    if (hits > best.hits) best = { index: i, hits };
  }
  if (best.index >= 0) return best.index;
  if (first < 0) return 0;
  // No name is known: the nearest line of words that is as wide.
  const width = trimmed(lines[first]!.cells);
  for (let i = first - 1; i >= Math.max(0, first - 4); i--) {
    const { cells } = lines[i]!;
    if (isUnitsRow(cells)) continue;
    if (Math.abs(trimmed(cells) - width) <= 1 && cells.filter((c) => formOf(c, false) === 'text').length * 2 >= width)
      return i;
  }
  return -1;
}

interface CommentedHeader {
  number: number;
  cells: string[];
  units: string[] | null;
  unitsLine: number | null;
}

/** numpy.savetxt writes its header as a comment; a comment with the units may follow. */
function commentedHeader(
  all: readonly { number: number; text: string; comment: boolean }[],
  lines: readonly Line[],
  first: number,
  separator: Separator,
  names: (cells: readonly string[]) => number,
): CommentedHeader | null {
  const row = lines[first];
  if (!row) return null;
  const width = trimmed(row.cells);
  let below: { units: string[]; unitsLine: number } | null = null;
  for (const line of all
    .filter((l) => l.comment && l.number < row.number)
    .reverse()
    .slice(0, REACH)) {
    const text = line.text
      .replace(COMMENT, '')
      .replace(/["',;\t]*$/, '')
      .trim();
    const ways = ([separator, ',', '\t', ';', 'blanks'] as const)
      .map((by) => (by === 'blanks' ? blankTitles(text, width) : cellsOf(text, by)))
      .filter((cells) => cells.length === width);
    const units = ways.find(isUnitsRow) ?? null;
    const cells = ways.sort((a, b) => names(b) - names(a))[0];
    if (cells && !units && names(cells) > 0)
      return { number: line.number, cells, units: below?.units ?? null, unitsLine: below?.unitsLine ?? null };
    if (units) below = { units, unitsLine: line.number };
  }
  return null;
}

/** A line of words below the names: descriptions, places, types, ranges behind their word (`Range=`); rules. */
const isRemarks = (cells: readonly string[], comma: boolean): boolean =>
  /^[A-Za-z][\w ]{2,30}[=:]$/.test(cells[0]!.trim()) ||
  cells.every((cell) => /^[-_=]{3,}$/.test(cell.trim())) ||
  (cells.some((cell) => formOf(cell, comma) === 'text') &&
    cells.every((cell) => /^(?:text|missing)$/.test(formOf(cell, comma))));

/** What stands before a row of units as its name. */
const UNITS_KEY =
  /^\W*(?:units?|unit ?names?|units? ?labels?|einheit(?:en)?|unit[ée]s?|unidad(?:es)?|unit[aà]|eenheid|jednostka)\W*$/i;

/** What stands in a row of units for a column that has none. */
const UNITLESS = /^[[(]?(?:dimensionless|none|text|bool|unitless|quat|[-–—1])?[\])]?$/i;

/** The unit that a row of units gives a column: as written, understood or not; '' for none. */
export const unitInRow = (cell: string): string => {
  const unit = cell.trim().replace(/^[[({](.*)[\])}]$/, '$1');
  return UNITLESS.test(unit) ? '' : unit;
};

const unitsIn = (all: readonly string[]): string[] =>
  (UNITS_KEY.test(all[0] ?? '') ? all.slice(1) : all)
    .filter((cell) => unitInRow(cell) !== '')
    .map((cell) => cell.trim());

/** A row of units: nothing but units, and one of them a real one. */
export function isUnitsRow(cells: readonly string[]): boolean {
  const units = unitsIn(cells);
  return units.length > 0 && units.every(isUnit);
}

/** A row under the names, of short words that are mostly units: those that are not known are units too, to be told so. */
function isUnitsBelow(cells: readonly string[]): boolean {
  const units = unitsIn(cells);
  const known = units.filter(isUnit).length;
  return (
    isUnitsRow(cells) || (known >= 2 && 2 * known > units.length && units.every((unit) => /^\D\S{0,11}$/.test(unit)))
  );
}

/** Without the word that stands before them, in a column of its own or in that of the first title. */
function unitCells(cells: readonly string[], width: number): string[] {
  if (!UNITS_KEY.test(cells[0]!)) return [...cells];
  return cells.length > width ? cells.slice(1) : ['', ...cells.slice(1)];
}

/** Where the levels of names have names too, the index's stands in a line of its own (pandas). */
const isIndexName = (cells: readonly string[], titles: readonly string[]): boolean =>
  titles.length > 2 && timeRank(cells[0]!) !== null && cells.slice(1).every((cell) => cell.trim() === '');

/** pandas writes an index's name in a line of its own: it fills gaps of the titles. */
function fillsTitles(cells: readonly string[], titles: string[]): boolean {
  const filled = cells.flatMap((cell, i) => (cell.trim() === '' ? [] : [i]));
  if (isIndexName(cells, titles)) {
    titles[0] = cells[0]!;
    return true;
  }
  const fits =
    filled.length > 0 && filled.every((i) => (titles[i] ?? 'x').trim() === '' && formOf(cells[i]!, false) === 'text');
  if (fits) for (const i of filled) titles[i] = cells[i]!;
  return fits;
}

/** A line of names above fills the first titles, where these are empty. */
function fillsFromAbove(cells: readonly string[], titles: string[]): boolean {
  const empty = titles.findIndex((title) => title.trim() !== '');
  if (empty < 1) return false;
  const first = cells.slice(0, empty);
  if (!first.every((cell) => formOf(cell, false) === 'text' && !/[=:]$/.test(cell.trim()))) return false;
  for (const [i, cell] of first.entries()) titles[i] = cell;
  return true;
}

/** Lines above names that occur more than once: each name of a group holds to the right until the next. */
function groupsOf(
  lines: readonly Line[],
  header: number,
  titles: readonly string[],
  headerLines: number[],
): string[][] {
  const filled = titles.map((t) => t.trim().toLowerCase()).filter((t) => t !== '');
  if (new Set(filled).size === filled.length) return [];
  const groups: string[][] = [];
  for (let i = header - 1; i >= Math.max(0, header - 6); i--) {
    const { cells, number } = lines[i]!;
    if (lines[i + 1]!.number - number > 1) break;
    if (
      Math.abs(cells.length - titles.length) > 2 ||
      cells.length < 3 ||
      (cells[0]!.trim() !== '' && i === 0 && cells.length !== titles.length)
    )
      break;
    let held = '';
    const group = titles.map((_, column) => (held = isMissing(cells[column] ?? '') ? held : cells[column]!.trim()));
    if (new Set(group.filter((g) => g !== '')).size > 1) groups.unshift(group);
    headerLines.push(number);
  }
  return groups;
}
