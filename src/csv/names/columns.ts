import type { ColumnPlan, ImportChoices } from '../plan.ts';
import type { Property } from '../layout/preamble.ts';
import type { Source } from '../source.ts';
import { factorOf, isUnit, kindOf, RIGHT_UNITS, type Kind } from '../units/units.ts';
import { shortened, splitTitle, unitBehind } from '../units/titles.ts';
import { defaultUnit } from '../units/defaults.ts';
import type { Attitude } from './attitude.ts';
import type { Candidate } from './systems.ts';

export interface ColumnsFinding {
  columns: ColumnPlan[];
  notes: string[];
  /** Columns named twice. */
  repeated: { title: string; message: string }[];
}

export interface Given {
  choices: ImportChoices;
  properties: readonly Property[];
  up: 'y' | 'z';
}

/** Axes of a file whose Y points up, as the contract's: (x, y, z) = (X, -Z, Y). */
export function turnedName(name: string): { name: string; sign: number } {
  const match = /^(.*?[\s._/:-]|[a-z]*)([xyz])$/i.exec(name);
  if (!match || match[2]!.toLowerCase() === 'x') return { name, sign: 1 };
  return match[2]!.toLowerCase() === 'y' ? { name: `${match[1]}z`, sign: 1 } : { name: `${match[1]}y`, sign: -1 };
}

/** What each column of a system's file is; a text says which unit is wrong. */
export function columnsOf(
  sources: readonly Source[],
  { hits }: Candidate,
  attitude: Attitude | null,
  timed: ReadonlySet<number>,
  given: Given,
): ColumnsFinding | string {
  const finding: ColumnsFinding = { columns: [], notes: [], repeated: [] };
  const best = new Map<string, number>();
  for (const [i, hit] of hits.entries()) {
    if (!hit || timed.has(i)) continue;
    const other = best.get(hit.word.name);
    if (other === undefined || hit.rank < hits[other]!.rank) best.set(hit.word.name, i);
  }
  const titles = new Map<string, number>();
  for (const { title } of sources) titles.set(title, (titles.get(title) ?? 0) + 1);
  const ignored: string[] = [];
  const converted: string[] = [];
  const renamed: string[] = [];
  for (const source of sources) {
    const { index } = source;
    // `X` of one body and of the other: by their full names.
    const title = (titles.get(source.title)! > 1 ? '' : shortened(source.title)) || shortened(source.name);
    const part = attitude ? attitude.columns.indexOf(index) : -1;
    const hit = hits[index];
    const plain: ColumnPlan = { ...blank(source), title };
    if (timed.has(index)) finding.columns.push({ ...plain, name: 't', kind: 'time', role: 'time' });
    else if (part >= 0) {
      const turn = given.up === 'y' ? turnedName('xyzw'[part]!) : { name: 'xyzw'[part]!, sign: 1 };
      finding.columns.push({ ...plain, ...attitudePart(source, turn, attitude!, given), role: 'attitude' });
    } else if (!hit || best.get(hit.word.name) !== index) {
      finding.columns.push(plain);
      if (hit && source.title !== '')
        finding.repeated.push({
          title,
          message: `column ${index + 1} is "${hit.word.name}" again; the ${best.get(hit.word.name)! < index ? 'first one' : `one called "${shortened(sources[best.get(hit.word.name)!]!.title)}"`} is used`,
        });
      else if (source.title !== '') ignored.push(title);
    } else {
      const { word } = hit;
      const { unit, from } = unitOf(source, hit.unit, word.name, word.kind, given);
      const factor = factorOf(unit, word.kind);
      if (factor === undefined) {
        if (word.needed)
          return `column ${index + 1}, "${title}": the unit "${unit}" is not understood for ${word.name}; right would be ${RIGHT_UNITS[word.kind]}`;
        ignored.push(`${title} (unit not understood)`);
        finding.columns.push(plain);
        continue;
      }
      const sign = given.up === 'y' ? turnedName(source.plain).sign : 1;
      if (factor !== 1) converted.push(title);
      if (hit.rank >= 2 || hit.rank < 0) renamed.push(`${source.name} → ${word.name}`);
      finding.columns.push({
        ...plain,
        name: word.name,
        unit,
        unitFrom: from,
        factor: sign * factor,
        kind: word.kind,
        role: word.kind.endsWith('rate') ? 'rate' : word.needed ? 'coordinate' : 'other',
      });
    }
  }
  if (renamed.length > 0) finding.notes.push(`read as: ${listed(renamed)}`);
  if (converted.length > 0) finding.notes.push(`converted to SI and radians: ${listed(converted)}`);
  if (ignored.length > 0) finding.notes.push(`columns not used: ${listed(ignored)}`);
  return finding;
}

