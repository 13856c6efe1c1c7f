import type { Source } from '../source.ts';
import { formOf } from './cells.ts';
import type { Layout } from './layout.ts';

/** Rows of several bodies in one table, told apart by a column with their names or numbers. */
export interface Stacked {
  column: number;
  values: readonly string[];
}

/** Numbers are names of bodies only under such a title. */
const NAMES =
  /^(?:body|object|agent|robot|vehicle|subject|rigid ?body|marker|track|particle)[\s_-]?(?:id|no|nr|number|name)?$/i;
const MOST_BODIES = 200;

/**
 * The column by which the times of each body rise, though those of all rows do not. Null for any other table.
 * @param seconds time of a row's cells
 */
export function stackedOf(
  layout: Layout,
  sources: readonly Source[],
  timed: ReadonlySet<number>,
  seconds: (cells: readonly string[]) => number,
): Stacked | null {
  const { rows } = layout;
  const comma = layout.decimal === ',';
  const times = rows.map((row) => seconds(row));
  if (rises(times) || rows.length < 4) return null;
  for (const { index, plain } of sources) {
    if (timed.has(index)) continue;
    const cells = rows.map((row) => (row[index] ?? '').trim());
    const values = [...new Set(cells)];
    if (values.length < 2 || values.length > Math.min(MOST_BODIES, rows.length / 2)) continue;
    const forms = values.map((value) => formOf(value, comma));
    if (!forms.every((form) => form === 'text') && !(NAMES.test(plain) && forms.every((form) => form === 'number')))
      continue;
    if (values.every((value) => rises(times.filter((_, i) => cells[i] === value)))) return { column: index, values };
  }
  return null;
}

const rises = (times: readonly number[]): boolean =>
  times.length > 0 && times.every((t, i) => i === 0 || !(t <= times[i - 1]!));
