import { readFileSync } from 'node:fs';
import { Matrix } from 'ml-matrix';
import { describe, expect, test } from 'vitest';
import { careResidual, solveCare } from '../../../src/core/control/design/riccati.ts';
import { seeded } from '../../helpers.ts';
import { randomMatrix, relativeDifference, spectralDistance } from './helpers.ts';

interface StoredCase {
  name: string;
  A: number[][];
  B: number[][];
  C: number[][];
  R: number[];
  gain: number[][];
  closedLoop: [number, number][];
  scipy: number;
}
const { cases } = JSON.parse(readFileSync('tests/reference/riccati.json', 'utf8')) as { cases: StoredCase[] };

describe('agrees with SciPy, refined in 60 digits', () => {
  test('there are stored cases up to 30 states', () => expect(Math.max(...cases.map((c) => c.A.length))).toBe(30));

  test.each(cases.map((c) => [c.name, c] as const))('%s', (_, { A, B, C, R, gain, closedLoop }) => {
    const c = new Matrix(C);
    const solution = solveCare(new Matrix(A), new Matrix(B), c.transpose().mmul(c), R);
    expect(solution.residual).toBeLessThan(1e-10);
    expect(relativeDifference(solution.gain, new Matrix(gain))).toBeLessThan(1e-9);
    // The last digits of a large gain move the eigenvalues; above 1e6 they say nothing.
    const size = new Matrix(gain).norm();
    if (size < 1e6) expect(spectralDistance(solution.closedLoop, closedLoop)).toBeLessThan(1e-9 * Math.max(1, size));
  });
});

describe.each([21, 22, 23])('seed %i', (seed) => {
  const random = seeded(seed);
  const n = 4 + Math.floor(random() * 8);
  const A = randomMatrix(random, n, n);
  const B = randomMatrix(random, n, 2);
  const C = randomMatrix(random, 3, n);
  const Q = C.transpose().mmul(C);
  const R = [0.3, 4];

  test('X is symmetric, positive semidefinite, solves the equation and stabilizes', () => {
    const { X, gain, residual, closedLoop } = solveCare(A, B, Q, R);
    const F = B.mmul(Matrix.diag(R.map((r) => 1 / Math.sqrt(r))));
    expect(careResidual(A, F, Q, X)).toBeLessThan(1e-12);
    expect(residual).toBeLessThan(1e-12);
    expect(Matrix.sub(X, X.transpose()).norm()).toBe(0);
    const x = randomMatrix(random, n, 1);
    expect(x.transpose().mmul(X).mmul(x).get(0, 0)).toBeGreaterThanOrEqual(-1e-12);
    expect(Matrix.sub(Matrix.diag(R).mmul(gain), B.transpose().mmul(X)).norm()).toBeLessThan(
      1e-11 * X.norm() * B.norm(),
    );
    expect(Math.max(...closedLoop.map(([re]) => re))).toBeLessThan(0);
  });

  test('no other gain nearby costs less', () => {
    // The cost from x is x^T P x with P the Lyapunov solution of any stabilizing gain; X is the least of them.
    const { X, gain } = solveCare(A, B, Q, R);
    const other = Matrix.add(gain, randomMatrix(random, 2, n).mul(1e-3));
    const closed = Matrix.sub(A, B.mmul(other));
    const P = accumulated(closed, Matrix.add(Q, other.transpose().mmul(Matrix.diag(R)).mmul(other)));
    const x = randomMatrix(random, n, 1);
    const cost = (M: Matrix) => x.transpose().mmul(M).mmul(x).get(0, 0);
    expect(cost(P)).toBeGreaterThan(cost(X));
  });
});

test('a scalar equation by hand', () => {
  // 2 a x - b^2 x^2 / r + q = 0
  const [a, b, q, r] = [3, 2, 5, 0.5];
  const { X } = solveCare(new Matrix([[a]]), new Matrix([[b]]), new Matrix([[q]]), [r]);
  expect(X.get(0, 0)).toBeCloseTo((a + Math.sqrt(a * a + (b * b * q) / r)) / ((b * b) / r), 13);
});

test('without cost a stable system is left alone, an unstable one mirrored', () => {
  const zero = new Matrix([[0]]);
  expect(solveCare(new Matrix([[-2]]), new Matrix([[1]]), zero, [1]).gain.get(0, 0)).toBeCloseTo(0, 14);
  expect(solveCare(new Matrix([[2]]), new Matrix([[1]]), zero, [1]).gain.get(0, 0)).toBeCloseTo(4, 13);
});

test.each([
  [
    'an unstable mode without input',
    new Matrix([
      [1, 0],
      [0, -1],
    ]),
    new Matrix([[0], [1]]),
    Matrix.eye(2),
  ],
  [
    'a mode on the axis that costs nothing',
    new Matrix([
      [0, 1],
      [-1, 0],
    ]),
    new Matrix([[0], [1]]),
    Matrix.zeros(2, 2),
  ],
  [
    'an integrator that costs nothing',
    new Matrix([
      [0, 0],
      [0, -1],
    ]),
    new Matrix([[1], [1]]),
    new Matrix([
      [0, 0],
      [0, 1],
    ]),
  ],
])('no gain comes back for %s', (_, A, B, Q) => {
  expect(() => solveCare(A, B, Q, [1])).toThrow(/no stabilizing solution/);
});

/** Solution of A^T P + P A = -C by the integral of the motion (Smith's doubling): another way than the code's own. */
function accumulated(A: Matrix, C: Matrix): Matrix {
  const n = A.rows;
  const I = Matrix.eye(n);
  const gamma = A.norm();
  const inverse = inverseOf(Matrix.sub(A, Matrix.mul(I, gamma)));
  let step = Matrix.add(A, Matrix.mul(I, gamma)).mmul(inverse);
  let P = inverse
    .transpose()
    .mmul(C)
    .mmul(inverse)
    .mul(2 * gamma);
  for (let k = 0; k < 40; k++) {
    P = Matrix.add(P, step.transpose().mmul(P).mmul(step));
    step = step.mmul(step);
  }
  return P;
}

function inverseOf(A: Matrix): Matrix {
  const n = A.rows;
  const both = A.to2DArray().map((row, i) => [...row, ...Array.from({ length: n }, (_, j) => (i === j ? 1 : 0))]);
  for (let k = 0; k < n; k++) {
    const p = [...Array(n - k).keys()]
      .map((i) => i + k)
      .sort((i, j) => Math.abs(both[j]![k]!) - Math.abs(both[i]![k]!))[0]!;
    [both[k], both[p]] = [both[p]!, both[k]!];
    both[k] = both[k]!.map((x) => x / both[k]![k]!);
    both.forEach((row, i) => {
      if (i !== k) both[i] = row.map((x, j) => x - row[k]! * both[k]![j]!);
    });
  }
  return new Matrix(both.map((row) => row.slice(n)));
}
