/** One's own system in the page: a pendulum is typed, a mistake is told at its line and mended, it runs and is shared. */
import { expect, test } from '@playwright/test';
import { openWithoutScene, withoutScene } from '../../../tests/browser/helpers.ts';

interface Shown {
  run: { value: { kind: string; reason?: string } | null };
  motion: { value: { system: { meta: { title: string } } } | null };
}

test.use({ permissions: ['clipboard-read', 'clipboard-write'] });

test('a pendulum is typed, mended, run and shared', async ({ page, context }) => {
  const { errors } = await openWithoutScene(page);
  const ran = (title: RegExp) =>
    expect
      .poll(() =>
        page.evaluate(() => {
          const { run, motion } = (window as unknown as { ripstikApp: { state: Shown } }).ripstikApp.state;
          return run.value?.kind === 'ended' ? `${motion.value?.system.meta.title} ${run.value.reason}` : '';
        }),
      )
      .toMatch(title);
  await page.getByTestId('tool-own').click();
  const text = page.getByTestId('own-text');
  const state = page.getByTestId('own-state');
  await expect(state).toHaveAttribute('data-state', 'untouched');
  await page.getByTestId('own-template').selectOption('cart-pendulum');
  await expect(state).toHaveAttribute('data-state', 'fine');
  await ran(/^Cart and pendulum end$/);
  await expect(page.getByTestId('system')).toContainText('Cart and pendulum');

  // At the end: a spring, at first between names that are not there.
  await text.click();
  await page.keyboard.press('Control+End');
  await page.keyboard.insertText('potential 1/2 5 Y^2');
  await expect(state).toHaveAttribute('data-state', 'faults');
  await expect(state).toContainText(/Line \d+: .*Y/);
  for (let i = 0; i < 3; i++) await page.keyboard.press('Backspace');
  await page.keyboard.insertText('X^2');
  await expect(state).toHaveAttribute('data-state', 'fine');
  await ran(/^Cart and pendulum end$/);

  await page.getByTestId('share').click();
  await expect(page.getByTestId('message')).toContainText('Link copied');
  const link = await page.evaluate(() => navigator.clipboard.readText());
  const other = await context.newPage();
  await withoutScene(other);
  await other.goto(link);
  await expect(other.getByTestId('system')).toContainText('Cart and pendulum');
  await expect(other.getByTestId('run-state')).toHaveAttribute('data-reason', 'end');
  expect(errors).toEqual([]);
});
