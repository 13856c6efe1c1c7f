import { expect, test } from 'vitest';
import {
  decadeTicks,
  linearTicks,
  niceStep,
  scaleOf,
  tickText,
  withAir,
  type ScaleKind,
} from '../../src/charts/scales.ts';
import { seeded } from '../helpers.ts';

const SEED = 8;

test('ticks are round, within the range and about as many as there is room for', () => {
  const random = seeded(SEED);
  for (let k = 0; k < 300; k++) {
    const where = `seed ${SEED}, ${k}`;
    const low = (random() - 0.5) * 10 ** (12 * random() - 6);
    const high = low + 10 ** (12 * random() - 6);
    const ticks = linearTicks(low, high, 6);
    expect(ticks.length, where).toBeGreaterThanOrEqual(2);
    expect(ticks.length, where).toBeLessThanOrEqual(7);
    for (const t of ticks) expect(t >= low - 1e-9 * (high - low) && t <= high + 1e-9 * (high - low), where).toBe(true);
  }
  expect(decadeTicks(1e-10, 1e-4, 7)).toHaveLength(7);
  expect([niceStep(0.03), niceStep(1), niceStep(7)]).toEqual([0.05, 1, 10]);
});

test('a number on an axis is short, with a true minus sign and no negative zero', () => {
  expect(tickText(-1.5e-7)).toBe('\u22121.5e\u22127');
  expect([0, -0, 0.1 + 0.2, -25, 1e5, 1e-3, 123456].map(tickText)).toEqual([
    '0',
    '0',
    '0.3',
    '\u221225',
    '1e5',
    '0.001',
    '1.23456e5',
  ]);
});

test('every scale rises, gives its values back, and has its ticks within', () => {
  const random = seeded(SEED + 1);
  const kinds: ScaleKind[] = ['linear', 'logarithmic', 'bent'];
  for (let k = 0; k < 300; k++) {
    const kind = kinds[k % 3]!;
    const where = `seed ${SEED + 1}, ${k}, ${kind}`;
    const low = kind === 'logarithmic' ? 10 ** (6 * random() - 6) : -(10 ** (4 * random() - 1));
    const high = kind === 'logarithmic' ? low * 10 ** (0.2 + 5 * random()) : 10 ** (4 * random() - 1);
    const scale = scaleOf({ kind, bend: 10 ** Math.round(2 * random() - 2) }, [low, high]);
    expect(scale.share(low), where).toBeCloseTo(0, 10);
    expect(scale.share(high), where).toBeCloseTo(1, 10);
    let before = -Infinity;
    for (let s = 0; s <= 1; s += 0.1) {
      const value = scale.value(s);
      expect(scale.share(value), where).toBeCloseTo(s, 9);
      expect(value, where).toBeGreaterThan(before);
      before = value;
    }
    const ticks = scale.ticks(7);
    expect(ticks.length, where).toBeGreaterThan(0);
    for (const t of ticks) {
      expect(scale.share(t), where).toBeGreaterThan(-1e-6);
      expect(scale.share(t), where).toBeLessThan(1 + 1e-6);
    }
  }
});

test('the bent scale is odd and has decades on both sides of zero, fewer where there is no room', () => {
  const scale = scaleOf({ kind: 'bent', bend: 1 }, [-1000, 1000]);
  expect(scale.ticks(16)).toEqual([-1000, -100, -10, -1, 0, 1, 10, 100, 1000]);
  expect(scale.ticks(7)).toEqual([-1000, -100, -10, 0, 10, 100, 1000]);
  expect(scale.ticks(3)).toEqual([-1000, 0, 1000]);
  for (const most of [3, 4, 5, 7, 9, 16]) {
    const shares = scale.ticks(most).map((t) => scale.share(t));
    for (let i = 1; i < shares.length; i++)
      expect(shares[i]! - shares[i - 1]!, `${most}`).toBeGreaterThanOrEqual(0.75 / most);
  }
  for (const x of [0.5, 7, 300]) expect(scale.share(x) + scale.share(-x)).toBeCloseTo(1, 12);
});

test('names stand in steps, as many as have room', () => {
  const scale = scaleOf({ kind: 'steps', names: ['a', 'b', 'c', 'd', 'e'] }, [-0.5, 4.5]);
  expect(scale.ticks(9).map((t) => scale.text(t))).toEqual(['a', 'b', 'c', 'd', 'e']);
  expect(scale.ticks(3)).toEqual([0, 2, 4]);
});

test('a flat curve stands in the middle, and what only rounding moves is flat', () => {
  expect(withAir([3, 3], 0.06)).toEqual([2.7, 3.3]);
  const [low, high] = withAir([1, 1 + 1e-15], 0.06);
  expect(high - low).toBeGreaterThan(0.1);
  expect(withAir([Infinity, -Infinity], 0.06)).toEqual([-1, 1]);
  expect(withAir([1, 100], 0.5, 'logarithmic')).toEqual([0.1, 1000]);
});
