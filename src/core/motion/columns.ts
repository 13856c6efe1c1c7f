/** The catalogue: what every column of a motion is called and measured in, recorded or computed, the same everywhere. */
import { inputsOf } from '../model/inputs.ts';
import { perSecond } from '../model/units.ts';
import type { ColourRole, DataColumn, SystemMeta, SystemView } from '../model/system.ts';
import { joined, symbolText, words, type Text } from './symbols.ts';

export type ColumnKind = 'time' | 'length' | 'angle' | 'rate' | 'force' | 'energy' | 'power' | 'ratio';
export type ColumnGroup = 'coordinates' | 'rates' | 'inputs' | 'forces' | 'energy' | 'computed' | 'bodies' | 'other';

export interface Column {
  /** Permanent id, as in files, links and APIs. */
  name: string;
  /** `α_fp`; of a rate, that of its coordinate. */
  symbol: string;
  /** A dot stands above the symbol. */
  rate: boolean;
  label: string;
  /** SI, as recorded. */
  unit: string;
  kind: ColumnKind;
  /** Radians or radians per second: shown in degrees by choice. */
  degrees: boolean;
  /** A position angle: values that differ by whole turns mean the same. */
  turns: boolean;
  /** Its colour; null where it belongs to nothing. */
  role: ColourRole | null;
  group: ColumnGroup;
}

type Facts = Pick<Column, 'name' | 'symbol' | 'label' | 'kind' | 'group'> & Partial<Column>;

const column = (facts: Facts): Column => ({
  rate: false,
  unit: '',
  degrees: false,
  turns: false,
  role: null,
  ...facts,
});

/** A length or an angle and its rate; `sums` of coordinates are columns like these. */
function pair(
  name: string,
  symbol: string,
  label: string,
  angle: boolean,
  role: ColourRole,
  { group, pure = false }: { group?: ColumnGroup; pure?: boolean | undefined } = {},
): Column[] {
  const unit = angle ? 'rad' : pure ? '' : 'm';
  const common = { symbol, degrees: angle, role };
  return [
    column({
      ...common,
      name,
      label,
      unit,
      kind: angle ? 'angle' : pure ? 'ratio' : 'length',
      turns: angle,
      group: group ?? 'coordinates',
    }),
    column({
      ...common,
      name: `${name}_dot`,
      label: `rate of ${label}`,
      unit: perSecond(unit),
      kind: 'rate',
      rate: true,
      group: group ?? 'rates',
    }),
  ];
}

/** Coordinates of a place on the ground: those called x and y, whatever their case. */
export function groundCoordinates({ coordinates }: Pick<SystemMeta, 'coordinates'>): string[] {
  return coordinates.filter(({ name, kind }) => kind === 'length' && /^[xy]$/i.test(name)).map(({ name }) => name);
}

/** Everything that the catalogue knows of a system, by name. */
function catalogueOf(meta: SystemMeta, contacts: SystemView['contacts']): Map<string, Column> {
  const energy = (name: string, symbol: string, label: string): Column =>
    column({ name, symbol, label, unit: 'J', kind: 'energy', group: 'energy' });
  const all = [
    column({ name: 't', symbol: 't', label: 'time', unit: 's', kind: 'time', group: 'other' }),
    ...meta.coordinates.flatMap((c) => pair(c.name, c.symbol, c.label, c.kind === 'angle', c.role, { pure: c.pure })),
    ...(meta.sums ?? []).flatMap((s) => pair(s.name, s.symbol, s.label, true, s.role, { group: 'computed' })),
    ...inputsOf(meta).map((i) => column({ ...i, kind: 'force', role: roleOfInput(meta, i.column), group: 'inputs' })),
    ...(meta.columns ?? []).map(dataColumn),
    ...contacts.flatMap((c) => [
      multiplier(c.lateral, `${c.label}, lateral force`, c.role),
      multiplier(c.vertical, `${c.label}, vertical force`, c.role),
    ]),
    energy('energy', 'E', 'energy'),
    energy('kinetic', 'T', 'kinetic energy'),
    energy('potential', 'V', 'potential energy'),
    energy('work', 'W', 'work of the inputs so far'),
    column({ name: 'power', symbol: 'P', label: 'power of the inputs', unit: 'W', kind: 'power', group: 'energy' }),
    column({
      name: 'power.gross',
      symbol: 'P_gross',
      label: 'power of the inputs, what they take out counted too',
      unit: 'W',
      kind: 'power',
      group: 'energy',
    }),
    column({ name: 'residual', symbol: 'residual', label: 'constraint residual', kind: 'ratio', group: 'other' }),
    column({
      name: 'speed',
      symbol: 'v',
      label: 'speed over the ground',
      unit: 'm/s',
      kind: 'rate',
      group: 'computed',
    }),
    column({
      name: 'path',
      symbol: 's',
      label: 'length of the path so far',
      unit: 'm',
      kind: 'length',
      group: 'computed',
    }),
    ...meta.bodies.flatMap((b) =>
      ['x', 'y', 'z'].map((axis) =>
        column({
          name: `${b.id}.${axis}`,
          symbol: `${axis}_${b.label}`,
          label: `${b.label}, ${axis}`,
          unit: 'm',
          kind: 'length',
          role: b.role,
          group: 'bodies',
        }),
      ),
    ),
  ];
  // A coordinate's own name wins over what is computed.
  return new Map(all.reverse().map((c) => [c.name, c]));
}

