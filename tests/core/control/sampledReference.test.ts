// Sampled regulators, Kalman filters and margins against SciPy and python-control (tests/reference/sampled_control.py).
import { readFileSync } from 'node:fs';
import { Matrix } from 'ml-matrix';
import { describe, expect, test } from 'vitest';
import { marginsOf } from '../../../src/core/control/margins.ts';
import { solveDare } from '../../../src/core/control/sampled/dare.ts';
import { held, sampledCost } from '../../../src/core/control/sampled/hold.ts';
import { continuousKalman, sampledKalman, type ObservedPlant } from '../../../src/core/control/sampled/kalman.ts';
import { relativeDifference } from './helpers.ts';

type Rows = number[][];
const { cases, loops } = JSON.parse(
  readFileSync(new URL('../../reference/sampled-control.json', import.meta.url), 'utf8'),
) as {
  cases: { h: number; A: Rows; B: Rows; C: Rows; K: Rows; L: Rows; Ld: Rows }[];
  loops: {
    A: Rows;
    B: Rows;
    K: Rows;
    gain: [number, number | null];
    phase: number;
    delay: number;
    disc: number;
    pythonControl: { phase: number };
  }[];
};

describe.each(cases.map((c) => [c.A.length, c] as const))('a random system of %i states', (n, { h, ...rows }) => {
  const [A, B, C] = [new Matrix(rows.A), new Matrix(rows.B), new Matrix(rows.C)];
  const I = Matrix.eye(n);
  const plant = { A, B, C, fromStates: I, toStates: I } as unknown as ObservedPlant;
  const ones = (count: number): number[] => new Array<number>(count).fill(1);

  test('its sampled regulator', () => {
    const { A: Ad, B: Bd } = held(A, B, h);
    const cost = sampledCost(A, B, I, Matrix.eye(B.columns), h);
    const { gain } = solveDare(Ad, Bd, cost.Q, cost.R, cost.N);
    expect(relativeDifference(gain, new Matrix(rows.K))).toBeLessThan(1e-7);
  });

  test('its Kalman filters, continuous and sampled', () => {
    const continuous = continuousKalman(plant, ones(n), ones(C.rows));
    expect(relativeDifference(continuous.gain, new Matrix(rows.L))).toBeLessThan(1e-8);
    const sampled = sampledKalman(
      plant,
      ones(n),
      ones(C.rows).map(() => 1 / Math.sqrt(h)),
      h,
    );
    expect(relativeDifference(sampled.gain, new Matrix(rows.Ld))).toBeLessThan(1e-8);
  });
});

test.each(loops.map((loop) => [loop.A.length, loop] as const))(
  'the margins of a random loop of %i states',
  (_, loop) => {
    const found = marginsOf({ A: new Matrix(loop.A), B: new Matrix(loop.B), K: new Matrix(loop.K) }, ['u']);
    const [down, up] = found.gain['u']!;
    expect(down).toBeCloseTo(loop.gain[0], 9);
    if (loop.gain[1] === null) expect(up).toBe(Infinity);
    else expect(up / loop.gain[1]).toBeCloseTo(1, 9);
    expect(found.phase['u']! / loop.phase).toBeCloseTo(1, 9);
    expect(found.phase['u']! / loop.pythonControl.phase).toBeCloseTo(1, 3);
    expect(found.delay / loop.delay).toBeCloseTo(1, 9);
    // Least over the reference's grid.
    expect(found.disc / loop.disc).toBeCloseTo(1, 5);
  },
);
