import { existsSync, realpathSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { pathToFileURL } from 'node:url';
import { Worker } from 'node:worker_threads';
import '../core/simulation/everyMotion.ts';
import { checkMeasures, type StudyRow } from '../core/sweep/runOne.ts';
import { systemMetas } from '../core/systems/registry.ts';
import { Journal } from './journal.ts';
import { openOutput } from './output.ts';
import { loadStudy } from './study.ts';
import { csvTable, factsOf, parquetTable } from './studyTable.ts';
import type { Say } from './sweepWorker.ts';
import { UsageError, pathOf, readText } from './usage.ts';

export interface SweepOptions {
  out: string | undefined;
  /** `2/8`: the second of eight parts. */
  shard: string | undefined;
  /** Threads; absent: one a core. */
  workers: string | undefined;
  /** Go on with an interrupted sweep; nothing to do where it is finished. */
  resume: boolean;
}

/** Runs that a worker is given at once; fewer near the end, so that none waits long for another. */
const BATCH = 16;
/** Between two lines of progress: on a terminal, and where it is kept, ms. */
const TELL_MS = [250, 10_000] as const;
/** Rows that are kept in memory until the table is written; more would end the program after hours of work. */
const MOST_ROWS = 4_000_000;
/** Refused runs that are told with their reason. */
const MOST_TOLD = 5;

/**
 * Carries a study out: one row a run, by index, into a Parquet or CSV file that appears when all of it is there.
 *
 * @param name of the study, `-` for standard input
 * @returns 0, or 130 where it was interrupted
 * @throws UsageError, ScenarioError
 */
export async function sweep(name: string | undefined, options: SweepOptions): Promise<number> {
  if (!name) throw new UsageError('which study? Name a JSON file');
  const { out } = options;
  if (!out || !/\.(parquet|csv)$/.test(out))
    throw new UsageError('--out must name a file that ends in .parquet or .csv');
  const [part, parts] = shardOf(options.shard);
  const text = readText(name);
  const { study, written, system } = await loadStudy(text);
  checkMeasures(study, system, systemMetas);
  const rowsOfPart = Math.ceil((study.runs - part + 1) / parts);
  if (rowsOfPart > MOST_ROWS)
    throw new UsageError(
      `${rowsOfPart} runs are more than one table takes, ${MOST_ROWS}; split the study: --shard 1/${Math.ceil(study.runs / MOST_ROWS)}, and so on`,
    );
  const facts = { study: written, shard: `${part}/${parts}` };
  const path = pathOf(out);
  if (options.resume && existsSync(path) && !existsSync(`${path}.unfinished`)) {
    if (JSON.stringify(factsOf(path)) !== JSON.stringify(facts))
      throw new UsageError(`${out} is not of this study and shard: name another --out, or leave --resume out`);
    process.stderr.write(`sweep: ${out} is finished already\n`);
    return 0;
  }
  const journal = new Journal(path, out, facts, options.resume);
  const open: number[] = [];
  for (let index = part - 1; index < study.runs; index += parts) if (!journal.rows.has(index)) open.push(index);
  const progress = new Progress(journal.rows.size + open.length, journal.rows.size);
  let finished: boolean;
  try {
    finished = await computeAll(text, open, workersOf(options.workers, open.length), (row) => {
      journal.add(row);
      progress.tell(journal.rows.size);
    });
  } catch (error) {
    journal.close();
    throw error;
  }
  if (!finished) {
    journal.close();
    process.stderr.write(`sweep: interrupted; ${journal.rows.size} runs are kept: --resume goes on\n`);
    return 130;
  }
  const rows = [...journal.rows.values()].sort((a, b) => a.index - b.index);
  const output = openOutput(out, name);
  try {
    output.write(path.endsWith('.csv') ? csvTable(study, rows, facts) : parquetTable(study, rows, facts));
    output.finish();
  } catch (error) {
    output.discard();
    journal.close();
    throw error;
  }
  journal.remove();
  tellRefused(rows);
  return 0;
}

function shardOf(shard: string | undefined): [part: number, parts: number] {
  const [, part, parts] = /^(\d+)\/(\d+)$/.exec(shard ?? '1/1') ?? [];
  if (!(Number(part) >= 1 && Number(part) <= Number(parts)))
    throw new UsageError(`--shard must be as 2/8, the second of eight parts, not "${shard!}"`);
  return [Number(part), Number(parts)];
}

function workersOf(given: string | undefined, runs: number): number {
  const workers = given === undefined ? availableParallelism() : Number(given);
  if (!(Number.isInteger(workers) && workers >= 1))
    throw new UsageError(`--workers must be a whole number from 1, not "${given!}"`);
  return Math.min(workers, runs);
}

/** This program again, in a thread. A thread does not inherit the loader that reads TypeScript: from sources it is given one. */
function startWorker(study: string): Worker {
  const program = realpathSync(process.argv[1]!);
  if (!program.endsWith('.ts')) return new Worker(program, { workerData: study });
  const urls = [import.meta.resolve('tsx/esm/api'), pathToFileURL(program).href].map((url) => JSON.stringify(url));
  const code = `import(${urls[0]!}).then(({ register }) => { register(); return import(${urls[1]!}); })`;
  return new Worker(code, { eval: true, workerData: study });
}

/** @returns whether all of them were computed; false after a signal */
async function computeAll(
  study: string,
  open: readonly number[],
  count: number,
  take: (row: StudyRow) => void,
): Promise<boolean> {
  const workers = Array.from({ length: count }, () => startWorker(study));
  let next = 0;
  let interrupted = (): void => {};
  const signalled = new Promise<boolean>((resolve) => (interrupted = () => resolve(false)));
  process.once('SIGINT', interrupted).once('SIGTERM', interrupted);
  const work = (worker: Worker): Promise<void> =>
    new Promise((resolve, reject) => {
      worker.on('error', reject);
      worker.on('exit', () => reject(new Error('a worker ended before its runs were done')));
      worker.on('message', (said: Say) => {
        try {
          if (said !== 'idle') return take(said);
        } catch (error) {
          return reject(error as Error);
        }
        if (next >= open.length) return resolve();
        const size = Math.max(1, Math.min(BATCH, Math.floor((open.length - next) / (4 * count))));
        worker.postMessage(open.slice(next, next + size));
        next += size;
      });
    });
  try {
    return await Promise.race([signalled, Promise.all(workers.map(work)).then(() => true)]);
  } finally {
    process.removeListener('SIGINT', interrupted).removeListener('SIGTERM', interrupted);
    await Promise.all(workers.map((worker) => worker.terminate()));
  }
}

/** How many runs are done, on standard error. */
class Progress {
  private readonly total: number;
  private readonly before: number;
  private readonly terminal = process.stderr.isTTY;
  private readonly began = performance.now();
  private told = performance.now();

  /** @param before done in an earlier call */
  constructor(total: number, before: number) {
    this.total = total;
    this.before = before;
  }

  tell(done: number): void {
    const now = performance.now();
    const last = done === this.total;
    if (now - this.told < TELL_MS[this.terminal ? 0 : 1] && !last) return;
    this.told = now;
    const rate = (done - this.before) / Math.max(1e-3, (now - this.began) / 1000);
    const left = last ? '' : `, about ${Math.ceil((this.total - done) / rate)} s left`;
    const line = `sweep: ${done} of ${this.total} runs, ${rate.toFixed(1)} a second${left}`;
    process.stderr.write(this.terminal ? `\r\x1b[K${line}${last ? '\n' : ''}` : `${line}\n`);
  }
}

function tellRefused(rows: readonly StudyRow[]): void {
  const refused = rows.filter(({ reason }) => reason === 'refused');
  for (const { index, message } of refused.slice(0, MOST_TOLD))
    process.stderr.write(`sweep: run ${index} was refused: ${message}\n`);
  if (refused.length > MOST_TOLD) process.stderr.write(`sweep: and ${refused.length - MOST_TOLD} more\n`);
}
