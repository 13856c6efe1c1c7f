import { Checker } from '../scenario/checker.ts';
import { jsonFault, placeIn } from '../scenario/json.ts';
import { ScenarioError, type ScenarioFile } from '../scenario/types.ts';
import { measureOf, type ParsedMeasure } from './measure.ts';

/**
 * Manoeuvres that a vehicle with its controller is put through: data, so that a person adds her own. Each is a patch over
 * a scenario, one number of the run that comes of it, and the bounds that it is to be within.
 */
export interface TestFile {
  version: 1;
  tests: Test[];
}

export interface Test {
  name: string;
  /** What it changes of the scenario, key by key; null leaves a key out. */
  scenario?: Record<string, unknown>;
  /** As `measure.ts` reads it: `max(abs(alpha + alpha_fp))`, `settle.alpha`, `time`. */
  measure: string;
  /** Least and most; null: none. SI, or expressions such as `20 deg`. */
  bound: [number | string | null, number | string | null];
  /** Rows from this time on count, s. */
  after?: number;
  /** The run may stop before its duration; what it computed is measured. */
  stops?: boolean;
  /** The same run with numbers drawn by chance. */
  spread?: Spread;
}

/** Monte Carlo: paths of the scenario, each with a distribution. */
export interface Spread {
  vary: Record<string, Distribution>;
  count: number;
  seed?: number;
  /** Share of the runs that must pass; all unless named. */
  share?: number;
}

export type Distribution = { uniform: [number, number] } | { normal: [number, number] } | { list: number[] };

/** A test as it is carried out. */
export interface CheckedTest extends Omit<Test, 'bound'> {
  parsed: ParsedMeasure;
  low: number;
  high: number;
  /** Its bounds were written in degrees, and so are its figures told. */
  degrees: boolean;
}

const KEYS = ['name', 'scenario', 'measure', 'bound', 'after', 'stops', 'spread'];
const MOST_TESTS = 200;
const MOST_RUNS = 1000;
const MOST_SEED = 2 ** 32 - 1;

/**
 * @param raw JSON as parsed
 * @throws ScenarioError with the path of the first thing that is wrong
 */
export function checkTests(raw: unknown): CheckedTest[] {
  const c = new Checker();
  const file = new Map(c.entries('', raw, ['version', 'tests']));
  if (file.get('version') !== 1) c.add('version', 'must be 1');
  const list = file.get('tests');
  if (!Array.isArray(list) || list.length === 0) c.add('tests', 'must be a list of at least one test');
  else if (list.length > MOST_TESTS) c.add('tests', `${list.length} are more than the ${MOST_TESTS} allowed`);
  const tests = (Array.isArray(list) ? list.slice(0, MOST_TESTS) : []).map((entry, i) =>
    checkTest(c, entry, `tests[${i}]`),
  );
  for (const [path, message] of c.errors) throw new ScenarioError(path, message);
  return tests as CheckedTest[];
}

/**
 * Reads JSON text.
 *
 * @param text as written in the file
 * @throws ScenarioError
 */
export function parseTests(text: string): CheckedTest[] {
  const plain = text.replace(/^\ufeff/, '');
  const fault = jsonFault(plain);
  if (fault) {
    const { line, column } = placeIn(plain, fault.position);
    throw new ScenarioError('', `not JSON: line ${line}, column ${column}: ${fault.message}`);
  }
  return checkTests(JSON.parse(plain));
}

