import { readFileSync } from 'node:fs';
import { expect, test } from '@playwright/test';
import { chooseCase, ended, openWithoutScene, VIEWPORT } from '../../../tests/browser/helpers.ts';

test.use({ viewport: VIEWPORT });

/** Every one that the view offers to begin with, and a fixed-step one. */
const CHOSEN = ['qr', 'collocation', 'ida', 'blt', 'dopri5', 'dop853', 'rk4'];

test('methods are compared on the scenario in the panel: table, curves, cancel, table as CSV', async ({ page }) => {
  const watch = await openWithoutScene(page);
  await chooseCase(page, 'released');
  await ended(page, 2, 'touchdown');
  await page.getByTestId('tool-methods').click();
  const row = (id: string) => page.getByTestId(`method-row-${id}`);
  for (const id of CHOSEN) await row(id).getByRole('checkbox').check();
  await page.getByTestId('methods-run').click();
  for (const id of CHOSEN) await expect(row(id).locator('.why span')).toHaveText('touchdown');
  await expect(page.getByTestId('methods-cancel')).toBeDisabled();
  await expect(page.getByTestId('methods-plot').locator('canvas')).toBeVisible();

  // All of them fall at the same moment.
  const reached = await Promise.all(CHOSEN.map(async (id) => Number(await row(id).locator('.reached').innerText())));
  for (const t of reached) expect(t).toBeCloseTo(0.5243, 3);

  const [file] = await Promise.all([page.waitForEvent('download'), page.getByTestId('methods-csv').click()]);
  const lines = readFileSync(await file.path(), 'utf8')
    .trim()
    .split('\n');
  expect(lines).toHaveLength(1 + CHOSEN.length);
  expect(lines[0]).toContain('computing_s,output_s,steps');
  await page.keyboard.press('Escape');
  await expect(page.getByTestId('tool-panel-methods')).toBeHidden();
  expect(watch.errors).toEqual([]);
});
