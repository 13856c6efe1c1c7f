import type { SystemMeta } from '../core/model/system.ts';
import { sniff } from './containers/sniff.ts';
import { encodingOf } from './encoding/encoding.ts';
import { formOf } from './layout/cells.ts';
import { layoutOf, type Layout } from './layout/layout.ts';
import { longOf } from './layout/long.ts';
import { valueOf } from './layout/preamble.ts';
import { columnsOf, dataColumns, turnedName, type ColumnsFinding } from './names/columns.ts';
import { quaternionsIn } from './names/quaternion.ts';
import { candidate, fitSystem, type Candidate } from './names/systems.ts';
import { attitudeOf, namesColumns, type Systems } from './names/vocabulary.ts';
import type { Encoding, ImportChoices, ImportPlan, Question, Understanding } from './plan.ts';
import { readNumber } from './reading/numbers.ts';
import { isMeant, lookedUp, sourcesOf, type Source } from './source.ts';
import { timeOf, type TimeFinding } from './time/timePlan.ts';
import { doubtsOf } from './units/doubts.ts';

export interface UnderstandOptions {
  systems: Systems;
  choices?: ImportChoices;
  /** Whether what names no system's coordinates is data; otherwise it is refused. */
  data?: boolean;
  /** System of a scenario that stands in the file's comments. */
  preferred?: string | null;
}

/** Of a file without a header and any name of a column. */
const NO_HEADER = 'there is no header row, and';
/** A group of rotations has an x too, which is no position. */
const NOT_MEANT = /(?:^|\.)rotation\.[xyz]$/i;
const MOST_PREVIEW = 20;
/** Bytes by which a file is understood. */
export const ENOUGH_TO_DECIDE = 65536;

/**
 * Understands a file from its first bytes (`ENOUGH_TO_DECIDE` are enough; unpacked, where they were gzip's). Never
 * throws for bad input.
 */
export function understand(start: Uint8Array, options: UnderstandOptions): Understanding {
  const container = sniff(start);
  if (container.kind === 'refused') return { kind: 'refused', line: 0, message: container.message };
  const encoding = options.choices?.encoding ?? encodingOf(start);
  const text = new TextDecoder(encoding).decode(start.subarray(0, 4 * ENOUGH_TO_DECIDE));
  const whole = start.length < ENOUGH_TO_DECIDE ? text : text.slice(0, text.lastIndexOf('\n') + 1 || text.length);
  return understandText(whole.replace(/\r\n?/g, '\n'), encoding, options);
}

interface Work {
  layout: Layout;
  choices: ImportChoices;
  options: UnderstandOptions;
  up: 'y' | 'z';
}

interface Meaning {
  system: string | null;
  long: ImportPlan['long'];
  finding: ColumnsFinding;
  timing: TimeFinding;
  width: number;
  notes: string[];
}

/** @param text whole lines, each ended by LF, without a byte order mark */
export function understandText(text: string, encoding: Encoding, options: UnderstandOptions): Understanding {
  const choices = options.choices ?? {};
  const layout = layoutOf(text.replace(/^\ufeff/, ''), choices, (cells) => namesColumns(cells, options.systems));
  if (!layout) return { kind: 'refused', line: 0, message: 'there are no rows of numbers' };
  const line = layout.headerLines[0] ?? layout.firstRow;
  const motive =
    valueOf(layout.properties, /^Format Version$/i) !== null && valueOf(layout.properties, /^Take Name$/i) !== null;
  const up = choices.up ?? (motive ? 'y' : 'z');
  const meaning = meaningOf({ layout, choices, options, up });
  if (typeof meaning === 'string') return { kind: 'refused', line, message: meaning };
  const { finding, timing, system, long } = meaning;
  const notes = [...layoutNotes(layout), ...meaning.notes, ...finding.notes, ...timing.notes];
  if (motive && system !== null)
    notes.push(
      `Motive's axes${up === 'y' ? ' (Y up) are turned so that Z is up: x = X, y = -Z, z = Y' : ' are taken as they are, Z up'}`,
    );
  const plan: ImportPlan = {
    encoding,
    separator: layout.separator,
    decimal: layout.decimal,
    headerLines: layout.headerLines,
    unitsLine: layout.unitsLine,
    firstRow: layout.firstRow,
    width: meaning.width,
    comments: layout.comments,
    properties: layout.properties,
    system,
    columns: finding.columns,
    time: timing.time,
    long,
    up,
    rates: choices.rates ?? 'none',
    questions: [],
    notes,
    repeated: finding.repeated,
    preview: layout.rows.slice(0, MOST_PREVIEW).map((row) => row.slice(0, 200)),
    shape: shapeOf(layout),
  };
  return {
    kind: 'plan',
    plan: { ...plan, questions: [...timing.questions, ...questionsOf(plan, layout, Boolean(options.preferred))] },
  };
}

