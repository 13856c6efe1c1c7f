import type { SystemMeta } from '../model/system.ts';
import type { FactKind, SweepMeasure } from '../motion/sweepMeasures.ts';
import { uniform } from '../scenario/chance.ts';
import { kindOf, unknownName } from '../scenario/checker.ts';
import { evaluateNumber } from '../scenario/expressions.ts';
import { ScenarioError, type ScenarioFile } from '../scenario/types.ts';
import { withValue } from '../scenario/sweepAxes.ts';
import { checkScenario } from '../scenario/schema.ts';
import { normalQuantile } from './normalQuantile.ts';
import { MOST_SOBOL_DIMENSIONS, sobol } from './sobol.ts';

/** A number in SI, or text as a scenario takes it: `10 deg`. */
export type StudyNumber = number | string;

/** How one place of the scenario varies. */
export type StudyVariation =
  | { grid: readonly [from: StudyNumber, to: StudyNumber, count: number] }
  | { list: readonly StudyNumber[] }
  | { uniform: readonly [from: StudyNumber, to: StudyNumber] }
  | { normal: readonly [mean: StudyNumber, sd: StudyNumber] };

/** Many runs of one scenario, as written. */
export interface StudyFile {
  version: 1;
  scenario: ScenarioFile;
  /** By place in the scenario, `initial.alpha`; places joined by `+` take the same value. */
  vary: Readonly<Record<string, StudyVariation>>;
  /** Absent: a grid. */
  sample?: { kind: 'grid' | 'random' | 'sobol'; count?: number; seed?: number };
  /** `final.X`, `max.alpha_fp`, `min.energy`, or a fact of the run as `drift`. */
  measures?: readonly string[];
}

/** A checked study: each run follows from its index alone. */
export interface Study {
  file: StudyFile;
  runs: number;
  /** The varied places, in their order. */
  paths: readonly string[];
  /** As they are named. */
  measureNames: readonly string[];
  measures: readonly SweepMeasure[];
  /** Numbers in SI, or text, one a place. @param index from 0 */
  values(index: number): (number | string)[];
  /** @param index from 0 */
  scenario(index: number): ScenarioFile;
}

/** More would not fit into a column of 32-bit indices, nor into a table that a person opens. */
const MOST_RUNS = 100_000_000;
const COLUMN_MEASURES = { final: 'end', max: 'max', min: 'min' } as const;
const FACTS: readonly FactKind[] = ['drift', 'residual', 'steps', 'work', 'distance', 'costOfTransport'];
const KINDS = ['grid', 'random', 'sobol'] as const;
const KEYS = ['version', 'scenario', 'vary', 'sample', 'measures'];

/** One varied place: its value for a share between 0 and 1, and, where they can be counted, how many and which. */
interface Axis {
  path: string;
  at(share: number): number | string;
  list: readonly (number | string)[] | null;
}

/**
 * @param raw the file's JSON; its own system, if it has one, is already learnt
 * @param systems metas by id
 * @throws ScenarioError with the place of what is wrong
 */
export function checkStudy(raw: unknown, systems: Readonly<Record<string, SystemMeta>>): Study {
  const file = record(raw, '') as unknown as StudyFile;
  for (const key of Object.keys(file)) if (!KEYS.includes(key)) fail(key, unknownName(key, KEYS));
  if (file.version !== 1) fail('version', `must be 1, not ${kindOf(file.version)}`);
  const axes = Object.entries(record(file.vary, 'vary')).map(([path, how]) => axisOf(path, how));
  if (axes.length === 0) fail('vary', 'names nothing; right would be {"initial.alpha": {"grid": [-0.1, 0.1, 21]}}');
  const { runs, values } = samplesOf(file.sample ?? { kind: 'grid' }, axes);
  const measureNames = list(file.measures ?? [], 'measures').map((name, i) => text(name, `measures.${i}`));
  const paths = axes.map(({ path }) => path);
  measureNames.forEach((name, i) => {
    if (measureNames.indexOf(name) < i || [...paths, 'index', 'reason', 'time'].includes(name))
      fail(`measures.${i}`, `there is a column "${name}" already`);
  });
  const measures = measureNames.map((name, i) => measureOf(name, `measures.${i}`));
  const base = record(file.scenario, 'scenario') as unknown as ScenarioFile;
  const scenario = (index: number): ScenarioFile =>
    values(index).reduce<ScenarioFile>((next, value, k) => withValue(next, paths[k]!, value), base);
  const study: Study = { file, runs, paths, measureNames, measures, values, scenario };
  checkFirst(study, base, systems);
  return study;
}

