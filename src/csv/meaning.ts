/** What the columns of a table mean: time, system, coordinates and their rates, attitudes, bodies; or data. */
import type { SystemMeta } from '../core/model/system.ts';
import { formOf } from './layout/cells.ts';
import type { Layout } from './layout/layout.ts';
import { longOf, longUnits } from './layout/long.ts';
import { valueOf } from './layout/preamble.ts';
import { stackedOf } from './layout/stacked.ts';
import { withoutAffixes } from './names/affixes.ts';
import { attitudesIn, scalarFirst, type Attitude } from './names/attitude.ts';
import { bodiesOf, bodyIn, type Body } from './names/bodies.ts';
import { columnsOf, dataColumns, turnedName, type ColumnsFinding } from './names/columns.ts';
import { candidate, fitSystem, type Candidate, type Fit } from './names/systems.ts';
import { conceptsIn } from './names/phrases.ts';
import { attitudeOf, type Systems } from './names/vocabulary.ts';
import type { ImportChoices, ImportPlan, Question } from './plan.ts';
import { readNumber } from './reading/numbers.ts';
import { isMeant, lookedUp, sourcesOf, type Source } from './source.ts';
import { splitTitle } from './units/titles.ts';
import { timeReaderOf } from './time/reader.ts';
import { timeRank } from './time/timeNames.ts';
import { timeOf, type TimeFinding } from './time/timePlan.ts';

export interface UnderstandOptions {
  systems: Systems;
  choices?: ImportChoices;
  /** Whether what names no system's coordinates is data; otherwise it is refused. */
  data?: boolean;
  /** System of a scenario that stands in the file's comments. */
  preferred?: string | null;
}

export interface Work {
  layout: Layout;
  choices: ImportChoices;
  options: UnderstandOptions;
  up: 'y' | 'z';
}

export interface Meaning extends Pick<ImportPlan, 'system' | 'long' | 'width' | 'bodies' | 'body' | 'only' | 'euler'> {
  finding: ColumnsFinding;
  timing: TimeFinding;
  notes: string[];
  questions: Question[];
}

/** Of a file without a header and any name of a column. */
const NO_HEADER = 'there is no header row, and';
/** A group of rotations has an x too, which is no position. */
const NOT_MEANT = /(?:^|\.)rotation\.[xyz]$/i;
/** What a school's logger names beside each column is a run. */
const RUN = /^(?:run|trial|set|take|data ?set)\b/i;
/** Bodies that a question offers. */
const MOST_OFFERED = 20;

/** A text says why the table can't be read. */
export function meaningOf(work: Work): Meaning | string {
  const { layout, choices } = work;
  const sources = sourcesOf(layout);
  const lying = lyingDown(layout, sources);
  if (lying !== null) return lying;
  const timing = timeOf(layout, sources, choices);
  if (typeof timing === 'string') return timing;
  if (!layout.titles && layout.headerLines.length === 0) {
    const bare = headerless(work, sources);
    if (bare)
      return typeof bare === 'string'
        ? bare
        : { ...bare, timing: bare.timing ?? withoutTime(layout, sources, choices) };
  }
  const own = meaningWith(work, sources, timing, null);
  if (typeof own !== 'string' && own.system !== null) {
    const its = timeOfBody(work, sources, own);
    const timed = its ? meaningWith(work, sources, its, null) : own;
    return stacked(work, sources, typeof timed === 'string' ? own : timed);
  }
  const long = longOf(layout, sources, timing.time.columns[0]);
  if (!long) return own;
  const units = longUnits(layout, long);
  const names = [
    sources[long.time]!,
    ...long.names.map((title, i): Source => {
      const { name, unit } = splitTitle(title);
      return { index: 0, title, name: name || title, plain: name || title, unit, rowUnit: units[i]! };
    }),
  ].map((s, index) => ({ ...s, index }));
  const pivoted = meaningWith(work, names, { ...timing, time: { ...timing.time, columns: [0] } }, long);
  if (typeof pivoted === 'string') return own;
  pivoted.notes.unshift(`one value a row: the names in "${sources[long.name]!.name}" became columns`);
  return pivoted;
}

