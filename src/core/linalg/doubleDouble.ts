/**
 * Small dense matrices in twice the precision: each number is an unevaluated sum `hi + lo` of two doubles, about 32
 * digits (T. J. Dekker, "A floating-point technique for extending the available precision", Numerische Mathematik 18
 * (1971), 224-242; Y. Hida, X. S. Li and D. H. Bailey, "Library for double-double and quad-double arithmetic", 2007).
 *
 * For what a double can't tell apart (weights of 1e-8 beside 1e8 in one Riccati equation); some thirty times slower
 * than plain arithmetic, so for matrices of a few dozen rows, off every hot path. Not guaranteed: results near the
 * ends of the range of doubles (a product's low part is lost below 1e-290).
 */
export class DoubleDouble {
  readonly hi: Float64Array;
  readonly lo: Float64Array;

  /** A matrix of zeros, row-major. */
  constructor(
    readonly rows: number,
    readonly columns: number,
  ) {
    this.hi = new Float64Array(rows * columns);
    this.lo = new Float64Array(rows * columns);
  }

  /** @param entries row-major, rows x columns */
  static from(entries: ArrayLike<number>, rows: number, columns: number): DoubleDouble {
    const A = new DoubleDouble(rows, columns);
    A.hi.set(entries);
    return A;
  }

  static identity(n: number, scale = 1): DoubleDouble {
    const A = new DoubleDouble(n, n);
    for (let i = 0; i < n; i++) A.hi[i * n + i] = scale;
    return A;
  }

  clone(): DoubleDouble {
    const A = new DoubleDouble(this.rows, this.columns);
    A.hi.set(this.hi);
    A.lo.set(this.lo);
    return A;
  }

  transpose(): DoubleDouble {
    const { rows, columns } = this;
    const T = new DoubleDouble(columns, rows);
    for (let i = 0; i < rows; i++) {
      for (let j = 0; j < columns; j++) {
        T.hi[j * rows + i] = this.hi[i * columns + j]!;
        T.lo[j * rows + i] = this.lo[i * columns + j]!;
      }
    }
    return T;
  }

  /** this + factor * other; `factor` a power of two, or rounded once. */
  plus(other: DoubleDouble, factor = 1): DoubleDouble {
    const S = this.clone();
    for (let k = 0; k < S.hi.length; k++) {
      accumulate(S, k, other.hi[k]!, other.lo[k]!, factor, 0);
    }
    return S;
  }

  times(other: DoubleDouble): DoubleDouble {
    const P = new DoubleDouble(this.rows, other.columns);
    for (let i = 0; i < this.rows; i++) {
      for (let j = 0; j < other.columns; j++) {
        const at = i * other.columns + j;
        for (let k = 0; k < this.columns; k++) {
          const [a, b] = [i * this.columns + k, k * other.columns + j];
          accumulate(P, at, this.hi[a]!, this.lo[a]!, other.hi[b]!, other.lo[b]!);
        }
      }
    }
    return P;
  }

  /** (this + transpose) / 2 */
  symmetric(): DoubleDouble {
    const S = this.plus(this.transpose());
    for (let k = 0; k < S.hi.length; k++) {
      S.hi[k]! *= 0.5;
      S.lo[k]! *= 0.5;
    }
    return S;
  }

  /** X with this X = B, by LU with partial pivoting; null where this is singular. */
  solve(B: DoubleDouble): DoubleDouble | null {
    const n = this.rows;
    const [A, X] = [this.clone(), B.clone()];
    for (let k = 0; k < n; k++) {
      let pivot = k;
      for (let i = k + 1; i < n; i++) if (Math.abs(A.hi[i * n + k]!) > Math.abs(A.hi[pivot * n + k]!)) pivot = i;
      if (!(Math.abs(A.hi[pivot * n + k]!) > 0)) return null;
      if (pivot !== k) for (const M of [A, X]) swapRows(M, pivot, k);
      for (let i = k + 1; i < n; i++) eliminate(A, X, i, k);
    }
    for (let k = n - 1; k >= 0; k--) {
      for (let j = 0; j < X.columns; j++) divide(X, k * X.columns + j, A.hi[k * n + k]!, A.lo[k * n + k]!);
      for (let i = 0; i < k; i++) {
        const [h, l] = [-A.hi[i * n + k]!, -A.lo[i * n + k]!];
        if (h === 0) continue;
        for (let j = 0; j < X.columns; j++) {
          accumulate(X, i * X.columns + j, h, l, X.hi[k * X.columns + j]!, X.lo[k * X.columns + j]!);
        }
      }
    }
    return X;
  }

  /** Frobenius norm, to a double's precision. */
  norm(): number {
    return Math.hypot(...this.hi);
  }
}

/** 2^27 + 1: splits a double into two halves whose products are exact. */
const SPLITTER = 134217729;

/** entry k of A += (xh + xl) (yh + yl) */
function accumulate(A: DoubleDouble, k: number, xh: number, xl: number, yh: number, yl: number): void {
  const p = xh * yh;
  let c = SPLITTER * xh;
  const x1 = c - (c - xh);
  const x2 = xh - x1;
  c = SPLITTER * yh;
  const y1 = c - (c - yh);
  const y2 = yh - y1;
  const e = x1 * y1 - p + x1 * y2 + x2 * y1 + x2 * y2 + (xh * yl + xl * yh);
  const a = A.hi[k]!;
  const s = a + p;
  const bb = s - a;
  const t = a - (s - bb) + (p - bb) + e + A.lo[k]!;
  const hi = s + t;
  A.hi[k] = hi;
  A.lo[k] = t - (hi - s);
}

/** entry k of A /= (yh + yl): a quotient in doubles, corrected twice by what it leaves. */
function divide(A: DoubleDouble, k: number, yh: number, yl: number): void {
  const rest = new DoubleDouble(1, 1);
  rest.hi[0] = A.hi[k]!;
  rest.lo[0] = A.lo[k]!;
  const quotient = new DoubleDouble(1, 1);
  for (let i = 0; i < 3; i++) {
    const q = rest.hi[0]! / yh;
    accumulate(quotient, 0, q, 0, 1, 0);
    accumulate(rest, 0, -q, 0, yh, yl);
  }
  A.hi[k] = quotient.hi[0]!;
  A.lo[k] = quotient.lo[0]!;
}

function swapRows(A: DoubleDouble, a: number, b: number): void {
  const m = A.columns;
  for (let j = 0; j < m; j++) {
    for (const x of [A.hi, A.lo]) [x[a * m + j], x[b * m + j]] = [x[b * m + j]!, x[a * m + j]!];
  }
}

/** Row i -= (A_ik / A_kk) row k, in A and X. */
function eliminate(A: DoubleDouble, X: DoubleDouble, i: number, k: number): void {
  const n = A.columns;
  if (A.hi[i * n + k] === 0) return;
  divide(A, i * n + k, A.hi[k * n + k]!, A.lo[k * n + k]!);
  const [h, l] = [-A.hi[i * n + k]!, -A.lo[i * n + k]!];
  for (let j = k + 1; j < n; j++) accumulate(A, i * n + j, h, l, A.hi[k * n + j]!, A.lo[k * n + j]!);
  const m = X.columns;
  for (let j = 0; j < m; j++) accumulate(X, i * m + j, h, l, X.hi[k * m + j]!, X.lo[k * m + j]!);
}
