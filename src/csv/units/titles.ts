import { remembered } from '../names/remembered.ts';
import { isUnit } from './units.ts';

/** No longer title is a name with a unit; the patterns would take long over it. */
const LONGEST_TITLE = 200;
const BRACKETED = /^(.*?)[[({<（【]([^\])}>）】]*)[\])}>）】]$/;
/** `x/mm`, `x: mm`, `x, mm`, `x in mm`, `x_mm`, `x mm`. */
const BEHIND = /^(.+?)(?:\s*[/:,]\s*|[_\s]+in[_\s]+|[_\s]+)([^\s_:,]+)$/;

export interface Title {
  name: string;
  unit: string;
}

/** `der(x)`, `board.der(x)`, `d(x)/dt`: brackets that belong to the name. */
const FUNCTION = /(?:^|[.\s/:])(?:der|d|diff|ddt|dot)\s*$/i;
/** `pos[0]`: a part of an array. */
const INDEXED = /^[A-Za-z_]\w+\[\d\]$/;
/** As LaTeX sets it: `$\\dot{\\theta}_{fc}$`. */
const unset = (title: string): string =>
  /[$\\]/.test(title)
    ? title
        .replace(/\\dot\s*\{?\s*(\\?[A-Za-z]+)\s*\}?((?:_\{?\w+\}?)?)/g, '$1$2_dot')
        .replace(/\\(?:mathrm|text|mathit|rm|,|;|left|right)(?![a-z])/g, '')
        .replace(/[$\\{}]/g, '')
        .replace(/\s+/g, ' ')
        .trim()
    : title;
/** `x(t)`, `x[t]`, `x'[t]`: of time, which is no unit. */
const OF_TIME = /\s*(?:\(t\)|\[t\])$/;
/** `yawDeg`, `xMm`: the unit is the last word of a name in camel case. */
const LAST_WORD =
  /^(.*[a-z0-9XYZ])(Deg|Degrees|Rad|Radians|Mm|Cm|Meters|Metres|Ms|Millis|Us|Micros|Ns|Nanos|Sec|Seconds)$/;

/** Splits `alpha [deg]` and `time (s)` into name and unit: what stands in brackets is the unit, understood or not. */
export function splitTitle(title: string): Title {
  if (title.length > LONGEST_TITLE) return { name: '', unit: '' };
  const line = unset(title.trim().replace(/\s+/g, ' '));
  if (INDEXED.test(line)) return { name: line, unit: '' };
  if (OF_TIME.test(line)) return { name: line.replace(OF_TIME, ''), unit: '' };
  const match = BRACKETED.exec(line);
  if (!match || FUNCTION.test(match[1]!)) return { name: line, unit: '' };
  if (match[1]!.trim() === '') return { name: match[2]!.trim(), unit: '' };
  // ISO 80000 writes `v/(m/s)`.
  return { name: match[1]!.replace(/[\s/:,]+$/, ''), unit: match[2]!.trim() };
}

/** A unit behind the name without brackets, where it is one; null otherwise. */
export function unitBehind(name: string): Title | null {
  return unitsBehind(name)[0] ?? null;
}

/** Every way to part a name from a unit behind it: `v/m/s` and `v_x_mm/s` have two. */
export const unitsBehind = remembered((name): readonly Title[] =>
  name.length > LONGEST_TITLE
    ? []
    : [/^([^/]+)\s*[/:]\s*([^:]+)$/, BEHIND, LAST_WORD].flatMap((pattern) => {
        const match = pattern.exec(name);
        return match && isUnit(match[2]!) ? [{ name: match[1]!.trim(), unit: match[2]!.trim() }] : [];
      }),
);

/** A title on one line that a message can hold. */
export function shortened(title: string): string {
  const line = title.trim().replace(/\s+/g, ' ');
  return line.length > 60 ? `${line.slice(0, 59)}…` : line;
}
