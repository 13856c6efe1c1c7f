/** What every browser test needs: opening the page, dropping files, reading the scene, comparing pictures. */
import { readFileSync } from 'node:fs';
import { expect, test, type BrowserContext, type Download, type Page } from '@playwright/test';
import { ripstikMeta } from '../../src/core/systems/ripstik/meta.ts';
import { ripstikView } from '../../src/core/systems/ripstik/view.ts';
import type { SceneView } from '../../src/scene/contract.ts';
import type { FromWorker, ToWorker } from '../../src/compute/remote/protocol.ts';
import type { RunEvent } from '../../src/compute/services/runTypes.ts';

/** Small: software WebGL pays for every pixel. */
export const VIEWPORT = { width: 900, height: 600 };
export const BODIES = ripstikMeta.bodies.length;
export const COORDINATES = ripstikMeta.coordinates.map((c) => c.name);
/** The case the page opens with. */
export const FIRST_END = '10.000';

/** What the page and a worker say to each other of a run, with the page's clock (ms). */
export interface WorkerEvent {
  at: number;
  sent: boolean;
  type: RunEvent['type'] | 'start' | 'cancel' | 'push' | 'ended' | 'refused';
  /** Counts the runs of a worker, from 1. */
  run: number;
  time: number;
  rows: number;
}

declare global {
  interface Window {
    ripstikScene?: SceneView;
    /** Kept by `recordWorkers`. */
    workerEvents: WorkerEvent[];
    cspViolations: string[];
    longTasks: { start: number; duration: number }[];
  }
}

export interface Watch {
  errors: string[];
  foreign: string[];
}

/** Opens the page and waits until the first run stands on the stage, drawn. Everything that goes wrong is in the answer. `before` runs in the page before its own code. */
export async function openPage(page: Page, before: () => unknown = () => undefined): Promise<Watch> {
  const watch = await open(page, before);
  await expect
    .poll(() => page.evaluate(() => window.ripstikScene?.stats().bodies ?? 0), 'bodies on the stage')
    .toBeGreaterThan(BODIES); // somebody stands on them
  await drawn(page);
  return watch;
}

/** The same for tests of numbers and words, in which nothing depends on the picture: there is none. */
export async function openWithoutScene(page: Page): Promise<Watch> {
  await withoutScene(page);
  return open(page, () => undefined);
}

async function open(page: Page, before: () => unknown): Promise<Watch> {
  const watch: Watch = { errors: [], foreign: [] };
  page.on('pageerror', (error) => watch.errors.push(String(error)));
  page.on('console', (message) => {
    if (message.type() === 'error') watch.errors.push(message.text());
  });
  await page.addInitScript(() => {
    window.cspViolations = [];
    document.addEventListener('securitypolicyviolation', (event) =>
      window.cspViolations.push(`${event.violatedDirective}: ${event.blockedURI}`),
    );
  });
  await page.addInitScript(before);
  await recordWorkers(page);
  const own = new URL(test.info().project.use.baseURL!).origin;
  page.on('request', (request) => {
    if (new URL(request.url()).origin !== own) watch.foreign.push(request.url());
  });
  await page.goto('./');
  await expect(page.getByTestId('run-state')).toHaveAttribute('data-reason', 'end');
  return watch;
}

/** Where only numbers and words count: software WebGL pays for every pixel, so there is none, and the page says so. */
export async function withoutScene(pages: Page | BrowserContext): Promise<void> {
  await pages.addInitScript(() => {
    const plain = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, kind: string, ...rest: never[]) {
      return /webgl/.test(kind) ? null : Reflect.apply(plain, this, [kind, ...rest]);
    } as typeof plain;
  });
}