function checkTest(c: Checker, raw: unknown, path: string): CheckedTest | undefined {
  const given = new Map(c.entries(path, raw, KEYS));
  const text = (key: string): string => {
    const value = given.get(key);
    if (typeof value === 'string' && value.trim() !== '') return value;
    c.add(`${path}.${key}`, `must be a text, not ${value === undefined ? 'missing' : JSON.stringify(value)}`);
    return '';
  };
  const name = text('name');
  const measure = text('measure');
  let parsed: ParsedMeasure | null = null;
  try {
    if (measure) parsed = measureOf(measure);
  } catch (error) {
    c.add(`${path}.measure`, (error as Error).message);
  }
  const bound = given.get('bound');
  if (!Array.isArray(bound) || bound.length !== 2)
    c.add(`${path}.bound`, 'must be a pair: the least and the most, null for none');
  const [low, high] = [0, 1].map((i) => {
    const value: unknown = Array.isArray(bound) ? bound[i] : null;
    return value === null ? NaN : (c.constant(`${path}.bound[${i}]`, value) ?? NaN);
  });
  if (low! > high!) c.add(`${path}.bound`, `the least, ${low}, is more than the most, ${high}`);
  if (Array.isArray(bound) && bound[0] === null && bound[1] === null)
    c.add(`${path}.bound`, 'must name a least or a most');
  const patch = given.get('scenario');
  if (patch !== undefined) c.entries(`${path}.scenario`, patch);
  const after = given.get('after');
  const spread = given.get('spread');
  for (const key of ['stops'])
    if (given.get(key) !== undefined && typeof given.get(key) !== 'boolean')
      c.add(`${path}.${key}`, 'must be true or false');
  if (!parsed) return undefined;
  return {
    name,
    measure,
    parsed,
    low: Number.isNaN(low) ? -Infinity : low!,
    high: Number.isNaN(high) ? Infinity : high!,
    degrees: Array.isArray(bound) && bound.some((b) => typeof b === 'string' && /\bdeg\s*$/.test(b)),
    ...(patch === undefined ? {} : { scenario: patch as Record<string, unknown> }),
    ...(after === undefined ? {} : { after: c.number(`${path}.after`, after, { least: 0 }) ?? 0 }),
    ...(given.get('stops') === true ? { stops: true } : {}),
    ...(spread === undefined ? {} : { spread: checkSpread(c, spread, `${path}.spread`) }),
  };
}

function checkSpread(c: Checker, raw: unknown, path: string): Spread {
  const given = new Map(c.entries(path, raw, ['vary', 'count', 'seed', 'share']));
  const vary: Record<string, Distribution> = {};
  for (const [name, value] of c.entries(`${path}.vary`, given.get('vary') ?? {})) {
    const at = `${path}.vary.${name}`;
    const kinds = c.entries(at, value, ['uniform', 'normal', 'list']);
    if (kinds.length !== 1) {
      c.add(at, 'must have one of uniform [from, to], normal [mean, deviation], list [values]');
      continue;
    }
    const [kind, numbers] = kinds[0]!;
    if (!Array.isArray(numbers) || numbers.length === 0 || (kind !== 'list' && numbers.length !== 2))
      c.add(`${at}.${kind}`, kind === 'list' ? 'must be a list of numbers' : 'must be two numbers');
    else numbers.forEach((x, i) => c.number(`${at}.${kind}[${i}]`, x, {}));
    vary[name] = { [kind]: numbers } as Distribution;
  }
  if (Object.keys(vary).length === 0) c.add(`${path}.vary`, 'must name at least one number of the scenario');
  const optional = (key: string, rule: Parameters<Checker['number']>[2]): number | undefined =>
    given.get(key) === undefined ? undefined : c.number(`${path}.${key}`, given.get(key), rule);
  const seed = optional('seed', { least: 0, most: MOST_SEED, integer: true });
  const share = optional('share', { above: 0, most: 1 });
  return {
    vary,
    count: c.number(`${path}.count`, given.get('count'), { least: 1, most: MOST_RUNS, integer: true }) ?? 1,
    ...(seed === undefined ? {} : { seed }),
    ...(share === undefined ? {} : { share }),
  };
}

/**
 * A scenario with a patch over it: objects are gone into, anything else is replaced, null leaves out.
 *
 * @param file the scenario as written
 * @param patch what differs, by key
 */
export function patched(file: ScenarioFile, patch: Readonly<Record<string, unknown>> = {}): ScenarioFile {
  return merged(file, patch) as unknown as ScenarioFile;
}

function merged(base: unknown, patch: Readonly<Record<string, unknown>>): Record<string, unknown> {
  const result: Record<string, unknown> = isPlain(base) ? { ...base } : {};
  for (const [key, value] of Object.entries(patch)) {
    if (value === null) delete result[key];
    else result[key] = isPlain(value) ? merged(result[key], value) : value;
  }
  return result;
}

const isPlain = (x: unknown): x is Record<string, unknown> => typeof x === 'object' && x !== null && !Array.isArray(x);
