import fc from 'fast-check';
import { expect, test } from 'vitest';
import { decimated } from '../../../src/core/motion/decimated.ts';
import { Envelope } from '../../../src/core/motion/envelope.ts';
import { seeded } from '../../helpers.ts';

const SEED = 20171208;

function brute(values: Float64Array, from: number, to: number): [number, number] {
  const part = [...values.subarray(from, to)].filter((v) => !Number.isNaN(v));
  return [Math.min(...part), Math.max(...part)];
}

test('the range of any rows of a growing column is what going through them gives', () => {
  fc.assert(
    fc.property(
      fc.integer({ min: 1, max: 4000 }),
      fc.array(fc.tuple(fc.nat(), fc.nat()), { maxLength: 12 }),
      fc.nat(),
      (rows, ranges, salt) => {
        const random = seeded(salt);
        const values = Float64Array.from({ length: rows }, () => (random() < 0.02 ? NaN : random() - 0.5));
        const envelope = new Envelope();
        for (const [a, b] of ranges) {
          const shown = values.subarray(0, 1 + (a % rows));
          const [from, to] = [a % shown.length, b % (shown.length + 1)].sort((x, y) => x - y) as [number, number];
          expect(envelope.range(shown, from, to)).toEqual(brute(shown, from, to));
        }
      },
    ),
    { seed: SEED, numRuns: 200 },
  );
});

test('no peak is lost, nothing is added, and few points are left', () => {
  const rows = 200_000;
  const random = seeded(7);
  const t = Float64Array.from({ length: rows }, (_, i) => i / 1000);
  const values = Float64Array.from(t, (x) => Math.sin(x) + 0.1 * random());
  values[123_456] = 9;
  values[7] = -9;
  for (const [from, to] of [
    [0, 200],
    [50, 180],
    [123, 124],
    [-5, 300],
  ] as const) {
    const { t: x, y } = decimated(t, values, new Envelope(), from, to, 500);
    expect(x.length).toBeLessThanOrEqual(2002);
    for (let i = 1; i < x.length; i++) expect(x[i]!).toBeGreaterThanOrEqual(x[i - 1]!);
    const inside = [...values].filter((_, i) => t[i]! >= from && t[i]! <= to);
    expect(Math.max(...y)).toBeGreaterThanOrEqual(inside.reduce((a, b) => Math.max(a, b)));
    expect(Math.min(...y)).toBeLessThanOrEqual(inside.reduce((a, b) => Math.min(a, b)));
    const known = new Set(values);
    expect(y.every((v) => known.has(v))).toBe(true);
  }
});

test('few rows are all there, with a neighbour on each side of the range', () => {
  const t = Float64Array.of(0, 1, 2, 3, 4, 5);
  expect(decimated(t, t, new Envelope(), 1.5, 3.5, 100)).toEqual({ t: [1, 2, 3, 4], y: [1, 2, 3, 4] });
  expect(decimated(t, t, new Envelope(), -9, 9, 100).t).toEqual([...t]);
  expect(decimated(new Float64Array(0), new Float64Array(0), new Envelope(), 0, 1, 10)).toEqual({ t: [], y: [] });
});
