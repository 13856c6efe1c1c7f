import { Matrix } from 'ml-matrix';
import { doubled } from '../design/doubling.ts';
import { squaresOf } from '../../linalg/square.ts';
import { ControlError, fromRowMajor, norm, solveLinear, symmetricPart, toRowMajor } from '../linearization/matrices.ts';
import type { DareSolution } from './dareSolution.ts';
import { solveDareTwice, type PreciseProblem } from './dareTwice.ts';
import { complexText, modulus, plainEigenvalues } from '../linearization/spectrum.ts';

/**
 * The discrete-time algebraic Riccati equation with a cross term,
 *
 *     X = A^T X A + Q - (A^T X B + N) (R + B^T X B)^-1 (B^T X A + N^T),
 *
 * for its stabilizing solution, by structure-preserving doubling (E. K.-W. Chu, H.-Y. Fan, W.-W. Lin and C.-S. Wang,
 * "Structure-preserving algorithms for periodic discrete-time algebraic Riccati equations", Int. J. Control 77 (2004),
 * 767-788, section 3), the cross term taken into A and Q first. Doubling squares the closed loop, so that a slowest
 * modulus of 1 - 1e-9 takes 30 steps. Where doubles do not hold weights and rates beside each other, the same is done in
 * twice the precision.
 */

const MOST_DOUBLINGS = 60;
const CONVERGED = 1e-15;
const ACCEPTED = 1e-9;

/**
 * @param A n x n
 * @param B n x k
 * @param Q n x n, symmetric
 * @param R k x k, symmetric
 * @param N n x k, cost of state by input
 * @param precise the same problem in twice the precision, of a caller who knows that the cost sees every mode on the unit circle
 * @throws ControlError where there is no stabilizing solution that can be computed
 */
export function solveDare(
  A: Matrix,
  B: Matrix,
  Q: Matrix,
  R: Matrix,
  N = new Matrix(A.rows, B.columns),
  precise?: () => PreciseProblem,
): DareSolution {
  const n = A.rows;
  if (n === 0)
    return { X: new Matrix(0, 0), gain: new Matrix(B.columns, 0), residual: 0, closedLoop: [], doublings: 0 };
  const weighted = solveLinear(R, N.transpose());
  const force = solveLinear(R, B.transpose());
  if (!weighted || !force) throw new ControlError('R is singular: every input needs a weight');
  const plain = Matrix.sub(A, B.mmul(weighted));
  const state = symmetricPart(Matrix.sub(Q, N.mmul(weighted)));
  // A cost that does not see an unstable mode: the least solution, which doubling finds, leaves it; a small cost on all does not.
  for (const share of [0, 1e-14, 1e-11]) {
    const all = Matrix.eye(n).mul(share * (norm(state) || 1));
    const first = {
      Ak: toRowMajor(plain),
      Gk: toRowMajor(symmetricPart(B.mmul(force))),
      Hk: toRowMajor(Matrix.add(state, all)),
    };
    const found = doubled(squaresOf(n), n, first, { mostSteps: MOST_DOUBLINGS, converged: CONVERGED });
    if (!found) continue;
    const solution = judged(A, B, Q, R, N, fromRowMajor(found.X, n, n));
    if (solution) return { ...solution, doublings: found.steps };
  }
  const solution = precise && solveDareTwice(precise());
  if (solution && solution.residual < ACCEPTED) return solution;
  const worst = plainEigenvalues(A).sort((a, b) => modulus(b) - modulus(a))[0]!;
  throw new ControlError(
    `the sampled Riccati equation has no stabilizing solution that can be computed (largest open-loop eigenvalue ${complexText(worst)}); a shorter sample time or other inputs may have one`,
  );
}

/** The solution's gain and residual, if it stabilizes. */
function judged(
  A: Matrix,
  B: Matrix,
  Q: Matrix,
  R: Matrix,
  N: Matrix,
  X: Matrix,
): Omit<DareSolution, 'doublings'> | null {
  const XA = X.mmul(A);
  const right = Matrix.add(B.transpose().mmul(XA), N.transpose());
  const gain = solveLinear(Matrix.add(R, B.transpose().mmul(X).mmul(B)), right);
  if (!gain) return null;
  const moved = A.transpose().mmul(XA);
  const saved = right.transpose().mmul(gain);
  const rest = Matrix.add(moved, Q).sub(saved).sub(X);
  const residual = norm(rest) / (norm(moved) + norm(Q) + norm(saved) + norm(X) || 1);
  const closedLoop = plainEigenvalues(Matrix.sub(A, B.mmul(gain)));
  if (!(residual < ACCEPTED) || closedLoop.some((value) => !(modulus(value) < 1))) return null;
  return { X, gain, residual, closedLoop };
}
