import type { Matrix } from 'ml-matrix';
import { DoubleDouble } from '../../linalg/doubleDouble.ts';
import { norm } from '../linearization/matrices.ts';
import type { Complex } from '../linearization/spectrum.ts';
import { doubledTwice, eigenvaluesOfBothEnds, GOOD, ON_ALL, once, twice } from './twice.ts';

/**
 * The Riccati equation of `riccati.ts` in twice the precision, by the same structure-preserving doubling: for weights
 * and rates so far apart that a double can't hold them beside each other (weights of 1e-8 and 1e8, a board at walking
 * pace whose heading answers a thousandth as fast as its steer).
 */
export interface PreciseSolution {
  /** Rounded to doubles. */
  X: Matrix;
  /** F^T X, rounded after it was computed. */
  w: Matrix;
  closedLoop: Complex[];
  /** Of the equation, relative to its terms, in twice the precision. */
  residual: number;
  doublings: number;
}

/** Shares of the largest rate tried for gamma. */
const GAMMAS = [1, 0.1, 0.01, 1e-3, 1e-4];

/**
 * Every mode of A on the imaginary axis is seen by Q: the caller has looked.
 *
 * @param A n x n
 * @param F B R^-1/2, n x k
 * @param C with Q = C^T C, p x n
 * @returns null where doubling does not converge
 */
export function solveCareTwice(A: Matrix, F: Matrix, C: Matrix): PreciseSolution | null {
  const [a, f, c] = [twice(A), twice(F), twice(C)];
  const q = c.transpose().times(c);
  const ft = f.transpose();
  const cost = q.norm() > 0 ? q.norm() : norm(A) ** 2 / (norm(F) ** 2 || 1);
  const G = f.times(ft);
  const largest = Math.max(norm(A), norm(F) * norm(C));
  let best: PreciseSolution | null = null;
  for (const [all, share] of ON_ALL.flatMap((all) => GAMMAS.map((share) => [all, share] as const))) {
    const found = doubling(a, G, q.plus(DoubleDouble.identity(A.rows, all * cost)), share * largest);
    if (!found) continue;
    const w = ft.times(found.X);
    const closed = a.plus(f.times(w), -1);
    const closedLoop = eigenvaluesOfBothEnds(closed);
    if (!closedLoop || closedLoop.some(([re]) => !(re < 0))) continue;
    const residual = residualOf(a, w, q, found.X);
    if (best && !(residual < best.residual)) continue;
    best = { X: once(found.X), w: once(w), closedLoop, residual, doublings: found.steps };
    if (residual < GOOD) break;
  }
  return best;
}

/** Paper symbols as in `riccati.ts`. */
function doubling(A: DoubleDouble, G: DoubleDouble, H: DoubleDouble, gamma: number) {
  const n = A.rows;
  const I = DoubleDouble.identity(n);
  const shifted = A.plus(I, -gamma);
  const inverse = shifted.solve(I);
  const W = inverse && shifted.transpose().plus(H.times(inverse).times(G));
  const inverseW = W?.solve(I);
  if (!inverse || !inverseW) return null;
  const Ak = I.plus(inverseW.transpose(), 2 * gamma);
  const zero = new DoubleDouble(n, n);
  const Gk = zero.plus(inverse.times(G).times(inverseW), 2 * gamma).symmetric();
  const Hk = zero.plus(inverseW.times(H).times(inverse), 2 * gamma).symmetric();
  return doubledTwice({ Ak, Gk, Hk });
}

/** |A^T X + X A - w^T w + Q| as a share of its terms. */
function residualOf(A: DoubleDouble, w: DoubleDouble, Q: DoubleDouble, X: DoubleDouble): number {
  const AtX = A.transpose().times(X);
  const ww = w.transpose().times(w);
  const rest = AtX.plus(AtX.transpose()).plus(ww, -1).plus(Q);
  return rest.norm() / (2 * AtX.norm() + ww.norm() + Q.norm() || 1);
}
