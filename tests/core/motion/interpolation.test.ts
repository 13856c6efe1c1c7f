import { expect, test } from 'vitest';
import { interpolate, shorter, TURN } from '../../../src/core/motion/interpolation.ts';
import { seeded } from '../../helpers.ts';

const SEED = 17;

test('a cubic with its rates comes back exactly, and a straight line without them', () => {
  const random = seeded(SEED);
  for (let k = 0; k < 200; k++) {
    const [a, b, c, d] = Array.from({ length: 4 }, () => 4 * random() - 2) as [number, number, number, number];
    const cubic = (t: number): number => a + t * (b + t * (c + t * d));
    const rate = (t: number): number => b + t * (2 * c + 3 * t * d);
    const t = [random(), 1 + random(), 2 + random()];
    const at = t[0]! + random() * (t[2]! - t[0]!);
    const row = at < t[1]! ? 0 : 1;
    expect(Math.abs(interpolate(t, t.map(cubic), t.map(rate), row, at) - cubic(at)), `seed ${SEED}, ${k}`).toBeLessThan(
      1e-12,
    );
    const line = (x: number): number => a + b * x;
    expect(Math.abs(interpolate(t, t.map(line), undefined, row, at) - line(at)), `seed ${SEED}, ${k}`).toBeLessThan(
      1e-13,
    );
  }
});

test('a row gives its own value, the ends are kept, and a rate that is not a number leaves the chord', () => {
  const [t, y] = [
    [0, 1, 2],
    [3, 5, 4],
  ];
  for (const row of [0, 1, 2]) expect(interpolate(t, y, [9, 9, 9], row, t[row]!)).toBe(y[row]);
  expect(interpolate(t, y, undefined, 0, -5)).toBe(3);
  expect(interpolate(t, y, undefined, 2, 5)).toBe(4);
  expect(interpolate(t, y, [NaN, 1, 1], 0, 0.5)).toBe(4);
  expect(interpolate(t, y, undefined, 1, 7)).toBe(4);
});

test('the fourth order of the cubic, the second of the line', () => {
  const error = (n: number, rates: boolean): number => {
    const t = Array.from({ length: n + 1 }, (_, i) => i / n);
    const [y, rate] = [t.map((x) => Math.sin(5 * x)), t.map((x) => 5 * Math.cos(5 * x))];
    let worst = 0;
    for (let row = 0; row < n; row++)
      for (const s of [0.25, 0.5, 0.75]) {
        const at = (row + s) / n;
        worst = Math.max(worst, Math.abs(interpolate(t, y, rates ? rate : undefined, row, at) - Math.sin(5 * at)));
      }
    return worst;
  };
  expect(Math.log2(error(40, true) / error(80, true))).toBeCloseTo(4, 0);
  expect(Math.log2(error(40, false) / error(80, false))).toBeCloseTo(2, 0);
});

test('a recorded angle takes the shorter way whatever whole turns its rows jump by; a computed one its own', () => {
  const random = seeded(SEED + 1);
  for (let k = 0; k < 200; k++) {
    const [from, step] = [20 * random() - 10, (random() - 0.5) * 0.98 * TURN];
    const jump = TURN * Math.round(6 * random() - 3);
    const y = [from, from + step + jump];
    const s = random();
    expect(interpolate([0, 1], y, undefined, 0, s, TURN), `seed ${SEED + 1}, ${k}`).toBeCloseTo(from + s * step, 9);
    expect(interpolate([0, 1], y, undefined, 0, s)).toBeCloseTo(from + s * (step + jump), 9);
    expect(Math.abs(shorter(step + jump, TURN))).toBeLessThanOrEqual(TURN / 2 + 1e-12);
  }
});
