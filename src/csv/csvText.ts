import Papa from 'papaparse';
import { readNumber } from './numbers.ts';

/** A record of a file and the 1-based line on which it begins. */
export type RecordSink = (cells: string[], line: number) => void;

/** No row of numbers is longer; a file without line ends would only grow in memory. */
export const LONGEST_LINE = 1e6;

const SEPARATORS = [',', ';', '\t'] as const;
/** Lines that decide the separator. */
const SAMPLE_LINES = 30;
/** Lines over which a quoted cell may reach. */
const LONGEST_RECORD = 6;
const DECIMAL_COMMA = /^[+-]?\d*,\d+(e[+-]?\d+)?$/i;

/** Turns text in pieces into whole lines that end with LF, whatever the file's line ends are. */
export class LineSource {
  private rest = '';
  private heldReturn = false;

  /** The lines that are whole by now. */
  push(piece: string): string {
    let text = this.heldReturn ? `\r${piece}` : piece;
    // A CR at the end may be half of a CRLF.
    this.heldReturn = text.endsWith('\r');
    if (this.heldReturn) text = text.slice(0, -1);
    if (text.includes('\r')) text = text.replace(/\r\n?/g, '\n');
    const end = text.lastIndexOf('\n') + 1;
    if (end === 0) {
      this.rest += text;
      return '';
    }
    const whole = this.rest + text.slice(0, end);
    this.rest = text.slice(end);
    return whole;
  }

  get waiting(): number {
    return this.rest.length;
  }

  /** What is left when the file ends without a line end. */
  finish(): string {
    const last = this.rest;
    this.rest = '';
    return last === '' ? '' : `${last}\n`;
  }
}

/** Empties the lines that begin with `#` (a spreadsheet may have put quotes around them) and hands over their text. */
export function withoutComments(block: string, onComment: (text: string) => void): string {
  if (!block.includes('#')) return block;
  return block.replace(/^[ \t]*(["']?)#[^\n]*$/gm, (line, quote: string) => {
    const plain = line.trim();
    onComment(
      quote === '"'
        ? plain
            .replace(/"[,;\t]*$/, '')
            .slice(1)
            .replace(/""/g, '"')
        : plain,
    );
    return '';
  });
}

/** The separator that makes most cells numbers, then most cells. */
export function separatorOf(block: string): string {
  const lines = block
    .slice(0, 65536)
    .split('\n', 4 * SAMPLE_LINES)
    .filter((line) => line.trim() !== '')
    .slice(0, SAMPLE_LINES);
  // The last line of a sample may be cut, the first may be a header.
  const rows = lines.length > 2 ? lines.slice(1, -1) : lines.slice(-1);
  let best: { separator: string; share: number; cells: number } = { separator: ',', share: -1, cells: 0 };
  for (const separator of SEPARATORS) {
    const cells = rows
      .flatMap((row) => row.split(separator).map((cell) => cell.trim().replace(/^"(.*)"$/, '$1')))
      .filter((cell) => cell !== '');
    const numbers = cells.filter(
      (cell) =>
        !Number.isNaN(readNumber(cell, false)) ||
        (separator !== ',' && cells.length > rows.length && DECIMAL_COMMA.test(cell)),
    );
    const share = cells.length > 0 ? numbers.length / cells.length : 0;
    if (share > best.share || (share === best.share && cells.length > best.cells))
      best = { separator, share, cells: cells.length };
  }
  return best.separator;
}

/** How decimals are written in some rows, or null where none tells. Commas count only where they separate nothing. */
export function decimalsOf(block: string, separator: string): 'comma' | 'point' | null {
  if (separator === ',' || /\d\.\d/.test(block)) return 'point';
  return /\d,\d/.test(block) ? 'comma' : null;
}

/** Splits whole lines into records. Quotes are rare in files of numbers: lines without them take papaparse's fast way. */
export function eachRecord(block: string, separator: string, firstLine: number, sink: RecordSink): void {
  if (!block.includes('"')) {
    const { data } = Papa.parse<string[]>(block, { delimiter: separator, newline: '\n', fastMode: true });
    for (let i = 0; i < data.length; i++) sink(data[i]!, firstLine + i);
    return;
  }
  const lines = block.split('\n');
  for (let i = 0; i < lines.length;) {
    const length = recordLength(lines, i);
    const text = lines.slice(i, i + length).join('\n');
    const cells = text.includes('"')
      ? (Papa.parse<string[]>(text, { delimiter: separator, newline: '\n' }).data[0] ?? [''])
      : text.split(separator);
    sink(cells, firstLine + i);
    i += length;
  }
}

/** Lines of the record that begins at a line: a quoted cell may hold line ends, but a stray quote swallows nothing. */
function recordLength(lines: readonly string[], start: number): number {
  let quotes = 0;
  for (let length = 1; length <= LONGEST_RECORD && start + length <= lines.length; length++) {
    for (const c of lines[start + length - 1]!) if (c === '"') quotes++;
    if (quotes % 2 === 0) return length;
  }
  return 1;
}
