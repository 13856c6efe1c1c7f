// `npm run big`: a table of 100 MB, one of 1 GB, and an hour at 1 kHz, in the built page; what is measured goes into docs/robustness.md.
import { expect, test, type Page } from '@playwright/test';
import {
  chooseCase,
  ended,
  medianOf,
  numberIn,
  openPage,
  pause,
  type as typeInto,
  VIEWPORT,
  workerEvents,
} from '../../tests/browser/helpers.ts';
import { bigTable } from './bigFiles.ts';
import { keep, MB, told } from './figures.ts';
import { Gauges, longTasks, noteLongTasks, residentBytes, slowScripts, watchPeak, watchTasks } from './gauges.ts';

test.use({ viewport: VIEWPORT });

interface Seek {
  /** Until the page had put everything in place, and until the picture was drawn, ms. */
  own: number;
  drawn: number;
}

/** Seeks to places all over the motion by the slider. */
async function scrubbed(page: Page, count = 25): Promise<Seek[]> {
  return page.evaluate(async (n) => {
    const slider = document.querySelector<HTMLInputElement>('[data-testid=scrubber]')!;
    const frame = () => new Promise((done) => requestAnimationFrame(done));
    const waits: { own: number; drawn: number }[] = [];
    for (let k = 0; k < n; k++) {
      await frame();
      const drawn = window.ripstikScene!.stats().frames;
      const from = performance.now();
      slider.value = String(
        Number(slider.min) + (((k + 1) * 0.6180339887) % 1) * (Number(slider.max) - Number(slider.min)),
      );
      slider.dispatchEvent(new InputEvent('input', { bubbles: true }));
      const own = performance.now() - from;
      while (window.ripstikScene!.stats().frames === drawn && performance.now() - from < 10_000) await frame();
      waits.push({ own, drawn: performance.now() - from });
    }
    return waits;
  }, count);
}

function seeks(waits: readonly Seek[]): string {
  const [own, drawn] = [waits.map((w) => w.own), waits.map((w) => w.drawn)];
  return `page ${medianOf(own).toFixed(1)} ms, picture ${medianOf(drawn).toFixed(0)} ms (longest ${Math.max(...drawn).toFixed(0)})`;
}

test('100 MB with 21 columns plays', async ({ page }) => {
  const watch = await openPage(page);
  const gauges = await Gauges.of(page);
  const file = bigTable('ride.csv', 100e6);
  try {
    await page.getByTestId('tool-plots').click();
    await pause(page);
    await noteLongTasks(page);
    await scrubbed(page);
    const before = await longTasks(page);
    await slowScripts(page);
    const peak = watchPeak(() => residentBytes());
    const busiest = await watchTasks(page);
    const from = Date.now();
    await page.getByTestId('open-file').setInputFiles(file.path);
    await expect(page.getByTestId('reading')).toBeVisible();
    const during = await scrubbed(page, 10);
    await expect(page.getByTestId('rows')).toHaveText(`${file.rows.toLocaleString('en')} rows`, { timeout: 120_000 });
    const seconds = (Date.now() - from) / 1000;
    await expect(page.getByTestId('play')).toHaveAccessibleName('Pause');
    await page.waitForTimeout(8000);
    const cpu = await busiest();
    const loading = await longTasks(page);
    const slow = await slowScripts(page);
    expect(await numberIn(page, 'time')).toBeGreaterThan(0.5);
    await pause(page);
    const after = await scrubbed(page);
    const scrubbing = await longTasks(page);
    const buffers = await gauges.buffers();
    console.log(slow, await slowScripts(page));
    keep('table-100', {
      what: `a CSV file of ${MB(file.bytes)}, 21 columns, ${file.rows.toLocaleString('en')} rows`,
      became: `plays after ${seconds.toFixed(1)} s`,
      tasks: `longest ${cpu.toFixed(0)} ms of CPU; by the clock ${told(loading)} (scrubbing after: ${told(scrubbing)}; before the file: ${told(before)})`,
      seeks: `while it loads ${seeks(during)}; then ${seeks(after)}`,
      memory: `${MB(buffers)} of columns, page at most ${MB(peak())}`,
    });
    expect(watch).toEqual({ errors: [], foreign: [] });
  } finally {
    file.remove();
  }
});

