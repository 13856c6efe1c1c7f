import { expect, test } from '@playwright/test';
import { BODIES, openPage, VIEWPORT } from './helpers.ts';

test.use({ viewport: VIEWPORT });

const file = (name: string, text: string) => ({ name, mimeType: 'text/plain', buffer: Buffer.from(text) });
const material = file('rod.mat', 'newmtl red\nKd 1 0 0\n');

test("a person's own mesh replaces a body; a bad one is refused with its place and leaves it", async ({ page }) => {
  const watch = await openPage(page);
  const triangles = () => page.evaluate(() => window.ripstikScene!.stats().triangles);
  await expect.poll(triangles).toBeGreaterThan(1000);
  const before = await triangles();

  await page
    .getByTestId('open-file')
    .setInputFiles([file('rod.mdl', 'v -0.1 0 0\nv 0.1 0 0\nv 0 0 0.1\nusemtl red\nf 1 2 3\n'), material]);
  await expect.poll(triangles).toBeLessThan(before - 1000);
  const own = await triangles();

  await page.getByTestId('open-file').setInputFiles([file('rod.mdl', 'v 0 0 0\nv 1 0 0\nf 1 2 9\n'), material]);
  const message = page.getByTestId('message').filter({ hasText: 'rod.mdl' });
  await expect(message).toContainText('line 3');
  expect(await triangles()).toBe(own);
  expect(await page.evaluate(() => window.ripstikScene!.stats().bodies)).toBeGreaterThan(BODIES);
  expect(watch.errors).toEqual([]);
});
