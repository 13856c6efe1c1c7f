import { extentOf } from './extent.ts';

/** Numbers that loggers write for "nothing measured". */
const SENTINELS = [
  -9999, 9999, -999, 999, -99999, 99999, -999999, 999999, -9999.99, -999.99, -999.25, -32768, -2147483648, 1e30, -1e30,
  9.9e37, 9.96921e36,
];
/** Times the other numbers of a column. */
const FAR = 20;
const FEW = 0.5;

export interface Measured {
  data: Float64Array;
  /** Of the file's unit. */
  factor: number;
}

/**
 * Rows in which all columns that have it hold a number that stands for a missing one: far from all others of the column,
 * and in two columns at once where there are two. Null where there is none.
 */
export function missingRows(columns: readonly Measured[]): { value: number; rows: readonly number[] } | null {
  for (const value of SENTINELS) {
    const hit = columns.filter(({ data, factor }) => {
      const { low, high } = extentOf(data);
      const written = value * factor;
      return isSame(low, written) || isSame(high, written);
    });
    if (hit.length < Math.min(2, columns.length)) continue;
    const rows = rowsWith(hit, value);
    if (rows) return { value, rows };
  }
  return null;
}

const isSame = (a: number, b: number): boolean => Math.abs(a - b) <= 1e-6 * Math.abs(b);

function rowsWith(columns: readonly Measured[], value: number): number[] | null {
  const rows: number[] = [];
  let others = 0;
  const length = columns[0]!.data.length;
  for (let i = 0; i < length; i++) {
    const same = columns.filter(({ data, factor }) => isSame(data[i]!, value * factor)).length;
    if (same > 0) rows.push(i);
    else for (const { data, factor } of columns) others = Math.max(others, Math.abs(data[i]! / factor) || 0);
  }
  return rows.length <= FEW * length && FAR * others < Math.abs(value) ? rows : null;
}
