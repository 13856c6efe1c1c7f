import { readFileSync } from 'node:fs';
import { expect, test, type Page } from '@playwright/test';
import {
  chooseCase,
  ended,
  numberIn,
  openWithoutScene,
  type as typeIn,
  VIEWPORT,
} from '../../../tests/browser/helpers.ts';

test.use({ viewport: VIEWPORT });

const plain = (text: string): number => parseFloat(text.replaceAll('\u2212', '-'));

/** First column of a table of modes. */
async function eigenvaluesIn(page: Page, table: string): Promise<string[]> {
  return (await page.getByTestId(table).locator('tbody th').allInnerTexts()).map((text) =>
    text.replaceAll('\u2212', '-'),
  );
}

async function ready(page: Page): Promise<void> {
  await expect(page.getByTestId('analysis')).toHaveAttribute('data-state', 'ready');
}

test('the upright board: at rest, at 1 m/s, its orders, a point that is none', async ({ page }) => {
  const watch = await openWithoutScene(page);
  await chooseCase(page, 'released');
  await ended(page, 2, 'touchdown');
  await page.getByTestId('tool-analysis').click();
  await ready(page);
  // At rest: the fastest growth, and what it is where the constraint Jacobian is frozen.
  expect((await eigenvaluesIn(page, 'modes-open'))[0]).toBe('10.99');
  expect(plain(await page.getByTestId('growth-c').innerText())).toBe(14.04);
  expect(await numberIn(page, 'difference-b')).toBeLessThan(1e-10);
  await expect(page.getByTestId('reach-summary')).toContainText('8 of 14');

  await typeIn(page, 'point-X_dot', '1');
  await expect(page.getByTestId('reach-summary')).toContainText('10 of 14');
  expect(await eigenvaluesIn(page, 'modes-open')).toEqual([
    '9.372 ± 0.4646i',
    '0',
    '0',
    '0',
    '0',
    '0',
    '0',
    '-6.64 ± 22.36i',
    '-7.585 ± 28.15i',
    '-10.91',
    '-12.7',
  ]);
  await expect(page.getByTestId('unreachable').locator('li')).toHaveCount(4);
  await expect(page.getByTestId('reach-dots').locator('tbody tr')).toHaveCount(6);

  // By keys: the first point, then the next ones.
  await page.getByTestId('eigenvalue-plane').locator('[tabindex="0"]').focus();
  await expect(page.getByTestId('mode-detail')).toContainText('12.695');
  await page.keyboard.press('ArrowRight');
  await expect(page.getByTestId('mode-detail')).toContainText('10.911');
  await page.keyboard.press('ArrowRight');
  await expect(page.getByTestId('mode-detail')).toContainText('Hz');

  // A lean that stays is no steady motion: it is said where, and the last point stays.
  await page.getByTestId('point-add').selectOption('alpha_fp');
  await typeIn(page, 'point-alpha_fp', '5');
  await expect(page.getByTestId('analysis-problem')).toContainText('no steady motion');
  await expect(page.getByTestId('analysis')).toHaveAttribute('data-state', 'refused');
  await expect(page.getByTestId('modes-open')).toBeVisible();
  await typeIn(page, 'point-alpha_fp', '');
  await ready(page);

  await page.getByTestId('fold-right').click();
  await expect(page.getByTestId('tool-panel-analysis')).toHaveCount(0);
  await expect(page.getByTestId('tool-analysis')).toBeFocused();
  expect(watch.errors).toEqual([]);
  expect(await page.evaluate(() => window.cspViolations)).toEqual([]);
});

test('a balanced board: closed loop, gains as JSON, root locus computed, walked, cancelled, saved', async ({
  page,
}) => {
  const watch = await openWithoutScene(page);
  await chooseCase(page, 'balanced');
  await ended(page, 2, 'end');
  await page.getByTestId('tool-analysis').click();
  await ready(page);
  const closed = (await eigenvaluesIn(page, 'modes-closed')).map(plain);
  expect(Math.max(...closed)).toBe(0);
  expect(closed.filter((re) => re === 0)).toHaveLength(4);
  expect(await numberIn(page, 'care-residual')).toBeLessThan(1e-10);

  const [json] = await Promise.all([page.waitForEvent('download'), page.getByTestId('analysis-export-json').click()]);
  expect(json.suggestedFilename()).toBe('ripstik-lqr.json');
  const design = JSON.parse(readFileSync(await json.path(), 'utf8')) as {
    states: string[];
    inputs: string[];
    A: number[][];
    K: number[][];
  };
  expect(design.inputs).toEqual(['tau_fc', 'tau_bc']);
  expect([design.states.length, design.A.length, design.K.length, design.K[0]!.length]).toEqual([20, 20, 2, 20]);
  const shown = plain(await page.getByTestId('gains').locator('tbody tr').nth(3).locator('td').nth(1).innerText());
  expect(shown).toBe(Number(design.K[0]![3]!.toPrecision(4)));

  await page.getByTestId('locus-closed').check();
  await typeIn(page, 'locus-to', '3');
  await typeIn(page, 'locus-count', '31');
  await page.getByTestId('locus-run').click();
  await expect(page.getByTestId('locus-critical')).toContainText('nothing grows above');
  await expect(page.getByTestId('locus-plot').locator('canvas')).toBeVisible();
  await page.getByTestId('locus-walk').focus();
  await page.keyboard.press('End');
  await expect(page.getByTestId('locus').locator('output')).toContainText('3');
  const [csv] = await Promise.all([page.waitForEvent('download'), page.getByTestId('locus-csv').click()]);
  const lines = readFileSync(await csv.path(), 'utf8')
    .trim()
    .split('\n');
  expect(lines[0]!.split(',')).toHaveLength(1 + 2 * 14);
  expect(lines.length).toBeGreaterThan(31);

  await page.getByTestId('locus-subject').selectOption('parameter.casterTrail');
  await typeIn(page, 'locus-count', '1000');
  await page.getByTestId('locus-run').click();
  await page.getByTestId('locus-cancel').click();
  await expect(page.getByTestId('locus-cancel')).toBeDisabled();
  // What was there before stays.
  await expect(page.getByTestId('locus-critical')).toContainText('nothing grows above');
  expect(watch.errors).toEqual([]);
});

test('a rider from rest to 5 m/s: growth, largest gain and delay margin', async ({ page }) => {
  await openWithoutScene(page);
  await chooseCase(page, 'rider-balanced');
  await page.getByTestId('tool-analysis').click();
  await ready(page);
  await page.getByTestId('curves-section').locator('summary').click();
  await typeIn(page, 'curves-count', '2');
  await page.getByTestId('curves-run').click();
  const rows = page.getByTestId('curves-table').locator('tbody tr');
  await expect(rows).toHaveText([/^0\s*2\.998\s*58226\s*tau_af per beta/, /^5\s*2\.564\s*143\.8\s*tau_af per beta/]);
});