/** A path that leads nowhere is told before anything runs. Values of single runs may be refused later, each in its row. */
function checkFirst({ paths, values }: Study, base: ScenarioFile, systems: Readonly<Record<string, SystemMeta>>): void {
  try {
    checkScenario(base, systems);
  } catch (error) {
    if (error instanceof ScenarioError) fail(`scenario.${error.path}`, messageOf(error));
    throw error;
  }
  values(0).forEach((value, k) => {
    try {
      checkScenario(withValue(base, paths[k]!, value), systems);
    } catch (error) {
      if (error instanceof ScenarioError) fail(`vary.${paths[k]!}`, `${error.path}: ${messageOf(error)}`);
      throw error;
    }
  });
}

const messageOf = ({ path, message }: ScenarioError): string =>
  path && message.startsWith(`${path}: `) ? message.slice(path.length + 2) : message;

function axisOf(path: string, raw: unknown): Axis {
  const where = `vary.${path}`;
  if (path.split(/[.+]/).some((part) => part === '' || part === '__proto__'))
    fail(where, 'is no place in a scenario; right would be initial.alpha');
  if (path.split('+').some((part) => part === 'system' || part === 'version'))
    fail(where, 'stays the same in one study; make a study for each system');
  const ways = Object.entries(record(raw, where));
  const known = ['grid', 'list', 'uniform', 'normal'];
  if (ways.length !== 1) fail(where, `needs one of ${known.join(', ')}`);
  const [kind, given] = ways[0]!;
  if (!known.includes(kind)) fail(where, unknownName(kind, known));
  const items = list(given, `${where}.${kind}`);
  const size = { grid: 3, uniform: 2, normal: 2 }[kind];
  if (size !== undefined ? items.length !== size : items.length === 0)
    fail(`${where}.${kind}`, `needs ${size ?? 'at least one'} ${size ? 'entries' : 'entry'}, not ${items.length}`);
  if (kind === 'list') {
    const values = items.map((item, i) => valueOf(item, `${where}.list.${i}`));
    if (new Set(values.map((value) => typeof value)).size > 1)
      fail(`${where}.list`, 'holds numbers and words; right would be one kind');
    return { path, list: values, at: (share) => pick(values, share) };
  }
  const [a, b] = [0, 1].map((i) => numberOf(items[i], `${where}.${kind}.${i}`)) as [number, number];
  if (kind === 'uniform') return { path, list: null, at: (share) => a + share * (b - a) };
  if (kind === 'normal') {
    if (!(b >= 0)) fail(`${where}.normal.1`, `a deviation must not be negative: ${b}`);
    return { path, list: null, at: (share) => a + b * normalQuantile(share) };
  }
  const count = items[2];
  if (typeof count !== 'number' || !Number.isInteger(count) || count < 1 || count > MOST_RUNS)
    fail(`${where}.grid.2`, `must be a whole number from 1, not ${kindOf(count)}`);
  const values = Array.from({ length: count }, (_, i) =>
    i === 0 ? a : i === count - 1 ? b : Number((a + (i / (count - 1)) * (b - a)).toPrecision(13)),
  );
  return { path, list: values, at: (share) => pick(values, share) };
}

const pick = <T>(values: readonly T[], share: number): T => values[Math.floor(share * values.length)]!;

