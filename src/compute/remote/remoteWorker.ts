/** The page's end of remote calls. */
import type { Calls, Endpoint, ErrorData, FromWorker, ToWorker } from './protocol.ts';

/** A `Worker`, or what stands for one in a test. */
export interface WorkerLike extends Endpoint {
  addEventListener(type: 'message' | 'messageerror', listener: (event: MessageEvent) => void): void;
  addEventListener(type: 'error', listener: (event: { message?: string }) => void): void;
  terminate(): void;
}

export interface CallOptions<Event> {
  onEvent?: ((event: Event) => void) | undefined;
  /** Aborting asks the worker to end the call with an answer: a partial result, or an error. */
  signal?: AbortSignal | undefined;
  transfer?: Transferable[] | undefined;
  /**
   * Heard at once after a key too. After a press browsers hold back a worker's messages until the page has drawn (up to 50 ms in
   * Chromium), but not those of a broadcast channel; their buffers are copied in place of being moved.
   */
  prompt?: boolean | undefined;
}

/** A call under way. */
export interface OngoingCall<Result, Update> {
  /** Rejected with `RemoteError`, `WorkerLost`, or a `DOMException` named `AbortError` when aborted early or dropped. */
  result: Promise<Result>;
  /** Says something to the call; after its answer this does nothing. */
  update(update: Update): void;
  /** Gives the call up without an answer: nothing more is heard of it. */
  drop(): void;
}

/** An error thrown by a service: its name, its message and, of a `ScenarioError`, its path. */
export class RemoteError extends Error {
  readonly path: string;
  constructor({ name, message, path }: ErrorData) {
    super(message);
    this.name = name;
    this.path = path;
  }
}

/** The worker died, fell silent or could not be understood; the next call gets a new one. `message` says which, or is empty. */
export class WorkerLost extends Error {
  override readonly name = 'WorkerLost';
}

/** How long a worker may take to answer an abort; a run looks at its mailbox every 4 ms. */
const PATIENCE_MS = 3000;

interface Pending {
  resolve(result: unknown): void;
  reject(error: Error): void;
  onEvent: ((event: never) => void) | undefined;
  /** Takes back what the call left behind: its listener and its watchdog. */
  forget(): void;
}

/** One worker, started by the first call and, once lost, again by the next. */
export class RemoteWorker<T extends Calls<T>> {
  private readonly start: () => WorkerLike;
  private readonly patience: number;
  private worker: WorkerLike | null = null;
  private next = 1;
  private readonly pending = new Map<number, Pending>();

  /** @param patience from an abort to the worker's end if it does not answer, ms */
  constructor(start: () => WorkerLike, patience = PATIENCE_MS) {
    this.start = start;
    this.patience = patience;
  }

  call<K extends keyof T & string>(
    name: K,
    request: T[K]['request'],
    { onEvent, signal, transfer = [], prompt = false }: CallOptions<T[K]['event']> = {},
  ): OngoingCall<T[K]['result'], T[K]['update']> {
    const call = this.next++;
    const result = new Promise<T[K]['result']>((resolve, reject) => {
      if (signal?.aborted) return reject(aborted());
      let watchdog: ReturnType<typeof setTimeout> | undefined;
      const abort = (): void => {
        this.post({ kind: 'abort', call });
        watchdog = setTimeout(() => this.lose('it did not answer'), this.patience);
      };
      const channel = prompt && typeof BroadcastChannel === 'function' ? this.channel() : null;
      const forget = (): void => {
        channel?.close();
        signal?.removeEventListener('abort', abort);
        clearTimeout(watchdog);
      };
      this.pending.set(call, { resolve, reject, onEvent, forget });
      signal?.addEventListener('abort', abort);
      try {
        this.post({ kind: 'call', call, name, request, channel: channel?.name }, transfer);
      } catch (error) {
        // The worker could not be started, or the request cannot be sent.
        this.take(call)?.reject(error instanceof Error ? error : new Error(String(error)));
      }
    });
    return {
      result,
      update: (update) => void (this.pending.has(call) && this.post({ kind: 'update', call, update })),
      drop: () => {
        const dropped = this.take(call);
        if (!dropped) return;
        this.post({ kind: 'drop', call });
        dropped.reject(aborted());
      },
    };
  }

  /** Ends the worker; calls under way are dropped. */
  close(): void {
    this.end(aborted());
  }

  /** Of this call alone: other pages of the same origin hear every name. */
  private channel(): BroadcastChannel {
    const channel = new BroadcastChannel(`ripstik.call.${crypto.getRandomValues(new Uint32Array(4)).join('.')}`);
    channel.onmessage = ({ data }: MessageEvent<FromWorker>) => this.receive(data);
    channel.onmessageerror = () => this.lose('a message could not be read');
    return channel;
  }

  private post(message: ToWorker, transfer: Transferable[] = []): void {
    this.worker ??= this.open();
    this.worker.postMessage(message, transfer);
  }

  private open(): WorkerLike {
    const worker = this.start();
    const ifCurrent = (what: () => void): void => void (worker === this.worker && what());
    worker.addEventListener('message', ({ data }: MessageEvent<FromWorker>) => ifCurrent(() => this.receive(data)));
    worker.addEventListener('error', ({ message }) => ifCurrent(() => this.lose(message ?? '')));
    worker.addEventListener('messageerror', () => ifCurrent(() => this.lose('a message could not be read')));
    return worker;
  }

  private receive(message: FromWorker): void {
    switch (message.kind) {
      case 'event':
        return this.pending.get(message.call)?.onEvent?.(message.event as never);
      case 'result':
        return this.take(message.call)?.resolve(message.result);
      case 'error':
        return this.take(message.call)?.reject(new RemoteError(message.error));
      case 'unreadable':
        return this.lose('a message could not be read');
    }
  }

  private lose(why: string): void {
    this.end(new WorkerLost(why));
  }

  private end(error: Error): void {
    this.worker?.terminate();
    this.worker = null;
    for (const call of [...this.pending.keys()]) this.take(call)!.reject(error);
  }

  /** A call that is over: no answer is taken for it twice. */
  private take(call: number): Pending | undefined {
    const pending = this.pending.get(call);
    this.pending.delete(call);
    pending?.forget();
    return pending;
  }
}

const aborted = (): DOMException => new DOMException('given up', 'AbortError');
