import { expect, test } from 'vitest';
import { curveMark, firstAt, type Curve } from '../../src/charts/curves.ts';
import type { Frame } from '../../src/charts/frame.ts';
import { scaleOf } from '../../src/charts/scales.ts';
import { PRINT } from '../../src/charts/surface.ts';
import { seeded } from '../helpers.ts';
import { recorder } from './recorder.ts';

const curve = (x: ArrayLike<number>, y: ArrayLike<number>, more: Partial<Curve> = {}): Curve => ({
  label: [],
  color: '#123456',
  x,
  y,
  ...more,
});
const frame: Frame = {
  left: 0,
  top: 0,
  width: 200,
  height: 100,
  x: scaleOf({}, [0, 1]),
  y: scaleOf({}, [-2, 2]),
  density: 1,
};

/** What is drawn, as points; a piece of a line that goes on where the last one ended adds none. */
function traced(c: Curve, into = frame): [number, number][] {
  const { surface, strokes } = recorder();
  curveMark(c).draw(surface, into, PRINT);
  return strokes
    .flatMap((stroke) => stroke.points)
    .filter((p, i, all) => p[0] !== all[i - 1]?.[0] || p[1] !== all[i - 1]?.[1]);
}

test('a long curve is drawn with a few lines a pixel, and loses no peak', () => {
  const random = seeded(3);
  const n = 20_000;
  const x = Float64Array.from({ length: n }, (_, i) => i / (n - 1));
  const y = Float64Array.from({ length: n }, () => random() - 0.5);
  for (let k = 0; k < 40; k++) y[Math.floor(random() * n)] = random() < 0.5 ? 1.9 : -1.9;
  const points = traced(curve(x, y, { rising: true }));
  expect(points.length).toBeLessThanOrEqual(2 * 201);
  // Every row lies within what is drawn over its pixel.
  const drawn = new Map<number, [number, number]>();
  for (const [px, py] of points) {
    const pixel = Math.min(199, Math.floor(px + 1e-9));
    const [low, high] = drawn.get(pixel) ?? [Infinity, -Infinity];
    drawn.set(pixel, [Math.min(low, py), Math.max(high, py)]);
  }
  for (let i = 0; i < n; i++) {
    const [low, high] = drawn.get(Math.max(0, Math.floor(200 * x[i]! - 1e-9)))!;
    const py = 50 - 25 * y[i]!;
    expect(py >= low - 1e-9 && py <= high + 1e-9, `row ${i}`).toBe(true);
  }
});

test('a path is drawn through its points, less those within a pixel', () => {
  const n = 5000;
  const x = Float64Array.from({ length: n }, (_, i) => 0.5 + 0.4 * Math.cos((20 * i) / n));
  const y = Float64Array.from({ length: n }, (_, i) => Math.sin((20 * i) / n));
  const points = traced(curve(x, y));
  expect(points.length).toBeLessThan(n / 2);
  expect(points[0]![0]).toBeCloseTo(200 * x[0]!, 12);
  expect(points[0]![1]).toBeCloseTo(50 - 25 * y[0]!, 12);
  expect(points.at(-1)![0]).toBeCloseTo(200 * x[n - 1]!, 12);
  for (let i = 1; i < points.length; i++)
    expect(Math.hypot(points[i]![0] - points[i - 1]![0], points[i]![1] - points[i - 1]![1])).toBeLessThan(3);
});

test('a gap is no line, and factors turn what is recorded into what is shown', () => {
  const gap = traced(curve([0, 0.25, 0.5, 0.75, 1], [1, 1, NaN, 1, 1]));
  expect(gap).toEqual([
    [0, 25],
    [50, 25],
    [150, 25],
    [200, 25],
  ]);
  expect(traced(curve([0, 10], [3, 3], { xFactor: 0.1, yFactor: 0.5 }))).toEqual([
    [0, 12.5],
    [200, 12.5],
  ]);
});

test('the room that a curve needs is that of the values shown, gaps left out, within what is looked at', () => {
  const rows = [Float64Array.of(0, 1, 2, 3, 4), Float64Array.of(1, NaN, -5, 7, 100)] as const;
  const rising = curveMark(curve(...rows, { yFactor: 2, rising: true }));
  expect(rising.extent!(null)).toEqual({ x: [0, 4], y: [-10, 200] });
  expect(rising.extent!([1.5, 2.5])!.y).toEqual([-10, -10]);
  // Between two rows it is the line from one to the other.
  expect(rising.extent!([2.2, 2.4])!.y).toEqual([-10, 14]);
  expect(curveMark(curve(...rows, { loose: true })).extent!(null)).toBe(null);
  expect(curveMark(curve([2, -1], [5, 6])).extent!(null)).toEqual({ x: [-1, 2], y: [5, 6] });
  expect([firstAt([0, 1, 2], 1.5), firstAt([0, 1, 2], 1), firstAt([0, 1, 2], 1, true)]).toEqual([2, 1, 2]);
});

test('the point nearest to the pointer is picked, and none from afar', () => {
  const mark = curveMark(curve([0.1, 0.5, 0.9], [0, 1, 0], { points: true }));
  expect(mark.pick!(frame, 102, 27)).toBe(1);
  expect(mark.pick!(frame, 60, 90)).toBe(null);
});

test('between rows a curve bends as its rate says, and only there', () => {
  // A regulator's first rows: fast at first, at rest after.
  const x = Float64Array.of(0, 0.2, 0.4, 0.6, 0.8, 1);
  const f = (t: number): number => Math.exp(-8 * t);
  const y = x.map(f);
  const rate = x.map((t) => -8 * f(t));
  const few = traced(curve(x, y, { rising: true }));
  const many = traced(curve(x, y, { rising: true, rate }));
  expect(few).toHaveLength(x.length);
  expect(many.length).toBeGreaterThan(20);
  expect(many.filter(([px]) => px > 155)).toHaveLength(2);
  for (const row of few) expect(many).toContainEqual(row);
  const middle = many.find(([px]) => Math.abs(px - 20) < 1.5)!;
  const chord = 50 - 25 * (0.5 * (y[0]! + y[1]!));
  const exact = 50 - 25 * f(middle[0] / 200);
  expect(Math.abs(middle[1] - exact)).toBeLessThan(0.3 * Math.abs(chord - exact));
  // A straight line needs no points, an unknown rate gives none, and rows that were left out are not asked for.
  expect(traced(curve(x, x, { rising: true, rate: x.map(() => 1) }))).toHaveLength(x.length);
  expect(traced(curve(x, y, { rising: true, rate: x.map(() => NaN) }))).toHaveLength(x.length);
  const long = Float64Array.from({ length: 20_000 }, (_, i) => i / 19_999);
  const wild = long.map((t) => Math.sin(3000 * t));
  const steep = long.map((t) => 3000 * Math.cos(3000 * t));
  expect(traced(curve(long, wild, { rising: true, rate: steep })).length).toBeLessThanOrEqual(2 * 201);
});