/** Writes down what the page and its workers say to each other of runs. */
export async function recordWorkers(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const events: WorkerEvent[] = (window.workerEvents = []);
    const sent = { call: 'start', abort: 'cancel', update: 'push', drop: null } as const;
    const PlainWorker = window.Worker;
    window.Worker = class extends PlainWorker {
      private readonly runs = new Set<number>();
      constructor(...args: ConstructorParameters<typeof PlainWorker>) {
        super(...args);
        this.addEventListener('message', ({ data }: MessageEvent<FromWorker>) => {
          if (data.kind === 'unreadable' || !this.runs.has(data.call)) return;
          if (data.kind !== 'event') return this.note(false, data.call, data.kind === 'result' ? 'ended' : 'refused');
          const event = data.event as RunEvent;
          this.note(false, data.call, event.type, event.type === 'rows' ? event : undefined);
        });
      }
      override postMessage(message: ToWorker, ...rest: never[]): void {
        if (message.kind === 'call' && message.name === 'run.compute') this.runs.add(message.call);
        const type = sent[message.kind];
        if (type && this.runs.has(message.call)) this.note(true, message.call, type);
        super.postMessage(message, ...rest);
      }
      private note(bySelf: boolean, run: number, type: WorkerEvent['type'], { time = 0, rows = 0 } = {}): void {
        events.push({ at: performance.now(), sent: bySelf, type, run, time, rows });
      }
    };
  });
}

export const workerEvents = (page: Page): Promise<WorkerEvent[]> => page.evaluate(() => window.workerEvents);

/** Two frames later everything asked for has been drawn. */
export async function drawn(page: Page): Promise<void> {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}

// ── files

/** Drops a file on the scene as a person does: enter, over, drop. Of so many `times` the text. */
export async function drop(page: Page, name: string, text: string, times = 1): Promise<void> {
  await page.getByTestId('scene').evaluate(
    (target, file) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File(Array<string>(file.times).fill(file.text), file.name, { type: 'text/csv' }));
      for (const type of ['dragenter', 'dragover', 'drop']) {
        target.dispatchEvent(new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }));
      }
    },
    { name, text, times },
  );
}

export type Row = Readonly<Record<string, number>>;

/** Rows of t and all ten coordinates (SI) as CSV, with the columns in this order; those in `degrees` are written so. */
export function csvOf(rows: readonly Row[], order: readonly string[], degrees: readonly string[] = []): string {
  const title = (name: string) => (degrees.includes(name) ? `${name} [deg]` : name);
  const cell = (name: string, value: number) => String(degrees.includes(name) ? (value * 180) / Math.PI : value);
  return (
    [order.map(title).join(','), ...rows.map((row) => order.map((name) => cell(name, row[name]!)).join(','))].join(
      '\n',
    ) + '\n'
  );
}

export interface Table {
  columns: string[];
  rows: number[][];
}

/** A downloaded CSV, read without any of the program's own code. */
export async function tableOf(download: Download): Promise<Table & { text: string }> {
  const text = readFileSync(await download.path(), 'utf8');
  const lines = text.split('\n').filter((line) => line !== '' && !line.startsWith('#'));
  return { text, columns: lines[0]!.split(','), rows: lines.slice(1).map((line) => line.split(',').map(Number)) };
}

export async function exportCsv(page: Page): Promise<Table & { text: string }> {
  await page.getByTestId('export-menu').click();
  const download = page.waitForEvent('download');
  await page.getByTestId('export-csv').click();
  return tableOf(await download);
}

// ── the page's own controls

export async function chooseCase(page: Page, id: string): Promise<void> {
  await page.getByTestId('case-menu').click();
  await page.getByTestId(`case-${id}`).click();
}

/** Types into a field of the panel and leaves it. */
export async function type(page: Page, field: string, text: string): Promise<void> {
  const input = page.getByTestId(field);
  await input.fill(text);
  await input.press('Tab');
}

/** Waits for the end of a run; the page counts its runs from 1, the one it opens with. */
export async function ended(page: Page, run: number, reason: string): Promise<void> {
  // The end of the run before looks the same on the page: ask what the worker said.
  await expect
    .poll(async () => (await workerEvents(page)).some((event) => event.run === run && event.type === 'ended'), {
      message: `run ${run} ends`,
      timeout: 90_000,
    })
    .toBe(true);
  await expect(page.getByTestId('run-state')).toHaveAttribute('data-reason', reason);
}

/** Stops playing and goes to a time by the slider. */
export async function seek(page: Page, time: number): Promise<void> {
  await pause(page);
  await page.getByTestId('scrubber').fill(String(time));
  await expect(page.getByTestId('time')).toHaveText(new RegExp(`^${time.toFixed(3)}\\s`));
  await drawn(page);
}

export async function pause(page: Page): Promise<void> {
  await page.keyboard.press('k');
  await expect(page.getByTestId('play')).toHaveAccessibleName('Play');
}

