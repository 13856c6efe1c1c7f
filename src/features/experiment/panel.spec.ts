import { expect, test } from '@playwright/test';
import {
  chooseCase,
  ended,
  measured,
  medianOf,
  openPage,
  openWithoutScene,
  seek,
  type as typeInto,
  VIEWPORT,
} from '../../../tests/browser/helpers.ts';

test.use({ viewport: VIEWPORT });

test('fields read degrees and expressions, refuse nonsense, and show what the start became', async ({ page }) => {
  await openWithoutScene(page);
  await page.getByTestId('tool-now').click();
  const field = page.getByTestId('initial-alpha_fp');
  const plateAngle = page.getByTestId('now-alpha_fp');

  // The first run: nothing named the height, and the board was put on its wheels.
  await expect(page.getByTestId('solved-Z')).toContainText(/→ 0\.\d+\s*m/);

  // A held rod: the plates start where the field says, whatever that is.
  await chooseCase(page, 'hanging');
  await ended(page, 2, 'end');
  await expect(page.getByTestId('solved-Z')).toHaveCount(0);
  await typeInto(page, 'duration', '1');
  const runAndGoToStart = async () => {
    await page.getByTestId('run').click();
    await expect(page.getByTestId('stale')).toHaveCount(0);
    await expect(page.getByTestId('run-state')).toHaveAttribute('data-reason', 'end');
    await seek(page, 0);
  };

  await typeInto(page, 'initial-alpha_fp', 'pi/8');
  await expect(field).toHaveValue('pi/8');
  await runAndGoToStart();
  await expect(plateAngle).toHaveText('22.50');

  await typeInto(page, 'initial-alpha_fp', '30 deg');
  await expect(field).toHaveValue('30');
  await runAndGoToStart();
  await expect(plateAngle).toHaveText('30.00');

  // Nonsense stays in its field with its reason, and is never run: Run leads to it.
  await typeInto(page, 'initial-alpha_fp', 'pi/(8');
  await expect(field).toHaveAttribute('aria-invalid', 'true');
  const error = page.locator(`[id="${await field.getAttribute('aria-describedby')}"]`);
  await expect(error).toBeVisible();
  await expect(error).not.toBeEmpty();
  await expect(page.getByTestId('wrong')).toBeVisible();
  await page.getByTestId('run').click();
  await expect(field).toBeFocused();
  await expect(plateAngle).toHaveText('30.00');

  await typeInto(page, 'initial-alpha_fp', '-10');
  await expect(field).not.toHaveAttribute('aria-invalid', 'true');
  await expect(error).toHaveCount(0);
  await runAndGoToStart();
  await expect(plateAngle).toHaveText('−10.00');
});

test('a number is run as it is typed: the first frame of the new run comes at once', async ({ page }) => {
  const watch = await openPage(page);
  await chooseCase(page, 'released');
  await ended(page, 2, 'touchdown');
  const waits = await page.evaluate(async () => {
    const field = document.querySelector<HTMLInputElement>('[data-testid="initial-alpha"]')!;
    const { state } = (
      window as unknown as {
        ripstikApp: { state: { motion: { subscribe(listener: (motion: { id: number }) => void): () => void } } };
      }
    ).ripstikApp;
    // Frames drawn when the new run came: what is drawn then shows it.
    let known = 0;
    let came: number | null = null;
    state.motion.subscribe(({ id }) => {
      if (id !== known) came = window.ripstikScene!.stats().frames;
      known = id;
    });
    const frame = () => new Promise<number>((done) => requestAnimationFrame(done));
    const list: number[] = [];
    for (let k = 1; k <= 9; k++) {
      field.focus();
      field.value = `${k / 10}`;
      came = null;
      const from = performance.now();
      field.dispatchEvent(new InputEvent('input', { bubbles: true }));
      while (came === null || window.ripstikScene!.stats().frames <= came) await frame();
      list.push(performance.now() - from);
      for (let i = 0; i < 20; i++) await frame();
    }
    return list;
  });
  measured(
    `from a digit to the first frame of the new run: ${waits.map((ms) => ms.toFixed(0)).join(' ')} ms, median ${medianOf(waits).toFixed(0)} ms`,
  );
  // What is written is refused: nothing runs.
  const run = await page.getByTestId('end-time').innerText();
  await page.getByTestId('duration').fill('2 +');
  await page.getByTestId('duration').press('Enter');
  await expect(page.getByTestId('duration')).toHaveAttribute('aria-invalid', 'true');
  await expect(page.getByTestId('end-time')).toHaveText(run);
  expect(watch.errors).toEqual([]);
});
