import type { Trajectory } from '../../core/motion/trajectory.ts';
import { RemoteWorker, WorkerLost, type WorkerLike } from '../remote/remoteWorker.ts';
import type { ImportChoices, Understanding } from '../../csv/plan.ts';
import type { CsvCalls, FileReading } from '../services/csvTypes.ts';
import { stopped } from './answer.ts';

/** Rows copied and written in one go: a few milliseconds of the page's time. */
const ROWS_PER_PART = 20_000;

export interface ReadOptions {
  /** Of a file without times, s. */
  timeStep?: number | undefined;
  /** What a person decided; with them, what names no system opens as data. */
  choices?: ImportChoices | undefined;
  /** Share of the file read (0 to 1), and rows so far. */
  onProgress?: (share: number, rows: number) => void;
  signal?: AbortSignal;
}

export interface WriteOptions {
  /** Share of the rows written (0 to 1), after each part. */
  onProgress?: (share: number) => void;
  signal?: AbortSignal;
}

/** CSV reading and writing in a worker of its own, opened when first needed. */
export class CsvClient {
  private readonly worker: RemoteWorker<CsvCalls>;

  constructor(start: () => WorkerLike) {
    this.worker = new RemoteWorker(start);
  }

  /** @returns null when it was cancelled */
  async read(file: Blob, { timeStep, choices, onProgress, signal }: ReadOptions = {}): Promise<FileReading | null> {
    const onEvent = onProgress && (({ share, rows }: { share: number; rows: number }) => onProgress(share, rows));
    try {
      const reading = await this.worker.call('csv.read', { file, timeStep, choices }, { onEvent, signal }).result;
      // It may have been read to its end before the worker heard that it was not wanted.
      return signal?.aborted ? null : reading;
    } catch (error) {
      if (signal?.aborted) return null;
      throw plain(error);
    }
  }

  /** What a file is understood as, from its beginning. */
  async understand(file: Blob, choices?: ImportChoices): Promise<Understanding> {
    try {
      return await this.worker.call('csv.understand', { file, choices }).result;
    } catch (error) {
      throw plain(error);
    }
  }

  /**
   * A trajectory as a CSV file, part by part: no more than one part is held twice. Rows that come meanwhile are not in it.
   * @returns null when it was cancelled
   */
  async write(trajectory: Trajectory, comments: string[], options: WriteOptions = {}): Promise<Blob[] | null> {
    const { length, generation } = trajectory;
    const columns = [...trajectory.columns];
    const parts: Blob[] = [];
    for (let from = 0; from < length; from += ROWS_PER_PART) {
      // Rows were let go meanwhile: the numbers of those that stay are others.
      if (trajectory.generation !== generation) return this.write(trajectory, comments, options);
      const data = columns.map((name) => trajectory.column(name)!.slice(from, Math.min(length, from + ROWS_PER_PART)));
      const part = await this.worker
        .call(
          'csv.write',
          { columns: from === 0 ? columns : null, data, comments: from + ROWS_PER_PART >= length ? comments : null },
          { transfer: data.map((column) => column.buffer as ArrayBuffer) },
        )
        .result.catch((error: unknown) => Promise.reject(plain(error)));
      if (options.signal?.aborted) return null;
      parts.push(part);
      options.onProgress?.(Math.min(1, (from + ROWS_PER_PART) / length));
    }
    return parts;
  }
}

/** In words for a person. */
const plain = (error: unknown): Error =>
  error instanceof WorkerLost
    ? new Error(stopped('the file reader', error))
    : error instanceof Error
      ? error
      : new Error(String(error));
