/** What stands around the numbers of a table's cells and is none of them: marks of text, units, groups of thousands. */
import { isBareGroup, ungrouped } from '../reading/grouped.ts';
import { readNumber } from '../reading/numbers.ts';
import { timeRank } from '../time/timeNames.ts';
import { isUnit } from '../units/units.ts';
import { isMissing } from './errors.ts';

export interface Dress {
  /** Numbers told to be text, `="0.5"` or `'0.5`. */
  text: boolean;
  /** The unit behind each number of a column; '' where there is none. */
  units: readonly string[];
  /** `1,234` is 1234, as other cells show. */
  grouped: boolean;
}

/** Share of a column's filled cells that must have its unit. */
const MOST = 0.9;
const TEXT = /^(?:=\s*"([^"]*)"|["']([^"']*)["']?)$/;
const WITH_UNIT =
  /^([+\-−]?(?:\d[\d.,'’\u00a0\u202f]*|[.,]\d+)(?:[ed][+-]?\d+)?)\s*([^\d\s.,:;+-][^\d\s:;]{0,7}\d?)$/iu;

/** A cell without the marks that make it text. */
const bare = (cell: string): string => {
  const match = TEXT.exec(cell.trim());
  return match ? (match[1] ?? match[2])! : cell;
};

function parted(cell: string): { number: string; unit: string } | null {
  const match = cell.length < 40 ? WITH_UNIT.exec(cell.trim()) : null;
  return match && isUnit(match[2]!) ? { number: match[1]!, unit: match[2]! } : null;
}

/** A number with digits and a point alone, as nearly all are. */
const isPlain = (cell: string): boolean => Number.isFinite(+cell);

/** For counting what separates: a cell's number alone. */
export function numberIn(cell: string): string {
  if (isPlain(cell)) return cell;
  const plain = bare(cell);
  return parted(plain)?.number ?? plain;
}

/**
 * @param rows cells of lines that are most likely rows
 * @param names cells of the line that may hold the names
 * @returns null where the cells are plain, as nearly always
 */
export function dressOf(
  rows: readonly (readonly string[])[],
  names: readonly string[],
  decimalComma: boolean,
): Dress | null {
  const cells = rows.flat().filter((cell) => cell.trim() !== '');
  if (cells.every((cell) => isPlain(cell))) return null;
  const text = cells.filter((cell) => TEXT.test(cell.trim())).length > cells.length / 2;
  const plain = text ? rows.map((row) => row.map(bare)) : rows;
  const width = Math.max(0, ...plain.map((row) => row.length));
  const columns = Array.from({ length: width }, (_, i) =>
    plain.map((row) => (row[i] ?? '').trim()).filter((cell) => !isMissing(cell)),
  );
  const units = columns.map((column, i) => unitOf(column, names[i] ?? '', decimalComma));
  const numbers = columns.map((column, i) =>
    units[i] === '' ? column : column.map((cell) => parted(cell)?.number ?? cell),
  );
  const grouped = areGrouped(numbers, decimalComma);
  return text || grouped || units.some((unit) => unit !== '') ? { text, units, grouped } : null;
}

function unitOf(column: readonly string[], name: string, decimalComma: boolean): string {
  const found = column.map(parted);
  const unit = found.find((cell) => cell !== null)?.unit ?? '';
  // `5 m` under a time is five minutes, and read so.
  if (unit === '' || (unit === 'm' && timeRank(name) !== null)) return '';
  const same = found.filter(
    (cell) =>
      cell?.unit === unit &&
      !(Number.isNaN(readNumber(cell.number, decimalComma)) && !isBareGroup(cell.number, decimalComma)),
  );
  return same.length >= MOST * column.length ? unit : '';
}

/**
 * Whether `1,234` can only be 1234: another cell shows that the mark parts thousands, or a column has it from 1000 on
 * and nothing below, and points are seen to part decimals; and no cell says otherwise.
 */
function areGrouped(columns: readonly (readonly string[])[], decimalComma: boolean): boolean {
  const mark = decimalComma ? '.' : ',';
  const isBare = (cell: string): boolean => isBareGroup(cell, decimalComma);
  if (!columns.some((column) => column.some(isBare))) return false;
  const isShown = (cell: string): boolean => cell.includes(mark) && ungrouped(cell, decimalComma) !== null;
  const marked = columns.flat().filter((cell) => cell.includes(mark) && /^[+-]?[\d.,]+$/.test(cell));
  if (!marked.every((cell) => isBare(cell) || isShown(cell))) return false;
  if (marked.some(isShown)) return true;
  const decimals = columns.some((column) =>
    column.some((cell) => (decimalComma ? /^[+-]?(?:0|\d{2,})?,\d+$/ : /^[+-]?(?:0|\d{2,})?\.\d+$/).test(cell)),
  );
  return (
    decimals &&
    columns.every((column) => !column.some(isBare) || column.filter((cell) => /^[+-]?\d{1,3}$/.test(cell)).length > 1)
  );
}

/** The cells as plain numbers. */
export function undressed(cells: readonly string[], { text, units, grouped }: Dress, decimalComma: boolean): string[] {
  return cells.map((cell, i) => {
    let plain = text ? bare(cell) : cell;
    const unit = units[i] ?? '';
    if (unit !== '') {
      const parts = parted(plain);
      if (parts?.unit === unit) plain = parts.number;
    }
    return grouped ? (ungrouped(plain.trim(), decimalComma, true) ?? plain) : plain;
  });
}
