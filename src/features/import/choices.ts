/** What the person's presses mean as choices for the reading. */
import type { SystemMeta } from '../../core/model/system.ts';
import type { ColumnPlan, ImportChoices, ImportPlan } from '../../csv/plan.ts';
import { words } from './words.ts';

/** Where a column can go; '' is nowhere. */
export interface Target {
  id: string;
  label: string;
}

const NOWHERE: Target = { id: '', label: words.unused };
const TIME: Target = { id: 't', label: words.timeName };

/** The system's coordinates and their rates, the time, and what the column is called already. */
export function targetsOf({ name }: ColumnPlan, meta: SystemMeta | null): Target[] {
  const own = name === null ? [] : [{ id: name, label: meta ? name : words.asIs }];
  if (!meta) return distinct([NOWHERE, TIME, ...own]);
  const coordinates = meta.coordinates.map(({ name: id, label }) => ({ id, label: `${id}: ${label}` }));
  const rates = meta.order === 1 ? [] : coordinates.map(({ id }) => ({ id: `${id}_dot`, label: `${id}_dot` }));
  return distinct([NOWHERE, TIME, ...coordinates, ...rates, ...own]);
}

const distinct = (targets: readonly Target[]): Target[] =>
  targets.filter(({ id }, i) => targets.findIndex((t) => t.id === id) === i);

/** A column goes elsewhere: what it was before is then in no column. */
export function sentTo({ source, name }: ColumnPlan, target: string): ImportChoices {
  const left = name === null || name === target || name === 't' ? {} : { [name]: null };
  if (target === 't') return { time: source, ...(Object.keys(left).length > 0 ? { map: left } : {}) };
  return {
    ...(name === 't' ? { time: null } : {}),
    map: { ...left, ...(target === '' ? {} : { [target]: source }) },
  };
}

const UNITS: Readonly<Record<ColumnPlan['kind'], readonly string[]>> = {
  time: ['s', 'ms', 'us', 'ns', 'min', 'h'],
  length: ['m', 'cm', 'mm', 'km', 'in', 'ft'],
  angle: ['rad', 'deg', 'rev'],
  'length rate': ['m/s', 'cm/s', 'mm/s', 'km/h'],
  'angle rate': ['rad/s', 'deg/s', 'rpm'],
  plain: [],
};
/** Of data that says nothing of itself. */
const ANY = ['rad', 'deg', 'rad/s', 'deg/s', 'm', 'cm', 'mm', 'm/s'];

/** Units that a column can be given; the one it has is among them. */
export function unitsFor({ kind, unit, role }: ColumnPlan): Target[] {
  const list = kind === 'plain' ? (role === 'data' ? ANY : []) : UNITS[kind];
  const shown = (id: string): Target => ({
    id,
    label: id === '' ? words.noUnit : id.replace('us', 'µs').replace('deg', '°'),
  });
  // In one order whatever is chosen: arrow keys walk through it.
  return (list.includes(unit) ? [...list] : [unit, ...list]).map(shown);
}

/** Coordinates of the system that no column gives. */
export function missingOf({ columns, system }: ImportPlan, meta: SystemMeta | null): string[] {
  if (system === null || !meta || columns.some(({ role }) => role === 'attitude')) return [];
  const given = new Set(columns.map(({ name }) => name));
  return meta.coordinates.map(({ name }) => name).filter((name) => !given.has(name));
}

/**
 * The plan as choices will have it that are not read yet, or can't be: a system is chosen, and columns are still without
 * a place. What is pressed next starts from it.
 * @param meta of the system chosen; null for data
 */
export function drafted(plan: ImportPlan, choices: ImportChoices, meta: SystemMeta | null): ImportPlan {
  const system = meta?.id ?? null;
  const entries = Object.entries(choices.map ?? {});
  const places = new Map(entries.map(([name, source]) => [source, name]));
  const left = new Set(entries.map(([name]) => name));
  const known = new Set(['t', ...(meta?.coordinates ?? []).flatMap(({ name }) => [name, `${name}_dot`])]);
  const stays = (name: string): boolean => !left.has(name) && (system === plan.system || known.has(name));
  const columns = plan.columns.map((column): ColumnPlan => {
    const { source, role } = column;
    const own = column.name !== null && stays(column.name) ? column.name : null;
    const name = choices.time === source ? 't' : (places.get(source) ?? own);
    return {
      ...column,
      name,
      unit: choices.units?.[source] ?? (role === 'time' ? choices.timeUnit : undefined) ?? column.unit,
      ...(name === null || role !== 'unused' ? {} : { role: 'coordinate' }),
    };
  });
  const { encoding, separator, decimal, body, run, up, rates } = { ...plan, ...choices };
  return { ...plan, encoding, separator, decimal, body, run, up, rates, system, columns };
}

/** Whether some column of this kind has no unit of its own, so that one for all of them says something. */
export const unitless = ({ columns }: ImportPlan, kind: 'angle' | 'length'): boolean =>
  columns.some((c) => (c.kind === kind || c.kind === `${kind} rate`) && c.name !== null && c.unitFrom === 'none');
