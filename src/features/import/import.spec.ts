// How a file was read, walked by keyboard on desk and phone; nothing is wrong for a screen reader in either theme.
import AxeBuilder from '@axe-core/playwright';
import { expect, test, type Page } from '@playwright/test';
import { drawn, drop, openPage, openWithoutScene, pause, seek } from '../../../tests/browser/helpers.ts';

/** A sleigh whose heading is in degrees that nothing names, lengths in millimetres by the units row. */
const rows = Array.from({ length: 60 }, (_, i) => {
  const t = i / 30;
  return [t * 1000, 300 * t, 40 * Math.sin(t), 170 * Math.sin(3 * t)].map((x) => x.toFixed(3).replace('.', ','));
});
const sleigh = ['Zeit;x;y;theta', 'ms;mm;mm;', ...rows.map((row) => row.join(';')), ''].join('\r\n');
const log = [
  'time,volts,yaw rate [deg/s]',
  ...Array.from({ length: 40 }, (_, i) => `${i / 20},${3 + i / 100},30`),
  '',
].join('\n');

const RULES = ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa'];

const endTime = (page: Page) => page.getByTestId('end-time');

/** Where the first body is, and how it stands: 12 numbers of the scene. */
async function bodyOnStage(page: Page): Promise<number[]> {
  await drawn(page);
  return page.evaluate(() => window.ripstikScene!.bodyMatrix(0) ?? []);
}

/** Tab by Tab, as without a mouse. */
async function tabTo(page: Page, testId: string): Promise<void> {
  for (let i = 0; i < 120; i++) {
    if (await page.getByTestId(testId).evaluate((element) => element === document.activeElement)) return;
    await page.keyboard.press('Tab');
  }
  throw new Error(`${testId} is not reached by Tab`);
}

/** By the first letters of the option, which a closed list takes. */
async function chooseByKeys(page: Page, testId: string, value: string): Promise<void> {
  await tabTo(page, testId);
  const list = page.getByTestId(testId);
  for (let i = 0; i < 40 && (await list.inputValue()) !== value; i++) {
    const before = await list.inputValue();
    await page.keyboard.press('ArrowDown');
    if ((await list.inputValue()) === before) break;
  }
  await expect(list).toHaveValue(value);
}

