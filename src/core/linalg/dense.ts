/**
 * Small dense kernels. Matrices are row-major `Float64Array`s that the caller owns; nothing here allocates.
 *
 * Sources: Golub and Van Loan, Matrix Computations, 4th ed., section 4.2 (Cholesky), 3.1 (triangular
 * systems), 8.5 (cyclic Jacobi).
 */

/**
 * Cholesky factor of a symmetric positive definite matrix in place: the lower triangle of `A` (n x n)
 * becomes L with A = L L^T; the strict upper triangle is left as it was.
 *
 * @param A n x n, row-major
 * @param n size
 * @param relativeFloor a pivot below this part of its diagonal entry counts as zero
 * @returns 0, or k + 1 when pivot k is not above `relativeFloor` times its diagonal entry (or not a number):
 * the leading block of order k + 1 is not positive definite to working precision.
 */
export function cholesky(A: Float64Array, n: number, relativeFloor = 0): number {
  for (let j = 0; j < n; j++) {
    const rowJ = j * n;
    const diagonal = A[rowJ + j]!;
    let pivot = diagonal;
    for (let k = 0; k < j; k++) pivot -= A[rowJ + k]! * A[rowJ + k]!;
    if (!(pivot > relativeFloor * diagonal)) return j + 1;
    const root = Math.sqrt(pivot);
    A[rowJ + j] = root;
    const inverse = 1 / root;
    for (let i = j + 1; i < n; i++) {
      const rowI = i * n;
      let sum = A[rowI + j]!;
      for (let k = 0; k < j; k++) sum -= A[rowI + k]! * A[rowJ + k]!;
      A[rowI + j] = sum * inverse;
    }
  }
  return 0;
}

/**
 * Solves L x = b in place of b, L the lower triangle of `L` (n x n).
 *
 * @param L n x n, row-major; above the diagonal it is not read
 * @param n size
 * @param b right-hand side, then the solution, n
 */
export function solveLower(L: Float64Array, n: number, b: Float64Array): void {
  for (let i = 0; i < n; i++) {
    let sum = b[i]!;
    for (let k = 0; k < i; k++) sum -= L[i * n + k]! * b[k]!;
    b[i] = sum / L[i * n + i]!;
  }
}

/**
 * Solves L^T x = b in place of b.
 *
 * @param L n x n, row-major; above the diagonal it is not read
 * @param n size
 * @param b right-hand side, then the solution, n
 */
export function solveLowerTransposed(L: Float64Array, n: number, b: Float64Array): void {
  for (let i = n - 1; i >= 0; i--) {
    let sum = b[i]!;
    for (let k = i + 1; k < n; k++) sum -= L[k * n + i]! * b[k]!;
    b[i] = sum / L[i * n + i]!;
  }
}

/**
 * Eigenvalues of a symmetric matrix by cyclic Jacobi rotations, onto the diagonal of `A` (n x n, destroyed);
 * eigenvectors into the columns of `V` (n x n) if it is given.
 *
 * @param A n x n, symmetric
 * @param n size
 * @param V n x n, an eigenvector a column
 */
export function symmetricEigenvalues(A: Float64Array, n: number, V?: Float64Array): void {
  V?.fill(0);
  if (V) for (let i = 0; i < n; i++) V[i * n + i] = 1;
  for (let sweep = 0; sweep < 30; sweep++) {
    let off = 0;
    let on = 0;
    for (let i = 0; i < n; i++) {
      on += A[i * n + i]! * A[i * n + i]!;
      for (let j = 0; j < i; j++) off += A[i * n + j]! * A[i * n + j]!;
    }
    // At 1e-32 of the norm squared the off-diagonal part is below rounding.
    if (!(off > 1e-32 * on)) return;
    for (let r = 0; r < n - 1; r++) for (let s = r + 1; s < n; s++) rotate(A, n, r, s, V);
  }
}

/** One Jacobi rotation that makes A[r][s] zero (Golub and Van Loan, algorithm 8.5.1). */
function rotate(A: Float64Array, n: number, r: number, s: number, V?: Float64Array): void {
  const ars = A[r * n + s]!;
  if (ars === 0) return;
  const tau = (A[s * n + s]! - A[r * n + r]!) / (2 * ars);
  const t = (tau >= 0 ? 1 : -1) / (Math.abs(tau) + Math.sqrt(1 + tau * tau));
  const c = 1 / Math.sqrt(1 + t * t);
  const d = t * c;
  for (let k = 0; k < n; k++) {
    const x = A[k * n + r]!;
    const y = A[k * n + s]!;
    A[k * n + r] = c * x - d * y;
    A[k * n + s] = d * x + c * y;
  }
  for (let k = 0; k < n; k++) {
    const x = A[r * n + k]!;
    const y = A[s * n + k]!;
    A[r * n + k] = c * x - d * y;
    A[s * n + k] = d * x + c * y;
  }
  if (!V) return;
  for (let k = 0; k < n; k++) {
    const x = V[k * n + r]!;
    const y = V[k * n + s]!;
    V[k * n + r] = c * x - d * y;
    V[k * n + s] = d * x + c * y;
  }
}

/**
 * Largest absolute entry; NaN if any entry is.
 *
 * @param x any number of entries
 */
export function maxAbs(x: Float64Array): number {
  let largest = 0;
  for (let i = 0; i < x.length; i++) {
    const a = Math.abs(x[i]!);
    if (!(a <= largest)) largest = a;
    if (a !== a) return NaN;
  }
  return largest;
}
