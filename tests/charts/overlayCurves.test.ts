import { expect, test } from 'vitest';
import { decadeTicks, linearTicks, tickText } from '../../src/charts/axisTicks.ts';
import { drawCurve, firstAt, limitsOf, type Frame, type OverlayCurve } from '../../src/charts/overlayCurves.ts';
import { seeded } from '../helpers.ts';

const curve = (x: ArrayLike<number>, y: ArrayLike<number>): OverlayCurve => ({
  label: '',
  color: '',
  x,
  y,
  xFactor: 1,
  yFactor: 1,
});
const frame: Frame = { left: 0, top: 0, width: 200, height: 100, low: [0, -2], high: [1, 2], logarithmicX: false };

/** What is drawn, as points; a piece of a line that goes on where the last one ended adds none. */
function traced(c: OverlayCurve, rising: boolean): [number, number][] {
  const points: [number, number][] = [];
  const to = (x: number, y: number): void => {
    if (points.at(-1)?.[0] !== x || points.at(-1)?.[1] !== y) points.push([x, y]);
  };
  const context = new Proxy(
    {},
    { get: (_, key) => (key === 'moveTo' || key === 'lineTo' ? to : () => {}), set: () => true },
  );
  drawCurve(context as CanvasRenderingContext2D, c, frame, rising);
  return points;
}

test('a long curve is drawn with a few lines a pixel, and loses no peak', () => {
  const random = seeded(3);
  const n = 20_000;
  const x = Float64Array.from({ length: n }, (_, i) => i / (n - 1));
  const y = Float64Array.from({ length: n }, () => random() - 0.5);
  for (let k = 0; k < 40; k++) y[Math.floor(random() * n)] = random() < 0.5 ? 1.9 : -1.9;
  const points = traced(curve(x, y), true);
  expect(points.length).toBeLessThanOrEqual(4 * 201);
  const drawn = new Map<number, [number, number]>();
  for (const [px, py] of points) {
    const [low, high] = drawn.get(px) ?? [Infinity, -Infinity];
    drawn.set(px, [Math.min(low, py), Math.max(high, py)]);
  }
  for (let i = 0; i < n; i++) {
    const [low, high] = drawn.get(Math.floor(200 * x[i]!))!;
    const py = 100 - (100 * (y[i]! + 2)) / 4;
    expect(py >= low - 1e-9 && py <= high + 1e-9).toBe(true);
  }
});

test('a path is drawn through its points, less those within a pixel', () => {
  const n = 5000;
  const x = Float64Array.from({ length: n }, (_, i) => 0.5 + 0.4 * Math.cos((20 * i) / n));
  const y = Float64Array.from({ length: n }, (_, i) => Math.sin((20 * i) / n));
  const points = traced(curve(x, y), false);
  expect(points.length).toBeLessThan(n / 2);
  expect(points[0]).toEqual([200 * x[0]!, 100 - (100 * (y[0]! + 2)) / 4]);
  for (let i = 1; i < points.length; i++)
    expect(Math.hypot(points[i]![0] - points[i - 1]![0], points[i]![1] - points[i - 1]![1])).toBeLessThan(3);
});

test('limits are those of the values shown, gaps left out, within the zoom', () => {
  const c = { ...curve([0, 1, 2, 3, 4], [1, NaN, -5, 7, 100]), yFactor: 2 };
  expect(limitsOf([c], null, true)).toEqual({ x: [0, 4], y: [-10, 200] });
  expect(limitsOf([c], [1.5, 2.5], true).y).toEqual([-10, 14]);
  expect(limitsOf([], null, true)).toEqual({ x: [0, 1], y: [0, 1] });
  expect(firstAt([0, 1, 2], 1.5)).toBe(2);
});

test('ticks are round, within the range and about as many as there is room for', () => {
  const random = seeded(8);
  for (let k = 0; k < 200; k++) {
    const low = (random() - 0.5) * 10 ** (12 * random() - 6);
    const high = low + 10 ** (12 * random() - 6);
    const ticks = linearTicks(low, high, 6);
    expect(ticks.length).toBeGreaterThanOrEqual(2);
    expect(ticks.length).toBeLessThanOrEqual(7);
    for (const t of ticks) expect(t >= low - 1e-9 * (high - low) && t <= high + 1e-9 * (high - low)).toBe(true);
  }
  expect(decadeTicks(1e-10, 1e-4, 7)).toHaveLength(7);
  expect(tickText(-1.5e-7)).toBe('\u22121.5e\u22127');
  expect(tickText(0)).toBe('0');
});
