import { Matrix } from 'ml-matrix';
import { balanced, inUnit, type BalancedPlant } from './balance.ts';
import { columnSpace, norm } from './matrices.ts';
import { reachByModes } from './modalReach.ts';
import { distance, eigenvalues, modesOf, modulus, ON_AXIS, type Complex, type Mode } from './spectrum.ts';
import { reachableSubspace, type Reachability } from './staircase.ts';
import { sylvesterLeastSquares, sylvesterWith } from '../design/sylvester.ts';

/** Corrections of a reachable subspace; each squares what is missing. */
const MOST_CORRECTIONS = 3;

/**
 * A reachable subspace of the same dimension, but invariant and with the inputs in it to rounding: over weak stages the
 * staircase's last directions carry rounding many times over. Newton's method for invariant subspaces (G. W. Stewart,
 * "Error and perturbation bounds for subspaces associated with certain eigenvalue problems", SIAM Review 15 (1973),
 * 727-764): V + Vp P with (Vp^T A Vp) P - P (V^T A V) = -Vp^T A V, here with P (V^T B) = -Vp^T B besides.
 */
function refined(reach: Reachability, { A, B }: Pick<BalancedPlant, 'A' | 'B'>): Reachability {
  let { reachable: V, complement: Vp } = reach;
  if (V.columns === 0 || Vp.columns === 0) return reach;
  const missing = (): number => norm(Vp.transpose().mmul(A).mmul(V)) / (norm(A) || 1);
  let least = missing();
  for (let k = 0; k < MOST_CORRECTIONS && least > FINE; k++) {
    const [Vt, Vpt] = [V.transpose(), Vp.transpose()];
    const rest = Vpt.mmul(A).mmul(V).mul(-1);
    const P = sylvesterWith(Vpt.mmul(A).mmul(Vp), Vt.mmul(A).mmul(V), rest, Vt.mmul(B), Vpt.mmul(B).mul(-1));
    const before = { V, Vp };
    ({ basis: V, complement: Vp } = columnSpace(Matrix.add(V, Vp.mmul(P)), () => before.V.columns));
    const now = missing();
    if (!(now < least)) {
      ({ V, Vp } = before);
      break;
    }
    least = now;
  }
  return { ...reach, reachable: V, complement: Vp };
}

/** What a refined subspace may leave out, as a share of |A|. */
const FINE = 1e-15;

/** A in blocks of reachable and other directions, and a complement that moves by itself. */
export interface ReachableSplit extends Reachability {
  /** V^T A V, V^T A Vp, Vp^T A Vp and V^T B. */
  A: Matrix;
  coupling: Matrix;
  unreachableA: Matrix;
  B: Matrix;
  /** S of least norm with A S - S unreachableA = -coupling: Vp + V S spans the complement. r x (d - r). */
  S: Matrix;
  /** W = V^T - S Vp^T: W V = I, and W leaves out what no input reaches. r x d. */
  W: Matrix;
  /** Largest entry of A S - S unreachableA + coupling, as a share of A's norm; above rounding no invariant complement exists. */
  complementResidual: number;
  /** Where ranks were decided, with the reachable subspace there. */
  balance: BalancedPlant & { reachable: Matrix };
  /** Norm of the whole A: the scale of rounding in all its blocks. */
  scale: number;
}

/**
 * @param A d x d
 * @param B d x k
 * @param sizes of B's columns, as in `reachableSubspace`
 * @param basis of the tangent space that A and B are in, or the plant in balanced coordinates: with either, ranks are
 * decided in those
 * @param weakest as in `reachableSubspace`
 */
export function splitByReachability(
  A: Matrix,
  B: Matrix,
  sizes?: readonly number[],
  basis?: Matrix | BalancedPlant,
  weakest = 0,
): ReachableSplit {
  const I = Matrix.eye(A.rows);
  const plant = !basis ? { A, B, basis: I, back: I, unit: 1 } : basis instanceof Matrix ? balanced(basis, A, B) : basis;
  const sized = sizes?.map((size) => size / plant.unit);
  const first = splitAt(A, B, plant, reachableSubspace(plant.A, plant.B, sized, 1, weakest));
  const split = isInvariant(first) ? first : (smallestInvariant(A, B, plant, sized, weakest) ?? first);
  if (!leavesGrowing(split) && split.strength > DECIDED) return split;
  // There in the middle of the plant's rates, where fast and slow modes are as far from 1.
  const middle = basis instanceof Matrix ? inUnit(basis, A, B, middleRate(A)) : plant;
  const byModes = reachByModes(
    middle,
    sizes?.map((size) => size / middle.unit),
  );
  if (!byModes) return split;
  const modal = splitAt(A, B, middle, byModes);
  // A mode that grows with its rounding alone is none that no input reaches.
  if (leavesGrowing(modal) !== leavesGrowing(split)) return leavesGrowing(modal) ? split : modal;
  // Of two invariant subspaces with the inputs in them the smaller: what is reached is the smallest one.
  const smaller = split.reachable.columns < modal.reachable.columns;
  return isInvariant(split) && (smaller || !isInvariant(modal)) ? split : modal;
}

/**
 * Whether a subspace that was refined is as invariant as rounding lets it be. With a direction too few it is not: what A makes
 * of it lies outside by 1e-9 or more, where gaps between singular values may say little (weak stages beside stiff ankles).
 */
const isInvariant = ({ balance: { A, reachable: V } }: ReachableSplit): boolean => {
  const { complement: Vp } = columnSpace(V, () => V.columns);
  return V.columns === 0 || Vp.columns === 0 || norm(Vp.transpose().mmul(A).mmul(V)) <= INVARIANT * norm(A);
};
const INVARIANT = 1e-13;

