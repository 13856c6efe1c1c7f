// The noise of sensors: the moments of a normal distribution, and the same numbers for the same seed.
import { expect, test } from 'vitest';
import { normal } from '../../../src/core/scenario/chance.ts';
import { Sensors } from '../../../src/core/control/sampled/sensors.ts';

const COUNT = 100_000;

test.each([0, 1, 42, 4294967295])('mean, deviation and neighbours of seed %i', (seed) => {
  let [sum, squares, neighbours, streams] = [0, 0, 0, 0];
  for (let k = 0; k < COUNT; k++) {
    const x = normal(seed, 3, k);
    sum += x;
    squares += x * x;
    neighbours += x * normal(seed, 3, k + 1);
    streams += x * normal(seed, 4, k);
  }
  // Four standard errors.
  for (const x of [sum, neighbours, streams]) expect(Math.abs(x / COUNT)).toBeLessThan(4 / Math.sqrt(COUNT));
  expect(Math.abs(squares / COUNT - 1)).toBeLessThan(4 * Math.sqrt(2 / COUNT));
});

test('is this to the last bit on every machine', () => {
  expect([normal(7, 0, 0), normal(7, 1, 0), normal(7, 0, 1000)]).toEqual([
    -0.14081752416677773, -0.6406248721759766, 1.6828447650186718,
  ]);
});

test('a sensor: bias, density, steps, and a walk that does not depend on where it is first read', () => {
  const [h, state] = [0.01, [0.3, 0.1]] as const;
  const read = (sensor: object, k: number, seed = 5): number => {
    const out = new Float64Array(1);
    const sensors = new Sensors({ 'a + 2*b_dot': sensor }, ['a', 'b', 'a_dot', 'b_dot'], h, seed);
    sensors.read(k, Float64Array.from([state[0], 0]), Float64Array.from([0, state[1]]), out);
    return out[0]!;
  };
  expect(read({ resolution: 0.3 }, 0)).toBeCloseTo(0.6, 12);
  expect(read({ noise: 1e-12, bias: 0.25 }, 0)).toBeCloseTo(0.75, 9);
  expect(read({ density: 0.02 }, 9) - 0.5).toBeCloseTo(0.2 * normal(5, 0, 9), 12);
  expect(read({ noise: 0.02 }, 9) - 0.5).toBeCloseTo(0.02 * normal(5, 0, 9), 12);
  expect(read({ noise: 0.02 }, 9, 6)).not.toBe(read({ noise: 0.02 }, 9, 5));
  let walk = 0;
  for (let k = 1; k <= 50; k++) walk += 0.3 * 0.1 * normal(5, 1, k);
  expect(read({ drift: 0.3 }, 50) - 0.5).toBeCloseTo(walk, 12);
});
