/** A short share of `npm run soak`: the same acts twice, and what the page holds after the second time is what it held after the first. */
import { expect, test } from '@playwright/test';
import { chanceFrom } from '../../tools/soak/acts.ts';
import { expectReturned, Soak } from '../../tools/soak/soak.ts';
import { openPage, VIEWPORT } from './helpers.ts';

test.use({ viewport: VIEWPORT });

/** Kinds of acts that leave most behind if they leave anything; the others have their own tests. */
const SHARE = ['run', 'cancel', 'good table', 'keep', 'export PNG', 'weights', 'look', 'context lost'] as const;
const SEED = 20171208;

test('acts of every kind leave nothing behind', async ({ page }) => {
  const soak = await Soak.of(page, await openPage(page));
  const readings = [];
  for (let round = 0; round < 2; round++) {
    const chance = chanceFrom(SEED);
    for (const name of SHARE) await soak.act(name, chance);
    readings.push(await soak.base());
  }
  expect(soak.counts['run']).toBe(2);
  expectReturned(readings[0]!, readings[1]!);
});
