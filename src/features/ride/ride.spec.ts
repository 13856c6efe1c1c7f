import { expect, test } from '@playwright/test';
import { openWithoutScene, VIEWPORT } from '../../../tests/browser/helpers.ts';

test.use({ viewport: VIEWPORT });

test('a course is ridden with keys, and how fast keys reach the picture is told', async ({ page }) => {
  const watch = await openWithoutScene(page);
  await page.keyboard.press('u');
  const ride = page.getByTestId('ride-view');
  await expect(ride).toHaveAttribute('data-phase', 'riding', { timeout: 60_000 });
  await page.keyboard.down('ArrowUp');
  await expect(ride).toHaveAttribute('data-speed', /^1\.[3-5]/, { timeout: 30_000 });
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('ArrowRight');
  await expect(ride).toHaveAttribute('data-passed', /^[2-4]$/, { timeout: 60_000 });
  await page.keyboard.up('ArrowUp');
  await page.keyboard.down('ArrowDown');
  await expect(ride).toHaveAttribute('data-speed', /^-?0\.[01]/, { timeout: 30_000 });
  const read = (name: string) => ride.getAttribute(`data-${name}`);
  const latency = Number(await read('latency'));
  console.log(
    `ride: from key to picture ${latency.toFixed(1)} ms on the median, ${await read('dropped')} of ${await read('frames')} frames dropped`,
  );
  expect(latency).toBeGreaterThan(0);
  await page.keyboard.press('Escape');
  await expect(ride).toHaveCount(0);
  // A run like any: it is played, and its scenario has what was told.
  await page.getByTestId('run').click();
  await expect(page.getByTestId('run-state')).toHaveAttribute('data-reason', 'end', { timeout: 60_000 });
  expect(watch.errors).toEqual([]);
});
