import { Matrix, SingularValueDecomposition } from 'ml-matrix';
import { luFactor, luSolve } from '../../linalg/lu.ts';

/**
 * What the control code needs of matrices beside ml-matrix: designs are made a few times a second at most, so clear
 * code that allocates is right here, and nowhere else in `core`.
 */

/** A design, a point or a weight that can't be had; the message says which and why. */
export class ControlError extends Error {
  override name = 'ControlError';
}

/**
 * A row-major array as a matrix.
 *
 * @param data rows x columns entries
 * @param rows how many
 * @param columns how many
 */
export function fromRowMajor(data: Float64Array, rows: number, columns: number): Matrix {
  const A = new Matrix(rows, columns);
  for (let r = 0; r < rows; r++) for (let c = 0; c < columns; c++) A.set(r, c, data[r * columns + c]!);
  return A;
}

/**
 * A matrix as a row-major array.
 *
 * @param A any size
 */
export function toRowMajor(A: Matrix): Float64Array {
  return Float64Array.from(A.to1DArray());
}

/**
 * Frobenius norm; 0 of an empty matrix.
 *
 * @param A any size
 */
export function norm(A: Matrix): number {
  return A.isEmpty() ? 0 : A.norm('frobenius');
}

/**
 * Largest absolute difference of two entries.
 *
 * @param A any size
 * @param B the size of A
 */
export function maxDifference(A: Matrix, B: Matrix): number {
  return A.isEmpty() ? 0 : Matrix.sub(A, B).abs().max();
}

/**
 * Columns side by side; either may be empty.
 *
 * @param A any size
 * @param B as many rows as A
 */
export function besides(A: Matrix, B: Matrix): Matrix {
  const C = new Matrix(A.rows, A.columns + B.columns);
  if (A.columns > 0) C.setSubMatrix(A, 0, 0);
  if (B.columns > 0) C.setSubMatrix(B, 0, A.columns);
  return C;
}

/**
 * A stack of row blocks.
 *
 * @param blocks each with as many columns
 */
export function stacked(blocks: readonly Matrix[]): Matrix {
  const C = new Matrix(
    blocks.reduce((sum, b) => sum + b.rows, 0),
    blocks[0]!.columns,
  );
  let row = 0;
  for (const block of blocks) {
    if (block.rows > 0) C.setSubMatrix(block, row, 0);
    row += block.rows;
  }
  return C;
}

/**
 * Some columns of a matrix, those from `from` up to and without `to`.
 *
 * @param A any size
 * @param from first column
 * @param to behind the last column
 */
export function columnsOf(A: Matrix, from: number, to: number): Matrix {
  return to > from && A.rows > 0
    ? A.subMatrix(0, A.rows - 1, from, to - 1)
    : new Matrix(A.rows, Math.max(0, to - from));
}

/** Orthonormal bases of a matrix's column space and of what is orthogonal to it, with the gap that decided. */
export interface ColumnSpace {
  /** rows x rank, and rows x (rows - rank). */
  basis: Matrix;
  complement: Matrix;
  /** The smallest singular value that counts and the largest that does not (0 where there is none). */
  kept: number;
  dropped: number;
}

/** Shares of a scale between which a singular value may be either small or rounding: there the widest gap decides. */
const CERTAIN = 1e-6;
const ROUNDING_AT_MOST = 1e-10;
/** What rounding leaves of a zero at the least: smaller values differ by chance. */
export const LEAST = 1e-15;

/**
 * How many singular values count. Rounding grows with what came before (a direction found by a small singular value
 * carries an error of its inverse), so that no fixed number tells a weak coupling from rounding; but between the two
 * lies a gap. Above `CERTAIN` of the scale a value counts; below, the widest gap between neighbours decides, where the
 * smaller one can be rounding.
 *
 * @param values singular values, the largest first
 * @param scale size of what they are computed from: that of a matrix without cancellation
 * @param strength product of the shares that counted before, where the values follow from them
 */
export function rankByGap(values: readonly number[], scale: number, strength = 1): number {
  if (!(scale > 0)) return 0;
  const least = Math.min(CERTAIN / 10, LEAST / strength);
  const atMost = Math.max(ROUNDING_AT_MOST, 10 * least);
  const shares = values.map((value) => Math.max(value / scale, least));
  const certain = shares.filter((share) => share > CERTAIN).length;
  let [rank, widest] = [shares.length, 1];
  // With none below it, the smallest is compared with what rounding leaves.
  for (let k = certain; k <= shares.length; k++) {
    const smaller = shares[k] ?? least;
    const gap = (shares[k - 1] ?? 1) / smaller;
    if (smaller <= atMost && gap > widest) [rank, widest] = [k, gap];
  }
  return rank;
}

/**
 * Column space by singular values (Golub and Van Loan, Matrix Computations, 4th ed., section 5.4).
 *
 * @param A any size
 * @param count how many count, of all (the largest first); a number: those above it
 */
export function columnSpace(A: Matrix, count: number | ((values: readonly number[]) => number)): ColumnSpace {
  const m = A.rows;
  if (m === 0 || A.columns === 0) return { basis: new Matrix(m, 0), complement: Matrix.eye(m), kept: 0, dropped: 0 };
  // Padded with zero columns, so that the left singular vectors are a full basis.
  const padded = A.columns < m ? besides(A, Matrix.zeros(m, m - A.columns)) : A;
  const { leftSingularVectors: U, diagonal } = new SingularValueDecomposition(padded, {
    computeRightSingularVectors: false,
    autoTranspose: true,
  });
  const values = diagonal.slice(0, Math.min(m, A.columns));
  const rank = typeof count === 'number' ? values.filter((s) => s > count).length : count(values);
  return {
    basis: columnsOf(U, 0, rank),
    complement: columnsOf(U, rank, m),
    kept: values[rank - 1] ?? 0,
    dropped: values[rank] ?? 0,
  };
}

/**
 * Solves A X = B by LU with partial pivoting; null where A is singular.
 *
 * @param A n x n
 * @param B n x k
 */
export function solveLinear(A: Matrix, B: Matrix): Matrix | null {
  const n = A.rows;
  if (n === 0) return B.clone();
  const factors = toRowMajor(A);
  const pivots = new Int32Array(n);
  if (!luFactor(factors, n, pivots)) return null;
  const X = new Matrix(n, B.columns);
  const column = new Float64Array(n);
  for (let c = 0; c < B.columns; c++) {
    for (let r = 0; r < n; r++) column[r] = B.get(r, c);
    luSolve(factors, n, pivots, column);
    for (let r = 0; r < n; r++) X.set(r, c, column[r]!);
  }
  return X;
}

/**
 * (A + A^T) / 2.
 *
 * @param A n x n
 */
export function symmetricPart(A: Matrix): Matrix {
  return Matrix.add(A, A.transpose()).mul(0.5);
}

/**
 * Product of several matrices, left to right.
 *
 * @param first the leftmost
 * @param others each with as many rows as the one before has columns
 */
export function product(first: Matrix, ...others: Matrix[]): Matrix {
  return others.reduce((left, right) => left.mmul(right), first);
}