async function expectAccessible(page: Page, within: string): Promise<void> {
  for (const theme of ['light', 'dark'] as const) {
    await page.evaluate((name) => {
      const { ripstikApp } = window as unknown as { ripstikApp: { actions: { set(id: string, value: string): void } } };
      ripstikApp.actions.set('theme', name);
    }, theme);
    const { violations } = await new AxeBuilder({ page }).include(within).withTags(RULES).analyze();
    expect(
      violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.target.join(' ')).join('; ')}`),
    ).toEqual([]);
  }
}

test.describe('on a desk', () => {
  test.use({ viewport: { width: 1200, height: 720 } });

  test('plays at once, asks beside it, follows each change, and remembers it', async ({ page }) => {
    const watch = await openPage(page);
    await drop(page, 'sleigh.csv', sleigh);
    await expect(endTime(page)).toHaveText(/^1\.967\s/);
    await expect(page.getByTestId('file-apart')).toContainText('sleigh.csv');
    await pause(page);

    // In the safest reading first; one press, by keyboard, reads it the other way where it stands.
    await seek(page, 0.5);
    const inRadians = await bodyOnStage(page);
    await tabTo(page, 'stage-answer-degrees-1');
    await page.keyboard.press('Enter');
    await expect(page.getByTestId('stage-question-degrees')).toHaveCount(0);
    await expect(page.getByTestId('time')).toHaveText(/^0\.500\s/);
    await expect.poll(() => bodyOnStage(page)).not.toEqual(inRadians);

    // The view says what was understood.
    await tabTo(page, 'how-read');
    await page.keyboard.press('Enter');
    await expect(page.getByTestId('import-unit-1')).toHaveValue('mm');
    await expect(page.getByTestId('import-separator')).toHaveValue(';');
    await expect(page.getByTestId('import-decimal')).toHaveValue(',');
    await expect(page.getByTestId('import-angles')).toHaveValue('deg');
    await expect(page.getByTestId('import-preview').getByRole('row').nth(1)).toContainText('0,000');
    await expectAccessible(page, '[data-testid=tool-panel-import]');

    // Each choice is read at once and keeps the focus.
    const before = await bodyOnStage(page);
    await chooseByKeys(page, 'import-unit-1', 'km');
    await expect.poll(() => bodyOnStage(page)).not.toEqual(before);
    await expect(page.getByTestId('import-unit-1')).toBeFocused();

    // A file of the same shape is read the same way, without a question.
    await drop(page, 'sleigh again.csv', sleigh);
    await expect(page.getByTestId('status')).toContainText('sleigh again.csv');
    await expect(page.getByTestId('import-unit-1')).toHaveValue('km');
    await expect(page.getByTestId('tool-question-degrees')).toHaveCount(0);
    await tabTo(page, 'import-as-found');
    await page.keyboard.press('Enter');
    await expect(page.getByTestId('import-unit-1')).toHaveValue('mm');
    await expect(page.getByTestId('tool-question-degrees')).toBeVisible();
    expect(watch.errors).toEqual([]);
  });

  test('another body, another run, and data: a choice each, by keyboard', async ({ page }) => {
    const watch = await openPage(page);
    const line = (i: number, more = 0) => [i / 30 + more, i / 100, 0, 0, 5 + i / 50, 5, 1].join(',');
    const once = Array.from({ length: 30 }, (_, i) => line(i));
    const again = Array.from({ length: 60 }, (_, i) => line(i));
    await drop(page, 'two.csv', ['t,a.x,a.y,a.theta,b.x,b.y,b.theta', ...once, ...again, ''].join('\n'));
    await expect(endTime(page)).toHaveText(/^0\.967\s/);
    await pause(page);
    const first = await bodyOnStage(page);
    await tabTo(page, 'how-read');
    await page.keyboard.press('Enter');
    await chooseByKeys(page, 'import-body', 'b');
    await expect.poll(() => bodyOnStage(page)).not.toEqual(first);
    await chooseByKeys(page, 'import-run', '2');
    await expect(endTime(page)).toHaveText(/^1\.967\s/);
    await expect(page.getByTestId('import-body')).toHaveValue('b');
    await page.getByTestId('import-system').selectOption('');
    await expect(page.getByTestId('no-scene')).toBeVisible();
    await expect(page.getByTestId('import-run')).toHaveValue('2');
    expect(watch.errors).toEqual([]);
  });

  test('columns of no system are data, and become a system as they are given places', async ({ page }) => {
    const watch = await openWithoutScene(page);
    await drop(page, 'log.csv', log);
    await expect(page.getByTestId('no-scene')).toBeVisible();
    await expect(page.getByTestId('scene-text')).toContainText('volts');
    await expectAccessible(page, '[data-testid=no-scene]');
    await tabTo(page, 'data-plots');
    await page.keyboard.press('Enter');
    await expect(page.getByTestId('tool-panel-plots')).toContainText('volts');
    await page.getByTestId('tool-now').click();
    await expect(page.getByTestId('now-yaw rate')).toHaveText('30');
    await page.getByTestId('tool-compare').click();
    await page.getByTestId('compare-keep').click();
    await page.getByTestId('export-menu').click();
    const [download] = await Promise.all([page.waitForEvent('download'), page.getByTestId('export-csv').click()]);
    expect(download.suggestedFilename()).toBe('log.csv');

    // What can't be read yet says so, and the file stays as it is.
    await page.getByTestId('tool-import').click();
    await page.getByTestId('import-system').selectOption('stiff-decay');
    await expect(page.getByTestId('import-refused')).toBeVisible();
    await expect(page.getByTestId('no-scene')).toBeVisible();
    await page.getByTestId('import-target-1').selectOption('y');
    await expect(page.getByTestId('import-refused')).toHaveCount(0);
    await expect(page.getByTestId('no-scene')).toHaveCount(0);
    expect(watch.errors).toEqual([]);
  });
});

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test('the tab of the file comes forward with its questions, and fits', async ({ page }) => {
    const watch = await openWithoutScene(page);
    await drop(page, 'sleigh.csv', sleigh);
    await expect(page.getByTestId('tab-import')).toHaveAttribute('aria-selected', 'true');
    await expect(page.getByTestId('tab-import')).toBeInViewport({ ratio: 0.9 });
    await tabTo(page, 'tool-answer-degrees-1');
    await page.keyboard.press('Enter');
    await expect(page.getByTestId('tool-question-degrees')).toHaveCount(0);
    await tabTo(page, 'import-target-3');
    await expect(page.getByTestId('import-target-3')).toHaveValue('theta');
    await expect(page.getByTestId('import-target-3')).toBeInViewport();
    await expectAccessible(page, '#sheet-import');
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
    expect(watch.errors).toEqual([]);
  });
});
