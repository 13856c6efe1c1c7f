import { Matrix } from 'ml-matrix';
import { describe, expect, test } from 'vitest';
import { axisSubspace } from '../../../src/core/control/linearization/axisSubspace.ts';
import { columnSpace } from '../../../src/core/control/linearization/matrices.ts';
import { eigenvalues, modesOf, splitZeros } from '../../../src/core/control/linearization/spectrum.ts';
import { lyapunov, sylvesterLeastSquares } from '../../../src/core/control/design/sylvester.ts';
import { seeded } from '../../helpers.ts';
import { blockDiagonal, randomMatrix, randomRotation, spectralDistance } from './helpers.ts';

const jordan = (size: number) => {
  const J = Matrix.zeros(size, size);
  for (let i = 0; i + 1 < size; i++) J.set(i, i + 1, 1);
  return J;
};

describe.each([1, 2, 3, 4])('seed %i', (seed) => {
  const random = seeded(seed);

  test('multiple zeros are exact, whatever their Jordan structure, and leave the other eigenvalues accurate', () => {
    const others = new Matrix([
      [-3, 20, 0],
      [-20, -3, 0],
      [0, 0, 800],
    ]);
    const T = randomRotation(random, 9);
    const A = T.transpose()
      .mmul(blockDiagonal(jordan(3), jordan(2), jordan(1), others))
      .mmul(T);
    const values = eigenvalues(A);
    expect(values.filter(([re, im]) => re === 0 && im === 0)).toHaveLength(6);
    const rest = values.filter(([re, im]) => re !== 0 || im !== 0);
    expect(
      spectralDistance(rest, [
        [-3, 20],
        [-3, -20],
        [800, 0],
      ]),
    ).toBeLessThan(1e-12);
    const { zero } = splitZeros(A);
    const image = A.mmul(zero);
    expect(Matrix.sub(image, zero.mmul(zero.transpose().mmul(image))).norm()).toBeLessThan(1e-11);
  });

  test('shapes are eigenvectors, of quotients with zeros too', () => {
    const A = blockDiagonal(
      jordan(2),
      new Matrix([
        [0, 5],
        [-7, -1],
      ]),
    );
    A.set(1, 2, 0.3);
    A.set(0, 3, -0.4);
    const states = ['a', 'b', 'a_dot', 'b_dot'];
    for (const {
      eigenvalue: [re, im],
      shape,
    } of modesOf(A, Matrix.eye(4), states)) {
      const x = Matrix.columnVector(shape);
      // (A - lambda)(A - conj lambda) x = 0 for the real part of an eigenvector at any phase.
      const once = A.mmul(x);
      const twice = Matrix.add(A.mmul(once), Matrix.mul(once, -2 * re)).add(Matrix.mul(x, re * re + im * im));
      expect(twice.norm()).toBeLessThan(1e-12);
    }
  });

  test('the modes on the imaginary axis are told from others by an invariant subspace', () => {
    const oscillation = new Matrix([
      [0, 11],
      [-11, 0],
    ]);
    const others = new Matrix([
      [-0.4, 3],
      [-3, -0.4],
    ]);
    const T = Matrix.add(randomRotation(random, 7), randomMatrix(random, 7, 7).mul(0.1));
    const inverse = columnSpaceInverse(T);
    const A = inverse.mmul(blockDiagonal(oscillation, jordan(2), others, new Matrix([[9]]))).mmul(T);
    const E = axisSubspace(A, A.norm());
    expect(E.columns).toBe(4);
    const image = A.mmul(E);
    expect(Matrix.sub(image, E.mmul(E.transpose().mmul(image))).norm()).toBeLessThan(1e-9);
    expect(spectralDistance([[0, 11]], eigenvalues(E.transpose().mmul(image), A.norm()))).toBeLessThan(1e-9);
  });

  test('column spaces are orthonormal and complete', () => {
    const A = randomMatrix(random, 8, 3).mmul(randomMatrix(random, 3, 11));
    const { basis, complement, kept, dropped } = columnSpace(A, 1e-10);
    expect([basis.columns, complement.columns]).toEqual([3, 5]);
    expect(complement.transpose().mmul(A).norm()).toBeLessThan(1e-12);
    expect(
      Matrix.sub(basis.mmul(basis.transpose()).add(complement.mmul(complement.transpose())), Matrix.eye(8)).norm(),
    ).toBeLessThan(1e-13);
    expect(kept / dropped).toBeGreaterThan(1e12);
  });

  test("Lyapunov's equation", () => {
    const A = Matrix.sub(randomMatrix(random, 7, 7), Matrix.eye(7).mul(4));
    const C = Matrix.eye(7);
    const X = lyapunov(A, C)!;
    expect(A.transpose().mmul(X).add(X.mmul(A)).add(C).norm()).toBeLessThan(1e-12);
    expect(Matrix.sub(X, X.transpose()).norm()).toBe(0);
  });

  test('a singular but solvable Sylvester equation has its least-norm solution', () => {
    const [A, B] = [blockDiagonal(jordan(2), randomMatrix(random, 3, 3)), jordan(2)];
    const known = randomMatrix(random, 5, 2);
    const C = Matrix.sub(A.mmul(known), known.mmul(B));
    const X = sylvesterLeastSquares(A, B, C);
    expect(Matrix.sub(A.mmul(X), X.mmul(B)).sub(C).norm()).toBeLessThan(1e-11);
    // Every solution of the homogeneous equation A H = H B with H in the Jordan blocks: polynomials in the shift.
    for (const H of [
      new Matrix([
        [1, 0],
        [0, 1],
      ]),
      new Matrix([
        [0, 1],
        [0, 0],
      ]),
    ]) {
      const full = Matrix.zeros(5, 2);
      full.setSubMatrix(H, 0, 0);
      expect(Math.abs(Matrix.mul(X, full).sum())).toBeLessThan(1e-11);
    }
  });
});

test('an empty matrix has no eigenvalues and no modes', () => {
  expect(eigenvalues(new Matrix(0, 0))).toEqual([]);
  expect(modesOf(new Matrix(0, 0), new Matrix(4, 0), ['a', 'b', 'c', 'd'])).toEqual([]);
});

function columnSpaceInverse(T: Matrix): Matrix {
  const n = T.rows;
  return sylvesterLeastSquares(T, Matrix.zeros(n, n), Matrix.eye(n));
}
