// After the first visit the page works without a connection, parts that are loaded later too.
import { cpSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import type { Server } from 'node:http';
import { join } from 'node:path';
import { expect, test } from '@playwright/test';
import { withoutScene } from './helpers.ts';

test.use({ viewport: { width: 800, height: 560 }, serviceWorkers: 'allow' });

test('loaded once, the page opens, runs and shows every part without a connection', async ({ page, context }) => {
  const errors: string[] = [];
  page.on('pageerror', (error) => errors.push(String(error)));
  await page.goto('./');
  await page.evaluate(async () => {
    await navigator.serviceWorker.ready;
  });
  const icons = await page.evaluate(async () => {
    const manifest = (await (await fetch('manifest.webmanifest')).json()) as {
      icons: { src: string; purpose?: string }[];
    };
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

test('a new version says so, is there after one press, and a second tab goes on with the old one', async ({
  page,
  context,
}, info) => {
  await withoutScene(page);
  // A host of its own, from the root this time, whose files change under the page.
  const folder = info.outputPath('host');
  cpSync('dist', folder, { recursive: true });
  const { serve } = (await import(new URL('../../scripts/serve-dist.mjs', import.meta.url).href)) as {
    serve(how: { port: number; folder: string; tries: number }): Promise<{ server: Server; port: number }>;
  };
  const { server, port } = await serve({ port: 0, folder, tries: 1 });
  try {
    await page.goto(`http://127.0.0.1:${port}/`);
    await expect.poll(() => page.evaluate(() => navigator.serviceWorker.controller !== null)).toBe(true);
    const second = await context.newPage();
    await withoutScene(second);
    await second.goto(`http://127.0.0.1:${port}/`);
    await expect(second.getByTestId('run-state')).toHaveAttribute('data-reason', 'end');
    // The next build: another title, under another revision, and a part that is called otherwise.
    const html = readFileSync(join(folder, 'index.html'), 'utf8').replace('<title>', '<title>Next ');
    writeFileSync(join(folder, 'index.html'), html);
    const worker = readFileSync(join(folder, 'offline.js'), 'utf8');
    const part = readdirSync(join(folder, 'assets')).find((name) => /^methodsTool-.*\.js$/.test(name))!;
    rmSync(join(folder, 'assets', part));
    writeFileSync(
      join(folder, 'offline.js'),
      worker
        .replace(/(index\.html`?['"]?,[`'"])\w+/, (_, before: string) => `${before}0123456789abcdef`)
        .replace(new RegExp(`\\[[^[\\]]*${part.replaceAll('.', '\\.')}[^\\]]*\\],?`), ''),
    );
    expect(readFileSync(join(folder, 'offline.js'), 'utf8')).not.toBe(worker);
    await page.evaluate(async () => {
      await (await navigator.serviceWorker.ready).update();
    });
    const message = page.getByTestId('message').filter({ hasText: 'A new version is ready' });
    await expect(message).toBeVisible();
    await expect(second.getByTestId('message')).toContainText('A new version is ready');
    await expect(page).toHaveTitle('RipStik Lab');
    await message.getByRole('button', { name: 'Reload' }).click();
    await expect(page).toHaveTitle('Next RipStik Lab');
    await expect(page.getByTestId('run-state')).toHaveAttribute('data-reason', 'end');
    await expect(message).toHaveCount(0);
    // The other tab goes on, what it loads only now is still there, and its own button still works.
    await second.getByTestId('tool-methods').click();
    await expect(second.getByTestId('methods-table')).toBeVisible();
    await second.getByTestId('message').getByRole('button', { name: 'Reload' }).click();
    await expect(second).toHaveTitle('Next RipStik Lab');
  } finally {
    server.closeAllConnections();
    server.close();
  }
});