/** Of a quaternion a number, of Euler angles an angle, in degrees where nothing says otherwise. */
function attitudePart(
  source: Source,
  turn: { name: string; sign: number },
  { euler }: Attitude,
  given: Given,
): Pick<ColumnPlan, 'name' | 'unit' | 'unitFrom' | 'factor' | 'kind'> {
  if (!euler) return { name: `q${turn.name}`, unit: '', unitFrom: 'none', factor: turn.sign, kind: 'plain' };
  const { unit, from } = unitOf(source, source.unit, source.name, 'angle', given);
  const known = unit === '' ? 'deg' : unit;
  return {
    name: `r${turn.name}`,
    unit: known,
    unitFrom: from,
    factor: turn.sign * (factorOf(known, 'angle') ?? Math.PI / 180),
    kind: 'angle',
  };
}

/** Columns of data: all that hold a number, by their own names, in SI where their unit is known. */
export function dataColumns(
  sources: readonly Source[],
  numeric: (index: number) => boolean,
  timed: ReadonlySet<number>,
  given: Given,
): ColumnsFinding {
  const ignored: string[] = [];
  const taken = new Set(['t']);
  const columns = sources.map((source): ColumnPlan => {
    if (timed.has(source.index)) return { ...blank(source), name: 't', kind: 'time', role: 'time' };
    if (!numeric(source.index)) {
      if (source.title !== '') ignored.push(shortened(source.title));
      return blank(source);
    }
    const behind = source.unit === '' ? unitBehind(source.name) : null;
    const chosen = given.choices.units?.[source.name];
    const unit =
      chosen ?? (source.unit || source.rowUnit || (behind && /[/:,\s]/.test(source.name) ? behind.unit : ''));
    const kind = kindOf(unit) ?? 'plain';
    // `V(out)`: what stands in brackets is no unit, and tells columns apart.
    const whole = source.unit !== '' && unit === source.unit && !isUnit(unit);
    let name = whole ? source.title : behind && unit === behind.unit ? behind.name : source.name;
    if (taken.has(name)) name = `${name} (${source.index + 1})`;
    taken.add(name);
    const unitFrom =
      chosen !== undefined ? 'choice' : unit === '' ? 'none' : unit === source.rowUnit ? 'units row' : 'title';
    return {
      ...blank(source),
      name,
      unit,
      unitFrom,
      kind: unit === '' ? 'plain' : kind,
      factor: unit === '' ? 1 : (factorOf(unit, kind) ?? 1),
      role: 'data',
    };
  });
  return { columns, notes: ignored.length > 0 ? [`columns not used: ${listed(ignored)}`] : [], repeated: [] };
}

function blank(source: Source): ColumnPlan {
  return {
    index: source.index,
    source: source.name,
    title: source.title,
    name: null,
    unit: source.unit || source.rowUnit,
    unitFrom: source.unit ? 'title' : source.rowUnit ? 'units row' : 'none',
    factor: 1,
    kind: 'plain',
    role: 'unused',
  };
}

function unitOf(
  source: Source,
  inTitle: string,
  name: string,
  kind: Kind,
  { choices, properties }: Given,
): { unit: string; from: ColumnPlan['unitFrom'] } {
  const chosen =
    choices.units?.[name] ?? choices.units?.[source.name] ?? choices.units?.[splitTitle(source.title).name];
  if (chosen !== undefined) return { unit: chosen, from: 'choice' };
  if (inTitle !== '') return { unit: inTitle, from: 'title' };
  if (source.rowUnit !== '') return { unit: source.rowUnit, from: 'units row' };
  const above = defaultUnit(properties, kind);
  if (above !== '') return { unit: above, from: 'lines above' };
  const { angles = '', lengths = '' } = choices;
  const base = kind.startsWith('angle') ? angles : kind.startsWith('length') ? lengths : '';
  return base === ''
    ? { unit: '', from: 'none' }
    : { unit: kind.endsWith('rate') ? `${base}/s` : base, from: 'choice' };
}

function listed(names: readonly string[]): string {
  return `${names.slice(0, 24).join(', ')}${names.length > 24 ? ` and ${names.length - 24} more` : ''}`;
}
