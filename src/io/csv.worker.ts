import { checkScenario } from '../core/scenario/schema.ts';
import type { Scenario } from '../core/scenario/types.ts';
import { judgeMotion, type Judgement } from '../core/simulation/judge.ts';
import { loadSystem } from '../core/systems/loaders.ts';
import { systemViews } from '../core/systems/views.ts';
import { readCsv, writeCsv, type CsvResult } from './csv.ts';

/** Reading, judging and writing large files off the main thread. Columns are transferred. */
export type CsvRequest =
  | { type: 'read'; id: number; text: string; timeStep?: number }
  | { type: 'write'; id: number; columns: string[]; data: Float64Array[]; comments: string[] };

/** What a file holds; with the scenario it came from, if it says so, its numbers can be judged. */
export interface FileReading {
  result: CsvResult;
  scenario: Scenario | null;
  judgement: Judgement | null;
}

export type CsvReply =
  | ({ type: 'read'; id: number } & FileReading)
  | { type: 'written'; id: number; text: string }
  | { type: 'failed'; id: number; message: string };

const metas = Object.fromEntries(Object.entries(systemViews).map(([id, view]) => [id, view.meta]));
const port = self as unknown as { postMessage(message: CsvReply, transfer?: Transferable[]): void };

self.addEventListener('message', ({ data }: MessageEvent<CsvRequest>) => {
  void answer(data).catch((error: unknown) => port.postMessage({ type: 'failed', id: data.id, message: error instanceof Error ? error.message : String(error) }));
});

async function answer(data: CsvRequest): Promise<void> {
  if (data.type === 'write') {
    port.postMessage({ type: 'written', id: data.id, text: writeCsv(data.columns, data.data, data.comments) });
    return;
  }
  const reading = await read(data.text, data.timeStep);
  const { result } = reading;
  const transfer = result.kind === 'motion' ? result.data.map((column) => column.buffer as ArrayBuffer) : [];
  port.postMessage({ type: 'read', id: data.id, ...reading }, transfer);
}

async function read(text: string, timeStep: number | undefined): Promise<FileReading> {
  const result = readCsv(text, { systems: metas, timeStep });
  const scenario = result.kind === 'motion' ? scenarioIn(result) : null;
  const system = scenario ? await loadSystem(scenario.system) : undefined;
  if (result.kind !== 'motion' || !scenario || !system) return { result, scenario, judgement: null };
  const column = (name: string): Float64Array | undefined => result.data[result.columns.indexOf(name)];
  return { result, scenario, judgement: judgeMotion(system, scenario.parameters, scenario.constraints, column) };
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
