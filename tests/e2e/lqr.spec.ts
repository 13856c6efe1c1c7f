import { expect, test } from '@playwright/test';
import { chooseCase, ended, openPage, pause, seek, VIEWPORT } from './helpers.ts';

test.use({ viewport: VIEWPORT });

test('a weight is changed while the board rides: the readout follows, the motion goes on with the new gain, undo takes it back', async ({ page }) => {
  const watch = await openPage(page);
  await chooseCase(page, 'balanced');
  await ended(page, 2, 'end');
  await pause(page);
  await seek(page, 1);
  await page.locator('summary', { hasText: 'Control' }).first().click();
  const readout = page.getByTestId('lqr-readout');
  await expect(readout).toContainText('10 of 14');
  const before = await readout.innerText();

  const slider = page.getByTestId('slider-alpha_fp');
  await slider.focus();
  await slider.press('End');
  await expect(page.getByTestId('weight-alpha_fp')).toHaveValue('10000');
  await expect.poll(() => readout.innerText()).not.toBe(before);
  await expect(page.getByRole('button', { name: 'retuned' })).toBeVisible();
  await expect(page.getByTestId('run-state')).toHaveAttribute('data-reason', 'end');
  // Still where it was, with what was ridden before kept.
  expect(Number(await page.getByTestId('scrubber').inputValue())).toBeCloseTo(1, 2);

  await page.getByTestId('lqr-undo').click();
  await expect(page.getByTestId('weight-alpha_fp')).toHaveValue('1');
  await expect.poll(() => readout.innerText()).toBe(before);

  // No input is no design: the place and the reason are told, and the motion stays.
  for (const name of ['tau_fc', 'tau_bc']) await page.getByTestId(`lqr-input-${name}`).uncheck();
  await expect(page.getByText('name at least one input').first()).toBeVisible();
  expect(watch.errors).toEqual([]);
});
