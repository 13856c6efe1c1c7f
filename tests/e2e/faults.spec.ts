import { expect, test, type Page } from '@playwright/test';
import { chooseCase, openPage, VIEWPORT, workerEvents } from './helpers.ts';

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

const rowsOnStage = (page: Page): Promise<string> => page.getByTestId('end-time').innerText();

test('a worker that dies: what was computed stays, the page says so, and the next run works', async ({ page }) => {
  await holdWorkers(page);
  await openPage(page);
  await page.getByTestId('duration').fill('20000');
  await page.getByTestId('duration').press('Enter');
  await expect.poll(async () => (await workerEvents(page)).filter((e) => e.run === 2 && e.type === 'rows').at(-1)?.time ?? 0).toBeGreaterThan(0.5);
  // As a crash reports itself.
  await page.evaluate(() => {
    for (const worker of (window as unknown as { heldWorkers: Worker[] }).heldWorkers) {
      worker.terminate();
      worker.dispatchEvent(new ErrorEvent('error', { message: 'out of memory' }));
    }
  });
  await expect(page.getByTestId('message').first()).toContainText('out of memory');
  await expect(page.getByTestId('message').first()).toContainText('rows computed so far are kept');
  await expect(page.getByTestId('run-state')).toHaveAttribute('data-reason', 'failed');
  expect(parseFloat(await rowsOnStage(page))).toBeGreaterThan(0.5);

  // One that is silent: cancel ends it.
  await page.getByTestId('run').click();
  await expect(page.getByTestId('run-state').locator('progress')).toBeVisible();
  await page.evaluate(() => (window as unknown as { heldWorkers: Worker[] }).heldWorkers.forEach((worker) => worker.terminate()));
  await page.getByTestId('cancel').click();
  await expect(page.getByTestId('message').last()).toContainText('did not answer', { timeout: 15_000 });

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
  await lose('loseContext');
  await expect(page.getByTestId('scene-error')).toBeVisible();
  await lose('restoreContext');
  await expect(page.getByTestId('scene-error')).toHaveCount(0);
  const before = await page.evaluate(() => window.ripstikScene!.stats().frames);
  await page.getByTestId('view-top').click();
  await expect.poll(() => page.evaluate(() => window.ripstikScene!.stats().frames)).toBeGreaterThan(before);
  expect(watch.errors.filter((e) => !/context/i.test(e))).toEqual([]);

  const bare = await context.newPage();
  await bare.addInitScript(() => {
    const get = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, kind: string, ...rest: unknown[]) {
      return kind.startsWith('webgl') ? null : (get as (...args: unknown[]) => unknown).call(this, kind, ...rest);
    } as typeof get;
    for (const name of ['localStorage', 'sessionStorage', 'indexedDB']) Object.defineProperty(window, name, { get: () => { throw new DOMException('forbidden', 'SecurityError'); } });
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
});
