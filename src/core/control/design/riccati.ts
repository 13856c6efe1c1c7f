import { EigenvalueDecomposition, Matrix } from 'ml-matrix';
import { leastSolution } from './cayley.ts';
import { ControlError, norm, symmetricPart } from '../linearization/matrices.ts';
import { complexText, ON_AXIS, plainEigenvalues, type Complex } from '../linearization/spectrum.ts';
import { solveCareTwice } from './careTwice.ts';
import { axisSubspace } from '../linearization/axisSubspace.ts';
import { unobservableSubspace } from '../linearization/reachability.ts';
import { lyapunov } from './sylvester.ts';

/**
 * The continuous-time algebraic Riccati equation `A^T X + X A - X G X + Q = 0`, G = B R^-1 B^T, for its stabilizing
 * solution: all eigenvalues of A - G X have negative real parts.
 *
 * Structure-preserving doubling (E. K.-W. Chu, H.-Y. Fan, W.-W. Lin, "A structure-preserving doubling algorithm for
 * continuous-time algebraic Riccati equations", Linear Algebra and its Applications 396 (2005), 55-80): a Cayley
 * transform with gamma > 0, then steps that square the transformed Hamiltonian, so that convergence is quadratic.
 * Afterwards Newton's method (D. L. Kleinman, "On an iterative technique for Riccati equation computations", IEEE
 * Trans. Automatic Control 13 (1968), 114-115), in the form that corrects by the residual, down to rounding. Both are done
 * twice: the first solution gives the coordinates in which the second is well scaled.
 *
 * Where doubles do not hold the weights and rates beside each other, the same is done in twice the precision
 * (`careTwice.ts`). Not guaranteed: small entries of X beside very large ones to full relative precision; the residual
 * says how good it is.
 */
export interface RiccatiSolution {
  X: Matrix;
  /** R^-1 B^T X, k x d. */
  gain: Matrix;
  /**
   * |A^T X + X A - K^T R K + Q| / (2 |A^T X| + |K^T R K| + |Q|) in Frobenius norms, K the gain; the larger of what it is
   * in the given coordinates and in those the equation was solved in, where K is R^-1 B^T X without cancellation.
   */
  residual: number;
  closedLoop: Complex[];
  doublings: number;
  corrections: number;
}

const MOST_CORRECTIONS = 20;
/** A residual above this is no solution; the solver's own is near 1e-16. */
const ACCEPTED = 1e-10;

/**
 * @param A n x n
 * @param B n x k
 * @param Q n x n, symmetric, positive semidefinite
 * @param R diagonal of the input weights, all positive
 * @param C with Q = C^T C, where it is known and every mode of A on the axis is seen by it: small weights beside large
 * ones survive in C, not in Q
 * @throws ControlError where there is no stabilizing solution to be had
 */
export function solveCare(A: Matrix, B: Matrix, Q: Matrix, R: readonly number[], C?: Matrix): RiccatiSolution {
  const n = A.rows;
  // In units where every input costs 1: u = R^-1/2 w.
  const unit = Matrix.diag(R.map((r) => 1 / Math.sqrt(r)));
  const F = B.mmul(unit);
  if (n === 0)
    return {
      X: new Matrix(0, 0),
      gain: new Matrix(B.columns, 0),
      residual: 0,
      closedLoop: [],
      doublings: 0,
      corrections: 0,
    };
  // With a mode on the axis that costs nothing there is none; what follows only comes near it, ever more slowly.
  const found = !C && freeOnAxis(A, Q) ? null : (inDoubles(A, F, Q) ?? inTwiceThePrecision(A, F, C ?? rootOf(Q)));
  if (!found) throw new ControlError(unsolvable(plainEigenvalues(A)));
  const { w, ...solution } = found;
  return { ...solution, gain: unit.mmul(w) };
}

/** Whether a mode on the imaginary axis costs nothing. */
function freeOnAxis(A: Matrix, Q: Matrix): boolean {
  const axis = axisSubspace(A, norm(A));
  return unobservableSubspace(axis.transpose().mmul(A).mmul(axis), Q.mmul(axis)).unseen.columns > 0;
}

/** C with C^T C = Q. */
function rootOf(Q: Matrix): Matrix {
  const { realEigenvalues, eigenvectorMatrix } = new EigenvalueDecomposition(Q, { assumeSymmetric: true });
  return Matrix.diag(realEigenvalues.map((x) => Math.sqrt(Math.max(0, x)))).mmul(eigenvectorMatrix.transpose());
}

type Found = Omit<RiccatiSolution, 'gain'> & { w: Matrix };

function inDoubles(A: Matrix, F: Matrix, Q: Matrix): Found | null {
  const start = stabilizing(A, F, Q);
  if (!start) return null;
  const { inverseT, a, f, q } = start;
  const { Y, corrections, converged } = refine(a, f, q, start.Y);
  const scaled = f.transpose().mmul(Y);
  const closedLoop = plainEigenvalues(Matrix.sub(a, f.mmul(scaled)));
  const X = symmetricPart(inverseT.transpose().mmul(Y).mmul(inverseT));
  const w = scaled.mmul(inverseT);
  const residual = Math.max(careResidual(a, f, q, Y), relativeRemainder(A.transpose().mmul(X), w, Q));
  // On the axis to rounding is not stable: there the two halves of the Hamiltonian's spectrum meet.
  const stable = closedLoop.every(([re]) => re < -ON_AXIS * norm(A));
  if (!stable || !converged || !(residual < ACCEPTED)) return null;
  return { X, w, residual, closedLoop, doublings: start.steps, corrections };
}

