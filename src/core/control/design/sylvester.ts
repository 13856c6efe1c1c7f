import { Matrix, SingularValueDecomposition } from 'ml-matrix';
import { luFactor, luSolve } from '../../linalg/lu.ts';

/**
 * Linear matrix equations as plain linear systems (Golub and Van Loan, Matrix Computations, 4th ed., section 12.3:
 * Kronecker products). Their order is the square of the matrices', which is small here; in return a singular equation
 * has its least-norm solution, and a regular one the stability of LU.
 */

/**
 * Singular values below this share of the largest are those of eigenvalues common to both matrices, zero but for
 * rounding; the others are not far below 1e-6 of it.
 */
const COMMON = 1e-9;

/**
 * X (r x s) of least norm that minimizes |A X - X B - C| (Frobenius); A is r x r, B s x s.
 *
 * @param A r x r
 * @param B s x s
 * @param C r x s
 */
export function sylvesterLeastSquares(A: Matrix, B: Matrix, C: Matrix): Matrix {
  const [r, s] = [A.rows, B.rows];
  if (r === 0 || s === 0) return new Matrix(r, s);
  return Matrix.from1DArray(r, s, leastNorm(kronecker(A, B), C.to1DArray()));
}

/**
 * The same with X D = E besides: X (r x s) of least norm that minimizes |A X - X B - C|² + |X D - E|².
 *
 * @param A r x r
 * @param B s x s
 * @param C r x s
 * @param D s x t
 * @param E r x t
 */
export function sylvesterWith(A: Matrix, B: Matrix, C: Matrix, D: Matrix, E: Matrix): Matrix {
  const [r, s, t] = [A.rows, B.rows, D.columns];
  if (r === 0 || s === 0) return new Matrix(r, s);
  const K = Matrix.zeros(r * (s + t), r * s);
  K.setSubMatrix(kronecker(A, B), 0, 0);
  for (let i = 0; i < r; i++) {
    for (let j = 0; j < t; j++) for (let k = 0; k < s; k++) K.set(r * s + i * t + j, i * s + k, D.get(k, j));
  }
  return Matrix.from1DArray(r, s, leastNorm(K, [...C.to1DArray(), ...E.to1DArray()]));
}

/** The matrix of X -> A X - X B on the rows of X one after the other. */
function kronecker(A: Matrix, B: Matrix): Matrix {
  const [r, s] = [A.rows, B.rows];
  const K = Matrix.zeros(r * s, r * s);
  for (let i = 0; i < r; i++) {
    for (let j = 0; j < s; j++) {
      const row = i * s + j;
      for (let k = 0; k < r; k++) K.set(row, k * s + j, A.get(i, k));
      for (let k = 0; k < s; k++) K.set(row, i * s + k, K.get(row, i * s + k) - B.get(k, j));
    }
  }
  return K;
}

function leastNorm(K: Matrix, right: readonly number[]): number[] {
  const { leftSingularVectors: U, rightSingularVectors: V, diagonal } = new SingularValueDecomposition(K);
  const c = U.transpose().mmul(Matrix.columnVector([...right]));
  diagonal.forEach((sigma, i) => c.set(i, 0, sigma > COMMON * diagonal[0]! ? c.get(i, 0) / sigma : 0));
  return V.mmul(c).to1DArray();
}

/**
 * Symmetric X with A^T X + X A = -C, C symmetric, n x n; null where A and -A share an eigenvalue.
 *
 * @param A n x n
 * @param C n x n, symmetric
 */
export function lyapunov(A: Matrix, C: Matrix): Matrix | null {
  const n = A.rows;
  const place = (i: number, j: number): number => (i >= j ? (i * (i + 1)) / 2 + j : (j * (j + 1)) / 2 + i);
  const size = (n * (n + 1)) / 2;
  const K = new Float64Array(size * size);
  const x = new Float64Array(size);
  for (let i = 0; i < n; i++) {
    for (let j = 0; j <= i; j++) {
      const row = place(i, j) * size;
      // (A^T X)_ij + (X A)_ij = sum over k of a_ki x_kj + x_ik a_kj
      for (let k = 0; k < n; k++) {
        K[row + place(k, j)]! += A.get(k, i);
        K[row + place(i, k)]! += A.get(k, j);
      }
      x[place(i, j)] = -C.get(i, j);
    }
  }
  const pivots = new Int32Array(size);
  if (!luFactor(K, size, pivots)) return null;
  luSolve(K, size, pivots, x);
  const X = new Matrix(n, n);
  for (let i = 0; i < n; i++) for (let j = 0; j < n; j++) X.set(i, j, x[place(i, j)]!);
  return X;
}
