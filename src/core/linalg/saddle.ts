import { back10, back4, factor10, factor4, forward10, forward4, rows10x4, solve10x4 } from './saddle10x4.generated.ts';

/**
 * A pivot of the scaled 4 x 4 system below this share of its diagonal (elsewhere: of the largest entry) is rounding:
 * the constraint rows are then dependent. Well below the event's 1e-6, so that the event speaks first.
 */
export const DEPENDENT = 1e-13;

/**
 * Kernels for the saddle-point system `[M -Omega^T; Omega 0]` by Cholesky factors of M and of its Schur complement
 * (Benzi, Golub and Liesen, Acta Numerica 14 (2005), section 5; Golub and Van Loan, Matrix Computations, 4th ed.,
 * sections 3.1 and 4.2). n coordinates, m rows, row-major, no allocation. The inverses of L's diagonal are kept,
 * because a division costs as much as several products.
 */
export interface SaddleKernels {
  mass: Triangular;
  schur: Triangular;
  /** Y = L^-1 Omega^T by rows of Omega (m x n), S = Y^T Y with both triangles (m x m). */
  rows(L: Float64Array, inverse: Float64Array, omega: Float64Array, Y: Float64Array, S: Float64Array): void;
  /** Solves M x - Omega^T y = f, Omega x = g for x in place of f and y in place of g; S and `inverseS` factored. */
  solve(
    L: Float64Array,
    inverse: Float64Array,
    Y: Float64Array,
    S: Float64Array,
    inverseS: Float64Array,
    f: Float64Array,
    g: Float64Array,
  ): void;
}

/** A symmetric positive definite matrix by its Cholesky factor. */
export interface Triangular {
  /**
   * A = L L^T: L over the lower triangle of `A`, 1 / L_ii into `inverse`.
   * @returns 0, or k + 1 where pivot k is not above `relativeFloor` times its diagonal entry
   */
  factor(A: Float64Array, inverse: Float64Array, relativeFloor: number): number;
  /** Solves L x = b in place of b. */
  forward(L: Float64Array, inverse: Float64Array, b: Float64Array): void;
  /** Solves L^T x = b in place of b. */
  back(L: Float64Array, inverse: Float64Array, b: Float64Array): void;
}

const unrolled: ReadonlyMap<number, Triangular> = new Map([
  [10, { factor: factor10, forward: forward10, back: back10 }],
  [4, { factor: factor4, forward: forward4, back: back4 }],
]);

/**
 * The fastest there are: straight lines for the board's size, else loops.
 *
 * @param n coordinates
 * @param m constraint rows
 */
export function saddleKernels(n: number, m: number): SaddleKernels {
  const mass = unrolled.get(n) ?? triangularLoops(n);
  const schur = unrolled.get(m) ?? triangularLoops(m);
  return n === 10 && m === 4 ? { mass, schur, rows: rows10x4, solve: solve10x4 } : loopKernels(n, m, mass, schur);
}

/**
 * Cholesky and triangular solves by loops, for any size.
 *
 * @param n size
 */
export function triangularLoops(n: number): Triangular {
  return {
    factor(A, inverse, relativeFloor) {
      for (let i = 0; i < n; i++) {
        for (let j = 0; j < i; j++) {
          let sum = A[i * n + j]!;
          for (let k = 0; k < j; k++) sum -= A[i * n + k]! * A[j * n + k]!;
          A[i * n + j] = sum * inverse[j]!;
        }
        const diagonal = A[i * n + i]!;
        let pivot = diagonal;
        for (let k = 0; k < i; k++) pivot -= A[i * n + k]! * A[i * n + k]!;
        if (!(pivot > relativeFloor * diagonal)) return i + 1;
        A[i * n + i] = Math.sqrt(pivot);
        inverse[i] = 1 / A[i * n + i]!;
      }
      return 0;
    },
    forward(L, inverse, b) {
      for (let i = 0; i < n; i++) {
        let sum = b[i]!;
        for (let k = 0; k < i; k++) sum -= L[i * n + k]! * b[k]!;
        b[i] = sum * inverse[i]!;
      }
    },
    back(L, inverse, b) {
      for (let i = n - 1; i >= 0; i--) {
        let sum = b[i]!;
        for (let k = i + 1; k < n; k++) sum -= L[k * n + i]! * b[k]!;
        b[i] = sum * inverse[i]!;
      }
    },
  };
}

/**
 * Solves of [M, -Omega^T; Omega, 0] by loops, for any size.
 *
 * @param n coordinates
 * @param m constraint rows
 * @param mass kernels for the mass matrix, n x n
 * @param schur kernels for Omega M^-1 Omega^T, m x m
 */
export function loopKernels(
  n: number,
  m: number,
  mass = triangularLoops(n),
  schur = triangularLoops(m),
): SaddleKernels {
  return {
    mass,
    schur,
    rows(L, inverse, omega, Y, S) {
      for (let r = 0; r < m; r++) {
        for (let i = 0; i < n; i++) {
          let sum = omega[r * n + i]!;
          for (let k = 0; k < i; k++) sum -= L[i * n + k]! * Y[r * n + k]!;
          Y[r * n + i] = sum * inverse[i]!;
        }
        for (let s = 0; s <= r; s++) {
          let sum = 0;
          for (let k = 0; k < n; k++) sum += Y[r * n + k]! * Y[s * n + k]!;
          S[r * m + s] = S[s * m + r] = sum;
        }
      }
    },
    solve(L, inverse, Y, S, inverseS, f, g) {
      mass.forward(L, inverse, f);
      for (let r = 0; r < m; r++) {
        let sum = g[r]!;
        for (let k = 0; k < n; k++) sum -= Y[r * n + k]! * f[k]!;
        g[r] = sum;
      }
      schur.forward(S, inverseS, g);
      schur.back(S, inverseS, g);
      for (let r = 0; r < m; r++) for (let k = 0; k < n; k++) f[k]! += Y[r * n + k]! * g[r]!;
      mass.back(L, inverse, f);
    },
  };
}
