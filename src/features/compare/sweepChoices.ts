import type { App } from '../../app/app.ts';
import { systemMetas } from '../../app/store.ts';
import { otherMethods, reportMethods } from '../../core/cases/methodSets.ts';
import { columnOf, shownFactor, shownUnit, sumsOf, symbolOf } from '../../core/motion/columns.ts';
import { placeSymbol } from '../../core/motion/placeSymbol.ts';
import { plainText as plainSymbol, words as plain, type Text } from '../../core/motion/symbols.ts';
import type { SweepAxis, SweepValue } from '../../core/scenario/sweepAxes.ts';
import { spaced, sweepPaths, type SweepPath } from '../../core/scenario/sweepPaths.ts';
import type { SweepMeasure } from '../../core/motion/sweepMeasures.ts';
import { checkScenario } from '../../core/scenario/schema.ts';
import type { ScenarioFile } from '../../core/scenario/types.ts';
import type { SystemMeta } from '../../core/model/system.ts';
import { words } from './words.ts';
import { formatScientific, formatShort, plainText } from '../../ui/kit/format.ts';

const own = words.sweep;
const DEGREE = Math.PI / 180;

/** What is typed for one axis; numbers in the unit shown. */
export interface AxisForm {
  /** A path, `method`, or empty for none. */
  path: string;
  from: string;
  to: string;
  count: string;
  scale: 'linear' | 'logarithmic';
  /** Ids of methods. */
  methods: readonly string[];
}

export const allMethods = [...reportMethods, ...otherMethods];
const FIRST_METHODS = ['qr', 'collocation', 'ida', 'blt', 'dopri5', 'dop853'];

/** What may be varied of a scenario; null when it cannot run. */
export function pathsOf(meta: SystemMeta, file: ScenarioFile): SweepPath[] | null {
  try {
    return sweepPaths(meta, file, checkScenario(file, systemMetas));
  } catch {
    return null;
  }
}

/** A range about what the number is now. */
export function offeredAxis(subject: SweepPath | undefined, path: string, count: number): AxisForm {
  const form = (from: number, to: number, scale: AxisForm['scale'] = 'linear'): AxisForm => ({
    path,
    from: formatShort(from, 4),
    to: formatShort(to, 4),
    count: String(count),
    scale,
    methods: FIRST_METHODS,
  });
  if (!subject) return form(0, 1);
  if (/tol$/.test(path)) return form(1e-10, 1e-4, 'logarithmic');
  const now = subject.angle ? subject.present / DEGREE : subject.present;
  if (now === 0) return subject.angle ? form(-10, 10) : form(0, 1);
  if (/^control\.[QR]\.|tep$/i.test(path)) return form(now / 10, now * 10, 'logarithmic');
  return now > 0 ? form(now / 2, now * 1.5) : form(now * 1.5, now / 2);
}

/** Two axes as they were stored, or null for anything else. */
export function formsFrom(value: unknown): readonly [AxisForm, AxisForm] | null {
  const isForm = (form: Partial<AxisForm> | null): boolean =>
    typeof form === 'object' &&
    form !== null &&
    [form.path, form.from, form.to, form.count].every((text) => typeof text === 'string') &&
    (form.scale === 'linear' || form.scale === 'logarithmic') &&
    Array.isArray(form.methods);
  return Array.isArray(value) && value.length === 2 && value.every(isForm) ? (value as [AxisForm, AxisForm]) : null;
}

/** @throws Error with words for the form */
export function axisOf(form: AxisForm, paths: readonly SweepPath[]): SweepAxis {
  if (form.path === 'method') {
    const chosen = allMethods.filter((m) => form.methods.includes(m.id));
    return {
      path: 'method',
      label: own.methods,
      unit: '',
      angle: false,
      values: chosen.map(({ label, method }, value) => ({ value, label, method })),
    };
  }
  const subject = paths.find((p) => p.path === form.path)!;
  const number = (text: string, what: string): number => {
    const value = Number(plainText(text));
    if (text.trim() === '' || !Number.isFinite(value)) throw new Error(own.needsNumber(what));
    return value;
  };
  const shown = spaced(number(form.from, own.from), number(form.to, own.to), number(form.count, own.count), form.scale);
  return {
    path: form.path,
    label: nameOf(form.path),
    unit: subject.unit,
    angle: subject.angle,
    values: shown.map((x) => ({ value: subject.angle ? x * DEGREE : x, label: formatShort(x, 6) })),
  };
}

