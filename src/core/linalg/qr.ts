/**
 * Householder QR with column pivoting of small dense matrices: Golub and Van Loan, Matrix Computations, 4th ed.,
 * section 5.1.2 (Householder vectors), 5.2.2 (QR), algorithm 5.4.1 (pivoting). Row-major, the caller owns all arrays.
 */

/** A column left shorter than this share of the longest one is rounding: the columns are then dependent. */
const DEPENDENT = 1e-12;

/**
 * Factors `A` (rows x columns, rows >= columns) in place, A P = Q R: R on and above the diagonal. `Q` (rows x rows) is
 * formed in full: its first `columns` columns span the columns of A, the others the null space of A^T.
 *
 * @param A rows x columns, row-major
 * @param rows number of rows
 * @param columns number of columns, at most rows
 * @param Q rows x rows, row-major
 * @param work one entry per row
 * @returns the rank
 */
export function qrFull(A: Float64Array, rows: number, columns: number, Q: Float64Array, work: Float64Array): number {
  Q.fill(0);
  for (let i = 0; i < rows; i++) Q[i * rows + i] = 1;
  let largest = 0;
  for (let k = 0; k < columns; k++) {
    const size = pivot(A, rows, columns, k);
    if (k === 0) largest = size;
    if (!(size > DEPENDENT * largest)) return k;
    const beta = reflector(A, rows, columns, k, size, work);
    reflectRows(A, rows, columns, k, beta, work);
    reflectColumns(Q, rows, k, beta, work);
  }
  return columns;
}

/** Brings the longest of the remaining columns to place k; its length. Norms are computed anew: columns are few. */
function pivot(A: Float64Array, rows: number, columns: number, k: number): number {
  let best = k;
  let longest = -1;
  for (let j = k; j < columns; j++) {
    let sum = 0;
    for (let i = k; i < rows; i++) sum += A[i * columns + j]! ** 2;
    if (sum > longest) {
      longest = sum;
      best = j;
    }
  }
  if (best !== k) {
    for (let i = 0; i < rows; i++) {
      const swap = A[i * columns + k]!;
      A[i * columns + k] = A[i * columns + best]!;
      A[i * columns + best] = swap;
    }
  }
  return Math.sqrt(longest);
}

/** Householder vector of column k into `w` (from k on); beta of I - beta w w^T. */
function reflector(A: Float64Array, rows: number, columns: number, k: number, size: number, w: Float64Array): number {
  const head = A[k * columns + k]!;
  // The sign that avoids cancellation.
  const alpha = head > 0 ? -size : size;
  for (let i = k; i < rows; i++) w[i] = A[i * columns + k]!;
  w[k] = head - alpha;
  return 1 / (size * size - alpha * head);
}

function reflectRows(A: Float64Array, rows: number, columns: number, k: number, beta: number, w: Float64Array): void {
  for (let j = k; j < columns; j++) {
    let sum = 0;
    for (let i = k; i < rows; i++) sum += w[i]! * A[i * columns + j]!;
    sum *= beta;
    for (let i = k; i < rows; i++) A[i * columns + j]! -= sum * w[i]!;
  }
}

/** Q <- Q (I - beta w w^T). */
function reflectColumns(Q: Float64Array, rows: number, k: number, beta: number, w: Float64Array): void {
  for (let i = 0; i < rows; i++) {
    let sum = 0;
    for (let j = k; j < rows; j++) sum += Q[i * rows + j]! * w[j]!;
    sum *= beta;
    for (let j = k; j < rows; j++) Q[i * rows + j]! -= sum * w[j]!;
  }
}