/** Names in the first column and a row of numbers for each: why that is not read. */
function lyingDown({ rows, titles, headerLines }: Layout, sources: readonly Source[]): string | null {
  const lines = titles && headerLines.length > 0 ? [titles, ...rows] : rows;
  if (sources.length < 2 * lines.length || lines.length < 3) return null;
  const names = lines.map((cells) => splitTitle(cells[0] ?? '').name);
  const numbers = lines.every((cells) =>
    cells
      .slice(1, 9)
      .every(
        (cell) => cell.trim() === '' || readNumber(cell, cell.includes(',')) === readNumber(cell, cell.includes(',')),
      ),
  );
  const timed = names.some((name) => timeRank(name) !== null);
  const known = names.filter(
    (name) => timeRank(name) !== null || conceptsIn(name) !== null || /^[a-z]{1,6}(?:_\w+)?$/i.test(name),
  );
  return numbers && timed && known.length === names.length
    ? `the names ${names.slice(0, 4).join(', ')}${names.length > 4 ? ', …' : ''} stand one below another, each before its numbers: exchange rows and columns (in a spreadsheet copy and paste transposed, in pandas df.T)`
    : null;
}

/** The board's ten columns hold no time. */
function withoutTime(layout: Layout, sources: readonly Source[], choices: ImportChoices): TimeFinding {
  return timeOf(layout, sources, { ...choices, time: null }) as TimeFinding;
}

/** Where each of several bodies has a time of its own: that of the one that is read. */
function timeOfBody(
  { layout, choices }: Work,
  sources: readonly Source[],
  { body, timing }: Meaning,
): TimeFinding | null {
  if (!body || choices.time !== undefined) return null;
  const own = sources.filter(({ plain }) => bodyIn(plain) === body && timeRank(plain.split('.').at(-1)!) !== null);
  const its = own.length > 0 ? timeOf(layout, own, choices) : null;
  return its && typeof its !== 'string' && its.time.columns[0] !== timing.time.columns[0] ? its : null;
}

/** Several bodies one below another: the rows of one are read. */
function stacked({ layout, choices }: Work, sources: readonly Source[], meaning: Meaning): Meaning {
  const { time } = meaning.timing;
  if (time.columns.length === 0 || meaning.bodies.length > 0) return meaning;
  const comma = layout.decimal === ',';
  const seconds =
    timeReaderOf(time, choices, comma) ??
    ((cells: readonly string[]) => readNumber(cells[time.columns[0]!] ?? '', comma));
  const found = stackedOf(layout, sources, new Set(time.columns), seconds);
  if (!found) return meaning;
  const body = found.values.find((value) => value === choices.body) ?? found.values[0]!;
  return {
    ...meaning,
    only: { column: found.column, value: body },
    ...offered(found.values, body, choices, meaning, `rows of several bodies, by "${sources[found.column]!.name}"`),
  };
}

