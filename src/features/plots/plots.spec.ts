import { readFileSync } from 'node:fs';
import { expect, test, type Page } from '@playwright/test';
import { chooseCase, ended, openWithoutScene, pause, seek } from '../../../tests/browser/helpers.ts';

test.use({ viewport: { width: 1100, height: 700 } });

const time = async (page: Page): Promise<number> =>
  page.evaluate(() => Number(document.querySelector<HTMLInputElement>('.transport input[type=range]')!.value));
const pane = (page: Page, i: number) => page.getByTestId('plot-pane').nth(i);

test('plots of a case: shared time, zoom, legend, units, other axes, saved', async ({ page }) => {
  const watch = await openWithoutScene(page);
  await chooseCase(page, 'wheel-pendulum-lqr');
  await ended(page, 2, 'end');
  await pause(page);
  await page.getByTestId('tool-plots').click();
  await expect(page.getByTestId('plot-pane')).not.toHaveCount(0);

  // The case's own axes, and the value at the cursor is the run's.
  await seek(page, 0);
  await expect(page.getByTestId('legend-psi').first()).toContainText('−96');
  await page.getByTestId('plots-degrees').uncheck();
  await expect(page.getByTestId('legend-psi').first()).toContainText('−1.676');
  await page.getByTestId('plots-degrees').check();

  // A click goes there, in scene and transport too.
  const over = pane(page, 0).getByTestId('plot-canvas');
  const box = (await over.boundingBox())!;
  const [left, right] = [box.x + 56, box.x + box.width - 12];
  await page.mouse.click((left + right) / 2, box.y + box.height / 2);
  expect(await time(page)).toBeCloseTo(7.5, 1);

  // Dragging zooms all plots over time, zero shows all again.
  await page.mouse.move(box.x + box.width * 0.2, box.y + 20);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.4, box.y + 30, { steps: 4 });
  await page.mouse.up();
  await expect(page.getByTestId('plots-whole')).toBeEnabled();
  const canvas = pane(page, 0).getByTestId('plot-canvas');
  await canvas.focus();
  await page.keyboard.press('0');
  await expect(page.getByTestId('plots-whole')).toBeDisabled();
  await page.keyboard.press('+');
  await expect(page.getByTestId('plots-whole')).toBeEnabled();
  const before = await time(page);
  await page.keyboard.press('ArrowRight');
  expect(await time(page)).toBeGreaterThan(before);

  // Another curve, hidden and shown; a phase portrait; the table; the case's plots again.
  await pane(page, 0).getByTestId('plot-add-curve').selectOption('psi_dot');
  await pane(page, 0).getByTestId('legend-psi_dot').click();
  await expect(pane(page, 0).getByTestId('legend-psi_dot')).toHaveAttribute('aria-pressed', 'false');
  await pane(page, 0).getByTestId('plot-x').selectOption('psi');
  await pane(page, 0).getByTestId('plot-table').click();
  await expect(pane(page, 0).getByTestId('chart-values').locator('tbody tr')).toHaveCount(21);

  await pane(page, 0).getByTestId('plot-save').click();
  const [csv] = await Promise.all([page.waitForEvent('download'), page.getByTestId('plot-csv').click()]);
  const lines = readFileSync(await csv.path(), 'utf8')
    .trim()
    .split('\n');
  expect(lines[0]).toMatch(/^t,psi/);
  expect(lines.length).toBeGreaterThan(100);
  await pane(page, 0).getByTestId('plot-save').click();
  const [svg] = await Promise.all([page.waitForEvent('download'), page.getByTestId('plot-svg').click()]);
  expect(readFileSync(await svg.path(), 'utf8')).toMatch(/<path d="M[^"]{200,}/);

  await page.getByTestId('plots-case').click();
  await expect(pane(page, 0).getByTestId('legend-psi_dot')).toHaveCount(0);
  expect(watch.errors).toEqual([]);
  expect(await page.evaluate(() => window.cspViolations)).toEqual([]);
});

test('a system of first order shows the exact curve; a running motion grows', async ({ page }) => {
  const watch = await openWithoutScene(page);
  await page.getByTestId('tool-plots').click();
  await chooseCase(page, 'stiff-decay-euler-8');
  await ended(page, 2, 'end');
  await expect(page.getByTestId('plots')).toContainText('exact solution');
  await chooseCase(page, 'ridden');
  await ended(page, 3, 'end');
  await expect(page.getByTestId('plot-spent')).toContainText('J put in');
  expect(watch.errors).toEqual([]);
});
