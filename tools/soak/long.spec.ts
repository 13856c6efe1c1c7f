// `npm run soak -- minutes seed`: acts until the time is over; what the page holds is read every other minute.
import { mkdirSync, writeFileSync } from 'node:fs';
import { test } from '@playwright/test';
import { openPage, VIEWPORT } from '../../tests/browser/helpers.ts';
import { acts, chanceFrom } from './acts.ts';
import { residentBytes, watchPeak } from './gauges.ts';
import { expectReturned, Soak } from './soak.ts';
import { soakTable } from './table.ts';

test.use({ viewport: VIEWPORT });

const minutes = Number(process.env['SOAK_MINUTES'] ?? 60);
const seed = Number(process.env['SOAK_SEED'] ?? 4711);
const EVERY_MS = Number(process.env['SOAK_EVERY'] ?? 120_000);

test(`soak: ${minutes} minutes from seed ${seed}`, async ({ page }) => {
  const soak = await Soak.of(page, await openPage(page));
  const chance = chanceFrom(seed);
  const names = Object.keys(acts);
  // Every act once: what is loaded and kept from then on is the page's own.
  for (const name of names) await soak.act(name, chance);
  await soak.base();
  console.log('start', JSON.stringify(await soak.base()));
  const peak = watchPeak(() => residentBytes(), 500);
  const from = Date.now();
  for (let next = from + EVERY_MS; Date.now() < from + 60_000 * minutes;) {
    await soak.act(chance.of(names), chance);
    if (Date.now() < next) continue;
    console.log(`${((Date.now() - from) / 60_000).toFixed(1)} min`, JSON.stringify(await soak.base()));
    next = Date.now() + EVERY_MS;
  }
  await soak.base();
  const [, start, ...later] = soak.readings;
  mkdirSync('.cache/soak', { recursive: true });
  writeFileSync(
    '.cache/soak/table.md',
    soakTable({
      counts: soak.counts,
      start: start!,
      readings: later,
      peak: peak(),
      minutes: (Date.now() - from) / 60_000,
      seed,
    }),
  );
  expectReturned(start!, later.at(-1)!);
});