function meaningOf(work: Work): Meaning | string {
  const { layout, choices } = work;
  const sources = sourcesOf(layout);
  const timing = timeOf(layout, sources, choices);
  if (typeof timing === 'string') return timing;
  if (!layout.titles && layout.headerLines.length === 0) {
    const bare = headerless(work, sources);
    if (bare) return typeof bare === 'string' ? bare : { ...bare, timing: bare.timing ?? timing };
  }
  const own = meaningWith(work, sources, timing, null);
  if (typeof own !== 'string' && own.system !== null) return own;
  const long = longOf(layout, sources, timing.time.columns[0]);
  if (!long) return own;
  const names = [
    sources[long.time]!,
    ...long.names.map((name): Source => ({ index: 0, title: name, name, unit: '', rowUnit: '' })),
  ].map((s, index) => ({ ...s, index }));
  const pivoted = meaningWith(work, names, { ...timing, time: { ...timing.time, columns: [0] } }, long);
  if (typeof pivoted === 'string') return own;
  pivoted.notes.unshift(`one value a row: the names in "${sources[long.name]!.name}" became columns`);
  return pivoted;
}

/** What the columns mean, given their names and the time. */
function meaningWith(
  work: Work,
  sources: readonly Source[],
  timing: TimeFinding,
  long: ImportPlan['long'],
): Meaning | string {
  const { layout, choices, options, up } = work;
  const timed = new Set(timing.time.columns);
  const chosen = new Map<string, number>();
  for (const [name, words] of Object.entries(choices.map ?? {})) {
    const source = words === null ? undefined : sources.find((s) => isMeant(s, words));
    if (words !== null && !source)
      return `there is no column "${words}" for ${name}; there are ${sources
        .map((s) => s.name)
        .slice(0, 12)
        .join(', ')}`;
    if (name !== 't') chosen.set(name, source?.index ?? -1);
  }
  const quaternions = quaternionsIn(sources.map((s) => s.name));
  const quaternion = quaternions[0] ?? null;
  const parts = new Set(quaternion?.columns);
  // How well a body was seen is not the residual of constraints.
  const captured = valueOf(layout.properties, /^NO_OF_FRAMES$|^Take Name$/i) !== null;
  const titles = sources.map((source) => {
    if (timed.has(source.index) || parts.has(source.index) || NOT_MEANT.test(source.name)) return null;
    if (captured && /(?:^|[. ])residual$/i.test(source.name)) return null;
    return up === 'y' ? lookedUp({ ...source, name: turnedName(source.name).name }) : lookedUp(source);
  });
  const given = { choices, properties: layout.properties, up };
  const base = { long, timing, width: sources.length, notes: [] as string[] };
  const numeric = (index: number): boolean =>
    long !== null || layout.rows.some((row) => formOf(row[index] ?? '', layout.decimal === ',') === 'number');
  const asData = (reason: string): Meaning | string => {
    const finding = dataColumns(sources, numeric, timed, given);
    if (!finding.columns.some((c) => c.role === 'data')) return reason || 'no column holds numbers';
    return { ...base, system: null, finding, notes: reason ? [`opened as data: ${reason}`] : [] };
  };
  if (choices.system === null) return asData('');
  const one = choices.system === undefined ? null : options.systems[choices.system];
  if (choices.system !== undefined && !one)
    return `there is no system "${choices.system}"; there are ${Object.keys(options.systems).join(', ')}`;
  const fit = one
    ? chosenFit(candidate(one.id, one, titles, chosen, quaternion !== null))
    : fitSystem(titles, options.systems, options.preferred ?? null, chosen, quaternion !== null);
  if (!fit.candidate) return options.data && !one ? asData(fit.reason) : fit.reason;
  const attitude = quaternion && attitudeOf(fit.candidate.meta);
  const used = attitude && !fit.candidate.hits.some((hit) => hit?.word.name === attitude.yaw) ? quaternion : null;
  if (used?.doubtful) base.notes.push('of q1 to q4 the last is taken for the scalar');
  const finding = columnsOf(sources, fit.candidate, used?.columns ?? null, timed, given);
  if (typeof finding === 'string') return finding;
  if (used)
    base.notes.push(
      `the quaternion ${used.columns.map((c) => sources[c]!.name).join(', ')} became ${[attitude!.yaw, attitude!.pitch, attitude!.roll].filter(Boolean).join(', ')}`,
    );
  return { ...base, system: fit.candidate.id, finding };
}