function offered(
  bodies: readonly string[],
  body: string,
  choices: ImportChoices,
  { notes, questions }: Pick<Meaning, 'notes' | 'questions'>,
  where: string,
): Pick<Meaning, 'bodies' | 'body' | 'notes' | 'questions'> {
  const shown = (name: string): string => (name === '' ? 'the one without a name' : name);
  const question: Question = {
    id: 'several-bodies',
    text: `The file holds ${bodies.length} ${bodies.every((name) => RUN.test(name)) ? 'runs side by side' : 'bodies'}: which one?`,
    answers: bodies.slice(0, MOST_OFFERED).map((name) => ({ label: shown(name), choices: { body: name } })),
    safest: Math.max(0, bodies.indexOf(body)),
    first: false,
  };
  return {
    bodies,
    body,
    notes: [...notes, `${where}: ${bodies.slice(0, MOST_OFFERED).map(shown).join(', ')}; ${shown(body)} is read`],
    questions: choices.body === undefined ? [...questions, question] : questions,
  };
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
  const { properties } = layout;
  const euler = /^[xyz]{3}$/i.exec(valueOf(properties, /^Rotation Type$/i) ?? '')?.[0].toUpperCase() ?? null;
  let attitudes = attitudesIn(
    sources.map((s) => s.plain),
    euler,
  );
  const parts = new Set(attitudes.flatMap(({ columns }) => columns));
  // How well a body was seen is not the residual of constraints.
  const captured = valueOf(properties, /^NO_OF_FRAMES$|^Take Name$/i) !== null;
  const titles = sources.map((source) => {
    const taken = timed.has(source.index) || parts.has(source.index) || NOT_MEANT.test(source.plain);
    if (taken || (captured && /(?:^|[. ])residual$/i.test(source.plain))) return null;
    return up === 'y' ? lookedUp({ ...source, plain: turnedName(source.plain).name }) : lookedUp(source);
  });
  const given = { choices, properties, up };
  const none = { bodies: [], body: null, only: null, euler: null };
  const base = { ...none, long, timing, width: sources.length, notes: [] as string[], questions: [] as Question[] };
  const numeric = (index: number): boolean =>
    long !== null || layout.rows.some((row) => formOf(row[index] ?? '', layout.decimal === ',') === 'number');
  const asData = (reason: string): Meaning | string => {
    const finding = dataColumns(sources, numeric, timed, given);
    if (!finding.columns.some((c) => c.role === 'data')) return withoutNumbers(layout, timing) ?? reason;
    return { ...base, system: null, finding, notes: reason ? [`opened as data: ${reason}`] : [] };
  };
  if (choices.system === null) return asData('');
  const one = choices.system === undefined ? null : options.systems[choices.system];
  if (choices.system !== undefined && !one)
    return `there is no system "${choices.system}"; there are ${Object.keys(options.systems).join(', ')}`;
  const fitOf = (names: readonly (string | null)[]): Fit =>
    one
      ? chosenFit(candidate(one.id, one, names, chosen, attitudes.length > 0))
      : fitSystem(names, options.systems, options.preferred ?? null, chosen, attitudes.length > 0);
  let fit = fitOf(titles);
  if (!fit.candidate && !long) {
    const shorter = withoutAffixes(
      sources,
      (names) =>
        fitOf(
          names.map((name, i) =>
            name === null || titles[i] === null ? null : lookedUp({ ...sources[i]!, plain: name }),
          ),
        ).candidate !== null,
    );
    if (shorter) return meaningWith(work, shorter, timing, long);
  }
  if (!fit.candidate) return options.data && !one ? asData(fit.reason) : fit.reason;
  const bodies = bodiesOf(sources, fit.candidate, attitudes, valueOf(properties, /^BODY_NAMES$/i) !== null);
  const body = bodies.find(({ name }) => name === choices.body) ?? bodies[0];
  if (body) {
    const ofBody = withBody(sources, titles, fit.candidate, attitudes, bodies, body);
    attitudes = ofBody.attitudes;
    fit = fitOf(ofBody.titles);
    if (!fit.candidate) return options.data && !one ? asData(fit.reason) : fit.reason;
  }
  const [attitude] = attitudes;
  const made = attitude && attitudeOf(fit.candidate.meta);
  const used = made && !fit.candidate.hits.some((hit) => hit?.word.name === made.yaw) ? attitude : null;
  const meaning: Meaning = {
    ...base,
    system: fit.candidate.id,
    euler: turnedOrder(used?.euler ?? null, up),
    finding: NOTHING,
  };
  if (body && bodies.length > 1)
    Object.assign(
      meaning,
      offered(
        bodies.map(({ name }) => name),
        body.name,
        choices,
        meaning,
        bodies.every(({ name }) => RUN.test(name)) ? 'several runs side by side' : 'several bodies',
      ),
    );
  const ordered = used?.doubtful ? inOrder(used, work, meaning) : used;
  const finding = columnsOf(sources, fit.candidate, ordered, timed, given);
  if (typeof finding === 'string') return finding;
  if (ordered)
    meaning.notes.push(
      `${ordered.euler ? `the turns (${ordered.euler}, each about the axes turned before)` : 'the quaternion'} ${ordered.columns.map((c) => sources[c]!.name).join(', ')} became ${[made!.yaw, made!.pitch, made!.roll].filter(Boolean).join(', ')}`,
    );
  return { ...meaning, finding };
}

