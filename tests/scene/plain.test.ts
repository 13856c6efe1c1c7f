import { expect, test } from 'vitest';
import { clustered } from '../../src/scene/actors/plain.ts';

const COLOUR = [0.2, 0.4, 0.6];

/** Corners of a sphere's triangles: place, normal, colour of each. */
function sphere(radius: number, slices: number, colour: (longitude: number) => number[] = () => COLOUR): Float32Array {
  const corner = (i: number, j: number): number[] => {
    const [a, b] = [(Math.PI * i) / slices, (2 * Math.PI * j) / slices];
    const n = [Math.sin(a) * Math.cos(b), Math.sin(a) * Math.sin(b), Math.cos(a)];
    return [...n.map((x) => radius * x), ...n, ...colour(j)];
  };
  const out: number[] = [];
  for (let i = 0; i < slices; i++)
    for (let j = 0; j < slices; j++) {
      const [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
      out.push(...a, ...b, ...c, ...a, ...c, ...d);
    }
  return Float32Array.from(out);
}

const placesOf = (points: Float32Array): number[][] =>
  Array.from({ length: points.length / 9 }, (_, i) => [...points.subarray(9 * i, 9 * i + 3)]);

test('in cells smaller than its triangles a body keeps them all, with each point once', () => {
  const corners = sphere(1, 12);
  const { points, index } = clustered(corners, 1e-5);
  // At the poles every other triangle has no area.
  expect(index.length / 3).toBe(2 * 12 * 12 - 2 * 12);
  expect(points.length).toBeLessThan(corners.length / 4);
  const given = new Set(placesOf(corners).map(String));
  for (const place of placesOf(points)) expect(given).toContain(String(place));
});

test('in larger cells there are fewer triangles, none without an area, and no point goes farther than a cell is wide', () => {
  const corners = sphere(1, 24);
  const cell = 0.25;
  const { points, index } = clustered(corners, cell);
  expect(index.length / 3).toBeLessThan(corners.length / 27 / 2);
  const places = placesOf(points);
  for (let i = 0; i < index.length; i += 3) {
    const [a, b, c] = [places[index[i]!]!, places[index[i + 1]!]!, places[index[i + 2]!]!].map(String);
    expect(new Set([a, b, c]).size).toBe(3);
  }
  for (const place of placesOf(corners)) {
    const nearest = Math.min(...places.map((p) => Math.hypot(...p.map((x, k) => x - place[k]!))));
    expect(nearest).toBeLessThan(cell * Math.sqrt(3));
  }
});

test('colours stay apart, and where two meet there is no gap', () => {
  const corners = sphere(1, 24, (j) => (j < 12 ? [1, 0, 0] : [0, 0, 1]));
  const { points } = clustered(corners, 0.2);
  const colours = new Map<string, Set<string>>();
  placesOf(points).forEach((place, i) => {
    const colour = [...points.subarray(9 * i + 6, 9 * i + 9)].join();
    colours.set(String(place), (colours.get(String(place)) ?? new Set()).add(colour));
  });
  expect(new Set([...colours.values()].flatMap((set) => [...set]))).toEqual(new Set(['1,0,0', '0,0,1']));
  expect([...colours.values()].some((set) => set.size === 2)).toBe(true);
});
