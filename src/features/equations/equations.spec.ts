import { expect, test, type Page } from '@playwright/test';
import {
  chooseCase,
  csvOf,
  COORDINATES,
  drop,
  ended,
  exportCsv,
  openWithoutScene,
  seek,
  VIEWPORT,
} from '../../../tests/browser/helpers.ts';

test.use({ viewport: VIEWPORT, permissions: ['clipboard-read', 'clipboard-write'] });

const plain = (text: string): number => parseFloat(text.replaceAll('\u2212', '-'));

async function openEquations(page: Page, system: string): Promise<void> {
  await page.getByTestId('tool-equations').click();
  await expect(page.getByTestId('equations')).toHaveAttribute('data-system', system);
  await formulasSet(page);
}

/** No formula of an open section waits. */
async function formulasSet(page: Page): Promise<void> {
  await expect.poll(() => page.locator('.formula-box:visible:not(:has(.katex))').count()).toBe(0);
  await expect(page.locator('.formula [role="alert"]')).toHaveCount(0);
}

async function openSection(page: Page, title: string): Promise<void> {
  await page
    .getByTestId('equations')
    .locator('summary', { has: page.getByRole('heading', { name: title, exact: true }) })
    .click();
}

test('the board: present numbers, matrices, meanings, LaTeX copied', async ({ page }) => {
  const watch = await openWithoutScene(page);
  await seek(page, 2);
  const { columns, rows } = await exportCsv(page);
  const row = rows.find(([t]) => Math.abs(t! - 2) < 1e-9)!;
  const at = (name: string) => row[columns.indexOf(name)]!;
  await openEquations(page, 'ripstik');

  await expect.poll(async () => plain(await page.getByTestId('equations-value-X').innerText())).toBeCloseTo(at('X'), 3);
  expect(plain(await page.getByTestId('equations-value-alpha_fp').innerText())).toBeCloseTo(
    (at('alpha_fp') * 180) / Math.PI,
    1,
  );
  const energy = async (letter: string) => plain(await page.getByTestId(`equations-${letter}`).innerText());
  expect((await energy('T')) + (await energy('V'))).toBeCloseTo(at('energy'), 2);

  await openSection(page, 'In numbers');
  const mass = page.getByTestId('equations-mass').locator('tbody tr');
  await expect(mass).toHaveCount(10);
  expect(plain(await mass.nth(0).locator('td').nth(0).innerText())).toBe(5);
  await expect(page.getByTestId('equations-condition')).toContainText('condition number');
  await expect(page.getByTestId('equations-omega').locator('tbody th')).toHaveText([
    'front lateral',
    'front vertical',
    'back lateral',
    'back vertical',
  ]);
  expect(plain(await page.getByTestId('equations-lambda-2').innerText())).toBeCloseTo(at('lambda_2'), 1);

  // Pointing at a letter says what it is; a formula's letters are walked through by keys.
  await page.getByTestId('equations').locator('[data-symbol="plateMass"]:visible').first().hover();
  await expect(page.getByTestId('equations-readout')).toContainText('plate mass=\u202f1\u202fkg');
  const potential = page.getByRole('group', { name: /^Potential energy/ });
  await potential.focus();
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowRight');
  await expect(potential.locator('.pointed').first()).toBeVisible();
  await expect(page.getByTestId('time')).toHaveText(/^2\.000/);
  await expect(potential.locator('math').first()).toBeAttached();
  await page.getByRole('button', { name: 'Copy LaTeX: Kinetic energy' }).click();
  expect(await page.evaluate(() => navigator.clipboard.readText())).toBe(
    'T = T_{r} + T_{fp} + T_{bp} + T_{fc} + T_{bc}',
  );

  await openSection(page, 'Constraints');
  await page.getByTestId('equations-set-rolling').locator('details').first().locator('summary').click();
  await expect(page.getByTestId('equations-set-rolling').locator('details').first().locator('.formula')).toHaveCount(8);
  for (const title of ['Bodies and frames', 'Inputs', 'Parameters']) await openSection(page, title);
  await formulasSet(page);
  await expect(page.getByTestId('equations-parameters').locator('tbody tr')).toHaveCount(20);
  // wide formulas stay in their boxes
  expect(
    await page.getByTestId('equations').evaluate((element) => element.scrollWidth - element.clientWidth),
  ).toBeLessThanOrEqual(0);
  expect(watch.errors).toEqual([]);
  expect(watch.foreign).toEqual([]);
  expect(await page.evaluate(() => window.cspViolations)).toEqual([]);
});

test('other systems, a file, and the phone', async ({ page }) => {
  const watch = await openWithoutScene(page);
  await openEquations(page, 'ripstik');
  await chooseCase(page, 'bicycle-weave');
  await ended(page, 2, 'end');
  await expect(page.getByTestId('equations')).toHaveAttribute('data-system', 'bicycle');
  await openSection(page, 'In numbers');
  await expect(page.getByTestId('equations-omega').locator('tbody tr')).toHaveCount(5);
  await page.getByTestId('system').selectOption('stiff-decay');
  await expect(page.getByTestId('equations')).toHaveAttribute('data-system', 'stiff-decay');
  await formulasSet(page);

  const rows = Array.from({ length: 20 }, (_, i) =>
    Object.fromEntries([['t', i / 60], ...COORDINATES.map((name) => [name, name === 'Z' ? 0.08196 : 0.001 * i])]),
  );
  await drop(page, 'board.csv', csvOf(rows, ['t', ...COORDINATES]));
  await expect(page.getByTestId('equations')).toHaveAttribute('data-system', 'ripstik');
  await expect(page.getByTestId('equations-value-Z')).toHaveText('0.0820');

  await page.setViewportSize({ width: 390, height: 800 });
  await page.getByTestId('tab-equations').click();
  await formulasSet(page);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390);
  expect(watch.errors).toEqual([]);
  expect(await page.evaluate(() => window.cspViolations)).toEqual([]);
});
