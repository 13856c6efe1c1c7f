import { checkScenario } from '../../core/scenario/schema.ts';
import type { Scenario } from '../../core/scenario/types.ts';
import { judgeMotion } from '../../core/simulation/judge.ts';
import { csvHeader, csvRows, type CsvResult } from '../../csv/csv.ts';
import { CsvByteReader } from '../../csv/csvBytes.ts';
import { Transferred, type Caller, type Handlers } from '../remote/serve.ts';
import type { CsvCalls, FileReading, ReadProgress, ReadRequest } from './csvTypes.ts';
import { systemOf } from './load.ts';
import { metas } from './metas.ts';

/** Between two reports of progress, bytes. */
const REPORT_EVERY = 4e6;

export const calls: Handlers<CsvCalls> = {
  async 'csv.read'(request, caller) {
    const result = await readStream(request, caller);
    if (caller.signal.aborted) return null;
    if (result.kind !== 'motion') return { result, scenario: null, judgement: null };
    return new Transferred(
      await judged(result),
      result.data.map((column) => column.buffer as ArrayBuffer),
    );
  },
  'csv.write': ({ heading, data }) =>
    new Blob([heading ? csvHeader(heading.columns, heading.comments) : '', ...csvRows(data)]),
};

/** Piece by piece: of the file itself no more is in memory than one piece. Between two pieces the mailbox is looked at. */
async function readStream(
  { file, timeStep }: ReadRequest,
  { signal, emit }: Caller<ReadProgress, never>,
): Promise<CsvResult> {
  const reader = new CsvByteReader({ systems: metas, ...(timeStep === undefined ? {} : { timeStep }) }, file.size);
  const pieces = file.stream().getReader();
  let [done, reported] = [0, 0];
  for (;;) {
    const { value } = await pieces.read();
    if (!value || reader.ended || signal.aborted) break;
    reader.push(value);
    done += value.length;
    if (done - reported < REPORT_EVERY) continue;
    reported = done;
    emit({ share: done / file.size, rows: reader.rows });
    await new Promise((resume) => setTimeout(resume));
  }
  await pieces.cancel();
  return reader.finish();
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
