import { closeSync, createReadStream, openSync, readSync, fstatSync, realpathSync } from 'node:fs';
import { basename } from 'node:path';
import { Readable } from 'node:stream';
import type { SystemMeta } from '../core/model/system.ts';
import { systemNamed } from '../core/scenario/own.ts';
import { learnSystemOf } from '../core/systems/registry.ts';
import { csvHeader, csvRows, type CsvResult } from '../csv/csv.ts';
import type { ColumnPlan, ImportChoices } from '../csv/plan.ts';
import { ENDING, readStream, scenarioIn, type Bytes } from '../csv/reading/stream.ts';
import { SI_UNITS } from '../csv/units/units.ts';
import { openOutput } from './output.ts';
import { pairsOf, pathOf, UsageError } from './usage.ts';

export interface ReadOptions {
  out?: string | undefined;
  /** `alpha=deg,x=mm` */
  units?: string | undefined;
  /** Seconds between rows of a file without times. */
  step?: string | undefined;
  /** `theta=yaw`: a coordinate and the column it comes from. */
  map?: string | undefined;
  time?: string | undefined;
  /** Id, or `none` for data. */
  system?: string | undefined;
  run?: string | undefined;
  /** Name of one of several bodies. */
  body?: string | undefined;
  /** `first` or `last`: which of a quaternion's four numbers is the scalar. */
  scalar?: string | undefined;
  /** `savitzky-golay`: rates that the file lacks, by differentiation. */
  rates?: string | undefined;
}

type Motion = Extract<CsvResult, { kind: 'motion' }>;

/** Issues that are written out. */
const MOST_LISTED = 40;

/**
 * Reads any file that the page reads: what was understood as an object, its rows into a CSV in SI, radians and times
 * from 0 where `out` names one.
 */
export async function read(
  name: string | undefined,
  systems: Readonly<Record<string, SystemMeta>>,
  options: ReadOptions,
): Promise<object> {
  if (!name) throw new UsageError('which file? Name one');
  const file = pathOf(name);
  const choices = choicesOf(options);
  const result = await readFile(name, file, systems, choices);
  if (result.kind === 'unusable') {
    const places = result.issues
      .filter((issue, i) => i === 0 || result.issues[0]!.message === 'no row could be used')
      .slice(0, 2);
    throw new UsageError(`${name} can't be read: ${places.map(described).join('; ')}`);
  }
  if (result.kind !== 'motion') throw new UsageError(`${name} has no times: give --step in seconds`);
  checkUnits(choices, result);
  if (options.out !== undefined) write(options.out, file, result);
  return reportOf(result, choices, basename(name));
}

async function readFile(
  name: string,
  file: string,
  systems: Readonly<Record<string, SystemMeta>>,
  choices: ImportChoices,
): Promise<CsvResult> {
  let descriptor: number;
  try {
    descriptor = openSync(file, 'r');
  } catch (error) {
    const { code, message } = error as NodeJS.ErrnoException;
    throw new UsageError(`${name} can't be read: ${code === 'ENOENT' ? 'there is no such file' : message}`);
  }
  try {
    const status = fstatSync(descriptor);
    if (status.isDirectory()) throw new UsageError(`${name} can't be read: it is a folder`);
    const ending = Buffer.alloc(Math.min(ENDING, status.size));
    if (status.isFile()) readSync(descriptor, ending, 0, ending.length, status.size - ending.length);
    const stream = Readable.toWeb(createReadStream(file)) as unknown as Bytes;
    const scenario = scenarioIn(ending);
    await learnSystemOf(scenario).catch(() => {});
    const preferred = systemNamed(scenario);
    return await readStream(stream, { systems, choices, data: true, unasked: true, size: status.size, preferred });
  } finally {
    closeSync(descriptor);
  }
}

function choicesOf({ units, step, map, time, system, run, body, scalar, rates }: ReadOptions): ImportChoices {
  if (step !== undefined && !(+step > 0 && +step < Infinity))
    throw new UsageError(`--step must be a number of seconds greater than 0, not "${step}"`);
  if (run !== undefined && !(Number.isInteger(+run) && +run > 0))
    throw new UsageError(`--run must be a whole number from 1, not "${run}"`);
  if (rates !== undefined && rates !== 'none' && rates !== 'savitzky-golay')
    throw new UsageError(`--rates must be none or savitzky-golay, not "${rates}"`);
  if (scalar !== undefined && scalar !== 'first' && scalar !== 'last')
    throw new UsageError(`--scalar must be first or last, not "${scalar}"`);
  return {
    ...(units === undefined ? {} : { units: pairsOf('--units', units, 'alpha=deg,x=mm') }),
    ...(map === undefined ? {} : { map: pairsOf('--map', map, 'theta=yaw,x=pos_x') }),
    ...(step === undefined ? {} : { step: +step }),
    ...(time === undefined ? {} : { time }),
    ...(system === undefined ? {} : { system: system === 'none' ? null : system }),
    ...(run === undefined ? {} : { run: +run }),
    ...(body === undefined ? {} : { body }),
    ...(scalar === undefined ? {} : { scalar }),
    ...(rates === undefined ? {} : { rates }),
  };
}

