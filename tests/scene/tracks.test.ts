import { describe, expect, test } from 'vitest';
import type { Trail } from '../../src/scene/contract.ts';
import { MOST_POINTS, countUntil, TrackBuffer } from '../../src/scene/overlay/trackBuffer.ts';

/** A track along x at the given speed (m/s) with `count` points 10 ms apart. */
function trail(count: number, speed = 1, room = count): Trail {
  const points = new Float32Array(3 * room);
  const times = new Float64Array(room);
  for (let i = 0; i < count; i++) {
    times[i] = 0.01 * i;
    points[3 * i] = speed * times[i]!;
  }
  return { role: 'first', points, times, count };
}

test('a track is drawn up to the present, including points at exactly that time', () => {
  const times = Float64Array.from([0, 0.1, 0.2, 0.2, 0.3, 99]);
  expect(countUntil(times, 5, -1)).toBe(0);
  expect(countUntil(times, 5, 0)).toBe(1);
  expect(countUntil(times, 5, 0.2)).toBe(4);
  expect(countUntil(times, 5, 50)).toBe(5);
  expect(countUntil(times, 0, 50)).toBe(0);
  expect(countUntil(times, 5, Number.NEGATIVE_INFINITY)).toBe(0);
});

describe('what the graphics card is sent of a track', () => {
  test('only what is new when it grows, also when its arrays were replaced', () => {
    const buffer = new TrackBuffer();
    expect(buffer.take(trail(100))).toEqual({ from: 0, grown: false });
    expect(buffer.count).toBe(100);
    expect(buffer.take(trail(100))).toBeNull();
    expect(buffer.take(trail(120, 1, 4000))).toEqual({ from: 100, grown: false });
    expect(buffer.take(trail(2000))).toEqual({ from: 120, grown: true });
    expect(buffer.points[3 * 1999]).toBeCloseTo(19.99, 5);
    expect(buffer.times[1999]).toBeCloseTo(19.99, 9);
  });

  test('another track starts over', () => {
    const buffer = new TrackBuffer();
    buffer.take(trail(100));
    expect(buffer.take(trail(150, 2))).toEqual({ from: 0, grown: false });
    expect(buffer.count).toBe(150);
    expect(buffer.take(trail(10))).toEqual({ from: 0, grown: false });
    expect(buffer.count).toBe(10);
    expect(buffer.take(trail(0))).not.toBeNull();
    expect(buffer.count).toBe(0);
  });

  test('a wheel that stands still adds nothing', () => {
    const buffer = new TrackBuffer();
    buffer.take(trail(5000, 0));
    expect(buffer.count).toBe(1);
    buffer.take(trail(10_000, 0));
    expect(buffer.count).toBe(1);
  });

  test('points that are not numbers leave no hole', () => {
    const broken = trail(10);
    broken.points[3 * 4] = Number.NaN;
    const buffer = new TrackBuffer();
    buffer.take(broken);
    expect(buffer.count).toBe(9);
    expect(buffer.points.subarray(0, 27).every(Number.isFinite)).toBe(true);
    expect(broken.points[12]).toBeNaN(); // what is given is never changed
  });
});

test('a track as long as an hour keeps so many points, from its first to nearly its last, in order', () => {
  const count = 300_000;
  const times = Float64Array.from({ length: count }, (_, k) => k / 100);
  const points = new Float32Array(3 * count);
  for (let k = 0; k < count; k++) points.set([3 * Math.cos(k / 300), 3 * Math.sin(k / 300), 0], 3 * k);
  const buffer = new TrackBuffer();
  for (let seen = 7_000; seen <= count + 6_999; seen += 7_000) {
    const change = buffer.take({ role: 'first', points, times, count: Math.min(seen, count) });
    expect(change).not.toBeNull();
    expect(buffer.count).toBeLessThanOrEqual(MOST_POINTS);
  }
  expect(buffer.count).toBeGreaterThan(MOST_POINTS / 4);
  const kept = [...buffer.times.subarray(0, buffer.count)];
  expect(kept[0]).toBe(0);
  expect(kept.at(-1)!).toBeGreaterThan(0.999 * times.at(-1)!);
  expect(kept.every((t, k) => k === 0 || t > kept[k - 1]!)).toBe(true);
  const radii = kept.map((_, k) => Math.hypot(buffer.points[3 * k]!, buffer.points[3 * k + 1]!));
  expect(radii.every((r) => Math.abs(r - 3) < 1e-4)).toBe(true);
});
