import type { Matrix } from 'ml-matrix';
import { squaresOf, type SquareAlgebra } from '../../linalg/square.ts';
import { fromRowMajor, toRowMajor } from '../linearization/matrices.ts';
import { doubled } from './doubling.ts';

/**
 * The least solution of `A^T X + X A - X G X + H = 0` by a Cayley transform and doubling (E. K.-W. Chu, H.-Y. Fan, W.-W. Lin,
 * Linear Algebra and its Applications 396 (2005), 55-80, sections 2 and 3).
 */

const MOST_DOUBLINGS = 60;
/** Change of X per doubling, relative, at which quadratic convergence has arrived. */
const CONVERGED = 1e-15;

/**
 * Paper symbols: A_k, G_k, H_k; H_k tends to the solution.
 *
 * @param A n x n
 * @param G n x n, symmetric
 * @param H n x n, symmetric
 * @returns null where it does not converge
 */
export function leastSolution(A: Matrix, G: Matrix, H: Matrix): { Y: Matrix; steps: number } | null {
  const n = A.rows;
  const algebra = squaresOf(n);
  const first = bestCayley(algebra, toRowMajor(A), toRowMajor(G), toRowMajor(H));
  if (!first) return null;
  const found = doubled(algebra, n, first, { mostSteps: MOST_DOUBLINGS, converged: CONVERGED });
  return found && { Y: fromRowMajor(found.X, n, n), steps: found.steps };
}

/** Shares tried for gamma: of |A|, and of the rate that G and H make by themselves, which a plant of integrators has alone. */
const GAMMAS = Array.from({ length: 7 }, (_, i) => 4 ** (i - 5));
const SLOW = 1e-6;

interface Cayley {
  gamma: number;
  /** Of A - gamma I, and of W, the paper's other matrix to invert. */
  inverse: Float64Array;
  inverseW: Float64Array;
  /** The larger condition number of the two. */
  condition: number;
}

/** The Cayley transform whose matrices to invert are best conditioned (the paper minimizes the same by a line search). */
function bestCayley(
  algebra: SquareAlgebra,
  A: Float64Array,
  G: Float64Array,
  H: Float64Array,
): { Ak: Float64Array; Gk: Float64Array; Hk: Float64Array } | null {
  const { times, plus, scaled, symmetric, transposed, norm: size } = algebra;
  const sizes = [size(A), Math.sqrt(size(G) * size(H))];
  let best: Cayley | null = null;
  for (const gamma of sizes.flatMap((one) => GAMMAS.map((share) => share * one))) {
    // Far below every rate the transform is the identity to rounding, and perfectly conditioned.
    const tried = gamma > SLOW * Math.max(...sizes) ? cayley(algebra, A, G, H, gamma) : null;
    if (tried && tried.condition < (best?.condition ?? Infinity)) best = tried;
  }
  if (!best) return null;
  const { gamma, inverse, inverseW } = best;
  const twice = 2 * gamma;
  return {
    Ak: plus(algebra.identity(), scaled(transposed(inverseW), twice)),
    Gk: symmetric(scaled(times(times(inverse, G), inverseW), twice)),
    Hk: symmetric(scaled(times(times(inverseW, H), inverse), twice)),
  };
}

function cayley(
  { identity, times, plus, scaled, transposed, solve, norm: size }: SquareAlgebra,
  A: Float64Array,
  G: Float64Array,
  H: Float64Array,
  gamma: number,
): Cayley | null {
  const I = identity();
  const shifted = plus(A, scaled(I, -gamma));
  const inverse = solve(shifted, I);
  if (!inverse) return null;
  const W = plus(transposed(shifted), times(times(H, inverse), G));
  const inverseW = solve(W, I);
  if (!inverseW) return null;
  return {
    gamma,
    inverse,
    inverseW,
    condition: Math.max(size(shifted) * size(inverse), size(W) * size(inverseW)),
  };
}