/** `5.800 s` or `−2e−16` as a number. */
export async function numberIn(page: Page, testId: string): Promise<number> {
  const text = (await page.getByTestId(testId).innerText()).replaceAll('\u2212', '-');
  const raised = /·10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)/.exec(text)?.[1] ?? '';
  const exponent = [...raised].map((c) => (c === '⁻' ? '-' : '⁰¹²³⁴⁵⁶⁷⁸⁹'.indexOf(c))).join('');
  return parseFloat(text) * 10 ** Number(exponent);
}

// ── the scene

/** Body to world, rotation by rows as `poses` has it, read from the picture's own objects. */
export async function posesOnStage(page: Page): Promise<number[][]> {
  const matrices = await page.evaluate(
    (count) => Array.from({ length: count }, (_, i) => window.ripstikScene!.bodyMatrix(i)!),
    BODIES,
  );
  return matrices.map((m) => [
    m[12]!,
    m[13]!,
    m[14]!,
    ...[0, 1, 2].flatMap((row) => [m[row]!, m[4 + row]!, m[8 + row]!]),
  ]);
}

/** Where the row of a file says the bodies are, with the default proportions. */
export function posesOf(row: Row): number[][] {
  const out = new Float64Array(12 * BODIES);
  ripstikView.poses(
    Float64Array.from(COORDINATES, (name) => row[name]!),
    Float64Array.from(ripstikMeta.parameters, (p) => p.default),
    out,
  );
  return Array.from({ length: BODIES }, (_, i) => [...out.subarray(12 * i, 12 * i + 12)]);
}

export function largestDifference(a: readonly number[][], b: readonly number[][]): number {
  return Math.max(...a.flatMap((numbers, i) => numbers.map((x, j) => Math.abs(x - b[i]![j]!))));
}

export interface Box {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

export const screenBox = (page: Page, body: number): Promise<Box> =>
  page.evaluate((i) => window.ripstikScene!.screenBox(i)!, body);

/** Shows these bodies only; after the board's own, of one that is ridden, come those of the figure on it. */
export async function showOnly(page: Page, bodies: readonly number[]): Promise<void> {
  await page.evaluate((shown) => {
    for (let i = 0; i < window.ripstikScene!.stats().bodies; i++)
      window.ripstikScene!.setBodyVisible(i, shown.includes(i));
  }, bodies);
  await drawn(page);
}

/** The canvas as it is on the screen, a PNG. */
export const picture = (page: Page): Promise<Buffer> => page.getByTestId('scene').screenshot();

/** Pixels that two pictures of the canvas have differently, within a box (CSS pixels) if one is given. */
export async function differingPixels(page: Page, a: Buffer, b: Buffer, box?: Box): Promise<number> {
  return page.evaluate(
    async ([first, second, within]) => {
      const pixels = async (base64: string) => {
        const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
        const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
        const context = new OffscreenCanvas(image.width, image.height).getContext('2d')!;
        context.drawImage(image, 0, 0);
        return context.getImageData(0, 0, image.width, image.height);
      };
      const [one, two] = [await pixels(first), await pixels(second)];
      const { width, height } = one;
      if (width !== two.width || height !== two.height) throw new Error('the pictures differ in size');
      const area = within ?? { left: 0, top: 0, right: width, bottom: height };
      let count = 0;
      for (let y = Math.max(0, Math.floor(area.top)); y < Math.min(height, Math.ceil(area.bottom)); y++) {
        for (let x = Math.max(0, Math.floor(area.left)); x < Math.min(width, Math.ceil(area.right)); x++) {
          const o = 4 * (y * width + x);
          // More than rounding in any colour.
          if ([0, 1, 2].some((c) => Math.abs(one.data[o + c]! - two.data[o + c]!) > 8)) count++;
        }
      }
      return count;
    },
    [a.toString('base64'), b.toString('base64'), box ?? null] as const,
  );
}

/** Told with the test, never asserted: machines differ. */
export function measured(figure: string): void {
  test.info().annotations.push({ type: 'measured', description: figure });
  console.log(figure);
}

/** A fault that was injected and survived, with what the page said of it: `npm run faults` makes its table of these. */
export function survived(fault: string, said: string): void {
  test.info().annotations.push({ type: 'fault', description: JSON.stringify([fault, said]) });
}

export const medianOf = (list: readonly number[]): number => [...list].sort((a, b) => a - b)[list.length >> 1]!;
