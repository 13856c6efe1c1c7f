/** A worker on this thread: the real services or a test's, behind a real message channel, which clones and transfers. */
import type { Handlers, Loaders } from '../../src/compute/remote/serve.ts';
import { serve } from '../../src/compute/remote/serve.ts';
import type { WorkerLike } from '../../src/compute/remote/remoteWorker.ts';
import { services } from '../../src/compute/services/services.ts';

type Listener = (event: never) => void;

export class NearWorker implements WorkerLike {
  terminated = false;
  /** What the page sent, as it was sent. */
  readonly sent: unknown[] = [];
  private readonly port: MessagePort;
  private readonly inner: MessagePort;

  constructor(loaders: Loaders = services) {
    const { port1, port2 } = new MessageChannel();
    [this.port, this.inner] = [port1, port2];
    serve(port2, loaders);
    port1.start();
    port2.start();
  }

  postMessage(message: unknown, transfer: Transferable[]): void {
    if (this.terminated) return;
    this.sent.push(message);
    this.port.postMessage(message, transfer);
  }

  addEventListener(type: string, listener: Listener): void {
    this.port.addEventListener(type, listener as EventListener);
  }

  terminate(): void {
    this.terminated = true;
    this.port.close();
    this.inner.close();
  }

  /** As a crash reports itself. */
  die(message: string): void {
    this.port.dispatchEvent(Object.assign(new Event('error'), { message }));
  }

  /** As a message that cannot be read: on the page's side, or on the worker's. */
  garble(side: 'page' | 'worker'): void {
    (side === 'page' ? this.port : this.inner).dispatchEvent(new Event('messageerror'));
  }
}

/** Starts the workers given, in their order, then fresh ones of the real services. */
export const starts =
  (...workers: NearWorker[]) =>
  (): NearWorker =>
    workers.shift() ?? new NearWorker();

/** A worker with one service of the test. */
export const serving = <T extends Record<keyof T, never>>(service: string, calls: Partial<Handlers<T>>): NearWorker =>
  new NearWorker({ [service]: () => Promise.resolve(calls) });

export const turn = (): Promise<void> => new Promise((done) => setTimeout(done, 2));
