import { expect, test, type Locator, type Page } from '@playwright/test';
import {
  chooseCase,
  COORDINATES,
  csvOf,
  differingPixels,
  drawn,
  drop,
  ended,
  numberIn,
  openPage,
  pause,
  picture,
  seek,
  survived,
  type as typeInto,
  VIEWPORT,
  withoutScene,
  workerEvents,
} from './helpers.ts';

test.use({ viewport: VIEWPORT });

/** Keeps the page's workers within reach, and lets a test make the next ones fail. */
async function holdWorkers(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const held: Worker[] = ((window as unknown as { heldWorkers: Worker[] }).heldWorkers = []);
    const Plain = window.Worker;
    window.Worker = class extends Plain {
      constructor(...args: ConstructorParameters<typeof Plain>) {
        super(...args);
        held.push(this);
      }
    };
  });
}

/** What is written there: its title, then its lines. */
async function said(place: Locator): Promise<string> {
  const [title, ...lines] = (await place.innerText())
    .split('\n')
    .map((line) => line.trim().replace(/\.$/, ''))
    .filter(Boolean);
  return `${title}: ${lines.join('. ')}.`;
}

const rowsOnStage = (page: Page): Promise<string> => page.getByTestId('end-time').innerText();

test('a worker that dies: what was computed stays, the page says so, and the next run works', async ({ page }) => {
  await holdWorkers(page);
  await openPage(page);
  await page.getByTestId('duration').fill('20000');
  await page.getByTestId('duration').press('Enter');
  await expect
    .poll(async () => (await workerEvents(page)).filter((e) => e.run === 2 && e.type === 'rows').at(-1)?.time ?? 0)
    .toBeGreaterThan(0.5);
  // As a crash reports itself.
  await page.evaluate(() => {
    for (const worker of (window as unknown as { heldWorkers: Worker[] }).heldWorkers) {
      worker.terminate();
      worker.dispatchEvent(new ErrorEvent('error', { message: 'out of memory' }));
    }
  });
  await expect(page.getByTestId('message').first()).toContainText('out of memory');
  await expect(page.getByTestId('message').first()).toContainText('rows computed so far are kept');
  survived('the worker of a run dies, out of memory', await said(page.getByTestId('message').first()));
  await expect(page.getByTestId('run-state')).toHaveAttribute('data-reason', 'failed');
  expect(parseFloat(await rowsOnStage(page))).toBeGreaterThan(0.5);

  // One that is silent: cancel ends it.
  await page.getByTestId('run').click();
  await expect(page.getByTestId('run-state').locator('progress')).toBeVisible();
  await page.evaluate(() =>
    (window as unknown as { heldWorkers: Worker[] }).heldWorkers.forEach((worker) => worker.terminate()),
  );
  await page.getByTestId('cancel').click();
  await expect(page.getByTestId('message').last()).toContainText('did not answer', { timeout: 15_000 });
  survived('the worker is silent after a cancel', await said(page.getByTestId('message').last()));

  await chooseCase(page, 'released');
  await expect(page.getByTestId('run-state')).toHaveAttribute('data-reason', 'touchdown');
});

test('a lost graphics context comes back; without WebGL files and numbers still work', async ({ page, context }) => {
  const watch = await openPage(page);
  const lose = (what: 'loseContext' | 'restoreContext') =>
    page.evaluate((name) => {
      const shared = window as unknown as { lost?: { loseContext(): void; restoreContext(): void } };
      const canvas = document.querySelector<HTMLCanvasElement>('[data-testid=scene]')!;
      shared.lost ??= canvas.getContext('webgl2')!.getExtension('WEBGL_lose_context')!;
      shared.lost[name]();
    }, what);
  await pause(page);
  await seek(page, 2);
  await drawn(page);
  const seen = await picture(page);
  await lose('loseContext');
  await expect(page.getByTestId('scene-error')).toBeVisible();
  const lost = await said(page.getByTestId('scene-error'));
  await lose('restoreContext');
  await expect(page.getByTestId('scene-error')).toHaveCount(0);
  await drawn(page);
  expect(await differingPixels(page, seen, await picture(page))).toBeLessThan(20);
  const before = await page.evaluate(() => window.ripstikScene!.stats().frames);
  await page.getByTestId('view-top').click();
  await expect.poll(() => page.evaluate(() => window.ripstikScene!.stats().frames)).toBeGreaterThan(before);
  expect(watch.errors.filter((e) => !/context/i.test(e))).toEqual([]);
  survived('the graphics context is lost, and comes back', `${lost} Then nothing: the view is there again.`);

  const bare = await context.newPage();
  await bare.addInitScript(() => {
    const get = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, kind: string, ...rest: unknown[]) {
      return kind.startsWith('webgl') ? null : (get as (...args: unknown[]) => unknown).call(this, kind, ...rest);
    } as typeof get;
    for (const name of ['localStorage', 'sessionStorage', 'indexedDB'])
      Object.defineProperty(window, name, {
        get: () => {
          throw new DOMException('forbidden', 'SecurityError');
        },
      });
  });
  const errors: string[] = [];
  bare.on('pageerror', (error) => errors.push(String(error)));
  await bare.goto('./');
  await expect(bare.getByTestId('scene-error')).toContainText('WebGL');
  await expect(bare.getByTestId('run-state')).toHaveAttribute('data-reason', 'end');
  await chooseCase(bare, 'released');
  await expect(bare.getByTestId('run-state')).toHaveAttribute('data-reason', 'touchdown');
  await bare.getByTestId('tool-now').click();
  await expect(bare.getByTestId('now-alpha')).not.toBeEmpty();
  expect(errors).toEqual([]);
  survived(
    'no WebGL, and every storage forbidden',
    `In place of the view: ${await said(bare.getByTestId('scene-error'))}`,
  );
});

