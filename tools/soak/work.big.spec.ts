// Part of `npm run big`: what the page does while a sweep runs, and ten million points in the plots.
import { expect, test, type Page } from '@playwright/test';
import { chooseCase, ended, medianOf, openPage, pause, VIEWPORT } from '../../tests/browser/helpers.ts';
import { bigTable } from './bigFiles.ts';
import { keep, MB, told } from './figures.ts';
import { Gauges, longTasks, noteLongTasks, slowScripts, watchTasks } from './gauges.ts';

test.use({ viewport: VIEWPORT });

const waits = (list: readonly number[]): string =>
  `median ${medianOf(list).toFixed(0)} ms, longest ${Math.max(...list).toFixed(0)} ms`;

test('a sweep of 200 runs', async ({ page }) => {
  const watch = await openPage(page);
  const gauges = await Gauges.of(page);
  await chooseCase(page, 'released');
  await ended(page, 2, 'touchdown');
  await pause(page);
  await page.getByTestId('tool-compare').click();
  await page.getByTestId('compare-sweep').click();
  await page.getByTestId('sweep-axis-0').selectOption('initial.X_dot');
  for (const [field, value] of [
    ['from', '1'],
    ['to', '3'],
    ['count', '200'],
  ] as const)
    await page.getByTestId(`sweep-${field}-0`).fill(value);
  await noteLongTasks(page);
  const busiest = await watchTasks(page);
  const from = Date.now();
  await page.getByTestId('sweep-run').click();
  await expect(page.getByTestId('sweep-standing')).toHaveAttribute('data-state', 'ended', { timeout: 300_000 });
  const seconds = (Date.now() - from) / 1000;
  const cpu = await busiest();
  const tasks = await longTasks(page);
  console.log(await slowScripts(page));
  keep('sweep', {
    what: 'a sweep of 200 runs over the speed, in all workers',
    became: `ended after ${seconds.toFixed(1)} s`,
    tasks: `longest ${cpu.toFixed(0)} ms of CPU; by the clock ${told(tasks)}`,
    seeks: '–',
    memory: `${MB(await gauges.buffers())} of columns`,
  });
  expect(watch).toEqual({ errors: [], foreign: [] });
});

/** Presses keys on a plot, one after another; from each to the picture two frames later, in ms. */
const pressed = (page: Page, keys: readonly string[]): Promise<number[]> =>
  page.evaluate(async (list) => {
    const plot = document.querySelector<HTMLElement>('[data-testid=plot-canvas]')!;
    const frame = () => new Promise((done) => requestAnimationFrame(done));
    const all: number[] = [];
    for (const key of list) {
      // Drawings come at most every tenth of a second: the last one is over.
      await new Promise((done) => setTimeout(done, 150));
      await frame();
      const from = performance.now();
      plot.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true }));
      await frame();
      await frame();
      all.push(performance.now() - from);
    }
    return all;
  }, keys);

test('ten million points in the plots', async ({ page }) => {
  const watch = await openPage(page);
  const gauges = await Gauges.of(page);
  const file = bigTable('long-ride.csv', 135e6);
  try {
    await page.getByTestId('tool-plots').click();
    await page.getByTestId('open-file').setInputFiles(file.path);
    await expect(page.getByTestId('rows')).toHaveText(`${file.rows.toLocaleString('en')} rows`, { timeout: 180_000 });
    await pause(page);
    const pane = page.getByTestId('plot-pane').first();
    const add = pane.getByTestId('plot-add-curve');
    const columns = await add
      .locator('option')
      .evaluateAll((list) =>
        list.map((option) => (option as HTMLOptionElement).value).filter((name) => /^\w+$/.test(name) && name !== 't'),
      );
    for (const name of columns) await add.selectOption(name);
    const shown = await pane.locator('[data-testid^=legend-]').count();
    const points = shown * file.rows;
    expect(points).toBeGreaterThanOrEqual(10e6);
    await page.evaluate(() => window.ripstikApp.actions.seek(200));
    await page.waitForTimeout(2000);
    await noteLongTasks(page);
    const busiest = await watchTasks(page);
    const zooms = await pressed(page, [
      '0',
      ...Array.from({ length: 24 }, () => '+'),
      ...Array.from({ length: 12 }, () => '-'),
      '0',
      '+',
      '0',
      '+',
    ]);
    const zooming = await longTasks(page);
    console.log(await slowScripts(page));
    const seeks = await page.evaluate(async () => {
      const frame = () => new Promise((done) => requestAnimationFrame(done));
      const list: number[] = [];
      for (let k = 1; k <= 30; k++) {
        await frame();
        const from = performance.now();
        window.ripstikApp.actions.seek((k * 137.5) % 400);
        await frame();
        await frame();
        list.push(performance.now() - from);
      }
      return list;
    });
    const cpu = await busiest();
    const seeking = await longTasks(page);
    keep('points', {
      what: `${(points / 1e6).toFixed(1)} million points in one plot: ${shown} curves of ${file.rows.toLocaleString('en')} rows`,
      became: `from a key that zooms to its second frame ${waits(zooms)}`,
      tasks: `longest ${cpu.toFixed(0)} ms of CPU; by the clock: zooming ${told(zooming)}, seeking ${told(seeking)}`,
      seeks: waits(seeks),
      memory: `${MB(await gauges.buffers())} of columns`,
    });
    expect(watch).toEqual({ errors: [], foreign: [] });
  } finally {
    file.remove();
  }
});
