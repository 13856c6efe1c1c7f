import { expect, test } from '@playwright/test';
import {
  chooseCase,
  ended,
  measured,
  medianOf,
  openPage,
  pause,
  seek,
  VIEWPORT,
} from '../../../tests/browser/helpers.ts';

test.use({ viewport: VIEWPORT });

test('a weight is changed while the board rides: the readout follows, the motion goes on with the new gain, undo takes it back', async ({
  page,
}) => {
  const watch = await openPage(page);
  await chooseCase(page, 'balanced');
  await ended(page, 2, 'end');
  await pause(page);
  await seek(page, 1);
  await page.locator('summary', { hasText: 'Control' }).first().click();
  await expect(page.getByTestId('lqr-facts')).toContainText('10 of 14');
  await expect(page.getByTestId('lqr-effect')).toContainText('work put in');
  const poles = page.getByTestId('lqr-poles');
  const before = await poles.innerText();

  const slider = page.getByTestId('slider-alpha_fp');
  await slider.focus();
  await slider.press('End');
  await expect(page.getByTestId('weight-alpha_fp')).toHaveValue('10000');
  await expect.poll(() => poles.innerText()).not.toBe(before);
  await expect(page.getByRole('button', { name: 'retuned' })).toBeVisible();
  await expect(page.getByTestId('run-state')).toHaveAttribute('data-reason', 'end');
  // Still where it was, with what was ridden before kept.
  expect(Number(await page.getByTestId('scrubber').inputValue())).toBeCloseTo(1, 2);

  await page.getByTestId('undo').click();
  await expect(page.getByTestId('weight-alpha_fp')).toHaveValue('1');
  await expect.poll(() => poles.innerText()).toBe(before);

  // From a move of the slider to the new numbers on the screen, and to the first frame of the motion that goes on with them.
  await seek(page, 1);
  const waits = await page.evaluate(async () => {
    const control = document.querySelector<HTMLInputElement>('[data-testid="slider-alpha_fp"]')!;
    const shown = document.querySelector<HTMLElement>('[data-testid="lqr-poles"]')!;
    const { state } = (window as unknown as { ripstikApp: { state: { motion: { value: { id: number } } } } })
      .ripstikApp;
    const frame = () => new Promise<number>((done) => requestAnimationFrame(done));
    const list: { readout: number; motion: number }[] = [];
    for (let k = 1; k <= 9; k++) {
      const [text, id, from] = [shown.innerText, state.motion.value.id, performance.now()];
      control.value = String(k / 4);
      control.dispatchEvent(new InputEvent('input', { bubbles: true }));
      let [readout, motion] = [0, 0];
      while (readout === 0 || motion === 0) {
        await frame();
        const now = performance.now() - from;
        if (readout === 0 && shown.innerText !== text) readout = now;
        if (motion === 0 && state.motion.value.id !== id) motion = now;
      }
      list.push({ readout, motion });
      for (let i = 0; i < 30; i++) await frame();
    }
    return list;
  });
  measured(
    `from a weight to its readout: median ${medianOf(waits.map((w) => w.readout)).toFixed(0)} ms, to the motion that goes on: median ${medianOf(waits.map((w) => w.motion)).toFixed(0)} ms`,
  );
  for (let k = 0; k < 9 && (await page.getByTestId('weight-alpha_fp').inputValue()) !== '1'; k++)
    await page.keyboard.press('Control+z');
  await expect(page.getByTestId('weight-alpha_fp')).toHaveValue('1');

  // No input is no design: the place and the reason are told, and the motion stays.
  for (const name of ['tau_fc', 'tau_bc']) await page.getByTestId(`lqr-input-${name}`).uncheck();
  await expect(page.getByText('name at least one input').first()).toBeVisible();
  expect(watch.errors).toEqual([]);
});

test('a computer that is too slow for the weights is called so where it is chosen', async ({ page }) => {
  await openPage(page);
  await chooseCase(page, 'balanced');
  await page.locator('summary', { hasText: 'Control' }).first().click();
  const computer = page.getByTestId('lqr-computer');
  await expect(computer).toContainText('needs a computer faster than 572 Hz; delay at most 1.37 ms');
  await page.getByTestId('lqr-sample').fill('0.005');
  await page.getByTestId('lqr-sample').press('Enter');
  await expect(computer).toContainText('the loop is unstable');
  await page.getByTestId('lqr-design').selectOption('sampled');
  await expect(computer).toContainText('the loop is stable');
});
