/** Numbers as people type and read them: real minus signs, degrees for angles, thin spaces before units. */
import type { NumberOrExpression } from '../../core/scenario/types.ts';

export const MINUS = '\u2212';
export const THIN = '\u202f';
const DEGREE = Math.PI / 180;
const PLAIN = /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i;
const PLAIN_DEGREES = /^([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?) ?deg$/i;

const typographic = (text: string): string => text.replace(/-/g, MINUS);

/** `digits` decimals, never a negative zero. */
export function formatFixed(x: number, digits: number): string {
  if (!Number.isFinite(x)) return '–';
  const text = x.toFixed(digits);
  return typographic(Number(text) === 0 ? text.replace('-', '') : text);
}

/** Powers of ten, e.g. `−2.1e−10`; zero is `0`. */
export function formatScientific(x: number, digits = 1): string {
  if (!Number.isFinite(x)) return '–';
  if (x === 0) return '0';
  return typographic(x.toExponential(digits).replace('e+', 'e'));
}

const RAISED = '⁰¹²³⁴⁵⁶⁷⁸⁹';

/** Powers of ten as they are written by hand, e.g. `−2·10⁻¹⁰`; what is neither small nor large as it is. */
export function formatPower(x: number): string {
  if (!Number.isFinite(x)) return '–';
  const [digits, exponent] = x.toExponential(0).split('e') as [string, string];
  if (x === 0 || Math.abs(Number(exponent)) <= 2) return formatShort(x, 1);
  const raised = [...exponent].map((c) => (c === '+' ? '' : c === '-' ? '⁻' : RAISED[Number(c)]!)).join('');
  return `${typographic(digits)}·10${raised}`;
}

export interface EnergyFacts {
  energyDrift: number | null;
  energyChange: number;
}

/** An energy drift beside the largest kinetic energy; at rest, where there is none, the change in joules. */
export function formatDrift({ energyDrift, energyChange }: EnergyFacts): string {
  return energyDrift === null ? `${formatScientific(energyChange)}${THIN}J` : formatScientific(energyDrift);
}

/** As few digits as say it: at most `digits` significant ones. */
export function formatShort(x: number, digits = 4): string {
  if (!Number.isFinite(x)) return '–';
  return typographic(String(Number(x.toPrecision(digits))).replace('e+', 'e'));
}

/** Signs of a number that every field has room for. */
const MOST_SIGNS = 8;

/** A field's text as it stands while nobody edits it: a number that is too long for its box is rounded, and says so. */
export function restingText(text: string): string {
  const plain = plainText(text).trim();
  return text.length > MOST_SIGNS && PLAIN_NUMBER.test(plain) ? `≈${formatShort(Number(plain))}` : text;
}

/** Text that says its value itself. */
export const PLAIN_NUMBER = /^[-+]?[\d.]*(e[-+]?\d*)?$/i;

/** Seconds to the millisecond. */
export const formatTime = (t: number): string => formatFixed(t, 3);

export const formatCount = (n: number): string => String(Math.round(n)).replace(/\B(?=(\d{3})+$)/g, ',');

export function formatSpeed(speed: number): string {
  const inverse = 1 / speed;
  if (speed < 1 && Math.abs(inverse - Math.round(inverse)) < 1e-9) return `1/${Math.round(inverse)}×`;
  return `${formatShort(speed, 2)}×`;
}

/** A value with its unit; angles in degrees to 0.01, lengths to 0.1 mm. */
export function formatValue(x: number, kind: 'length' | 'angle'): string {
  return kind === 'angle' ? formatFixed(x / DEGREE, 2) : formatFixed(x, 4);
}

/** A value in a sentence, e.g. `0.08196 m`, `12.4°`. */
export function formatQuantity(x: number, unit: string): string {
  const angle = unit.startsWith('°');
  const number = formatShort(angle ? x / DEGREE : x, 4);
  return unit === '' || unit === '°' ? number + unit : `${number}${THIN}${unit}`;
}

/** What stands in the field for a draft value: degrees for angles, expressions as they were typed. */
export function formatField(value: NumberOrExpression | undefined, angle: boolean): string {
  if (value === undefined) return '';
  if (typeof value === 'number') return formatShort(angle ? value / DEGREE : value, 12);
  const degrees = angle ? PLAIN_DEGREES.exec(value.trim()) : null;
  return typographic(degrees ? degrees[1]! : value);
}

/** Typed text with typographic signs made plain. */
export function plainText(text: string): string {
  return text
    .replace(/[\u2212\u2013]/g, '-')
    .replace(/[×·]/g, '*')
    .replace(/[\s\u202f\u2009\u00a0]+/g, ' ')
    .replace(/ ?°/g, ' deg')
    .replace(/π/g, 'pi')
    .trim();
}

export interface FieldRules {
  /** Bare numbers are degrees. */
  angle: boolean;
  unit?: string | undefined;
  /** May be empty: the value is then not named. */
  optional?: boolean;
  min?: number | undefined;
  max?: number | undefined;
  positive?: boolean | undefined;
  /** The draft takes a number only, no expression. */
  numeric?: boolean;
}

export type Parsed =
  { ok: true; stored: NumberOrExpression | undefined; value: number | undefined } | { ok: false; error: string };

/** Reads a field. `stored` is what the draft keeps: SI for plain numbers, otherwise the expression, made explicit. */
export function parseField(typed: string, rules: FieldRules, evaluate: (text: string) => number): Parsed {
  const { text, radians } = withoutUnit(plainText(typed), rules);
  if (text === '') {
    return rules.optional ? { ok: true, stored: undefined, value: undefined } : { ok: false, error: 'needs a number' };
  }
  if (/^[-+]?\d+,\d+$/.test(text)) return { ok: false, error: 'write decimals with a point' };
  const plain = PLAIN.test(text);
  const unitless = rules.angle && !radians && !isExpression(text);
  const expression = unitless ? (plain ? `${text} deg` : `(${text}) deg`) : text;
  let value: number;
  try {
    value = plain ? Number(text) * (unitless ? DEGREE : 1) : evaluate(expression);
  } catch (problem) {
    return { ok: false, error: problem instanceof Error ? problem.message : String(problem) };
  }
  const error = outside(value, rules);
  if (error) return { ok: false, error };
  const stored = rules.numeric || (plain && !unitless) ? value : expression;
  return { ok: true, stored, value };
}

/** Units may be typed; of those only `deg` changes what an expression means. */
function withoutUnit(text: string, rules: FieldRules): { text: string; radians: boolean } {
  if (rules.angle) {
    const perSecond = text.replace(/(deg|rad) ?\/ ?s$/i, '$1');
    const bare = perSecond.replace(/ ?(?<![a-z])rad$/i, '');
    return { text: bare, radians: bare !== perSecond };
  }
  const unit = rules.unit;
  return { text: unit && text.endsWith(` ${unit}`) ? text.slice(0, -unit.length).trim() : text, radians: false };
}

/** Whether the text of an angle field is not simply a number of degrees. */
export const isExpression = (text: string): boolean => /[a-zπ]/i.test(text.replace(/(\d|\.)e[-+\u2212]?\d/gi, '$1'));

function outside(value: number, rules: FieldRules): string | null {
  const show = (x: number) => (rules.angle ? `${formatShort(x / DEGREE)}°` : formatShort(x));
  if (!Number.isFinite(value)) return 'is not a finite number';
  if (rules.positive && value <= 0) return 'must be greater than 0';
  if (rules.min !== undefined && value < rules.min) return `must be at least ${show(rules.min)}`;
  if (rules.max !== undefined && value > rules.max) return `must be at most ${show(rules.max)}`;
  return null;
}

/** A tenth of the value's decade: 0.25 steps by 0.01, 9.81 by 0.1. */
export function naturalStep(reference: number): number {
  if (!Number.isFinite(reference) || reference === 0) return 0.1;
  return 10 ** (Math.floor(Math.log10(Math.abs(reference))) - 1);
}

/** `value` moved by `steps` of `step`, without binary dust. */
export function nudge(value: number, step: number, steps: number): number {
  return Number((value + step * steps).toPrecision(12));
}

/** The draft entry for a value that was stepped to, given in the unit of the field. */
export function storedFromShown(shown: number, rules: FieldRules): NumberOrExpression {
  if (!rules.angle) return shown;
  return rules.numeric ? shown * DEGREE : `${shown} deg`;
}

export const toShown = (si: number, angle: boolean): number => (angle ? si / DEGREE : si);
