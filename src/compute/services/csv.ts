import { systemNamed } from '../../core/scenario/own.ts';
import { checkScenario } from '../../core/scenario/schema.ts';
import type { Scenario } from '../../core/scenario/types.ts';
import { judgeMotion } from '../../core/simulation/judge.ts';
import { csvComments, csvHeader, csvRows, type CsvResult } from '../../csv/csv.ts';
import { ENDING, readStream, scenarioIn as scenarioBehind, understandStream } from '../../csv/reading/stream.ts';
import { Transferred, type Caller, type Handlers } from '../remote/serve.ts';
import type { CsvCalls, FileReading, ReadProgress, ReadRequest } from './csvTypes.ts';
import { systemOf } from './load.ts';
import { learnSystemOf } from '../../core/systems/registry.ts';
import { metas } from './metas.ts';

/** Between two reports of progress, bytes. */
const REPORT_EVERY = 4e6;

export const calls: Handlers<CsvCalls> = {
  async 'csv.read'(request, caller) {
    const result = await readFile(request, caller);
    if (caller.signal.aborted) return null;
    if (result.kind !== 'motion') return { result, scenario: null, judgement: null };
    return new Transferred(
      await judged(result),
      result.data.map((column) => column.buffer as ArrayBuffer),
    );
  },
  'csv.understand': async ({ file, choices }) =>
    understandStream(file.stream(), {
      systems: metas,
      data: true,
      preferred: await systemBehind(file),
      ...(choices ? { choices } : {}),
    }),
  'csv.write': ({ columns, data, comments }) =>
    new Blob([columns ? csvHeader(columns) : '', ...csvRows(data), comments ? csvComments(comments) : '']),
};

/** Between two pieces the mailbox is looked at. */
async function readFile(
  { file, timeStep, choices }: ReadRequest,
  { signal, emit }: Caller<ReadProgress, never>,
): Promise<CsvResult> {
  let reported = 0;
  const preferred = await systemBehind(file);
  return readStream(file.stream(), {
    systems: metas,
    size: file.size,
    preferred,
    ...(timeStep === undefined ? {} : { timeStep }),
    ...(choices ? { choices, data: true } : {}),
    after: (bytes, rows) => {
      if (bytes - reported < REPORT_EVERY) return signal.aborted;
      reported = bytes;
      // Unpacked there may be more of it than the file's size.
      emit({ share: Math.min(1, bytes / file.size), rows });
      return new Promise<boolean>((resume) => setTimeout(() => resume(signal.aborted)));
    },
  });
}

async function systemBehind(file: Blob): Promise<string | null> {
  const scenario = scenarioBehind(new Uint8Array(await file.slice(-ENDING).arrayBuffer()));
  // A description that can't be read leaves the table without its system, as any other comment that is no scenario.
  await learnSystemOf(scenario).catch(() => {});
  return systemNamed(scenario);
}

type Motion = Extract<CsvResult, { kind: 'motion' }>;

async function judged(result: Motion): Promise<FileReading> {
  const scenario = scenarioIn(result);
  if (!scenario) return { result, scenario, judgement: null };
  const column = (name: string): Float64Array | undefined => result.data[result.columns.indexOf(name)];
  const judgement = judgeMotion(await systemOf(scenario), scenario.parameters, scenario.constraints, column);
  return { result, scenario, judgement };
}

/** A comment is no promise: what is not a scenario of this system is left aside, and the numbers play without it. */
function scenarioIn(result: Motion): Scenario | null {
  if (result.scenario === null) return null;
  try {
    const scenario = checkScenario(result.scenario, metas);
    return scenario.system === result.systemId ? scenario : null;
  } catch {
    return null;
  }
}
