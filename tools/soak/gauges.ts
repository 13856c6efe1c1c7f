/** What is measured of a page while it works: memory, nodes, listeners, workers, graphics, and tasks that held it up. */
import { readFileSync } from 'node:fs';
import type { CDPSession, Page } from '@playwright/test';

export interface Reading {
  /** Bytes of script objects, of the code compiled for them, and of the buffers they hold (columns, meshes). */
  objects: number;
  code: number;
  buffers: number;
  nodes: number;
  listeners: number;
  workers: number;
  /** Workers beside another of the same purpose: each purpose keeps one, from its first call on. */
  doubles: number;
  geometries: number;
  textures: number;
  programs: number;
}

export class Gauges {
  private readonly page: Page;
  private readonly session: CDPSession;

  private constructor(page: Page, session: CDPSession) {
    this.page = page;
    this.session = session;
  }

  static async of(page: Page): Promise<Gauges> {
    return new Gauges(page, await page.context().newCDPSession(page));
  }

  /** Buffers as they are, in bytes. */
  async buffers(): Promise<number> {
    const { backingStorageSize = 0 } = (await this.session.send('Runtime.getHeapUsage')) as {
      backingStorageSize?: number;
    };
    return backingStorageSize;
  }

  /** Bytes of what can be reached, by kind: the engine goes on compiling for hours, which says nothing about what the page holds. */
  private async reachable(): Promise<{ objects: number; code: number }> {
    const parts: string[] = [];
    const listen = ({ chunk }: { chunk: string }): void => void parts.push(chunk);
    this.session.on('HeapProfiler.addHeapSnapshotChunk', listen);
    await this.session.send('HeapProfiler.takeHeapSnapshot', { reportProgress: false });
    this.session.off('HeapProfiler.addHeapSnapshotChunk', listen);
    const {
      snapshot: { meta },
      nodes,
    } = JSON.parse(parts.join('')) as {
      snapshot: { meta: { node_fields: string[]; node_types: [string[]] } };
      nodes: number[];
    };
    const [kinds, width, size] = [meta.node_types[0], meta.node_fields.length, meta.node_fields.indexOf('self_size')];
    const sum = new Map<string, number>();
    // The kind comes first.
    for (let i = 0; i < nodes.length; i += width)
      sum.set(kinds[nodes[i]!]!, (sum.get(kinds[nodes[i]!]!) ?? 0) + nodes[i + size]!);
    const of = (...names: string[]): number => names.reduce((total, name) => total + (sum.get(name) ?? 0), 0);
    return {
      objects: of(
        'object',
        'array',
        'string',
        'concatenated string',
        'sliced string',
        'closure',
        'number',
        'symbol',
        'bigint',
        'regexp',
        'object shape',
      ),
      code: of('code'),
    };
  }

  /** After everything unreachable has been collected. */
  async read(): Promise<Reading> {
    const { page, session } = this;
    // Twice: what a finalizer lets go is collected by the second.
    for (let k = 0; k < 2; k++) await session.send('HeapProfiler.collectGarbage');
    const { nodes, jsEventListeners } = await session.send('Memory.getDOMCounters');
    const {
      geometries = 0,
      textures = 0,
      programs = 0,
    } = await page.evaluate(() => window.ripstikScene?.stats() ?? ({} as Partial<Reading>));
    // One that is just ending says nothing any more.
    const purposes = await Promise.all(
      page.workers().map((worker) => worker.evaluate(() => self.name).catch(() => crypto.randomUUID())),
    );
    return {
      ...(await this.reachable()),
      buffers: await this.buffers(),
      nodes,
      listeners: jsEventListeners,
      workers: purposes.length,
      doubles: purposes.length - new Set(purposes).size,
      geometries,
      textures,
      programs,
    };
  }
}

