import { Matrix } from 'ml-matrix';
import { describe, expect, test } from 'vitest';
import {
  reachByInput,
  splitByReachability,
  unobservableSubspace,
} from '../../../src/core/control/linearization/reachability.ts';
import { reachableSubspace } from '../../../src/core/control/linearization/staircase.ts';
import { seeded } from '../../helpers.ts';
import { linearizationOf, randomMatrix, randomRotation } from './helpers.ts';

describe.each([11, 12, 13])('seed %i', (seed) => {
  const random = seeded(seed);

  test.each([
    [9, 4],
    [14, 10],
    [6, 6],
    [20, 1],
  ])('%i states of which %i are reachable', (n, r) => {
    const A = randomMatrix(random, n, n);
    // Rows of what is not reachable have no entries from what is.
    for (let i = r; i < n; i++) for (let j = 0; j < r; j++) A.set(i, j, 0);
    const B = randomMatrix(random, n, 1);
    for (let i = r; i < n; i++) B.set(i, 0, 0);
    const T = randomRotation(random, n);
    const [At, Bt] = [T.transpose().mmul(A).mmul(T), T.transpose().mmul(B)];
    const { reachable: V, complement, stages, margin } = reachableSubspace(At, Bt);
    expect(V.columns).toBe(r);
    expect(stages.reduce((sum, k) => sum + k, 0)).toBe(r);
    expect(margin.kept).toBeGreaterThan(1e6 * margin.dropped);
    // Invariant, orthonormal, and it holds the input.
    expect(complement.transpose().mmul(At).mmul(V).norm()).toBeLessThan(1e-11);
    expect(complement.transpose().mmul(Bt).norm()).toBeLessThan(1e-12);
    expect(Matrix.sub(V.transpose().mmul(V), Matrix.eye(r)).norm()).toBeLessThan(1e-13);
    const split = splitByReachability(At, Bt);
    // Its basis is another one of the same subspace.
    expect(Matrix.sub(V, split.reachable.mmul(split.reachable.transpose()).mmul(V)).norm()).toBeLessThan(1e-11);
    if (r < n) {
      expect(split.complementResidual).toBeLessThan(1e-11);
      expect(Matrix.sub(split.W.mmul(At), split.A.mmul(split.W)).norm()).toBeLessThan(
        1e-9 * At.norm() * split.W.norm(),
      );
    }
    expect(Matrix.sub(split.W.mmul(split.reachable), Matrix.eye(r)).norm()).toBeLessThan(1e-12);
  });
});

test("the size of an input's unit does not matter", () => {
  const { tangentA, tangentB } = linearizationOf({
    control: { type: 'lqr', inputs: ['tau_fc', 'tau_bc'], at: { X_dot: 1 } },
  });
  const scaled = tangentB.clone().mulColumn(0, 1e-9).mulColumn(1, 1e6);
  expect(reachableSubspace(tangentA, scaled).stages).toEqual([2, 2, 2, 2, 2]);
});

test('no input, or one that does nothing, reaches nothing', () => {
  const A = Matrix.eye(3);
  expect(reachableSubspace(A, new Matrix(3, 0)).reachable.columns).toBe(0);
  expect(reachableSubspace(A, Matrix.zeros(3, 2)).reachable.columns).toBe(0);
});

test('what an output never shows is the dual', () => {
  const A = new Matrix([
    [0, 1, 0],
    [-2, -1, 0],
    [1, 0, -3],
  ]);
  const { unseen } = unobservableSubspace(A, new Matrix([[1, 0, 0]]));
  expect(unseen.to2DArray().map(([x]) => Math.abs(x!))).toEqual([0, 0, 1]);
});

describe('the board', () => {
  const board = (X_dot: number, inputs: string[]) =>
    linearizationOf({ control: { type: 'lqr', inputs, at: { X_dot } } });
  const unstable = (values: readonly (readonly [number, number])[]) => values.filter(([re]) => re > 0).length;

  test.each([
    ['at rest', 0, 8],
    ['at 1 m/s', 1, 10],
    ['at 1 mm/s', 0.001, 10],
    ['at 10 m/s', 10, 10],
  ])('%s the steering motors reach what the contract says, with a wide margin', (_, speed, dimension) => {
    const { tangentA, tangentB } = board(speed, ['tau_fc', 'tau_bc']);
    expect(tangentA.rows).toBe(14);
    const { reachable, margin } = reachableSubspace(tangentA, tangentB);
    expect(reachable.columns).toBe(dimension);
    expect(margin.dropped).toBeLessThan(1e-12);
    expect(margin.kept).toBeGreaterThan(1e-6);
  });

  test('every input alone reaches every unstable mode, a single steering motor too', () => {
    for (const speed of [0, 0.5, 1, 3]) {
      const inputs = ['tau_fp', 'tau_bp', 'tau_twist', 'tau_fc', 'tau_bc'];
      const { tangentA, tangentB } = board(speed, inputs);
      for (const { input, reached, missed } of reachByInput(tangentA, tangentB, inputs)) {
        expect({ speed, input, missed: unstable(missed), reached: unstable(reached) }).toEqual({
          speed,
          input,
          missed: 0,
          reached: 2,
        });
      }
    }
  });
});
