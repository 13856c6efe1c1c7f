import { expect, test } from 'vitest';
import { Haste } from '../../src/scene/environment/haste.ts';

/** Pictures so far apart (ms); how often less was drawn from one on. */
function draw(haste: Haste, interval: number, pictures: number, from = 0): number {
  let less = 0;
  for (let i = 0; i < pictures; i++) if (haste.picture(from + i * interval)) less++;
  return less;
}

test('a fast device draws all of it in haste, a slow one less and less, none more within it', () => {
  const haste = new Haste(false);
  haste.set(true);
  expect(draw(haste, 16.7, 200)).toBe(0);
  expect([haste.share, haste.plain]).toEqual([1, false]);
  expect(draw(haste, 40, 200, 5000)).toBe(3);
  expect([haste.share, haste.plain]).toEqual([0.4, true]);
  draw(haste, 16.7, 200, 20_000);
  expect(haste.share).toBe(0.4);
  haste.set(false);
  expect([haste.share, haste.plain]).toEqual([1, false]);
});

test('out of haste nothing is left out; without a graphics card much of it is from the first picture', () => {
  const haste = new Haste(true);
  expect(draw(haste, 200, 100)).toBe(0);
  expect(haste.share).toBe(1);
  haste.set(true);
  expect([haste.share, haste.plain]).toEqual([0.55, true]);
});