/** Shares from which a singular value counts, tried one after the other where gaps led to no invariant subspace. */
const SHARES = Array.from({ length: 23 }, (_, i) => 10 ** (-2 - i / 2));

/** The smallest invariant subspace that holds the inputs, over all shares; null where there is none but the whole space. */
function smallestInvariant(
  A: Matrix,
  B: Matrix,
  plant: BalancedPlant,
  sizes: readonly number[] | undefined,
  weakest: number,
): ReachableSplit | null {
  let tried = -1;
  for (const share of SHARES) {
    if (share < weakest) break;
    const found = reachableSubspace(plant.A, plant.B, sizes, 1, share, true);
    if (found.reachable.columns === tried) continue;
    tried = found.reachable.columns;
    if (found.complement.columns === 0) break;
    const split = splitAt(A, B, plant, found);
    if (isInvariant(split)) return split;
  }
  return null;
}

/** Weak stages whose product is below this are decided by rounding, as far as the staircase can tell. */
const DECIDED = 1e-16;

/** Geometric mean of the moduli of A's eigenvalues other than zero, 1/s. */
function middleRate(A: Matrix): number {
  const rates = eigenvalues(A)
    .map(modulus)
    .filter((rate) => rate > 0);
  return Math.exp(rates.reduce((sum, rate) => sum + Math.log(rate), 0) / rates.length);
}

function leavesGrowing({ reachable, unreachableA, scale }: ReachableSplit): boolean {
  return reachable.columns > 0 && eigenvalues(unreachableA, scale).some(([re]) => re > ON_AXIS * scale);
}

/** The blocks for a reachable subspace that was found in the plant's balanced coordinates. */
function splitAt(A: Matrix, B: Matrix, plant: BalancedPlant, found: Reachability): ReachableSplit {
  const inBalance = refined(found, plant);
  // What the inputs reach is the same subspace; its basis is orthonormal in tangent coordinates.
  const { basis: V, complement: Vp } = columnSpace(
    plant.back.mmul(inBalance.reachable),
    () => inBalance.reachable.columns,
  );
  const reach = { ...inBalance, reachable: V, complement: Vp, balance: { ...plant, reachable: inBalance.reachable } };
  const [Vt, Vpt] = [V.transpose(), Vp.transpose()];
  const inner = Vt.mmul(A).mmul(V);
  const coupling = Vt.mmul(A).mmul(Vp);
  const outer = Vpt.mmul(A).mmul(Vp);
  const S = sylvesterLeastSquares(inner, outer, Matrix.mul(coupling, -1));
  const rest = Matrix.add(Matrix.sub(inner.mmul(S), S.mmul(outer)), coupling);
  return {
    ...reach,
    A: inner,
    coupling,
    unreachableA: outer,
    B: Vt.mmul(B),
    S,
    W: Matrix.sub(Vt, S.mmul(Vpt)),
    complementResidual: rest.isEmpty() ? 0 : rest.abs().max() / (norm(A) || 1),
    scale: norm(A),
  };
}

/**
 * Modes that no input reaches, by what moves in them. `toStates`: states x d.
 *
 * @param split of the plant
 * @param toStates states x d
 * @param states names
 */
export function unreachableModes(split: ReachableSplit, toStates: Matrix, states: readonly string[]): Mode[] {
  const shapes = Matrix.add(split.complement, split.reachable.mmul(split.S));
  return modesOf(split.unreachableA, toStates.mmul(shapes), states, split.scale);
}

/** What one input reaches by itself. */
export interface InputReach {
  input: string;
  dimension: number;
  /** Eigenvalues of the modes that it reaches, and that it does not. */
  reached: Complex[];
  missed: Complex[];
  margin: { kept: number; dropped: number };
}

/**
 * Which inputs reach which modes, each input alone.
 *
 * @param A d x d
 * @param B d x k
 * @param inputs names of B's columns
 * @param sizes of B's columns, as in `reachableSubspace`
 */
export function reachByInput(A: Matrix, B: Matrix, inputs: readonly string[], sizes?: readonly number[]): InputReach[] {
  const all = eigenvalues(A);
  return inputs.map((input, k) => {
    const { reachable: V, complement: Vp, margin } = reachableSubspace(A, B.getColumnVector(k), sizes && [sizes[k]!]);
    const missed = Vp.columns > 0 ? eigenvalues(Vp.transpose().mmul(A).mmul(Vp), norm(A)) : [];
    return { input, dimension: V.columns, reached: without(all, missed), missed, margin };
  });
}

/** A list of eigenvalues without the nearest to each of others. */
function without(all: readonly Complex[], others: readonly Complex[]): Complex[] {
  const left = [...all];
  for (const value of others) {
    let best = 0;
    left.forEach((x, i) => (best = distance(x, value) < distance(left[best]!, value) ? i : best));
    left.splice(best, 1);
  }
  return left;
}

/**
 * Orthonormal basis of what never shows in `C x` of `x' = A x` (the dual of reachability), and of its orthogonal
 * complement. `sizes` of the rows of C as those of B's columns.
 *
 * @param A d x d
 * @param C p x d
 * @param sizes of C's rows
 * @param before as for `reachableSubspace`
 */
export function unobservableSubspace(
  A: Matrix,
  C: Matrix,
  sizes?: readonly number[],
  before = 1,
): { unseen: Matrix; seen: Matrix; margin: Reachability['margin'] } {
  const { reachable, complement, margin } = reachableSubspace(A.transpose(), C.transpose(), sizes, before);
  return { unseen: complement, seen: reachable, margin };
}
