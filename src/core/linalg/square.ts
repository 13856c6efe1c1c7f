/**
 * n x n matrices as row-major arrays, for iterations that make many of them: sums run in the order of the indices, so that
 * the bits are those of the plain formulas.
 */
import { luFactor, luSolve } from './lu.ts';

/** Operations on matrices of one size; none writes to its arguments. */
export interface SquareAlgebra {
  identity(): Float64Array;
  times(a: Float64Array, b: Float64Array): Float64Array;
  plus(a: Float64Array, b: Float64Array): Float64Array;
  scaled(a: Float64Array, factor: number): Float64Array;
  transposed(a: Float64Array): Float64Array;
  /** (a + a^T) / 2. */
  symmetric(a: Float64Array): Float64Array;
  /** X with W X = B, by LU with partial pivoting; null where W is singular. */
  solve(W: Float64Array, B: Float64Array): Float64Array | null;
  /** Frobenius norm. */
  norm(a: Float64Array): number;
}

/**
 * @param n size of the matrices
 */
export function squaresOf(n: number): SquareAlgebra {
  const column = new Float64Array(n);
  const pivots = new Int32Array(n);
  const transposed = (a: Float64Array): Float64Array => {
    const c = new Float64Array(n * n);
    for (let i = 0; i < n; i++) for (let j = 0; j < n; j++) c[j * n + i] = a[i * n + j]!;
    return c;
  };
  return {
    identity: () => Float64Array.from({ length: n * n }, (_, i) => (i % (n + 1) === 0 ? 1 : 0)),
    times(a, b) {
      const c = new Float64Array(n * n);
      for (let j = 0; j < n; j++) {
        for (let k = 0; k < n; k++) column[k] = b[k * n + j]!;
        for (let i = 0; i < n; i++) {
          let sum = 0;
          for (let k = 0; k < n; k++) sum += a[i * n + k]! * column[k]!;
          c[i * n + j] = sum;
        }
      }
      return c;
    },
    plus(a, b) {
      const c = new Float64Array(n * n);
      for (let i = 0; i < c.length; i++) c[i] = a[i]! + b[i]!;
      return c;
    },
    scaled(a, factor) {
      const c = new Float64Array(n * n);
      for (let i = 0; i < c.length; i++) c[i] = a[i]! * factor;
      return c;
    },
    transposed,
    symmetric(a) {
      const c = new Float64Array(n * n);
      for (let i = 0; i < n; i++) for (let j = 0; j < n; j++) c[i * n + j] = (a[i * n + j]! + a[j * n + i]!) * 0.5;
      return c;
    },
    solve(W, B) {
      const factors = W.slice();
      if (!luFactor(factors, n, pivots)) return null;
      const X = new Float64Array(n * n);
      for (let j = 0; j < n; j++) {
        for (let i = 0; i < n; i++) column[i] = B[i * n + j]!;
        luSolve(factors, n, pivots, column);
        for (let i = 0; i < n; i++) X[i * n + j] = column[i]!;
      }
      return X;
    },
    norm(a) {
      let sum = 0;
      for (let i = 0; i < a.length; i++) sum += a[i]! * a[i]!;
      return Math.sqrt(sum);
    },
  };
}
