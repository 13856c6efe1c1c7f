import { isUnit } from './units.ts';

/** No longer title is a name with a unit; the patterns would take long over it. */
const LONGEST_TITLE = 200;
const BRACKETED = /^(.*?)[[({<]([^\])}>]*)[\])}>]$/;
/** `x/mm`, `x: mm`, `x, mm`, `x in mm`, `x_mm`, `x mm`. */
const BEHIND = /^(.+?)(?:\s*[/:,]\s*|[_\s]+in[_\s]+|[_\s]+)([^\s_:,]+)$/;

export interface Title {
  name: string;
  unit: string;
}

/** `der(x)`, `d(x)/dt`, `X(front)`: brackets that belong to the name. */
const FUNCTION = /^(?:der|d|diff|ddt|dot)\s*$/i;

/** Splits `alpha [deg]` and `time (s)` into name and unit: what stands in brackets is the unit, understood or not. */
export function splitTitle(title: string): Title {
  if (title.length > LONGEST_TITLE) return { name: '', unit: '' };
  const line = title.trim().replace(/\s+/g, ' ');
  const match = BRACKETED.exec(line);
  if (!match || FUNCTION.test(match[1]!)) return { name: line, unit: '' };
  // ISO 80000 writes `v/(m/s)`.
  return { name: match[1]!.replace(/[\s/:,]+$/, ''), unit: match[2]!.trim() };
}

/** A unit behind the name without brackets, where it is one; null otherwise. */
export function unitBehind(name: string): Title | null {
  if (name.length > LONGEST_TITLE) return null;
  // `v/m/s`: the first slash may be the one that divides name and unit.
  for (const pattern of [/^([^/]+)\s*[/:]\s*([^:]+)$/, BEHIND]) {
    const match = pattern.exec(name);
    if (match && isUnit(match[2]!)) return { name: match[1]!.trim(), unit: match[2]!.trim() };
  }
  return null;
}

/** A title on one line that a message can hold. */
export function shortened(title: string): string {
  const line = title.trim().replace(/\s+/g, ' ');
  return line.length > 60 ? `${line.slice(0, 59)}…` : line;
}
