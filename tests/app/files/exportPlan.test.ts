import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import {
  bitrateFor,
  fileName,
  frameCount,
  frameTime,
  keyCount,
  keyTimes,
  LARGEST,
  sideOf,
  sizeInWords,
  SMALLEST,
  videoDuration,
} from '../../../src/app/files/exportPlan.ts';
import { keepSign } from '../../../src/scene/export/keyframes.ts';

describe('frames of a video', () => {
  const ranges = fc.record({
    from: fc.double({ min: -5, max: 100, noNaN: true }),
    length: fc.double({ min: 0.1, max: 60, noNaN: true }),
    fps: fc.constantFrom(24, 25, 30, 50, 60),
    speed: fc.constantFrom(4, 2, 1, 1 / 2, 1 / 4, 1 / 64),
  });

  test('fill the range to half a frame, rise evenly, and stay within it', () => {
    fc.assert(
      fc.property(ranges, ({ from, length, fps, speed }) => {
        const range = { from, to: from + length, fps, speed };
        const frames = frameCount(range);
        const step = speed / fps;
        expect(Math.abs(frames * step - length)).toBeLessThanOrEqual(Math.max(step / 2, step - length) + 1e-9);
        expect(frameTime(range, 0) - from).toBe(0);
        expect(frameTime(range, frames - 1)).toBeLessThanOrEqual(Math.max(from, from + length - step / 2) + 1e-9);
        expect(videoDuration(range)).toBe(frames / fps);
      }),
      { seed: 7 },
    );
  });

  test.each([
    [{ from: 0, to: 10, fps: 30, speed: 1 }, 300],
    [{ from: 2, to: 3, fps: 24, speed: 1 / 4 }, 96],
    [{ from: 1, to: 1, fps: 60, speed: 1 }, 1],
  ])('%j', (range, frames) => expect(frameCount(range)).toBe(frames));
});

test('keyframes are the rows of the range with both of its ends, each moment once, or so many a second', () => {
  const t = Float64Array.of(0, 0.5, 0.5, 1, 1.5, 2);
  expect([...keyTimes(t, { from: 0, to: 2, rate: null })]).toEqual([0, 0.5, 1, 1.5, 2]);
  expect([...keyTimes(t, { from: 0.4, to: 1.7, rate: null })]).toEqual([0.5, 1, 1.5]);
  expect([...keyTimes(t, { from: 0.25, to: 1, rate: 4 })]).toEqual([0.25, 0.5, 0.75, 1]);
  expect(keyCount(t, { from: 0, to: 2, rate: null })).toBe(6);
  fc.assert(
    fc.property(
      fc.array(fc.double({ min: 0, max: 9, noNaN: true }), { minLength: 1 }),
      fc.double({ min: 0, max: 9, noNaN: true }),
      fc.double({ min: 0, max: 9, noNaN: true }),
      (times, from, to) => {
        const rows = Float64Array.from(times).sort();
        expect(keyTimes(rows, { from, to, rate: null })).toEqual(
          new Float64Array(new Set(rows.filter((time) => time >= from && time <= to))),
        );
      },
    ),
    { seed: 11 },
  );
});

test('sides are whole, within the limits, and even where asked', () => {
  fc.assert(
    fc.property(fc.double(), (pixels) => {
      const side = sideOf(pixels, true);
      expect(side % 2).toBe(0);
      expect(side).toBeGreaterThanOrEqual(SMALLEST);
      expect(side).toBeLessThanOrEqual(LARGEST);
    }),
    { seed: 7 },
  );
  expect(sideOf(1079.6)).toBe(1080);
});

test('file names hold nothing that a file system minds', () => {
  expect(fileName('Rides: 5 m/s, “straight”', 'png')).toBe('rides-5-m-s-straight.png');
  expect(fileName('Run 3.csv', 'glb')).toBe('run-3.glb');
  expect(fileName('Mödes', 'webm')).toBe('modes.webm');
  expect(fileName('***', 'mp4')).toBe('run.mp4');
});

test('sizes in words; more pixels take more bits', () => {
  expect([0, 999, 1500, 2.34e6, 45e6, 3.21e9].map(sizeInWords)).toEqual([
    '0 B',
    '999 B',
    '2 kB',
    '2.3 MB',
    '45 MB',
    '3.2 GB',
  ]);
  expect(bitrateFor(3840, 2160, 30)).toBeGreaterThan(bitrateFor(1280, 720, 30));
});

test('quaternions keep their rotation and never jump to the other sign', () => {
  fc.assert(
    fc.property(
      fc.array(fc.tuple(fc.double({ min: -1, max: 1, noNaN: true }), fc.boolean()), { minLength: 2, maxLength: 40 }),
      (steps) => {
        let angle = 0;
        const turns = Float64Array.from(
          steps.flatMap(([by, flip]) => {
            angle += by;
            const sign = flip ? -1 : 1;
            return [0, sign * Math.sin(angle / 2), 0, sign * Math.cos(angle / 2)];
          }),
        );
        const before = turns.slice();
        const last = new Float64Array(4);
        for (let o = 0; o < turns.length; o += 4) keepSign(turns.subarray(o, o + 4), last);
        for (let o = 0; o < turns.length; o += 4) {
          const sign = turns[o + 3] === before[o + 3] && turns[o + 1] === before[o + 1] ? 1 : -1;
          for (let i = 0; i < 4; i++) expect(turns[o + i]! - sign * before[o + i]!).toBe(0);
          if (o > 0)
            expect([0, 1, 2, 3].reduce((sum, i) => sum + turns[o + i]! * turns[o - 4 + i]!, 0)).toBeGreaterThanOrEqual(
              0,
            );
        }
      },
    ),
    { seed: 7 },
  );
});
