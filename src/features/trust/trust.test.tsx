// @vitest-environment happy-dom
import { expect, test } from 'vitest';
import type { Trust } from '../../core/simulation/trust.ts';
import { saidOf, stopsOf } from './said.ts';

const trust = (four: number, two: number, one: number, compared: number, last = 0): Trust => ({
  digits: [
    [0, 15],
    [compared, last],
  ],
  until: { 4: four, 2: two, 1: one },
  against: { name: 'dop853', rtol: 1e-13, atol: 1e-13, projection: true },
  compared,
});

test('what a comparison says', () => {
  expect(saidOf(trust(2.2, 3, 3.9, 5))).toBe('right to 4 digits until 2.2\u202fs, to none after 3.9\u202fs');
  expect(saidOf(trust(5, 5, 5, 5, 8))).toBe('right to 4 digits to the end, 5\u202fs');
  expect(saidOf(trust(2.219, 5, 5, 5, 3.4))).toBe('right to 4 digits until 2.21\u202fs, to 3 to the end, 5\u202fs');
  // Lost in between and found again: not told as held.
  const dip = trust(0.5, 1, 5, 5, 15);
  expect(
    saidOf({
      ...dip,
      digits: [
        [0, 15],
        [1, 1.2],
        [5, 15],
      ],
    }),
  ).toBe('right to 4 digits until 0.5\u202fs, to 1 to the end, 5\u202fs');
});

test('the band is full to four digits, fades, and ends where none is right or nothing was compared', () => {
  expect(stopsOf(trust(2, 3, 4, 5), 0, 5)).toEqual([
    { at: 0, strength: 1 },
    { at: 0.4, strength: 1 },
    { at: 0.6, strength: 0.55 },
    { at: 0.8, strength: 0.25 },
    { at: 0.8, strength: 0 },
  ]);
  expect(stopsOf(trust(4, 4, 4, 4), 0, 8).at(-2)).toEqual({ at: 0.5, strength: 1 });
  expect(stopsOf(trust(4, 4, 4, 4), 0, 8).at(-1)).toEqual({ at: 0.5, strength: 0 });
  // Two digits hold to the end, or one does: no stronger than that there.
  expect(stopsOf(trust(2, 4, 4, 4, 2.5), 0, 4)).toEqual([
    { at: 0, strength: 1 },
    { at: 0.5, strength: 1 },
    { at: 1, strength: 0.55 },
    { at: 1, strength: 0 },
  ]);
  expect(stopsOf(trust(1, 2, 4, 4, 15), 0, 4).map(({ strength }) => strength)).toEqual([1, 1, 0.55, 0.25, 0]);
});
