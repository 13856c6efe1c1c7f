import { checkScenario } from '../core/scenario/schema.ts';
import type { Scenario } from '../core/scenario/types.ts';
import { judgeMotion, type Judgement } from '../core/simulation/judge.ts';
import { loadSystem, systemViews } from '../core/systems/registry.ts';
import { csvHeader, csvRows, type CsvResult } from '../csv/csv.ts';
import { CsvByteReader } from '../csv/csvBytes.ts';

/** Reading, judging and writing large files off the main thread. Columns are transferred. */
export type CsvRequest =
  | { type: 'read'; id: number; file: Blob; timeStep?: number }
  /** Ends a reading; it is answered with `cancelled`. */
  | { type: 'cancel'; id: number }
  /** Some rows; those that begin a file have a heading. The data are transferred. */
  | { type: 'write'; id: number; heading: { columns: string[]; comments: string[] } | null; data: Float64Array[] };

/** What a file holds; with the scenario it came from, if it says so, its numbers can be judged. */
export interface FileReading {
  result: CsvResult;
  scenario: Scenario | null;
  judgement: Judgement | null;
}

export type CsvReply =
  | ({ type: 'read'; id: number } & FileReading)
  | { type: 'progress'; id: number; share: number; rows: number }
  | { type: 'cancelled'; id: number }
  | { type: 'written'; id: number; part: Blob }
  | { type: 'failed'; id: number; message: string };

const metas = Object.fromEntries(Object.entries(systemViews).map(([id, view]) => [id, view.meta]));
const port = self as unknown as { postMessage(message: CsvReply, transfer?: Transferable[]): void };

self.addEventListener('message', ({ data }: MessageEvent<CsvRequest>) => {
  void answer(data).catch((error: unknown) =>
    port.postMessage({ type: 'failed', id: data.id, message: error instanceof Error ? error.message : String(error) }),
  );
});

/** Readings that go on. */
const going = new Set<number>();
/** Between two reports of progress, bytes. */
const REPORT_EVERY = 4e6;

async function answer(data: CsvRequest): Promise<void> {
  if (data.type === 'cancel') {
    going.delete(data.id);
    return;
  }
  if (data.type === 'write') {
    const { heading } = data;
    port.postMessage({
      type: 'written',
      id: data.id,
      part: new Blob([heading ? csvHeader(heading.columns, heading.comments) : '', ...csvRows(data.data)]),
    });
    return;
  }
  going.add(data.id);
  const reading = await read(data.file, data.timeStep, data.id);
  if (!going.delete(data.id)) return port.postMessage({ type: 'cancelled', id: data.id });
  const { result } = reading;
  const transfer = result.kind === 'motion' ? result.data.map((column) => column.buffer as ArrayBuffer) : [];
  port.postMessage({ type: 'read', id: data.id, ...reading }, transfer);
}

async function read(file: Blob, timeStep: number | undefined, id: number): Promise<FileReading> {
  const result = await readStream(file, timeStep, id);
  const scenario = result.kind === 'motion' ? scenarioIn(result) : null;
  const system = scenario ? await loadSystem(scenario.system) : undefined;
  if (result.kind !== 'motion' || !scenario || !system) return { result, scenario, judgement: null };
  const column = (name: string): Float64Array | undefined => result.data[result.columns.indexOf(name)];
  return { result, scenario, judgement: judgeMotion(system, scenario.parameters, scenario.constraints, column) };
}

/** Piece by piece: of the file itself no more is in memory than one piece. Between two pieces the mailbox is looked at. */
async function readStream(file: Blob, timeStep: number | undefined, id: number): Promise<CsvResult> {
  const reader = new CsvByteReader({ systems: metas, ...(timeStep === undefined ? {} : { timeStep }) }, file.size);
  const pieces = file.stream().getReader();
  let [done, reported] = [0, 0];
  for (;;) {
    const { value } = await pieces.read();
    if (!value || reader.ended || !going.has(id)) break;
    reader.push(value);
    done += value.length;
    if (done - reported < REPORT_EVERY) continue;
    reported = done;
    port.postMessage({ type: 'progress', id, share: done / file.size, rows: reader.rows });
    await new Promise((resume) => setTimeout(resume));
  }
  await pieces.cancel();
  return reader.finish();
}

/** A comment is no promise: what is not a scenario of this system is left aside, and the numbers play without it. */
function scenarioIn(result: Extract<CsvResult, { kind: 'motion' }>): Scenario | null {
  if (result.scenario === null) return null;
  try {
    const scenario = checkScenario(result.scenario, metas);
    return scenario.system === result.systemId ? scenario : null;
  } catch {
    return null;
  }
}