function samplesOf(raw: unknown, axes: readonly Axis[]): Pick<Study, 'runs' | 'values'> {
  const sample = record(raw, 'sample');
  const { kind, count, seed = 0 } = sample;
  for (const key of Object.keys(sample))
    if (!['kind', 'count', 'seed'].includes(key)) fail(`sample.${key}`, unknownName(key, ['kind', 'count', 'seed']));
  if (!KINDS.includes(kind as 'grid')) fail('sample.kind', `must be ${KINDS.join(', ')}, not ${kindOf(kind)}`);
  if (!Number.isInteger(seed)) fail('sample.seed', `must be a whole number, not ${kindOf(seed)}`);
  if (kind === 'grid') {
    const open = axes.find((axis) => axis.list === null);
    if (open) fail(`vary.${open.path}`, 'has no grid and no list; or let "sample" be random or sobol');
    const runs = axes.reduce((product, axis) => product * axis.list!.length, 1);
    if (runs > MOST_RUNS) fail('vary', `gives ${runs} runs; at most ${MOST_RUNS} go into one study`);
    if (count !== undefined && count !== runs) fail('sample.count', `the grid has ${runs} runs, not ${String(count)}`);
    return { runs, values: (index) => gridPoint(axes, index) };
  }
  if (typeof count !== 'number' || !Number.isInteger(count) || count < 1 || count > MOST_RUNS)
    fail('sample.count', `must be a whole number from 1 to ${MOST_RUNS}, not ${kindOf(count)}`);
  if (kind === 'random')
    return { runs: count, values: (index) => axes.map((axis, k) => axis.at(uniform(seed as number, k, index))) };
  if (axes.length > MOST_SOBOL_DIMENSIONS)
    fail('vary', `a Sobol sequence here has ${MOST_SOBOL_DIMENSIONS} dimensions, not ${axes.length}`);
  // A seed shifts every coordinate's digits by its own pattern; 0 leaves the sequence as it is.
  const shifts = axes.map((_, k) => (seed === 0 ? 0 : Math.floor(uniform(seed as number, k, 0) * 2 ** 32)));
  return {
    runs: count,
    values: (index) => axes.map((axis, k) => axis.at((((sobol(index, k) ^ shifts[k]!) >>> 0) + 0.5) / 2 ** 32)),
  };
}

/** The last place varies fastest. */
function gridPoint(axes: readonly Axis[], index: number): (number | string)[] {
  const point: (number | string)[] = [];
  for (let k = axes.length - 1; k >= 0; k--) {
    const values = axes[k]!.list!;
    point[k] = values[index % values.length]!;
    index = Math.floor(index / values.length);
  }
  return point;
}

function measureOf(name: string, where: string): SweepMeasure {
  const [, kind, column] = /^(final|max|min)\.(.+)$/.exec(name) ?? [];
  if (kind && column) return { kind: COLUMN_MEASURES[kind as keyof typeof COLUMN_MEASURES], column };
  const fact = FACTS.find((f) => f === name);
  if (!fact)
    fail(where, `"${name}" is not known; right would be final., max. or min. of a column, ${FACTS.join(', ')}`);
  return { kind: fact };
}

/** Text that is a number, as `10 deg`, becomes one; other text, as a method's name, stays. */
function valueOf(raw: unknown, where: string): number | string {
  if (typeof raw === 'number' && Number.isFinite(raw)) return raw;
  if (typeof raw !== 'string') fail(where, `must be a number or text, not ${kindOf(raw)}`);
  try {
    return evaluateNumber(raw);
  } catch {
    return raw;
  }
}

function numberOf(raw: unknown, where: string): number {
  const value = valueOf(raw, where);
  if (typeof value === 'string') fail(where, `must be a number, not ${kindOf(raw)}; right would be 0.1 or "10 deg"`);
  return value;
}

function record(raw: unknown, where: string): Record<string, unknown> {
  if (typeof raw !== 'object' || raw === null || Array.isArray(raw))
    fail(where, `must be an object, not ${kindOf(raw)}`);
  return raw as Record<string, unknown>;
}

function list(raw: unknown, where: string): readonly unknown[] {
  if (!Array.isArray(raw)) fail(where, `must be a list, not ${kindOf(raw)}`);
  return raw as unknown[];
}

function text(raw: unknown, where: string): string {
  if (typeof raw !== 'string') fail(where, `must be text, not ${kindOf(raw)}`);
  return raw as string;
}

function fail(where: string, message: string): never {
  throw new ScenarioError(where, message);
}
