import Papa from 'papaparse';
import type { Separator } from '../plan.ts';
import { blankCells } from './cells.ts';
import { isComment, recordLength } from './records.ts';

/** A record of a file and the 1-based line on which it begins. */
export type RecordSink = (cells: string[], line: number) => void;

/** No row of numbers is longer; a file without line ends would only grow in memory. */
export const LONGEST_LINE = 1e6;

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

/**
 * Empties the lines that begin with `#`, `%` or `//` (a spreadsheet may have put quotes around them) and hands over their
 * text. A spreadsheet's `#N/A` begins a row.
 */
export function withoutComments(block: string, onComment: (text: string) => void): string {
  if (!/[#%/]/.test(block)) return block;
  return block.replace(/^[ \t]*(["']?)(?:#|%|\/\/)[^\n]*$/gm, (line, quote: string) => {
    if (!isComment(line)) return line;
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

/** Splits whole lines into records. Quotes are rare in files of numbers: lines without them take papaparse's fast way. */
export function eachRecord(block: string, separator: Separator, firstLine: number, sink: RecordSink): void {
  if (separator === 'blanks') {
    for (const [i, line] of block.split('\n').entries()) sink(blankCells(line), firstLine + i);
    return;
  }
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
