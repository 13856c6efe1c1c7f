import type { Trajectory } from '../core/motion/trajectory.ts';
import type { CsvReply, CsvRequest, FileReading } from './csv.worker.ts';

/** Rows copied and written in one go: a few milliseconds of the page's time. */
const ROWS_PER_PART = 20_000;

type WithoutId<T> = T extends unknown ? Omit<T, 'id'> : never;

export interface ReadOptions {
  /** Of a file without times, s. */
  timeStep?: number | undefined;
  /** Share of the file read (0 to 1), and rows so far. */
  onProgress?: (share: number, rows: number) => void;
  signal?: AbortSignal;
}

export interface WriteOptions {
  /** Share of the rows written (0 to 1), after each part. */
  onProgress?: (share: number) => void;
  signal?: AbortSignal;
}

interface Waiting {
  resolve(reply: CsvReply): void;
  reject(error: Error): void;
  onProgress: ReadOptions['onProgress'];
}

/** CSV reading and writing in a worker of its own, opened when first needed. */
export class CsvClient {
  private readonly create: () => Worker;
  private worker: Worker | null = null;
  private next = 1;
  private readonly waiting = new Map<number, Waiting>();

  constructor(create: () => Worker) {
    this.create = create;
  }

  /** @returns null when it was cancelled */
  async read(file: Blob, { timeStep, onProgress, signal }: ReadOptions = {}): Promise<FileReading | null> {
    const reply = await this.ask(
      { type: 'read', file, ...(timeStep === undefined ? {} : { timeStep }) },
      { ...(onProgress ? { onProgress } : {}), ...(signal ? { signal } : {}) },
    );
    if (reply.type === 'cancelled') return null;
    if (reply.type !== 'read') throw new Error('the reader answered out of turn');
    return reply;
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
      const reply = await this.ask(
        { type: 'write', heading: from === 0 ? { columns, comments } : null, data },
        { transfer: data.map((column) => column.buffer as ArrayBuffer) },
      );
      if (reply.type !== 'written') throw new Error('the writer answered out of turn');
      if (options.signal?.aborted) return null;
      parts.push(reply.part);
      options.onProgress?.(Math.min(1, (from + ROWS_PER_PART) / length));
    }
    return parts;
  }

  private ask(
    request: WithoutId<CsvRequest>,
    { onProgress, signal, transfer = [] }: Omit<ReadOptions, 'timeStep'> & { transfer?: Transferable[] } = {},
  ): Promise<CsvReply> {
    const id = this.next++;
    this.worker ??= this.open();
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject, onProgress });
      this.worker!.postMessage({ ...request, id }, transfer);
      signal?.addEventListener('abort', () => this.worker?.postMessage({ type: 'cancel', id } satisfies CsvRequest));
    });
  }

  private open(): Worker {
    const worker = this.create();
    worker.addEventListener('message', ({ data }: MessageEvent<CsvReply>) => {
      const waiting = this.waiting.get(data.id);
      if (data.type === 'progress') return waiting?.onProgress?.(data.share, data.rows);
      this.waiting.delete(data.id);
      if (data.type === 'failed') waiting?.reject(new Error(data.message));
      else waiting?.resolve(data);
    });
    worker.addEventListener('error', (event) => {
      worker.terminate();
      this.worker = null;
      for (const { reject } of this.waiting.values())
        reject(new Error(`the file reader stopped unexpectedly${event.message ? ` (${event.message})` : ''}`));
      this.waiting.clear();
    });
    return worker;
  }
}