interface Clock {
  /** No frames are drawn while it holds. */
  hold(): void;
  /** Frames go on; by the clock so much later (ms) than when they stopped. */
  release(later: number): void;
  /** Frames asked for and not drawn. */
  waiting(): number;
}

/** The page's clock and frames in the test's hands: what a hidden tab and a machine that sleeps do to them. */
function holdClock(): void {
  const [frame, cancel, now] = [
    window.requestAnimationFrame.bind(window),
    window.cancelAnimationFrame.bind(window),
    performance.now.bind(performance),
  ];
  let held: Map<number, FrameRequestCallback> | null = null;
  let [ahead, next] = [0, -1];
  performance.now = () => now() + ahead;
  window.requestAnimationFrame = (callback) => {
    if (!held) return frame((time) => callback(time + ahead));
    held.set(next, callback);
    return next--;
  };
  window.cancelAnimationFrame = (id) => (id < 0 ? void held?.delete(id) : cancel(id));
  const clock: Clock = {
    hold: () => void (held ??= new Map()),
    release(later) {
      const waiting = held;
      held = null;
      ahead += later;
      for (const callback of waiting?.values() ?? []) window.requestAnimationFrame(callback);
    },
    waiting: () => held?.size ?? 0,
  };
  Object.assign(window, { heldClock: clock });
}

const clockOf = <T>(page: Page, act: (clock: Clock) => T): Promise<T> =>
  page.evaluate(`(${act.toString()})(window.heldClock)`);

/** Hides the tab, or shows it again, as the browser tells the page. */
const hide = (page: Page, hidden: boolean): Promise<void> =>
  page.evaluate((now) => {
    Object.defineProperty(document, 'visibilityState', { configurable: true, get: () => (now ? 'hidden' : 'visible') });
    document.dispatchEvent(new Event('visibilitychange'));
  }, hidden);

test('a tab that was hidden and a machine that slept: playing goes on from where it was, nothing spins, nothing is lost', async ({
  page,
}) => {
  const watch = await openPage(page, holdClock);
  await seek(page, 2);
  await page.keyboard.press('l');
  await expect.poll(() => numberIn(page, 'time')).toBeGreaterThan(2.1);
  await typeInto(page, 'duration', '9');
  await clockOf(page, (clock) => clock.hold());
  await hide(page, true);
  // What was typed last is stored before the tab may be taken away.
  expect(await page.evaluate(() => localStorage.getItem('ripstik.work'))).toContain('"duration":9');
  await page.waitForTimeout(400);
  expect(await clockOf(page, (clock) => clock.waiting()), 'frames asked for').toBeLessThan(10);
  const before = await numberIn(page, 'time');
  await clockOf(page, (clock) => clock.release(3_600_000));
  await hide(page, false);
  await expect.poll(() => numberIn(page, 'time')).toBeGreaterThan(before);
  await expect(page.getByTestId('play')).toHaveAccessibleName('Pause');
  expect(await numberIn(page, 'time'), 'no jump by an hour, nor to the end').toBeLessThan(before + 4);
  // The speed that is held is the one that is seen, not the one of an hour.
  await page.waitForTimeout(1300);
  expect(await page.locator('.held').allInnerTexts()).not.toContain(expect.stringMatching(/0[.,]00/));
  expect(watch.errors).toEqual([]);
  survived(
    'the machine sleeps for an hour while a motion plays, its tab hidden',
    'Nothing: it goes on from where it was; what was typed last had been stored.',
  );
});

