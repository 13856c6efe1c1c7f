import type { ImportChoices, Separator } from '../plan.ts';
import { cellsOf, formOf } from './cells.ts';

const SEPARATORS: readonly Separator[] = [',', ';', '\t', '|', 'blanks'];
/** Lines that decide, the last of the sample: the first may be no rows yet. */
const DECIDING = 60;
const COMMA_NUMBER = /^[+-]?\d*,\d+([ed][+-]?\d+)?$/i;
const POINT_NUMBER = /^[+-]?\d*\.\d+([ed][+-]?\d+)?$/i;
/** `1,234.5`, `1.234,5`, `1 234`, `1'234.5`. */
const THOUSANDS =
  /^[+-]?\d{1,3}(?:(?:,\d{3})+\.\d+|(?:\.\d{3})+,\d+|(?:,\d{3}){2,}|(?:\.\d{3}){2,}|(?:['’ \u00a0\u202f]\d{3})+(?:[.,]\d+)?)$/;

export function hasThousands(cell: string): boolean {
  return cell.length < 40 && THOUSANDS.test(cell.trim());
}

export interface Marks {
  separator: Separator;
  decimal: '.' | ',';
}

/** The separator and decimal mark that make most cells numbers, then most cells. */
export function marksOf(lines: readonly string[], choices: ImportChoices): Marks {
  const deciding = lines.length > 2 ? lines.slice(1).slice(-DECIDING) : lines;
  const candidates = choices.separator ? [choices.separator] : SEPARATORS;
  let best: (Marks & { share: number; cells: number }) | null = null;
  for (const separator of candidates) {
    const cells = deciding.flatMap((line) => cellsOf(line, separator)).filter((cell) => cell.trim() !== '');
    const decimal = choices.decimal ?? decimalOf(cells);
    // A comma behind a number is a separator that was not taken for one.
    const isNumber = (cell: string): boolean => {
      if (decimal === ',' && cell.endsWith(',')) return false;
      const form = formOf(cell, decimal === ',');
      return form === 'number' || form === 'time' || hasThousands(cell);
    };
    // One decimal comma a line is two columns as well as one.
    const numbers =
      separator !== ',' && decimal === ',' && cells.length <= deciding.length ? 0 : cells.filter(isNumber).length;
    const share = cells.length > 0 ? numbers / cells.length : 0;
    if (!best || share > best.share || (share === best.share && cells.length > best.cells && separator !== 'blanks'))
      best = { separator, decimal, share, cells: cells.length };
  }
  const { separator, decimal } = best!;
  return { separator, decimal };
}

function decimalOf(cells: readonly string[]): '.' | ',' {
  let [commas, points] = [0, 0];
  for (const cell of cells) {
    const text = cell.trim();
    if (COMMA_NUMBER.test(text)) commas++;
    else if (POINT_NUMBER.test(text)) points++;
  }
  return commas > points ? ',' : '.';
}
