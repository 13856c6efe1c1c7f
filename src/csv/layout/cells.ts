import Papa from 'papaparse';
import type { Separator } from '../plan.ts';
import { moment } from '../time/clock.ts';
import { readNumber } from '../reading/numbers.ts';
import { isMissing } from './errors.ts';

/** Longer cells are no numbers and no names. */
const LONGEST = 64;

/** The cells of one line; quotes are papaparse's. */
export function cellsOf(line: string, separator: Separator): string[] {
  if (separator === 'blanks') return blankCells(line);
  if (!line.includes('"')) return line.split(separator);
  return Papa.parse<string[]>(line, { delimiter: separator, newline: '\n' }).data[0] ?? [''];
}

/** Runs of spaces and tabs separate; quotes hold a name together. */
export function blankCells(line: string): string[] {
  const text = line.trim();
  if (!text.includes('"')) return text.split(/[ \t\u00a0]+/);
  return (text.match(/"[^"]*"|[^\s"]+/g) ?? []).map((cell) => cell.replace(/^"(.*)"$/, '$1'));
}

/** Names between blanks, so many of them where that can be: units in brackets belong to the name before. */
export function blankTitles(line: string, width: number): string[] {
  const plain = blankCells(line);
  if (plain.length === width) return plain;
  const text = line.trim();
  const merged = text.match(/[^\s[(]+(?:\s*[[(][^\])]*[\])])?/g) ?? [];
  if (merged.length === width) return merged;
  const apart = text.split(/\s{2,}|\t/);
  return apart.length === width ? apart : plain;
}

/** What one cell of a table can be. */
export type CellForm = 'number' | 'time' | 'missing' | 'text';

export function formOf(cell: string, decimalComma: boolean): CellForm {
  if (cell.length > LONGEST) return 'text';
  // Nearly every cell is a number, and no number is missing.
  if (!Number.isNaN(readNumber(cell, decimalComma)) && cell.trim() !== '') return 'number';
  const text = cell.trim();
  if (isMissing(text)) return 'missing';
  if (moment(text) !== null) return 'time';
  return 'text';
}
