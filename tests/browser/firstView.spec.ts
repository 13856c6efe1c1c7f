/** All that a browser loads until the first motion moves is what `scripts/size.mjs` counts, and nothing beside it. */
import { readFileSync } from 'node:fs';
import { expect, test } from '@playwright/test';
import type { Chunk } from '../../scripts/chunks.ts';
import { openPage } from './helpers.ts';

// Who asks for stillness is shown a still picture: here the first motion plays by itself.
test.use({ contextOptions: { reducedMotion: 'no-preference' } });

test('until the first moving frame nothing is loaded that is not counted', async ({ page, baseURL }) => {
  const { firstView, withImports } = (await import(new URL('../../scripts/firstView.mjs', import.meta.url).href)) as {
    firstView(chunks: Readonly<Record<string, Chunk>>): ReadonlySet<string>;
    withImports(chunks: Readonly<Record<string, Chunk>>, from: readonly string[]): ReadonlySet<string>;
  };
  const list = new URL('../../.cache/chunks.json', import.meta.url);
  const { chunks } = JSON.parse(readFileSync(list, 'utf8')) as { chunks: Record<string, Chunk> };
  const loaded = new Set<string>();
  page.context().on('request', (request) => {
    const address = request.url();
    if (address.startsWith(baseURL!)) loaded.add(address.slice(baseURL!.length) || 'index.html');
  });
  await openPage(page);
  await expect(page.getByTestId('time')).not.toHaveText(/^0\.000/);
  // The service worker is registered a second after the run, before or after the first moving frame.
  // What the next run takes is loaded after the first has ended: on a slow machine perhaps before its motion is seen.
  const first = firstView(chunks);
  const NEXT = /simulation\/(?:everyMotion|trust)\.ts$|ripstik\/accelerations\.generated\.json$/;
  const holders = Object.keys(chunks).filter((file) =>
    Object.keys(chunks[file]!.modules).some((one) => NEXT.test(one)),
  );
  const next = withImports(chunks, holders);
  const counted = (file: string) => first.has(file) || !next.has(file);
  await expect.poll(() => [...loaded].filter(counted).sort()).toEqual([...first].sort());
});