function inTwiceThePrecision(A: Matrix, F: Matrix, C: Matrix): Found | null {
  const found = solveCareTwice(A, F, C);
  return found && found.residual < ACCEPTED ? { ...found, corrections: 0 } : null;
}

function unsolvable(near: readonly Complex[]): string {
  const worst = [...near].sort((a, b) => b[0] - a[0])[0]!;
  return `the Riccati equation has no stabilizing solution that can be computed: it fails at the mode with eigenvalue ${complexText(worst)}, which the inputs can hardly move or the weights hardly see`;
}

/** Eigenvalues of X below this share of the largest are raised to it: X may be singular, T may not. */
const FLOOR = 1e-14;

/** T with T^T X T = I, and its inverse, from the eigenvectors of X. */
function whitening(X: Matrix): { T: Matrix; inverseT: Matrix } {
  const { realEigenvalues, eigenvectorMatrix: E } = new EigenvalueDecomposition(symmetricPart(X), {
    assumeSymmetric: true,
  });
  const least = FLOOR * Math.max(...realEigenvalues) || 1;
  const roots = realEigenvalues.map((x) => Math.sqrt(Math.max(x, least)));
  return { T: E.mmul(Matrix.diag(roots.map((r) => 1 / r))), inverseT: Matrix.diag(roots).mmul(E.transpose()) };
}

/**
 * |A^T X + X A - X F F^T X + Q| as a share of its terms, F = B R^-1/2.
 *
 * @param A n x n
 * @param F n x k
 * @param Q n x n, symmetric
 * @param X n x n, the solution
 */
export function careResidual(A: Matrix, F: Matrix, Q: Matrix, X: Matrix): number {
  return relativeRemainder(A.transpose().mmul(X), F.transpose().mmul(X), Q);
}

function relativeRemainder(AtX: Matrix, w: Matrix, Q: Matrix): number {
  const size = 2 * norm(AtX) + norm(w) ** 2 + norm(Q);
  return size > 0 ? norm(remainder(AtX, w, Q)) / size : 0;
}

/** With w = F^T X: the product X F F^T X through w loses less to cancellation than through F F^T. */
function remainder(AtX: Matrix, w: Matrix, Q: Matrix): Matrix {
  return Matrix.add(AtX, AtX.transpose()).sub(w.transpose().mmul(w)).add(Q);
}

/** The equation in coordinates x = T z, with a stabilizing Y to start from. */
interface Scaled {
  inverseT: Matrix;
  a: Matrix;
  f: Matrix;
  q: Matrix;
  Y: Matrix;
  steps: number;
}

/**
 * A first solution, and the coordinates where it is the identity: there G and X are of one size in all directions.
 *
 * Doubling finds the least solution; where the cost does not see an unstable mode that is not the stabilizing one, and
 * a solution for a cost that sees everything is the start for Newton's method instead: from any stabilizing start that
 * converges to the stabilizing solution (Kleinman).
 */
function stabilizing(A: Matrix, F: Matrix, Q: Matrix): Scaled | null {
  const G = F.mmul(F.transpose());
  const cost = norm(Q) > 0 ? norm(Q) : norm(A) ** 2 / (norm(G) || 1);
  for (const seen of [Q, Matrix.add(Q, Matrix.eye(A.rows).mul(cost))]) {
    const rough = leastSolution(A, G, seen);
    if (!rough) continue;
    const { T, inverseT } = whitening(rough.Y);
    const [a, f, q] = [inverseT.mmul(A).mmul(T), inverseT.mmul(F), symmetricPart(T.transpose().mmul(Q).mmul(T))];
    const fine = leastSolution(a, f.mmul(f.transpose()), q);
    for (const Y of [fine?.Y, symmetricPart(T.transpose().mmul(rough.Y).mmul(T))]) {
      if (Y && stabilizes(a, f, Y)) return { inverseT, a, f, q, Y, steps: rough.steps + (fine?.steps ?? 0) };
    }
  }
  return null;
}

function stabilizes(A: Matrix, F: Matrix, Y: Matrix): boolean {
  return plainEigenvalues(Matrix.sub(A, F.mmul(F.transpose().mmul(Y)))).every(([re]) => re < 0);
}

/** A last correction above this share of X is no convergence (to a solution on the axis Newton's method halves its distance). */
const SETTLED = 1e-6;

/** Newton's method from a stabilizing start, until rounding stops it. */
function refine(
  A: Matrix,
  F: Matrix,
  Q: Matrix,
  start: Matrix,
): { Y: Matrix; corrections: number; converged: boolean } {
  let best = { Y: start, corrections: 0, converged: false };
  let least = careResidual(A, F, Q, start);
  let Y = start;
  for (let corrections = 1; corrections <= MOST_CORRECTIONS; corrections++) {
    const w = F.transpose().mmul(Y);
    const change = lyapunov(Matrix.sub(A, F.mmul(w)), remainder(A.transpose().mmul(Y), w, Q));
    if (!change) return best;
    Y = symmetricPart(Matrix.add(Y, change));
    const settled = norm(change) <= SETTLED * norm(Y);
    const residual = careResidual(A, F, Q, Y);
    if (settled && best.converged && !(residual < 0.5 * least)) return best;
    if (settled && residual >= least) return { ...best, converged: true };
    if (residual < least || !best.converged) best = { Y, corrections, converged: settled };
    least = residual;
  }
  return best;
}
