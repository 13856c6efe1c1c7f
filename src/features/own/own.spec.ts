/** One's own system in the page: a pendulum is typed, three mistakes are told at their lines and mended, it runs, is balanced and shared. */
import { expect, test } from '@playwright/test';
import { openWithoutScene, withoutScene } from '../../../tests/browser/helpers.ts';

interface Shown {
  run: { value: { kind: string; reason?: string } | null };
  motion: {
    value: {
      system: { meta: { title: string } };
      trajectory: { column(name: string): Float64Array };
    } | null;
  };
}

test.use({ permissions: ['clipboard-read', 'clipboard-write'] });

test('a pendulum is typed, mended, run, balanced, shared and restored', async ({ page, context }) => {
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

  await expect(page.getByTestId('own-formulas').locator('math')).not.toHaveCount(0);

  // At the end: three mistakes, each told at its line and mended; the last right system stays meanwhile.
  await text.click();
  await page.keyboard.press('Control+End');
  const types = async (line: string, said: RegExp) => {
    await page.keyboard.insertText(line);
    await expect(state).toHaveAttribute('data-state', 'faults');
    await expect(state).toContainText(said);
    await expect(page.getByTestId('own-formulas').locator('math')).not.toHaveCount(0);
    for (let i = 0; i < line.length; i++) await page.keyboard.press('Backspace');
  };
  await types('potential 1/2 5 Y^2', /Line \d+: .*Y/);
  await types('velocity X theta', /Line \d+: /);
  await types('potental X^2', /Line \d+: .*begins no statement/);
  await page.keyboard.insertText('potential 1/2 5 X^2');
  await expect(state).toHaveAttribute('data-state', 'fine');
  await ran(/^Cart and pendulum end$/);

  // Balanced upright by a regulator that is designed here.
  await page.getByTestId('initial-theta').fill('85');
  await page.getByTestId('initial-theta').press('Enter');
  await page.locator('summary', { hasText: 'Control' }).first().click();
  await page.getByTestId('control').selectOption('lqr');
  await expect
    .poll(() =>
      page.evaluate(() => {
        const { run, motion } = (window as unknown as { ripstikApp: { state: Shown } }).ripstikApp.state;
        const at = motion.value?.trajectory;
        return run.value?.kind === 'ended' && at ? Math.abs(at.column('theta').at(-1)! - Math.PI / 2) : 9;
      }),
    )
    .toBeLessThan(0.05);

  await page.getByTestId('share').click();
  await expect(page.getByTestId('message')).toContainText('Link copied');
  const link = await page.evaluate(() => navigator.clipboard.readText());
  const other = await context.newPage();
  await withoutScene(other);
  await other.goto(link);
  await expect(other.getByTestId('system')).toContainText('Cart and pendulum');
  await expect(other.getByTestId('run-state')).toHaveAttribute('data-reason', 'end');
  await other.close();
  await page.reload();
  await expect(page.getByTestId('system')).toContainText('Cart and pendulum');
  await expect(page.getByTestId('control')).toHaveValue('lqr');
  expect(errors).toEqual([]);
});
