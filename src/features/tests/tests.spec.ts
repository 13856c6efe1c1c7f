import { expect, test } from '@playwright/test';
import { openWithoutScene } from '../../../tests/browser/helpers.ts';

test('tests are run with one click: pass and fail, with the reason', async ({ page }) => {
  const watch = await openWithoutScene(page);
  await page.getByTestId('tool-tests').click();
  const text = page.getByTestId('tests-text');
  await page.getByText('The tests, as JSON').click();
  const short = { duration: 0.2 };
  await text.fill(
    JSON.stringify({
      version: 1,
      tests: [
        { name: 'goes on', scenario: short, measure: 'time', bound: [0.2, 0.2] },
        { name: 'is nowhere', scenario: short, measure: 'max(abs(X) + 1)', bound: [null, 0.5] },
      ],
    }),
  );
  await page.getByTestId('tests-run').click();
  await expect(page.getByTestId('tests-summary')).toHaveText('1 of 2 passed');
  await expect(page.getByTestId('tests-results')).toContainText('must be at most 0.5');
  expect(watch.errors).toEqual([]);
});
