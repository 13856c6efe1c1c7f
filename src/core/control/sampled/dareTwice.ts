import { DoubleDouble } from '../../linalg/doubleDouble.ts';
import { doubledTwice, eigenvaluesOfBothEnds, GOOD, ON_ALL, once } from '../design/twice.ts';
import type { Complex } from '../linearization/spectrum.ts';
import type { DareSolution } from './dareSolution.ts';

/** The equation of `dare.ts` in twice the precision: x_{k+1} = A x + B u with the cost x^T Q x + 2 x^T N u + u^T R u. */
export interface PreciseProblem {
  A: DoubleDouble;
  B: DoubleDouble;
  Q: DoubleDouble;
  R: DoubleDouble;
  N: DoubleDouble;
}

/**
 * Every mode on the unit circle is seen by the cost: the caller has looked.
 *
 * @param problem n states, k inputs
 * @returns null where doubling does not converge to a stabilizing solution
 */
export function solveDareTwice({ A, B, Q, R, N }: PreciseProblem): DareSolution | null {
  const n = A.rows;
  const weighted = R.solve(N.transpose());
  const force = R.solve(B.transpose());
  if (!weighted || !force) return null;
  const plain = A.plus(B.times(weighted), -1);
  const state = Q.plus(N.times(weighted), -1).symmetric();
  const Gk = B.times(force).symmetric();
  let best: DareSolution | null = null;
  for (const share of ON_ALL) {
    const Hk = state.plus(DoubleDouble.identity(n, share * (state.norm() || 1)));
    const found = doubledTwice({ Ak: plain, Gk, Hk });
    const solution = found && judged({ A, B, Q, R, N }, found.X);
    if (!solution || (best && !(solution.residual < best.residual))) continue;
    best = { ...solution, doublings: found.steps };
    if (best.residual < GOOD) break;
  }
  return best;
}

function judged({ A, B, Q, R, N }: PreciseProblem, X: DoubleDouble): Omit<DareSolution, 'doublings'> | null {
  const XA = X.times(A);
  const right = B.transpose().times(XA).plus(N.transpose());
  const gain = R.plus(B.transpose().times(X).times(B)).solve(right);
  if (!gain) return null;
  const moved = A.transpose().times(XA);
  const saved = right.transpose().times(gain);
  const rest = moved.plus(Q).plus(saved, -1).plus(X, -1);
  const residual = rest.norm() / (moved.norm() + Q.norm() + saved.norm() + X.norm() || 1);
  // lambda - 1, which tells the slowest from the circle.
  const beside = eigenvaluesOfBothEnds(A.plus(B.times(gain), -1).plus(DoubleDouble.identity(A.rows), -1));
  if (!beside || beside.some(([re, im]) => !(2 * re + re * re + im * im < 0))) return null;
  return { X: once(X), gain: once(gain), residual, closedLoop: beside.map(([re, im]): Complex => [1 + re, im]) };
}
