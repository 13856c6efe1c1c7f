import { beginsWithError } from './errors.ts';

/** Lines over which a quoted cell may reach. */
const LONGEST_RECORD = 6;

/** What a comment begins with, a spreadsheet's quotes before it. */
export const COMMENT = /^[ \t]*(["']?)(#|%|\/\/)/;

export function isComment(line: string): boolean {
  const match = COMMENT.exec(line);
  if (!match) return false;
  return match[2] !== '#' || !beginsWithError(line.trimStart().replace(/^["']/, ''));
}

/** Lines of the record that begins at a line: a quoted cell may hold line ends, but a stray quote swallows nothing. */
export function recordLength(lines: readonly string[], start: number): number {
  let quotes = 0;
  for (let length = 1; length <= LONGEST_RECORD && start + length <= lines.length; length++) {
    for (const c of lines[start + length - 1]!) if (c === '"') quotes++;
    if (quotes % 2 === 0) return length;
  }
  return 1;
}