function chosenFit(fit: Candidate): { candidate: Candidate | null; reason: string } {
  return fit.missing.length === 0
    ? { candidate: fit, reason: '' }
    : {
        candidate: null,
        reason: `for ${fit.meta.title} ${fit.missing.join(', ')} ${fit.missing.length === 1 ? 'is' : 'are'} missing; say which column each is`,
      };
}

/** A file of numbers alone: the coordinates in order, or the time before them, of a system that has such files. */
function headerless(
  { layout, choices, options }: Work,
  sources: readonly Source[],
): (Omit<Meaning, 'timing'> & { timing: TimeFinding | null }) | string | null {
  const system: SystemMeta | undefined = Object.values(options.systems).find((meta) => meta.headerless);
  const names = system?.coordinates.map((q) => q.name) ?? [];
  const count = layout.width;
  const fits = system && (count === names.length || count === names.length + 1);
  if (choices.map || choices.system !== undefined || choices.time !== undefined || !fits) {
    if (options.data || choices.map || choices.system === null) return null;
    return `${NO_HEADER} ${count} columns are neither ${names.length} (coordinates in order) nor ${names.length + 1} (time first)`;
  }
  const timed = count > names.length;
  const kinds = new Map(system.coordinates.map((q) => [q.name, q.kind]));
  const columns = sources.map((source, i) => {
    const name = (timed ? ['t', ...names] : names)[i]!;
    const kind = name === 't' ? ('time' as const) : kinds.get(name)!;
    return {
      index: i,
      source: source.name,
      title: String(i + 1),
      name,
      unit: '',
      unitFrom: 'none' as const,
      factor: 1,
      kind,
      role: name === 't' ? ('time' as const) : ('coordinate' as const),
    };
  });
  const timing: TimeFinding | null = timed
    ? { time: { columns: [0], form: 'number', unit: '', factor: 1, step: null }, questions: [], notes: [] }
    : null;
  const note = timed
    ? 'no header: time, then the coordinates in order (SI, radians)'
    : 'no header: the coordinates in order (SI, radians)';
  return {
    system: system.id,
    long: null,
    finding: { columns, notes: [note], repeated: [] },
    timing,
    width: count,
    notes: [],
  };
}

function layoutNotes(layout: Layout): string[] {
  const notes: string[] = [];
  const marks = { ';': 'semicolons', '\t': 'tabs', '|': 'upright bars', blanks: 'blanks' } as Record<string, string>;
  if (layout.separator !== ',') notes.push(`separated by ${marks[layout.separator] ?? `"${layout.separator}"`}`);
  if (layout.decimal === ',') notes.push('decimal commas');
  if (layout.unitsLine !== null) notes.push(`units are in line ${layout.unitsLine}`);
  const first = layout.headerLines[0];
  if (first !== undefined && first > 1 && layout.properties.length > 0)
    notes.push(`the header is in line ${layout.headerLines.join(', ')}`);
  return notes;
}

/** What the first rows leave open. */
function questionsOf(plan: ImportPlan, layout: Layout, known: boolean): Question[] {
  if (plan.system === null || plan.long || known) return [];
  const comma = plan.decimal === ',';
  const numbers = (index: number): number[] => layout.rows.map((row) => readNumber(row[index] ?? '', comma));
  const unsaid = plan.columns
    .filter((c) => c.role === 'coordinate' && c.unit === '' && c.unitFrom === 'none')
    .map((c) => ({ name: c.name!, kind: c.kind as 'length' | 'angle', data: numbers(c.index) }));
  const [time] = plan.time.columns;
  const t =
    time !== undefined && (plan.time.form === 'number' || plan.time.form === 'epoch')
      ? numbers(time).map((x) => x * plan.time.factor)
      : layout.rows.map((_, i) => i * (plan.time.step ?? 0.01));
  return doubtsOf(unsaid, t);
}

/** The same for files that the same program wrote: names, units and marks, not numbers. */
function shapeOf(layout: Layout): string {
  const titles = layout.titles?.map((title) => title.trim()) ?? [`${layout.width} columns`];
  const text = [layout.separator, layout.decimal, ...titles, '/', ...(layout.units ?? [])].join('\u001f');
  let [a, b] = [0x811c9dc5, 0x1000193];
  for (let i = 0; i < text.length; i++) {
    a = Math.imul(a ^ text.charCodeAt(i), 0x01000193);
    b = Math.imul(b ^ text.charCodeAt(i), 0x85ebca6b) ^ (b >>> 13);
  }
  return `${layout.width}-${(a >>> 0).toString(36)}${(b >>> 0).toString(36)}`;
}