test('a run that is computed while the tab is hidden is all there; one that is pushed by hand waits, and does not make up an hour', async ({
  page,
}) => {
  const watch = await openPage(page, holdClock);
  await chooseCase(page, 'hanging');
  await ended(page, 2, 'end');
  await typeInto(page, 'duration', '100000');
  await clockOf(page, (clock) => clock.hold());
  await page.getByTestId('run').click();
  await expect
    .poll(async () => (await workerEvents(page)).filter((e) => e.run === 3 && e.type === 'rows').at(-1)?.time ?? 0)
    .toBeGreaterThan(20);
  await clockOf(page, (clock) => clock.release(3_600_000));
  await page.getByTestId('cancel').click();
  await ended(page, 3, 'cancelled');
  expect(await numberIn(page, 'end-time')).toBeGreaterThan(20);
  survived('the tab is hidden while a run is computed', 'Nothing: no pictures are asked for, the rows come.');

  await chooseCase(page, 'balanced');
  await ended(page, 4, 'end');
  await pause(page);
  await seek(page, 1);
  await page.keyboard.press('g');
  await page.getByTestId('push-ahead').click();
  const reached = async (): Promise<number> =>
    (await workerEvents(page)).filter((e) => e.run === 5 && e.type === 'rows').at(-1)?.time ?? 0;
  await expect.poll(reached).toBeGreaterThan(1.2);
  await clockOf(page, (clock) => clock.hold());
  await page.waitForTimeout(300);
  const [shown, computed] = [await numberIn(page, 'time'), await reached()];
  expect(computed, 'no further than it is seen').toBeLessThan(shown + 1);
  await clockOf(page, (clock) => clock.release(3_600_000));
  await expect.poll(reached).toBeGreaterThan(computed);
  expect(await numberIn(page, 'time')).toBeLessThan(shown + 4);
  await page.getByTestId('push-none').click();
  await ended(page, 5, 'end');
  expect(watch.errors).toEqual([]);
  survived(
    'the same while a hand pushes the run',
    'Nothing: the run waits for what is seen, and does not make up the hour.',
  );
});

test('storage that becomes full: it is said once, the work goes on, and what was stored before is still there', async ({
  page,
}) => {
  await withoutScene(page);
  const errors: string[] = [];
  page.on('pageerror', (error) => errors.push(String(error)));
  await page.goto('./');
  await expect(page.getByTestId('run-state')).toHaveAttribute('data-reason', 'end');
  await typeInto(page, 'duration', '3');
  await expect.poll(() => page.evaluate(() => localStorage.getItem('ripstik.work'))).toContain('"duration":3');
  await page.evaluate(() => {
    const full = (): never => {
      throw new DOMException('', 'QuotaExceededError');
    };
    Storage.prototype.setItem = full;
    IDBObjectStore.prototype.put = full;
  });
  await typeInto(page, 'duration', '4');
  await expect(page.getByTestId('message')).toContainText('is full');
  const rows = [0, 1, 2].map((t) => ({ ...Object.fromEntries(COORDINATES.map((name) => [name, 0.1 * t])), t }));
  await drop(page, 'mine.csv', csvOf(rows, ['t', ...COORDINATES]));
  await expect(page.getByTestId('rows')).toHaveText('3 rows');
  await page.getByTestId('run').click();
  await expect(page.getByTestId('end-time')).toHaveText(/^4\.000\s/);
  await expect(page.getByTestId('message')).toHaveCount(1);
  survived('the storage becomes full', `Once: ${await said(page.getByTestId('message'))}`);
  expect(await page.evaluate(() => localStorage.getItem('ripstik.work'))).toContain('"duration":3');
  expect(errors).toEqual([]);
});

test('a file that is given up, and one that cannot be written: the work before stays, and the next one comes', async ({
  page,
}) => {
  const watch = await openPage(page);
  const stage = await rowsOnStage(page);
  const rows = Array.from({ length: 10_000 }, (_, k) => ({
    ...Object.fromEntries(COORDINATES.map((name) => [name, 0.125])),
    t: k / 100,
  }));
  // As soon as it can be, however fast the machine reads.
  await page.evaluate(() => {
    new MutationObserver((_, observer) => {
      const cancel = document.querySelector<HTMLElement>('[data-testid=cancel-reading]');
      if (!cancel) return;
      observer.disconnect();
      cancel.click();
    }).observe(document.body, { childList: true, subtree: true });
  });
  await drop(page, 'long.csv', csvOf(rows, ['t', ...COORDINATES]), 100);
  await expect(page.getByTestId('message').last()).toContainText('was not read to its end');
  expect(await rowsOnStage(page)).toBe(stage);
  survived('reading a large file is given up', await said(page.getByTestId('message').last()));

  await page.evaluate(() => {
    const post = Worker.prototype.postMessage;
    Worker.prototype.postMessage = function (this: Worker) {
      Worker.prototype.postMessage = post;
      queueMicrotask(() => this.dispatchEvent(new ErrorEvent('error', { message: 'out of memory' })));
    };
  });
  await page.getByTestId('export-menu').click();
  await page.getByTestId('export-csv').click();
  await expect(page.getByTestId('message').last()).toContainText('was not written');
  survived('a CSV file cannot be written: its worker dies', await said(page.getByTestId('message').last()));
  await page.getByTestId('export-menu').click();
  const [file] = await Promise.all([page.waitForEvent('download'), page.getByTestId('export-csv').click()]);
  expect(await file.failure()).toBeNull();
  expect(watch.errors).toEqual([]);
});
