import { expect, test } from 'vitest';
import { finishOf } from '../../src/scene/materials.ts';
import { palettes } from '../../src/scene/palette.ts';
import { countUntil } from '../../src/scene/trails.ts';

test('a track is drawn up to the present, including a point at exactly that time', () => {
  const times = Float64Array.from([0, 0.1, 0.2, 0.2, 0.3, 99]);
  expect(countUntil(times, 5, -1)).toBe(0);
  expect(countUntil(times, 5, 0)).toBe(1);
  expect(countUntil(times, 5, 0.2)).toBe(4);
  expect(countUntil(times, 5, 50)).toBe(5);
});

test('a material of an unknown name still gets a finish', () => {
  expect(finishOf('steel')[1]).toBeGreaterThan(0.5);
  expect(finishOf('no such material')).toEqual(finishOf('other'));
});

test('front and back differ in lightness and hue in both themes', () => {
  for (const palette of Object.values(palettes)) expect(palette.front).not.toBe(palette.back);
});