/** A file's own column; turns and degrees by its unit. */
function dataColumn({ name, label, unit }: DataColumn): Column {
  const angle = unit === 'rad';
  const degrees = angle || unit === 'rad/s';
  const kind: ColumnKind = angle ? 'angle' : unit === 'm' ? 'length' : /\/s$/.test(unit) ? 'rate' : 'ratio';
  return column({ name, symbol: name, label, unit, kind, degrees, turns: angle, group: 'other' });
}

const multiplier = (index: number, label: string, role: ColourRole | null): Column =>
  column({
    name: `lambda_${index + 1}`,
    symbol: `λ_${index + 1}`,
    label,
    unit: 'N',
    kind: 'force',
    role,
    group: 'forces',
  });

/** The colour of what an input works on, where that is one. */
function roleOfInput({ coordinates }: SystemMeta, entries: Readonly<Record<string, number>>): ColourRole | null {
  const roles = new Set(Object.keys(entries).map((name) => coordinates.find((c) => c.name === name)?.role));
  roles.delete('neutral');
  const [only] = roles;
  return roles.size === 1 ? (only ?? null) : null;
}

/** Made once a system, with and without its contacts. */
const catalogues = new WeakMap<SystemMeta, Map<number, Map<string, Column>>>();

function known(meta: SystemMeta, contacts: SystemView['contacts']): Map<string, Column> {
  let made = catalogues.get(meta);
  if (!made) catalogues.set(meta, (made = new Map()));
  let found = made.get(contacts.length);
  if (!found) made.set(contacts.length, (found = catalogueOf(meta, contacts)));
  return found;
}

/**
 * A column by its name; one that the system does not know is shown as it is recorded.
 *
 * @param meta of the system
 * @param name as recorded
 * @param contacts of the system, whose forces are named after them
 */
export function columnOf(meta: SystemMeta, name: string, contacts: SystemView['contacts'] = []): Column {
  const found = known(meta, contacts).get(name);
  if (found) return found;
  const lambda = /^lambda_(\d+)$/.exec(name);
  if (lambda) return multiplier(Number(lambda[1]) - 1, `multiplier ${lambda[1]}`, null);
  return column({ name, symbol: name, label: name, kind: 'ratio', group: 'other' });
}

/**
 * Sums of coordinates, own rolls, and their rates, where what they are sums of is there.
 *
 * @param meta of the system
 * @param has whether a column is there
 */
export function sumsOf(meta: SystemMeta, has: (name: string) => boolean): string[] {
  return (meta.sums ?? []).flatMap(({ name, of }) =>
    ['', '_dot'].flatMap((rate) => (of.every((c) => has(c + rate)) ? [name + rate] : [])),
  );
}

/**
 * Every column of a motion: the recorded ones, then those that can be computed of them.
 *
 * @param view of the system
 * @param recorded names of the recorded columns
 * @param constraints whether constraints acted: their columns are offered
 */
export function columnsOf(view: SystemView, recorded: readonly string[], constraints = true): Column[] {
  const { meta } = view;
  const contacts = constraints ? view.contacts : [];
  const has = (name: string): boolean => recorded.includes(name);
  const ground = groundCoordinates(meta);
  const list = recorded.map((name) => columnOf(meta, name, contacts));
  const computed = [
    ...sumsOf(meta, has),
    ...(ground.length > 0 && ground.every(has) ? ['path'] : []),
    ...(ground.length > 0 && ground.every((c) => has(`${c}_dot`)) ? ['speed'] : []),
    ...(meta.inputs.length > 0 && meta.inputs.every((i) => has(i.name)) ? ['power', 'work'] : []),
    ...(meta.coordinates.every((c) => has(c.name))
      ? meta.bodies.flatMap((b) => ['x', 'y', 'z'].map((axis) => `${b.id}.${axis}`))
      : []),
  ].filter((name) => !has(name));
  return [...list, ...computed.map((name) => columnOf(meta, name, contacts))];
}

const DEGREE = Math.PI / 180;

/** The unit in which it is shown. */
export const shownUnit = ({ unit, degrees }: Column, inDegrees: boolean): string =>
  degrees && inDegrees ? unit.replace('rad', '°') : unit;

/** From the recorded unit to the one shown. */
export const shownFactor = ({ degrees }: Column, inDegrees: boolean): number => (degrees && inDegrees ? 1 / DEGREE : 1);

/** The unit that all of these have, or those they have. */
export const unitsOf = (columns: readonly Column[], inDegrees: boolean): string =>
  [...new Set(columns.map((c) => shownUnit(c, inDegrees)))].filter(Boolean).join(', ');

/** The symbol, typeset. */
export const symbolOf = ({ symbol, rate }: Column): Text => symbolText(symbol, rate);

/**
 * What stands at an axis: symbols while they are few, and their unit.
 *
 * @param columns on this axis
 * @param inDegrees angles are shown in degrees
 * @param most symbols that are named; more are counted
 */
export function axisText(columns: readonly Column[], inDegrees: boolean, most = 4): Text {
  const unit = unitsOf(columns, inDegrees);
  const symbols = columns.length <= most ? joined(columns.map(symbolOf)) : [];
  return unit === '' ? symbols : joined([symbols, words(unit)].filter((text) => text.length > 0));
}

/** A column in plain words with its unit, for those who hear it. */
export const spoken = (of: Column, inDegrees: boolean): string => {
  const unit = shownUnit(of, inDegrees);
  return unit === '' ? of.label : `${of.label}, ${unit}`;
};