/** Resident memory of the processes that draw pages below this one, in bytes; null where the system does not tell. */
export function residentBytes(parent = process.pid): number | null {
  try {
    const children = (pid: number): number[] =>
      readFileSync(`/proc/${pid}/task/${pid}/children`, 'utf8')
        .trim()
        .split(' ')
        .filter(Boolean)
        .map(Number)
        .flatMap((child) => [child, ...children(child)]);
    const renderers = children(parent).filter((pid) =>
      readFileSync(`/proc/${pid}/cmdline`, 'utf8').includes('--type=renderer'),
    );
    return Math.max(
      0,
      ...renderers.map(
        (pid) => 1024 * Number(/VmRSS:\s+(\d+)/.exec(readFileSync(`/proc/${pid}/status`, 'utf8'))?.[1] ?? 0),
      ),
    );
  } catch {
    return null;
  }
}

/** Calls back every so often until stopped; what it saw last counts too. */
export function watchPeak(look: () => number | null, every = 100): () => number {
  let peak = 0;
  const see = (): void => void (peak = Math.max(peak, look() ?? 0));
  const timer = setInterval(see, every);
  return () => {
    see();
    clearInterval(timer);
    return peak;
  };
}

/** Tasks of more than 50 ms on the main thread, noted from now on; with the functions that ran in their frame. */
export async function noteLongTasks(page: Page): Promise<void> {
  await page.evaluate(() => {
    const notes: { at: number; ms: number }[] = ((window as unknown as { soakTasks: unknown }).soakTasks = []);
    new PerformanceObserver((list) => {
      for (const { startTime, duration } of list.getEntries()) notes.push({ at: startTime, ms: duration });
    }).observe({ type: 'longtask' });
    const frames: { at: number; ms: number; what: string }[] = ((
      window as unknown as { soakFrames: unknown }
    ).soakFrames = []);
    new PerformanceObserver((list) => {
      for (const entry of list.getEntries() as (PerformanceEntry & {
        scripts?: {
          duration: number;
          invoker: string;
          sourceURL: string;
          sourceFunctionName: string;
          sourceCharPosition: number;
        }[];
      })[]) {
        for (const s of entry.scripts ?? []) {
          if (s.duration > 30)
            frames.push({
              at: entry.startTime,
              ms: s.duration,
              what: `${s.invoker} ${s.sourceURL.replace(/.*\//, '')}:${s.sourceCharPosition} ${s.sourceFunctionName}`,
            });
        }
      }
    }).observe({ type: 'long-animation-frame' });
  });
}

/** Those since the last call, in ms, longest first. */
export async function longTasks(page: Page): Promise<number[]> {
  const list = await page.evaluate(() =>
    (window as unknown as { soakTasks: { ms: number }[] }).soakTasks.splice(0).map(({ ms }) => ms),
  );
  return list.sort((a, b) => b - a);
}

/** What ran in slow frames since the last call, longest first: to find what to mend. */
export async function slowScripts(page: Page): Promise<string[]> {
  const list = await page.evaluate(() =>
    (window as unknown as { soakFrames: { ms: number; what: string }[] }).soakFrames.splice(0),
  );
  return list
    .sort((a, b) => b.ms - a.ms)
    .slice(0, 6)
    .map(({ ms, what }) => `${ms.toFixed(0)} ms ${what}`);
}

/** CPU time of the main thread's longest task from now until the answer is called, ms: what the page itself takes, however busy the machine. */
export async function watchTasks(page: Page): Promise<() => Promise<number>> {
  const browser = page.context().browser()!;
  await browser.startTracing(page, { categories: ['-*', 'toplevel', '__metadata'] });
  return async () => {
    interface Event {
      ph: string;
      name: string;
      pid: number;
      tid: number;
      ts: number;
      dur?: number;
      tdur?: number;
      args: { name?: string };
    }
    const { traceEvents } = JSON.parse((await browser.stopTracing()).toString()) as { traceEvents: Event[] };
    const main = new Set(
      traceEvents
        .filter((e) => e.name === 'thread_name' && e.args.name === 'CrRendererMain')
        .map((e) => `${e.pid} ${e.tid}`),
    );
    return (
      Math.max(0, ...traceEvents.filter((e) => e.ph === 'X' && main.has(`${e.pid} ${e.tid}`)).map((e) => e.tdur ?? 0)) /
      1000
    );
  };
}
