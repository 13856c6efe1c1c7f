/** What the Riccati equations of continuous and of sampled control share in twice the precision. */
import { Matrix } from 'ml-matrix';
import { DoubleDouble } from '../../linalg/doubleDouble.ts';
import { plainEigenvalues, type Complex } from '../linearization/spectrum.ts';
import { doubled, type Algebra } from './doubling.ts';

const MOST_DOUBLINGS = 120;
const CONVERGED = 1e-20;
const SETTLED = 1e-9;
/** A residual at which no better one is looked for. */
export const GOOD = 1e-13;
/**
 * A cost on everything, as a share of Q's: with it the least solution, which doubling finds, is the stabilizing one.
 * The smallest that rounding lets through.
 */
export const ON_ALL = [1e-26, 1e-23, 1e-20];

/**
 * @param A any matrix
 * @returns the same numbers in twice the precision
 */
export const twice = (A: Matrix): DoubleDouble => DoubleDouble.from(A.to1DArray(), A.rows, A.columns);
/**
 * @param A any matrix
 * @returns rounded to doubles
 */
export const once = (A: DoubleDouble): Matrix => Matrix.from1DArray(A.rows, A.columns, [...A.hi]);

/** Matrices in twice the precision, as `doubling.ts` takes them. */
const IN_TWICE: Algebra<DoubleDouble> = {
  identity: (n) => DoubleDouble.identity(n),
  times: (a, b) => a.times(b),
  plus: (a, b) => a.plus(b),
  transposed: (a) => a.transpose(),
  symmetric: (a) => a.symmetric(),
  solve: (W, B) => W.solve(B),
  norm: (a) => a.norm(),
};

/**
 * Doubling in twice the precision.
 *
 * @param first A_0, G_0 and H_0, each n x n
 * @returns null where it does not converge
 */
export const doubledTwice = (
  first: Record<'Ak' | 'Gk' | 'Hk', DoubleDouble>,
): { X: DoubleDouble; steps: number } | null =>
  doubled(IN_TWICE, first.Ak.rows, first, { mostSteps: MOST_DOUBLINGS, converged: CONVERGED, settled: SETTLED });
/** Below this share of the largest, eigenvalues are taken from the inverse, where they are the largest. */
const SLOW = 1e-7;

/**
 * Eigenvalues of a matrix whose rates lie far apart: the fast ones from itself, the slow ones from its inverse.
 *
 * @param A n x n
 * @returns null where it has no inverse
 */
export function eigenvaluesOfBothEnds(A: DoubleDouble): Complex[] | null {
  const inverse = A.solve(DoubleDouble.identity(A.rows));
  if (!inverse) return null;
  const fast = plainEigenvalues(once(A));
  const largest = Math.max(...fast.map(([re, im]) => Math.hypot(re, im)));
  const size = ([re, im]: Complex): number => Math.hypot(re, im);
  const slow = plainEigenvalues(once(inverse))
    .map(([re, im]): Complex => {
      const square = re * re + im * im;
      return [re / square, -im / square];
    })
    .sort((a, b) => size(a) - size(b));
  const kept = fast.filter((value) => size(value) > SLOW * largest);
  return [...slow.slice(0, A.rows - kept.length), ...kept];
}
