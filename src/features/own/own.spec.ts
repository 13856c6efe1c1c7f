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

  // From nothing: all that stands there goes, a pendulum is typed, with three mistakes; each is told at its line.
  await text.click();
  await page.keyboard.press('ControlOrMeta+a');
  await page.keyboard.press('Delete');
  await page.keyboard.insertText(
    [
      'system "My pendulum"',
      'coordinate theta [rad] "from upright"',
      'parameter m [kg] = 0.5 positive',
      'parameter l [m] = 0.8 positive',
      'kinetic 1/2 m l^2 theta^2',
      'potential ml 9.81 cos(theta)',
      'input torque on thta "at the pivot"',
    ].join('\n'),
  );
  await expect(state).toHaveAttribute('data-state', 'faults');
  await expect(state.getByRole('listitem')).toHaveText([
    /Line 5: this has no rate in it: the rate of x is written x'/,
    /Line 6: unknown name "ml"; a product has a space/,
    /Line 7: unknown name "thta"; did you mean theta\?/,
  ]);
  // Mended one by one; the last right system stays on the stage meanwhile.
  await expect(page.getByTestId('system')).not.toContainText('My pendulum');
  const mend = async (line: string, right: string) => {
    await state.getByRole('button', { name: line }).click();
    await page.keyboard.press('Shift+End');
    await page.keyboard.press('Delete');
    await page.keyboard.insertText(right);
    await expect(state).not.toContainText(line);
  };
  await mend('Line 5', "kinetic 1/2 m l^2 theta'^2");
  await mend('Line 6', 'potential m l 9.81 cos(theta)');
  await mend('Line 7', 'input torque on theta "at the pivot"');
  await expect(state).toHaveAttribute('data-state', 'fine');
  await ran(/^My pendulum end$/);
  await expect(page.getByTestId('system')).toContainText('My pendulum');
  await expect(page.getByTestId('own-formulas').locator('math')).not.toHaveCount(0);

  // Balanced upright by a regulator that is designed here.
  await page.getByTestId('initial-theta').fill('20');
  await page.getByTestId('initial-theta').press('Enter');
  await page.locator('summary', { hasText: 'Control' }).first().click();
  await page.getByTestId('control').selectOption('lqr');
  await expect
    .poll(() =>
      page.evaluate(() => {
        const { run, motion } = (window as unknown as { ripstikApp: { state: Shown } }).ripstikApp.state;
        const at = motion.value?.trajectory;
        return run.value?.kind === 'ended' && at ? Math.abs(at.column('theta').at(-1)!) : 9;
      }),
    )
    .toBeLessThan(0.01);

  await page.getByTestId('share').click();
  await expect(page.getByTestId('message')).toContainText('Link copied');
  const link = await page.evaluate(() => navigator.clipboard.readText());
  const other = await context.newPage();
  await withoutScene(other);
  await other.goto(link);
  await expect(other.getByTestId('system')).toContainText('My pendulum');
  await expect(other.getByTestId('run-state')).toHaveAttribute('data-reason', 'end');
  await other.close();
  await page.reload();
  await expect(page.getByTestId('system')).toContainText('My pendulum');
  await expect(page.getByTestId('control')).toHaveValue('lqr');
  expect(errors).toEqual([]);
});
