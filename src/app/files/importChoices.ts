/** What a person chose for files of one shape: stored text is read like a stranger's, and is bounded. */
import type { ImportChoices } from '../../csv/plan.ts';

/** By `ImportPlan.shape`, the one chosen last at the end. */
export type RememberedChoices = Readonly<Record<string, ImportChoices>>;

/** Shapes that are remembered; the one that was chosen longest ago goes first. */
const MOST_SHAPES = 40;
const LONGEST_SHAPE = 2000;
/** Of a name of a column, and how many of them one shape may name. */
const LONGEST_TEXT = 200;
const MOST_NAMES = 300;

type Check = (value: unknown) => boolean;

const text: Check = (value) => typeof value === 'string' && value.length <= LONGEST_TEXT;
const oneOf =
  (...values: readonly unknown[]): Check =>
  (value) =>
    values.includes(value);
const orNull =
  (check: Check): Check =>
  (value) =>
    value === null || check(value);
const whole: Check = (value) => Number.isSafeInteger(value) && (value as number) >= 0;
const isRecord = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);
const table =
  (check: Check): Check =>
  (value) =>
    isRecord(value) &&
    Object.keys(value).length <= MOST_NAMES &&
    Object.entries(value).every(([name, entry]) => text(name) && name !== '__proto__' && check(entry));

const CHECKS: Readonly<Record<keyof ImportChoices, Check>> = {
  encoding: oneOf(
    'utf-8',
    'utf-16le',
    'utf-16be',
    'windows-1252',
    'windows-1250',
    'windows-1251',
    'shift_jis',
    'gb18030',
    'euc-kr',
  ),
  separator: oneOf(',', ';', '\t', '|', 'blanks'),
  decimal: oneOf('.', ','),
  headerLine: whole,
  system: orNull(text),
  map: table(orNull(text)),
  units: table(text),
  angles: oneOf('rad', 'deg'),
  lengths: oneOf('m', 'cm', 'mm'),
  time: orNull(text),
  timeUnit: text,
  dateOrder: oneOf('day first', 'month first'),
  step: (value) => typeof value === 'number' && value > 0 && Number.isFinite(value),
  run: (value) => whole(value) && value !== 0,
  body: text,
  scalar: oneOf('first', 'last'),
  up: oneOf('y', 'z'),
  rates: oneOf('none', 'savitzky-golay'),
};

/** What of it are choices; the rest is left out. */
export function choicesFrom(value: unknown): ImportChoices {
  if (!isRecord(value)) return {};
  return Object.fromEntries(
    Object.entries(CHECKS).flatMap(([name, check]) =>
      Object.hasOwn(value, name) && check(value[name]) ? [[name, value[name]]] : [],
    ),
  ) as ImportChoices;
}

/** Null where nothing is. */
export function rememberedFrom(value: unknown): RememberedChoices | null | undefined {
  if (value === null) return null;
  if (!isRecord(value)) return undefined;
  const entries = Object.entries(value)
    .filter(([shape]) => shape.length <= LONGEST_SHAPE && shape !== '__proto__')
    .map(([shape, choices]) => [shape, choicesFrom(choices)] as const)
    .filter(([, choices]) => Object.keys(choices).length > 0);
  return entries.length > 0 ? Object.fromEntries(entries.slice(-MOST_SHAPES)) : undefined;
}
