/**
 * LU factorization with partial pivoting of small dense matrices (Golub and Van Loan, Matrix Computations,
 * 4th ed., algorithm 3.4.1). Row-major, in place, no allocation; for real and, as pairs of arrays, complex systems.
 */

/**
 * Factors `A` (n x n) in place: unit lower L below the diagonal, U on and above it; row swaps into `pivots` (n).
 *
 * @param A n x n, row-major
 * @param n size
 * @param pivots n row numbers
 * @param smallest pivots up to this size count as zero
 * @returns false when a pivot is zero or not a number
 */
export function luFactor(A: Float64Array, n: number, pivots: Int32Array, smallest = 0): boolean {
  for (let k = 0; k < n; k++) {
    let p = k;
    for (let i = k + 1; i < n; i++) if (Math.abs(A[i * n + k]!) > Math.abs(A[p * n + k]!)) p = i;
    pivots[k] = p;
    const pivot = A[p * n + k]!;
    if (!(Math.abs(pivot) > smallest && Math.abs(pivot) < Infinity)) return false;
    if (p !== k) {
      for (let j = 0; j < n; j++) {
        const swap = A[k * n + j]!;
        A[k * n + j] = A[p * n + j]!;
        A[p * n + j] = swap;
      }
    }
    const inverse = 1 / pivot;
    for (let i = k + 1; i < n; i++) {
      const factor = A[i * n + k]! * inverse;
      A[i * n + k] = factor;
      if (factor === 0) continue;
      for (let j = k + 1; j < n; j++) A[i * n + j]! -= factor * A[k * n + j]!;
    }
  }
  return true;
}

/**
 * Solves A x = b in place of b with the factors of `luFactor`.
 *
 * @param A the factors, n x n
 * @param n size
 * @param pivots n row numbers
 * @param b right-hand side, then the solution, n
 */
export function luSolve(A: Float64Array, n: number, pivots: Int32Array, b: Float64Array): void {
  for (let k = 0; k < n; k++) {
    const p = pivots[k]!;
    if (p === k) continue;
    const swap = b[k]!;
    b[k] = b[p]!;
    b[p] = swap;
  }
  for (let i = 1; i < n; i++) {
    let sum = b[i]!;
    for (let j = 0; j < i; j++) sum -= A[i * n + j]! * b[j]!;
    b[i] = sum;
  }
  for (let i = n - 1; i >= 0; i--) {
    let sum = b[i]!;
    for (let j = i + 1; j < n; j++) sum -= A[i * n + j]! * b[j]!;
    b[i] = sum / A[i * n + i]!;
  }
}
