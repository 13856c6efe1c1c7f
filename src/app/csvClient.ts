import type { CsvReply, CsvRequest, FileReading } from '../io/csv.worker.ts';

type WithoutId<T> = T extends unknown ? Omit<T, 'id'> : never;

export interface ReadOptions {
  /** Of a file without times, s. */
  timeStep?: number | undefined;
  /** Share of the file read (0 to 1), and rows so far. */
  onProgress?: (share: number, rows: number) => void;
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
    const reply = await this.ask({ type: 'read', file, ...(timeStep === undefined ? {} : { timeStep }) }, onProgress, signal);
    if (reply.type === 'cancelled') return null;
    if (reply.type !== 'read') throw new Error('the reader answered out of turn');
    return reply;
  }

  async write(columns: string[], data: Float64Array[], comments: string[]): Promise<string> {
    const reply = await this.ask({ type: 'write', columns, data, comments });
    if (reply.type !== 'written') throw new Error('the writer answered out of turn');
    return reply.text;
  }

  private ask(request: WithoutId<CsvRequest>, onProgress?: ReadOptions['onProgress'], signal?: AbortSignal): Promise<CsvReply> {
    const id = this.next++;
    this.worker ??= this.open();
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject, onProgress });
      this.worker!.postMessage({ ...request, id });
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
      for (const { reject } of this.waiting.values()) reject(new Error(`the file reader stopped unexpectedly${event.message ? ` (${event.message})` : ''}`));
      this.waiting.clear();
    });
    return worker;
  }
}
