/**
 * LU factorization with partial pivoting of small dense complex matrices, real and imaginary parts in arrays of their
 * own: Golub and Van Loan, Matrix Computations, 4th ed., algorithm 3.4.1, pivots by |re| + |im| as in LINPACK's CGEFA.
 * Row-major, in place, no allocation.
 */

/**
 * Factors `re` + i `im` (n x n) in place: unit lower L below the diagonal, U above it, the inverses of its pivots on
 * the diagonal; row swaps into `pivots` (n).
 *
 * @param re real part, n x n, row-major
 * @param im imaginary part, n x n, row-major
 * @param n size
 * @param pivots n row numbers
 * @returns false when a pivot is zero or not a number
 */
export function complexLuFactor(re: Float64Array, im: Float64Array, n: number, pivots: Int32Array): boolean {
  for (let k = 0; k < n; k++) {
    const p = largestBelow(re, im, n, k);
    pivots[k] = p;
    if (p !== k) {
      swapRows(re, n, k, p);
      swapRows(im, n, k, p);
    }
    const kk = k * n + k;
    const a = re[kk]!;
    const b = im[kk]!;
    const square = a * a + b * b;
    if (!(square > 0 && square < Infinity)) return false;
    const c = (re[kk] = a / square);
    const d = (im[kk] = -b / square);
    for (let i = k + 1; i < n; i++) {
      const ik = i * n + k;
      const x = re[ik]!;
      const y = im[ik]!;
      if (x === 0 && y === 0) continue;
      const u = (re[ik] = x * c - y * d);
      const v = (im[ik] = x * d + y * c);
      for (let j = k + 1, ij = ik + 1, kj = kk + 1; j < n; j++, ij++, kj++) {
        re[ij]! -= u * re[kj]! - v * im[kj]!;
        im[ij]! -= u * im[kj]! + v * re[kj]!;
      }
    }
  }
  return true;
}

/**
 * Solves A x = b in place of b = `x` + i `y` (n each) with the factors of `complexLuFactor`.
 *
 * @param re real part of the factors, n x n
 * @param im imaginary part of the factors, n x n
 * @param n size
 * @param pivots n row numbers
 * @param x real part of b, then of the solution, n
 * @param y imaginary part of b, then of the solution, n
 */
export function complexLuSolve(
  re: Float64Array,
  im: Float64Array,
  n: number,
  pivots: Int32Array,
  x: Float64Array,
  y: Float64Array,
): void {
  for (let k = 0; k < n; k++) {
    const p = pivots[k]!;
    if (p === k) continue;
    const a = x[k]!;
    x[k] = x[p]!;
    x[p] = a;
    const b = y[k]!;
    y[k] = y[p]!;
    y[p] = b;
  }
  for (let i = 1; i < n; i++) {
    let a = x[i]!;
    let b = y[i]!;
    for (let j = 0, ij = i * n; j < i; j++, ij++) {
      a -= re[ij]! * x[j]! - im[ij]! * y[j]!;
      b -= re[ij]! * y[j]! + im[ij]! * x[j]!;
    }
    x[i] = a;
    y[i] = b;
  }
  for (let i = n - 1; i >= 0; i--) {
    const ii = i * n + i;
    let a = x[i]!;
    let b = y[i]!;
    for (let j = i + 1, ij = ii + 1; j < n; j++, ij++) {
      a -= re[ij]! * x[j]! - im[ij]! * y[j]!;
      b -= re[ij]! * y[j]! + im[ij]! * x[j]!;
    }
    x[i] = a * re[ii]! - b * im[ii]!;
    y[i] = a * im[ii]! + b * re[ii]!;
  }
}

function largestBelow(re: Float64Array, im: Float64Array, n: number, k: number): number {
  let p = k;
  let largest = 0;
  for (let i = k; i < n; i++) {
    const size = Math.abs(re[i * n + k]!) + Math.abs(im[i * n + k]!);
    if (size > largest) {
      largest = size;
      p = i;
    }
  }
  return p;
}

function swapRows(A: Float64Array, n: number, k: number, p: number): void {
  for (let j = 0; j < n; j++) {
    const swap = A[k * n + j]!;
    A[k * n + j] = A[p * n + j]!;
    A[p * n + j] = swap;
  }
}