test('1 GB is read with progress, and cancelled', async ({ page }) => {
  const watch = await openPage(page);
  const gauges = await Gauges.of(page);
  const file = bigTable('long-ride.csv', 1e9);
  try {
    await pause(page);
    const stage = await page.getByTestId('end-time').innerText();
    await noteLongTasks(page);
    const peak = watchPeak(() => residentBytes());
    await page.getByTestId('open-file').setInputFiles(file.path);
    await expect
      .poll(
        () =>
          page
            .getByTestId('reading')
            .locator('progress')
            .evaluate((bar) => (bar as HTMLProgressElement).value),
        { timeout: 60_000 },
      )
      .toBeGreaterThan(0.1);
    const during = await scrubbed(page, 10);
    const waited = await page.evaluate(async () => {
      const from = performance.now();
      document.querySelector<HTMLElement>('[data-testid=cancel-reading]')!.click();
      while (document.querySelector('[data-testid=reading]')) await new Promise((done) => requestAnimationFrame(done));
      return performance.now() - from;
    });
    await expect(page.getByTestId('message').last()).toContainText('was not read to its end');
    expect(await page.getByTestId('end-time').innerText()).toBe(stage);
    const cancelled = await gauges.read();

    const busiest = await watchTasks(page);
    const from = Date.now();
    await page.getByTestId('open-file').setInputFiles(file.path);
    await expect(page.getByTestId('rows')).toHaveText(`${file.rows.toLocaleString('en')} rows`, { timeout: 300_000 });
    const seconds = (Date.now() - from) / 1000;
    await page.waitForTimeout(3000);
    const cpu = await busiest();
    const tasks = await longTasks(page);
    await pause(page);
    const after = await scrubbed(page);
    keep('table-1000', {
      what: `a CSV file of ${MB(file.bytes)}, 21 columns, ${file.rows.toLocaleString('en')} rows`,
      became: `cancelled after a tenth within ${waited.toFixed(0)} ms, the work before stayed, ${MB(cancelled.buffers)} of buffers left; then read, plays after ${seconds.toFixed(0)} s`,
      tasks: `longest ${cpu.toFixed(0)} ms of CPU; by the clock ${told(tasks)}`,
      seeks: `while it loads ${seeks(during)}; then ${seeks(after)}`,
      memory: `${MB(await gauges.buffers())} of columns, page at most ${MB(peak())}`,
    });
    console.log(await slowScripts(page));
    expect(watch).toEqual({ errors: [], foreign: [] });
  } finally {
    file.remove();
  }
});

test('an hour at 1 kHz', async ({ page }) => {
  const watch = await openPage(page);
  const gauges = await Gauges.of(page);
  await chooseCase(page, process.env['BIG_CASE'] ?? 'rolling-wheel-circle');
  await ended(page, 2, 'end');
  await page.getByTestId('tool-plots').click();
  await typeInto(page, 'output-step', '0.001');
  await typeInto(page, 'duration', process.env['BIG_DURATION'] ?? '3600');
  await noteLongTasks(page);
  const peak = watchPeak(() => residentBytes());
  const busiest = await watchTasks(page);
  const from = Date.now();
  await page.getByTestId('run').click();
  await expect
    .poll(async () => (await workerEvents(page)).filter((e) => e.run === 3 && e.type === 'rows').at(-1)?.time ?? 0, {
      timeout: 600_000,
    })
    .toBeGreaterThan(600);
  const during = await scrubbed(page, 10);
  await page.getByTestId('play').click();
  await expect
    .poll(async () => (await workerEvents(page)).some((e) => e.run === 3 && e.type === 'ended'), {
      timeout: 1_800_000,
      intervals: [1000],
    })
    .toBe(true);
  const seconds = (Date.now() - from) / 1000;
  const cpu = await busiest();
  const tasks = await longTasks(page);
  const slow = await slowScripts(page);
  const rows = (await workerEvents(page))
    .filter((e) => e.run === 3 && e.type === 'rows')
    .reduce((sum, e) => sum + e.rows, 0);
  await pause(page);
  const after = await scrubbed(page);
  const scrubbing = await longTasks(page);
  console.log(slow, await slowScripts(page));
  keep('hour', {
    what: `an hour at 1 kHz, ${rows.toLocaleString('en')} rows computed`,
    became: `computed in ${seconds.toFixed(0)} s, plays meanwhile`,
    tasks: `longest ${cpu.toFixed(0)} ms of CPU; by the clock ${told(tasks)} (scrubbing after: ${told(scrubbing)})`,
    seeks: `while it comes ${seeks(during)}; then ${seeks(after)}`,
    memory: `${MB(await gauges.buffers())} of columns, page at most ${MB(peak())}`,
  });
  expect(watch).toEqual({ errors: [], foreign: [] });
});
