import { expect, test } from '@playwright/test';
import { ripstikMeta } from '../../src/core/systems/ripstik/meta.ts';
import {
  chooseCase,
  drop,
  ended,
  exportCsv,
  measured,
  numberIn,
  openPage,
  openWithoutScene,
  pause,
  seek,
  type as typeInto,
  VIEWPORT,
  workerEvents,
} from './helpers.ts';

test.use({ viewport: VIEWPORT });

/** Bound on the constraint residual of every emitted row, from the contract. */
const RESIDUAL = 1e-12;
const LONG = '100000';

for (const id of ['released', 'falling-ground']) {
  test(`a live falling run (${id}) streams, ends at touchdown and is exported`, async ({ page }) => {
    const watch = await openWithoutScene(page);
    await chooseCase(page, id);
    await ended(page, 2, 'touchdown');
    await pause(page);

    const run = (await workerEvents(page)).filter((event) => event.run === 2 && !event.sent);
    expect(run.map((event) => event.type)).toContain('rows');
    expect(run[0]!.type).toBe('started');
    expect(run.at(-1)!.type).toBe('ended');

    const end = await numberIn(page, 'end-time');
    expect(end).toBeGreaterThan(0.1);
    expect(end).toBeLessThan(5);
    const residual = await numberIn(page, 'residual');
    expect(residual).toBeGreaterThanOrEqual(0);
    expect(residual).toBeLessThan(RESIDUAL);

    const mark = page.locator('.scrub-line').getByRole('button', { name: 'touchdown' });
    await expect(mark).toBeVisible();
    await page.keyboard.press('Home');
    await expect(page.getByTestId('time')).toHaveText(/^0\.000\s/);
    await mark.click();
    expect(await numberIn(page, 'time')).toBe(end);
    await seek(page, 0.125);
    await page.keyboard.press('End');
    await expect(page.getByTestId('time')).toHaveText(await page.getByTestId('end-time').innerText());

    const { text, columns, rows } = await exportCsv(page);
    const names = ripstikMeta.coordinates.map((c) => c.name);
    expect(columns.slice(0, 21)).toEqual(['t', ...names, ...names.map((name) => `${name}_dot`)]);
    expect(rows.every((row) => row.length === columns.length && row.every(Number.isFinite))).toBe(true);
    expect(rows[0]![0]).toBe(0);
    expect(rows.at(-1)![0]!.toFixed(3)).toBe(end.toFixed(3));
    expect(rows.every((row, i) => i === 0 || row[0]! > rows[i - 1]![0]!)).toBe(true);
    expect(Math.max(...rows.map((row) => row[columns.indexOf('residual')]!))).toBeLessThan(RESIDUAL);

    // The page reads its own file back, whole.
    await drop(page, 'again.csv', text);
    await expect(page.getByTestId('rows')).toHaveText(`${rows.length} rows`);
    await expect(page.getByTestId('skipped')).toHaveCount(0);
    expect(await numberIn(page, 'end-time')).toBe(end);
    expect(watch.errors).toEqual([]);
  });
}

test('a long run is cancelled at once, keeps its rows, and the next run replaces it', async ({ page }) => {
  const watch = await openWithoutScene(page);
  await chooseCase(page, 'hanging');
  await ended(page, 2, 'end');
  await typeInto(page, 'duration', LONG);
  await page.getByTestId('run').click();
  await expect(page.getByTestId('run-state')).toContainText('computing');
  await expect
    .poll(
      async () => (await workerEvents(page)).filter((event) => event.run === 3 && event.type === 'rows').length,
      'chunks of rows',
    )
    .toBeGreaterThan(5);

  await page.getByTestId('cancel').click();
  await ended(page, 3, 'cancelled');
  await pause(page);
  const kept = await numberIn(page, 'end-time');
  expect(kept).toBeGreaterThan(0);
  expect(kept).toBeLessThan(Number(LONG));
  const events = (await workerEvents(page)).filter((event) => event.run === 3);
  const asked = events.find((event) => event.sent && event.type === 'cancel')!;
  const answered = events.find((event) => event.type === 'ended')!;
  const figure = `cancel answered after ${(answered.at - asked.at).toFixed(0)} ms, ${kept.toFixed(0)} s of motion kept`;
  measured(figure);

  // Once more, and this time another run takes its place while it computes.
  await page.getByTestId('run').click();
  await expect(page.getByTestId('run-state')).toContainText('computing');
  await expect
    .poll(async () => (await workerEvents(page)).some((event) => event.run === 4 && event.type === 'rows'))
    .toBe(true);
  await chooseCase(page, 'falling-ground');
  await ended(page, 5, 'touchdown');
  await pause(page);
  const end = await numberIn(page, 'end-time');
  expect(end).toBeLessThan(5);
  const { columns, rows } = await exportCsv(page);
  expect(rows.at(-1)![0]!.toFixed(3)).toBe(end.toFixed(3));
  expect(columns).toContain('lambda_4');
  // The abandoned run says nothing more.
  const all = await workerEvents(page);
  const replaced = all.findIndex((event) => event.sent && event.type === 'start' && event.run === 5);
  expect(
    all
      .slice(replaced)
      // The comparison beside the page counts its own runs, fewer.
      .filter((event) => event.type === 'ended' && event.run > 3)
      .map((event) => event.run),
  ).toEqual([5]);
  expect(watch.errors).toEqual([]);
});

test('a 60 s run streams in; tasks longer than 50 ms on the main thread are measured', async ({ page }) => {
  await openPage(page);
  await chooseCase(page, 'falling-report');
  await ended(page, 2, 'end');
  // Else the run follows what is typed, and runs are counted here.
  await page.getByTestId('live').click();
  await typeInto(page, 'duration', '60');
  await page.evaluate(() => {
    window.longTasks = [];
    new PerformanceObserver((list) => {
      for (const entry of list.getEntries())
        window.longTasks.push({ start: entry.startTime, duration: entry.duration });
    }).observe({ type: 'longtask' });
  });
  await page.getByTestId('run').click();
  await ended(page, 3, 'end');
  expect(await numberIn(page, 'end-time')).toBe(60);
  // A run may end within a frame or two of its start.
  await expect.poll(() => numberIn(page, 'time'), { message: 'it plays as it comes' }).toBeGreaterThan(0);

  const events = (await workerEvents(page)).filter((event) => event.run === 3);
  const [from, to] = [events[0]!.at, events.at(-1)!.at];
  expect(events.filter((event) => event.type === 'rows').length, 'chunks').toBeGreaterThan(2);
  expect(await page.evaluate(() => PerformanceObserver.supportedEntryTypes)).toContain('longtask');
  const tasks = (await page.evaluate(() => window.longTasks)).filter(
    (task) => task.start + task.duration >= from && task.start <= to,
  );
  const durations = tasks.map((task) => task.duration);
  const total = durations.reduce((sum, x) => sum + x, 0);
  const figure = `60 s run streamed in ${(to - from).toFixed(0)} ms: ${tasks.length} long tasks, longest ${Math.max(0, ...durations).toFixed(0)} ms, together ${total.toFixed(0)} ms`;
  measured(figure);
});
