// After the first visit the page works without a connection, parts that are loaded later too.
import { readFileSync } from 'node:fs';
import { expect, test } from '@playwright/test';

test.use({ viewport: { width: 800, height: 560 }, serviceWorkers: 'allow' });

test('loaded once, the page opens, runs and shows every part without a connection', async ({ page, context }) => {
  const errors: string[] = [];
  page.on('pageerror', (error) => errors.push(String(error)));
  await page.goto('./');
  await page.evaluate(async () => { await navigator.serviceWorker.ready; });
  const icons = await page.evaluate(async () => {
    const manifest = (await (await fetch('manifest.webmanifest')).json()) as { icons: { src: string; purpose?: string }[] };
    return Promise.all(manifest.icons.map(async ({ src, purpose }) => ({ purpose, ok: (await fetch(src)).ok })));
  });
  expect(icons.every(({ ok }) => ok)).toBe(true);
  expect(icons.some(({ purpose }) => purpose === 'maskable')).toBe(true);

  await context.setOffline(true);
  await page.goto('./#v=1&case=bicycle-weave&duration=0.5&sum=0');
  await expect(page.getByTestId('offline')).toHaveText('offline');
  await expect(page.getByTestId('run-state')).toHaveAttribute('data-reason', 'end');
  await page.getByTestId('tool-methods').click();
  await expect(page.getByTestId('methods-table')).toBeVisible();
  await page.getByTestId('sample-menu').click();
  await page.getByTestId('sample-ridden').click();
  await expect(page.getByTestId('rows')).toBeVisible();
  await expect.poll(() => page.evaluate(() => window.ripstikScene?.stats().bodies ?? 0)).toBeGreaterThan(0);
  expect(errors).toEqual([]);

  await context.setOffline(false);
  await expect(page.getByTestId('offline')).toHaveCount(0);
});

test('a new version says so, and is there after one press', async ({ page, context }) => {
  const built = readFileSync('dist/offline.js', 'utf8');
  await page.goto('./');
  await page.evaluate(async () => { await navigator.serviceWorker.ready; });
  await expect.poll(() => page.evaluate(() => navigator.serviceWorker.controller !== null)).toBe(true);
  // The next build: one byte of the worker differs.
  await context.route('**/offline.js', (route) => route.fulfill({ body: `${built}\n`, contentType: 'text/javascript' }));
  await page.evaluate(async () => { await (await navigator.serviceWorker.ready).update(); });
  const message = page.getByTestId('message').filter({ hasText: 'A new version is ready' });
  await expect(message).toBeVisible();
  const reloaded = page.waitForEvent('load');
  await message.getByRole('button', { name: 'Reload' }).click();
  await reloaded;
  await expect(page.getByTestId('run-state')).toHaveAttribute('data-reason', 'end');
  await expect(message).toHaveCount(0);
});
