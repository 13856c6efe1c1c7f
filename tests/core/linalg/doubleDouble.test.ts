import { expect, test } from 'vitest';
import { DoubleDouble } from '../../../src/core/linalg/doubleDouble.ts';
import { seeded } from '../../helpers.ts';

const random = seeded(31);
const square = (n: number): DoubleDouble =>
  DoubleDouble.from(
    Array.from({ length: n * n }, () => random() - 0.5),
    n,
    n,
  );

test('a Hilbert matrix of twelve rows, of condition 1e16, is inverted to fourteen digits', () => {
  const n = 12;
  const one = DoubleDouble.from([1], 1, 1);
  const H = new DoubleDouble(n, n);
  for (let i = 0; i < n; i++) {
    for (let j = 0; j < n; j++) {
      // 1 / (i + j + 1) to twice the precision.
      const entry = DoubleDouble.from([i + j + 1], 1, 1).solve(one)!;
      H.hi[i * n + j] = entry.hi[0]!;
      H.lo[i * n + j] = entry.lo[0]!;
    }
  }
  // First entry of the inverse: n^2; the last: known integers (Choi, American Mathematical Monthly 90 (1983), 301-312).
  const inverse = H.solve(DoubleDouble.identity(n))!;
  expect(inverse.hi[0]).toBeCloseTo(144, 9);
  expect(H.times(inverse).plus(DoubleDouble.identity(n), -1).norm()).toBeLessThan(1e-14);
});

test('what a double loses is kept', () => {
  const A = DoubleDouble.from([1e16], 1, 1);
  const B = A.plus(DoubleDouble.identity(1)).plus(A, -1);
  expect(B.hi[0]).toBe(1);
  const third = DoubleDouble.from([3], 1, 1).solve(DoubleDouble.identity(1))!;
  expect(Math.abs(third.times(DoubleDouble.from([3], 1, 1)).plus(DoubleDouble.identity(1), -1).hi[0]!)).toBeLessThan(
    1e-31,
  );
});

test('products are associative and transposed in turn, to 30 digits', () => {
  const [A, B, C] = [square(7), square(7), square(7)];
  const rest = A.times(B)
    .times(C)
    .plus(A.times(B.times(C)), -1);
  expect(rest.norm()).toBeLessThan(1e-29);
  expect(A.times(B).transpose().plus(B.transpose().times(A.transpose()), -1).norm()).toBeLessThan(1e-30);
});

test('a singular matrix has no solution', () => {
  expect(DoubleDouble.from([1, 2, 2, 4], 2, 2).solve(DoubleDouble.identity(2))).toBeNull();
});