/** Y of the file is Z here, and Z is -Y: the turns keep their order. */
function turnedOrder(order: string | null, up: 'y' | 'z'): string | null {
  if (order === null || up === 'z') return order;
  return order.replace(/[YZ]/g, (axis) => (axis === 'Y' ? 'Z' : 'Y'));
}

const NOTHING: ColumnsFinding = { columns: [], notes: [], repeated: [] };

/** Leaves what belongs to other bodies, and the attitude of this one. */
function withBody(
  sources: readonly Source[],
  titles: readonly (string | null)[],
  { hits }: Candidate,
  attitudes: readonly Attitude[],
  bodies: readonly Body[],
  body: Body,
): { titles: (string | null)[]; attitudes: Attitude[] } {
  const own = new Set([...body.columns].map((column) => hits[column]?.word.name));
  const others = new Set(bodies.flatMap((b) => (b === body ? [] : [...b.columns])));
  return {
    titles: titles.map((title, i) => {
      const word = hits[i]?.word;
      if (!word || word.kind === 'plain' || body.columns.has(i)) return title;
      const beside = own.has(word.name) && bodyIn(sources[i]!.plain) !== body.prefix;
      return beside || others.has(i) ? null : title;
    }),
    attitudes: attitudes.filter(({ columns }) => columns.every((column) => !others.has(column))),
  };
}

/** A quaternion whose scalar no name tells: by what a person said, else as it stands more upright. */
function inOrder(attitude: Attitude, { layout, choices, up }: Work, meaning: Meaning): Attitude {
  const [a, b, c, d] = [...attitude.columns].sort((x, y) => x - y) as [number, number, number, number];
  const rows = layout.rows
    .map((row) => [a, b, c, d].map((column) => readNumber(row[column] ?? '', layout.decimal === ',')))
    .filter((row) => row.every((q) => q === q));
  const first = choices.scalar ? choices.scalar === 'first' : scalarFirst(rows, up === 'y' ? 1 : 2);
  meaning.notes.push(`of the quaternion's four numbers the ${first ? 'first' : 'last'} is taken for the scalar`);
  if (!choices.scalar)
    meaning.questions.push({
      id: 'scalar',
      text: "Which of the quaternion's four numbers is the scalar?",
      answers: [
        { label: 'the first', choices: { scalar: 'first' } },
        { label: 'the last', choices: { scalar: 'last' } },
      ],
      safest: first ? 0 : 1,
      first: false,
    });
  return { ...attitude, columns: first ? [b, c, d, a] : [a, b, c, d] };
}

/** Why there is nothing to draw, where no column but the time holds numbers. */
function withoutNumbers({ rows, separator, firstRow }: Layout, { time }: TimeFinding): string | null {
  if (rows.length === 0) return `there are names, and no rows of numbers below them`;
  if (time.columns.length > 0) return 'there are times, and no other column with numbers';
  return separator === ',' && firstRow > 0
    ? 'there are no rows of numbers; cells are separated by commas, semicolons, tabs, vertical bars or blanks'
    : 'there are no rows of numbers';
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
    questions: [],
    bodies: [],
    body: null,
    only: null,
    euler: null,
  };
}
