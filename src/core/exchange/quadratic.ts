/** Springs and dampers of a system that are quadratic forms, as sums of squares: what an engine with joints and tendons takes. */

/** 1/2 weight (along · x - free)². */
export interface Square {
  weight: number;
  /** n. */
  along: Float64Array;
  free: number;
}

/** What is left after so much is rounding. */
const NOTHING = 1e-10;

/**
 * A positive semidefinite form 1/2 x^T A x + b^T x as a sum of squares, by Cholesky's factors with the largest pivot first (N. J.
 * Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., section 10.3). Null where there is none.
 *
 * @param A n x n, symmetric
 * @param b n
 */
export function squaresOf(A: Float64Array, b: Float64Array): Square[] | null {
  const n = b.length;
  const [left, rest] = [A.slice(), b.slice()];
  const size = Math.max(...A.map(Math.abs), 0);
  const squares: Square[] = [];
  for (let step = 0; step < n && size > 0; step++) {
    let k = 0;
    for (let i = 1; i < n; i++) if (left[i * n + i]! > left[k * n + k]!) k = i;
    const weight = left[k * n + k]!;
    if (!(weight > NOTHING * size)) break;
    const along = Float64Array.from({ length: n }, (_, i) => clean(left[i * n + k]! / weight));
    const free = clean(-rest[k]! / weight);
    for (let i = 0; i < n; i++) {
      rest[i]! += weight * free * along[i]!;
      for (let j = 0; j < n; j++) left[i * n + j]! -= weight * along[i]! * along[j]!;
    }
    squares.push({ weight, along, free });
  }
  const scale = Math.max(size, ...b.map(Math.abs));
  const remains = [...left, ...rest].some((x) => !(Math.abs(x) <= NOTHING * scale));
  return remains ? null : squares;
}

/** Rounding beside 1. */
const clean = (x: number): number =>
  Math.abs(x) < 1e-12 ? 0 : Math.abs(x - Math.round(x)) < 1e-12 ? Math.round(x) : x;
