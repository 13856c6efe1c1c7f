// A page that answers as it is touched: typed, slid, undone, refused; a file kept apart; words that explain themselves.
import { expect, test, type Page } from '@playwright/test';
import {
  chooseCase,
  csvOf,
  COORDINATES,
  drop,
  ended,
  numberIn,
  openWithoutScene,
  seek,
  VIEWPORT,
} from '../../../tests/browser/helpers.ts';

test.use({ viewport: VIEWPORT });

/** A column of the run on the stage at its start, and whether the run before is seen beside it. */
const onStage = (page: Page, column: string) =>
  page.evaluate((name) => {
    const { state } = (
      window as unknown as {
        ripstikApp: {
          state: {
            motion: { value: { trajectory: { column(name: string): Float64Array } } };
            former: { value: unknown };
          };
        };
      }
    ).ripstikApp;
    return { start: state.motion.value.trajectory.column(name)[0]!, ghost: state.former.value !== null };
  }, column);

test('a number answers while it is typed, slid and undone; nonsense is never run', async ({ page }) => {
  const watch = await openWithoutScene(page);
  await chooseCase(page, 'hanging');
  await ended(page, 2, 'end');
  await seek(page, 2);
  const roll = page.getByTestId('initial-alpha_fp');
  const written = await roll.inputValue();

  // Typed: the start at once, with the run before beside it; then the motion from where it was.
  await roll.fill('pi/8');
  await expect.poll(async () => (await onStage(page, 'alpha_fp')).start).toBeCloseTo(Math.PI / 8, 12);
  await expect(page.getByText('= 22.5°')).toBeVisible();
  await expect(page.getByTestId('time')).toHaveText(/^2\.000\s/);
  await expect(roll).toHaveValue('pi/8');

  // Slid, on demand.
  await page.getByRole('button', { name: 'Slider for rod roll' }).click();
  const slider = page.getByTestId('slide-initial.alpha');
  await slider.focus();
  await slider.press('ArrowRight');
  await expect(page.getByTestId('initial-alpha')).not.toHaveValue('');

  // Undone and done again, each of them shown.
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await expect(roll).toHaveValue(written);
  await expect.poll(async () => (await onStage(page, 'alpha_fp')).start).not.toBeCloseTo(Math.PI / 8, 6);
  await page.keyboard.press('Control+Shift+z');
  await expect(roll).toHaveValue('pi/8');
  await page.getByTestId('history').click();
  await page.getByRole('menuitem', { name: 'Before the first change' }).click();
  await expect(page.getByTestId('case-menu')).toContainText('Ridden board');
  await page.getByTestId('redo').click();
  await expect(page.getByTestId('case-menu')).not.toContainText('changed');

  // What is wrong is gone to, and said; nothing runs meanwhile.
  const end = await page.getByTestId('end-time').innerText();
  const duration = page.getByTestId('duration');
  await duration.fill('abc');
  await page.getByTestId('run').click();
  await expect(duration).toBeFocused();
  await expect(duration).toHaveAttribute('aria-invalid', 'true');
  await expect(page.getByTestId('end-time')).toHaveText(end);
  await page.keyboard.press('Escape');

  // Too long to follow every change: a mark, and Run.
  await duration.fill('100000');
  await expect(page.getByTestId('stale')).toBeVisible();
  await expect(page.getByTestId('end-time')).toHaveText(end);
  await duration.fill('1');
  await expect(page.getByTestId('stale')).toHaveCount(0);
  await expect.poll(() => numberIn(page, 'end-time')).toBe(1);
  await expect(page.locator('.caption')).toContainText('changed');
  await expect(page.getByTestId('caption-changes')).toContainText('duration');

  // A file is another thing, and stays.
  const rows = [0, 1, 2].map((t) => ({ ...Object.fromEntries(COORDINATES.map((name) => [name, 0.1 * t])), t }));
  await drop(page, 'mine.csv', csvOf(rows, ['t', ...COORDINATES]));
  await expect(page.getByTestId('file-apart')).toContainText('mine.csv');
  await duration.fill('3');
  await expect(page.getByTestId('rows')).toHaveText('3 rows');

  // Words explain themselves, and the help has more than keys.
  await page.getByTestId('file-apart').getByRole('button', { name: 'stage' }).click();
  await expect(page.getByRole('tooltip')).toContainText('one motion is played');
  await page.keyboard.press('Escape');
  await page.getByTestId('keys').click();
  await page.getByTestId('help-about').click();
  await expect(page.getByTestId('about')).toContainText('A-1: Modelling and Control of a Ripstik');
  await page.getByTestId('help-licences').click();
  await expect(page.getByTestId('licences')).toContainText('preact');
  expect(watch.errors).toEqual([]);
});
