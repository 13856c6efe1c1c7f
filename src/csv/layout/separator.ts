import type { ImportChoices, Separator } from '../plan.ts';
import { cellsOf, formOf } from './cells.ts';
import { numberIn } from './dress.ts';
import { isBareGroup, ungrouped } from '../reading/grouped.ts';

const SEPARATORS: readonly Separator[] = [',', ';', '\t', '|', 'blanks'];
/** Lines that decide, the last of the sample: the first may be no rows yet. */
const DECIDING = 60;
const COMMA_NUMBER = /^[+-]?\d*,\d+([ed][+-]?\d+)?$/i;
const POINT_NUMBER = /^[+-]?\d*\.\d+([ed][+-]?\d+)?$/i;
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
    const cells = deciding
      .flatMap((line) => {
        const own = cellsOf(line, separator);
        // Blanks in a line that is one cell separate; in others they may part thousands.
        return own.length === 1 && /\d\s+[\d+-]/.test(own[0]!) ? own : own.map(numberIn);
      })
      .filter((cell) => cell.trim() !== '');
    const decimal = choices.decimal ?? decimalOf(cells);
    // A comma behind a number is a separator that was not taken for one.
    const isNumber = (cell: string): boolean => {
      if (decimal === ',' && cell.endsWith(',')) return false;
      const form = formOf(cell, decimal === ',');
      return form === 'number' || form === 'time' || isBareGroup(cell.trim(), decimal === ',');
    };
    // One decimal comma a line is two columns as well as one.
    const numbers =
      separator !== ',' && decimal === ',' && cells.length <= deciding.length ? 0 : cells.filter(isNumber).length;
    const share = cells.length > 0 ? numbers / cells.length : 0;
    if (!best || share > best.share || (share === best.share && cells.length > best.cells && separator !== 'blanks'))
      best = { separator, decimal, share, cells: cells.length };
    // Whole numbers in every cell: no other mark can be inside them.
    if (share === 1 && cells.length > deciding.length) break;
  }
  const { separator, decimal } = best!;
  return { separator, decimal };
}

/** By the cells with one meaning; `1,234` is asked only where there are none. */
function decimalOf(cells: readonly string[]): '.' | ',' {
  let [commas, points, doubtful] = [0, 0, 0];
  for (const cell of cells) {
    const text = cell.trim();
    if (isBareGroup(text, false)) doubtful++;
    else if (isBareGroup(text, true)) doubtful--;
    else if (COMMA_NUMBER.test(text) || ungrouped(text, true) !== null) commas++;
    else if (POINT_NUMBER.test(text) || ungrouped(text, false) !== null) points++;
  }
  if (commas === points) return doubtful > 0 ? ',' : '.';
  return commas > points ? ',' : '.';
}