/** What is varied as it is read: typeset, in words, and its values in the unit shown. */
export interface AxisInfo {
  symbol: Text;
  /** With its unit, as it stands at an axis or over a column. */
  title: Text;
  label: string;
  unit: string;
  number(value: SweepValue): number;
  text(value: SweepValue): string;
  /** As short as still tells its values apart. */
  tick(value: SweepValue): string;
}

export function axisInfo(axis: SweepAxis, meta: SystemMeta, degrees: boolean): AxisInfo {
  const unit = axis.angle && !degrees ? axis.unit.replace('°', 'rad') : axis.unit;
  const factor = axis.angle && degrees ? 1 / DEGREE : 1;
  const symbol = placeSymbol(axis.path, axis.label, meta);
  const written =
    (digits: number | undefined) =>
    ({ value, label, method }: SweepValue): string =>
      method ? label : formatShort(value * factor, digits);
  const apart = (digits: number): boolean => new Set(axis.values.map(written(digits))).size === axis.values.length;
  return {
    symbol,
    title: unit === '' ? symbol : [...symbol, ...plain(`, ${unit}`)],
    label: unit === '' ? plainSymbol(symbol) : `${plainSymbol(symbol)}, ${unit}`,
    unit,
    number: ({ value }) => value * factor,
    text: written(6),
    tick: written([3, 4, 6].find(apart)),
  };
}

/** `parameters.casterTrail` as one reads it. */
export const nameOf = (path: string): string => path.split('+')[0]!.replace(/^(parameters|initial|method)\./, '');

/** Columns of which a value may be kept: states, energy and residual, and what the run on the stage has besides. */
export function measurableColumns(app: App, meta: SystemMeta): string[] {
  const states = meta.coordinates.map((c) => c.name);
  const motion = app.state.motion.value;
  const more =
    motion?.system.meta.id === meta.id && motion.source === 'run'
      ? motion.trajectory.columns.filter((c) => c !== 't')
      : [];
  return [
    ...new Set([
      ...states,
      ...states.map((s) => `${s}_dot`),
      'energy',
      'residual',
      ...more,
      ...sumsOf(meta, () => true),
    ]),
  ];
}

/** A measure in words and as its column is typeset, its unit, and the factor to what is shown. */
export interface MeasureInfo {
  id: string;
  label: string;
  title: Text;
  unit: string;
  factor: number;
}

export function measureInfo(measure: SweepMeasure, meta: SystemMeta, degrees: boolean): MeasureInfo {
  const kind = own.kinds[measure.kind];
  if ('column' in measure) {
    const of = columnOf(meta, measure.column);
    return {
      id: `${measure.kind}-${measure.column}`,
      label: `${kind} ${of.label}`,
      title: [...plain(`${kind} `), ...symbolOf(of)],
      unit: shownUnit(of, degrees),
      factor: shownFactor(of, degrees),
    };
  }
  return { id: measure.kind, label: kind, title: plain(kind), unit: own.units[measure.kind], factor: 1 };
}

/** With its unit, as it stands at an axis or over a column. */
export const titleOf = ({ title, unit }: MeasureInfo): Text =>
  unit === '' ? title : [...title, ...plain(`, ${unit}`)];

export const measureText = (x: number): string =>
  Number.isNaN(x)
    ? '–'
    : x !== 0 && (Math.abs(x) < 1e-3 || Math.abs(x) >= 1e6)
      ? formatScientific(x, 3)
      : formatShort(x, 5);
