import { EigenvalueDecomposition, inverse, Matrix } from 'ml-matrix';
import { sylvesterLeastSquares } from '../design/sylvester.ts';
import { besides, columnSpace, LEAST, norm } from './matrices.ts';
import type { BalancedPlant } from './balance.ts';
import { reachableSubspace, type Reachability } from './staircase.ts';
import { distance, eigenvalues, modulus, splitZeros, type Complex } from './spectrum.ts';

/**
 * The reachable subspace mode by mode: a mode is reached where its left eigenvector meets an input (M. L. J. Hautus,
 * "Controllability and observability conditions of linear autonomous systems", Proc. Kon. Ned. Akad. Wet. A 72 (1969),
 * 443-448); within the generalized null space, where eigenvectors say little, by the staircase.
 *
 * It answers where the staircase through the whole plant can't: stiff dampers make fast modes (ankles of 20 N·m·s/rad
 * at 3500 1/s), and beside those each of many weak stages of a slow mode (3 1/s) is as small as what rounding becomes over
 * them. The left eigenvector of a slow mode carries rounding only as far as other modes are near.
 */

const EPSILON = 2 ** -53;
/** Times its rounding an input's part in a mode is there; below the second it is not; between, nothing is decided. */
const REACHED = 1e3;
const MISSED = 10;
/** Left eigenvectors with more rounding than this decide nothing (modes of one eigenvalue, or all but one). */
const ROUGH = 1e-5;

/**
 * @param plant A d x d, B d x k
 * @param columnSizes of B's columns, as for `reachableSubspace`
 * @returns as the staircase does; null where modes are too near each other, or an input's part in one is neither
 * rounding nor clear of it
 */
export function reachByModes(
  { A, B }: Pick<BalancedPlant, 'A' | 'B'>,
  columnSizes?: readonly number[],
): Reachability | null {
  const sizes = columnSizes ?? Array.from({ length: B.columns }, (_, k) => norm(B.getColumnVector(k)));
  const { zero: Z, rest, restA } = splitZeros(A);
  if (restA.rows === 0) return null;
  const Zt = Z.transpose();
  const nilpotent = Zt.mmul(A).mmul(Z);
  // A (rest + Z T) = (rest + Z T) restA: what is not neutral, by itself.
  const T = sylvesterLeastSquares(nilpotent, restA, Zt.mmul(A).mmul(rest).mul(-1));
  const restB = rest.transpose().mmul(B);
  const moving = reachedModes(restA, restB, sizes, norm(A));
  if (!moving) return null;
  const neutralB = Zt.mmul(B).sub(T.mmul(restB));
  // What rounding of A becomes in T, and so in what the inputs do to neutral modes.
  const slowest = Math.min(...eigenvalues(restA, norm(A)).map(modulus));
  const rounding = (10 * EPSILON * norm(A) * (1 + norm(T))) / slowest;
  const neutral = reachableSubspace(nilpotent, neutralB, sizes, Math.min(1, LEAST / rounding), rounding);
  const all = besides(Matrix.add(rest, Z.mmul(T)).mmul(moving.reached), Z.mmul(neutral.reachable));
  const { basis: reachable, complement } = columnSpace(normalized(all), () => all.columns);
  return {
    reachable,
    complement,
    stages: [moving.reached.columns, ...neutral.stages],
    margin: {
      kept: Math.min(moving.margin.kept, neutral.margin.kept),
      dropped: Math.max(moving.margin.dropped, neutral.margin.dropped),
    },
    strength: Math.min(moving.strength, neutral.strength),
  };
}

function normalized(columns: Matrix): Matrix {
  const all = columns.clone();
  for (let c = 0; c < all.columns; c++) all.mulColumn(c, 1 / norm(all.getColumnVector(c)));
  return all;
}

/** Basis of what the reached modes of R span, in R's coordinates; null where that is not clear. */
function reachedModes(
  R: Matrix,
  B: Matrix,
  sizes: readonly number[],
  scale: number,
): { reached: Matrix; margin: Reachability['margin']; strength: number } | null {
  const { realEigenvalues, imaginaryEigenvalues, eigenvectorMatrix: E } = new EigenvalueDecomposition(R);
  const values = realEigenvalues.map((re, i): Complex => [re, imaginaryEigenvalues[i]!]);
  const left = inverse(E);
  // A pair has two columns of E and two rows of its inverse, of both of which its conjugate's are made.
  const pairOf = (i: number): number[] => {
    const im = values[i]![1];
    return im === 0 ? [i] : im > 0 ? [i, i + 1] : [i - 1, i];
  };
  const size = (of: number[], line: (i: number) => Matrix): number => Math.hypot(...of.map((i) => norm(line(i))));
  const column = (i: number): Matrix => E.getColumnVector(i);
  const row = (i: number): Matrix => left.getRowVector(i);
  const condition = values.map((_, i) => size(pairOf(i), column) * size(pairOf(i), row));
  const missed: number[] = [];
  const margin = { kept: Infinity, dropped: 0 };
  for (let i = 0; i < values.length; i++) {
    if (values[i]![1] < 0) continue;
    const pair = pairOf(i);
    const near = values.map((other, j) => (pair.includes(j) ? 0 : condition[j]! / distance(values[i]!, other)));
    // Its own rounding, and what neutral modes, which are as far as it is from 0, bring into it.
    const rounding = EPSILON * (10 + scale * near.reduce((sum, x) => sum + x, condition[i]! / modulus(values[i]!)));
    if (!(rounding < ROUGH)) return null;
    const share = Math.max(
      ...sizes.map((s, k) => (s > 0 ? size(pair, (p) => row(p).mmul(B.getColumnVector(k))) / s : 0)),
    );
    const relative = share / size(pair, row);
    if (relative > REACHED * rounding) margin.kept = Math.min(margin.kept, relative);
    else if (relative <= MISSED * rounding) {
      margin.dropped = Math.max(margin.dropped, relative);
      missed.push(...pair);
    } else return null;
  }
  const out = missed.map((i) => row(i)).reduce((rows, r) => besides(rows, r.transpose()), new Matrix(R.rows, 0));
  const reached = missed.length > 0 ? columnSpace(out, () => missed.length).complement : Matrix.eye(R.rows);
  return { reached, margin, strength: Math.min(1, margin.kept) };
}
