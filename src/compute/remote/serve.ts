/** The worker's end of remote calls. */
import type { Calls, Endpoint, ErrorData, FromWorker, ToWorker } from './protocol.ts';

/** What a service is given with a request. */
export interface Caller<Event, Update> {
  /** Aborted when the page gives the call up: a service that computes long looks at it in every turn of its own. */
  readonly signal: AbortSignal;
  /** Tells the page something before the answer. */
  readonly emit: (event: Event, transfer?: Transferable[]) => void;
  /** Hears what the page says to the call; what it said before is heard at once. */
  readonly onUpdate: (listener: (update: Update) => void) => void;
}

/** A service's calls, as functions. */
export type Handlers<T extends Calls<T>> = {
  [K in keyof T]: (
    request: T[K]['request'],
    caller: Caller<T[K]['event'], T[K]['update']>,
  ) => T[K]['result'] | Transferred<T[K]['result']> | Promise<T[K]['result'] | Transferred<T[K]['result']>>;
};

/** A result with buffers that move to the page in place of being copied. */
export class Transferred<Result> {
  readonly result: Result;
  readonly transfer: Transferable[];
  constructor(result: Result, transfer: Transferable[]) {
    this.result = result;
    this.transfer = transfer;
  }
}

/** A service is loaded by the first call that names it. */
export type Loaders = Readonly<Record<string, () => Promise<Readonly<Record<string, unknown>>>>>;

type Asked = Extract<ToWorker, { kind: 'call' }>;
type AnyHandler = (request: unknown, caller: Caller<unknown, unknown>) => unknown;

/**
 * Answers the calls that arrive at an endpoint, each with one result or one error; calls run side by side.
 *
 * @param loaders by service, the part of a call's name before its dot
 */
export function serve(endpoint: Endpoint, loaders: Loaders): void {
  const open = new Map<number, OpenCall>();
  const post = (message: FromWorker, transfer: Transferable[] = []): void => endpoint.postMessage(message, transfer);
  endpoint.addEventListener('messageerror', () => post({ kind: 'unreadable' }));
  endpoint.addEventListener('message', ({ data }: MessageEvent<ToWorker>) => {
    if (data.kind === 'call') return void answer(data);
    const call = open.get(data.call);
    if (data.kind === 'update') return call?.update(data.update);
    // A call that is dropped is no longer open: what it still says is not sent.
    if (data.kind === 'drop') open.delete(data.call);
    call?.controller.abort();
  });

  async function answer({ call: number, name, request, channel: named }: Asked): Promise<void> {
    const channel = named === undefined ? null : new BroadcastChannel(named);
    const say = (message: FromWorker, transfer?: Transferable[]): void => {
      if (open.get(number) !== call) return;
      if (channel) channel.postMessage(message);
      else post(message, transfer);
    };
    const call = new OpenCall((event, transfer) => say({ kind: 'event', call: number, event }, transfer));
    open.set(number, call);
    try {
      const handler = await handlerOf(loaders, name);
      const answered = await handler(request, call);
      const { result, transfer } = answered instanceof Transferred ? answered : new Transferred(answered, []);
      say({ kind: 'result', call: number, result }, transfer);
    } catch (error) {
      say({ kind: 'error', call: number, error: errorData(error) });
    }
    open.delete(number);
    channel?.close();
  }
}

class OpenCall implements Caller<unknown, unknown> {
  readonly controller = new AbortController();
  readonly signal = this.controller.signal;
  readonly emit: Caller<unknown, unknown>['emit'];
  private listener: ((update: unknown) => void) | null = null;
  private early: unknown[] = [];

  constructor(emit: Caller<unknown, unknown>['emit']) {
    this.emit = emit;
  }

  update(update: unknown): void {
    if (this.listener) this.listener(update);
    else this.early.push(update);
  }

  readonly onUpdate: Caller<unknown, unknown>['onUpdate'] = (listener) => {
    this.listener = listener;
    for (const update of this.early.splice(0)) listener(update);
  };
}

async function handlerOf(loaders: Loaders, name: string): Promise<AnyHandler> {
  const service = name.slice(0, name.indexOf('.'));
  const handlers = Object.hasOwn(loaders, service) ? await loaders[service]!() : {};
  if (!Object.hasOwn(handlers, name)) throw new Error(`there is no call "${name}"`);
  return handlers[name] as AnyHandler;
}

function errorData(error: unknown): ErrorData {
  if (!(error instanceof Error)) return { name: 'Error', message: String(error), path: '' };
  const path = 'path' in error && typeof error.path === 'string' ? error.path : '';
  return { name: error.name, message: error.message, path };
}
