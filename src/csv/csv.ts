import { writeNumber } from './reading/numbers.ts';
import type { CsvOptions, CsvResult } from './reading/result.ts';
import { CsvReader } from './reading/textReader.ts';

export { CsvReader } from './reading/textReader.ts';
export type { CsvOptions, CsvResult } from './reading/result.ts';
export type { CsvIssue } from './reading/issues.ts';

/** Rows joined into one piece of text; joining all at once would hold every line of a large run in memory twice. */
const ROWS_PER_PIECE = 2000;

/** Characters read at a time. */
const PIECE = 1 << 20;

/** The line above the rows: a spreadsheet and pandas take the first line for the names. */
export function csvHeader(columns: readonly string[]): string {
  return `${columns.join(',')}\n`;
}

/** Lines behind the rows that begin with `#`. */
export function csvComments(comments: readonly string[]): string {
  return comments.map((c) => `# ${c.replace(/[\r\n]+/g, ' ')}\n`).join('');
}

/**
 * Rows `from` to `to` of columns as CSV text, 17 significant digits: reading it back is exact to the last bit.
 * Values that are not finite are written as empty cells.
 */
export function* csvRows(data: readonly Float64Array[], from = 0, to = data[0]?.length ?? 0): Generator<string> {
  for (let start = from; start < to; start += ROWS_PER_PIECE) {
    const lines: string[] = [];
    for (let row = start; row < Math.min(to, start + ROWS_PER_PIECE); row++) {
      let line = '';
      for (let c = 0; c < data.length; c++) line += (c > 0 ? ',' : '') + writeNumber(data[c]![row]!);
      lines.push(line);
    }
    yield lines.join('\n') + '\n';
  }
}

/** A whole CSV file: header, rows, comments. */
export function writeCsv(
  columns: readonly string[],
  data: readonly Float64Array[],
  comments: readonly string[] = [],
): string {
  return csvHeader(columns) + [...csvRows(data)].join('') + csvComments(comments);
}

/** Reads a whole CSV file; see docs/csv-format.md for what is understood. Never throws for bad input. */
export function readCsv(text: string, options: CsvOptions): CsvResult {
  const reader = new CsvReader(options);
  // In pieces, so that the cells of one are forgotten before the next.
  for (let at = 0; at < text.length; at += PIECE) reader.push(text.slice(at, at + PIECE));
  return reader.finish();
}
