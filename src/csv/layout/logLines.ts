/**
 * Lines that are no rows of a table yet: of a board's serial log, `x:0.1 y:0.2` and `10:30:25.123 -> 0.1,0.2`; between
 * brackets or bars, `{0.1, 0.2},` and `| 0.1 | 0.2 |`, with rules between them.
 */
import type { Separator } from '../plan.ts';

export type LineForm = 'plain' | 'labelled' | 'stamped' | 'bracketed';

const PAIR = /([A-Za-z_\u0370-\u03ff][\w.[\]/\u0370-\u03ff]*)\s*[:=]\s*([^\s,;|]+)/g;
const NUMBER = /^[+-]?(?:\d|\.\d)/;
const STAMP = /^(\d{1,2}:\d{2}:\d{2}(?:[.,]\d+)?)\s*->\s?/gm;
const BRACKETED = /^\s*(?:[[({]+\s*[^\s\w"']?[\d.'"+-].*[\])}][\s,;\])}]*|\|.*\|\s*)$/;
/** `|---|---|`, `-----+-----`, `=====  =====`. */
const RULE = /^(?=[^-=]*(?:---|===))[\s|+:=-]*$/;
/** No row with brackets is longer. */
const LONGEST_BRACKETED = 4000;
/** Lines that decide, and the share of them that must have the form. */
const DECIDING = 60;
const MOST = 0.8;

/** The names and values of one line, or null where it has anything else. */
function pairsOf(line: string): [name: string, value: string][] | null {
  if (line.length > 4000 || line.replace(PAIR, '').replace(/[\s,;|]+/g, '') !== '') return null;
  return [...line.matchAll(PAIR)].map((match) => [match[1]!, match[2]!]);
}

export function lineFormOf(lines: readonly string[]): LineForm {
  const deciding = lines.slice(0, DECIDING);
  const share = (is: (line: string) => boolean): number => deciding.filter(is).length / (deciding.length || 1);
  if (share((line) => line.search(STAMP) === 0) > MOST) return 'stamped';
  if (
    deciding.slice(0, 12).some((line) => RULE.test(line)) ||
    share((line) => line.length < LONGEST_BRACKETED && BRACKETED.test(line)) > MOST
  )
    return 'bracketed';
  const labelled = (line: string): boolean => {
    const pairs = pairsOf(line);
    return pairs !== null && pairs.length >= 2 && pairs.every(([, value]) => NUMBER.test(value));
  };
  return lines.length > 1 && deciding.some((line) => /[:=]/.test(line)) && share(labelled) > MOST
    ? 'labelled'
    : 'plain';
}

/** Names of a labelled file, from its first lines: a value may be missing in one. */
export function labelsOf(lines: readonly string[]): string[] {
  return [...new Set(lines.slice(0, DECIDING).flatMap((line) => (pairsOf(line) ?? []).map(([name]) => name)))];
}

/** Cells in the order of the labels; a line of another form is one cell. */
export function labelledCells(line: string, labels: readonly string[]): string[] {
  const pairs = line.trim() === '' ? null : pairsOf(line);
  if (!pairs) return [line.trim()];
  const values = new Map(pairs);
  return labels.map((label) => values.get(label) ?? '');
}

/** The stamp of each line becomes a cell of its own. */
export function unstamped(text: string, separator: Separator): string {
  return text.replace(STAMP, `$1${separator === 'blanks' ? ' ' : separator}`);
}

/** Rows without what stands around them; rules become empty lines. */
export function unbracketed(text: string): string {
  return text
    .split('\n')
    .map((line) => (line.length > LONGEST_BRACKETED ? line : RULE.test(line) ? '' : unwrapped(line)))
    .join('\n');
}

/** A bar at one end alone stands before or behind an empty cell; what was opened inside a line is not closed behind it. */
function unwrapped(line: string): string {
  const bars = /^\s*\|\s?(.*?)\s*\|\s*$/.exec(line);
  if (bars) return bars[1]!;
  return /^\s*[[({]/.test(line) ? line.replace(/^\s*[[({]+\s?/, '').replace(/[\])}][\s,;\])}]*$/, '') : line;
}

/** Without their stamps. */
export const withoutStamp = (line: string): string => line.replace(STAMP, '');
