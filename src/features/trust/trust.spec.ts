import { expect, test } from '@playwright/test';
import { chooseCase, openWithoutScene, VIEWPORT } from '../../../tests/browser/helpers.ts';

test.use({ viewport: VIEWPORT });

test('the falling board says until when it is right, in the status line and along the time line', async ({ page }) => {
  const watch = await openWithoutScene(page);
  await chooseCase(page, 'falling-report');
  await expect(page.getByTestId('trust')).toHaveText(
    /^right to 4 digits until 1\.\d+\ss, to none after [23]\.?\d*\ss$/,
    {
      timeout: 30_000,
    },
  );
  const band = page.getByTestId('trust-band');
  await expect(band).toBeVisible();
  await expect(band).toHaveAttribute('aria-label', /right to 4 digits until/);
  await chooseCase(page, 'released');
  await expect(page.getByTestId('trust')).toHaveText(/^right to 4 digits to the end, 0\.\d+\ss$/, { timeout: 30_000 });
  expect(watch.errors).toEqual([]);
});