function checkUnits({ units }: ImportChoices, { plan }: Motion): void {
  for (const key of Object.keys(units ?? {}))
    if (
      !plan.columns.some((c) => c.unitFrom === 'choice' && (sameName(c.name, key) || sameName(c.source, key))) &&
      !plan.columns.some((c) => c.role === 'time' && (sameName(c.name, key) || sameName(c.source, key)))
    )
      throw new UsageError(
        `--units: there is no column "${key}"; there are ${plan.columns.flatMap((c) => (c.name === null ? [] : [c.name])).join(', ')}`,
      );
}

const sameName = (a: string | null, b: string): boolean => a?.toLowerCase() === b.toLowerCase();

function write(out: string, file: string, { columns, data, rows, scenario }: Motion): void {
  const path = pathOf(out);
  let same = false;
  try {
    same = realpathSync(path) === realpathSync(file);
  } catch {
    // It is not there yet.
  }
  if (same) throw new UsageError(`${out} is the file to be read; name another one to write`);
  const first = data[0]![0]!;
  const shifted = [first === 0 ? data[0]! : data[0]!.map((t) => t - first), ...data.slice(1)];
  const ending = scenario === null ? '' : `# scenario: ${JSON.stringify(scenario)}\n`;
  const output = openOutput(out, file);
  try {
    output.write(csvHeader(columns));
    for (const piece of csvRows(shifted, 0, rows)) output.write(piece);
    output.write(ending);
    output.finish();
  } catch (error) {
    output.discard();
    throw error;
  }
}

function reportOf(result: Motion, choices: ImportChoices, name: string): object {
  const { plan, issues } = result;
  const attitude = plan.columns.filter((c) => c.role === 'attitude');
  const columns = result.columns.map((column) => {
    if (column === 't') return { name: 't', ...timeSource(result) };
    const own = plan.columns.find((c) => c.name === column);
    if (own) return { name: column, source: own.title || own.source, ...unitOf(own) };
    if (attitude.length > 0 && !column.endsWith('_dot'))
      return {
        name: column,
        source: attitude.map((c) => c.source).join(', '),
        unit: plan.euler ? attitude[0]!.unit : 'quaternion',
      };
    return { name: column, source: `differentiated ${column.replace(/_dot$/, '')}`, unit: 'SI' };
  });
  const listed = issues.slice(0, MOST_LISTED).map(described);
  if (issues.length > MOST_LISTED) listed.push(`and ${issues.length - MOST_LISTED} more`);
  const unused =
    choices.step !== undefined && plan.time.step === null ? ['the file has times: --step is not used'] : [];
  return {
    file: name,
    system: result.systemId,
    rows: result.rows,
    skipped: result.skippedRows,
    columns,
    time: {
      ...timeSource(result),
      form: plan.time.form,
      ...(plan.time.step === null ? {} : { step: plan.time.step }),
      first: result.data[0]![0],
      duration: result.data[0]!.at(-1)! - result.data[0]![0]!,
    },
    encoding: plan.encoding,
    separator: plan.separator,
    decimal: plan.decimal,
    notes: [
      ...result.notes,
      ...result.questions.map((q) => `question: ${q.text} Read as ${q.answers[q.safest]!.label}${hint(q.id)}.`),
      ...unused,
      ...listed,
    ],
  };
}

const HINTS: Record<string, string> = {
  degrees: '; --units NAME=deg says otherwise',
  lengths: '; --units NAME=mm says otherwise',
  'time-unit': '; --units t=ms says otherwise',
  'time-step': '; --step SECONDS says otherwise',
  'several-runs': '; --run NUMBER takes another',
  'several-bodies': '; --body NAME takes another',
  scalar: '; --scalar first or last says otherwise',
};
const hint = (id: string): string => HINTS[id] ?? '';

function timeSource({ plan }: Motion): { source: string | null; unit: string } {
  const { columns, unit } = plan.time;
  const names = columns
    .map((index) => plan.columns.find((c) => c.index === index))
    .map((c) => c?.title || c?.source || '');
  return { source: names.length > 0 ? names.join(' + ') : null, unit: unit || 's' };
}

function unitOf({ unit, kind, unitFrom }: ColumnPlan): { unit: string; assumed?: true } {
  return unit !== '' || unitFrom === 'choice'
    ? { unit }
    : { unit: SI_UNITS[kind], ...(kind === 'plain' ? {} : { assumed: true }) };
}

function described({
  line,
  to,
  column,
  message,
}: {
  line: number;
  to?: number;
  column: string;
  message: string;
}): string {
  const lines = line > 0 ? (to !== undefined ? `lines ${line} to ${to}` : `line ${line}`) : '';
  const place = [lines, column ? `column ${column}` : ''].filter(Boolean).join(', ');
  return place ? `${place}: ${message}` : message;
}
