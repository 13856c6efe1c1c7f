import { inverse, Matrix, QrDecomposition } from 'ml-matrix';
import { besides, columnSpace, norm, rankByGap } from './matrices.ts';
import { reachByModes } from './modalReach.ts';
import { distance, eigenvalues, modesOf, modulus, ON_AXIS, type Complex, type Mode } from './spectrum.ts';
import { sylvesterLeastSquares, sylvesterWith } from '../design/sylvester.ts';

/** Where inputs can bring a linear system, and where not. */
export interface Reachability {
  /** Orthonormal bases of the reachable subspace V (d x r) and of its orthogonal complement Vp (d x (d - r)). */
  reachable: Matrix;
  complement: Matrix;
  /** New directions found at each stage: by the inputs themselves, by A once, twice … */
  stages: number[];
  /**
   * What decided: the smallest singular value that counted as reach and the largest that did not, both as shares (of
   * an input's own column at the first stage, of A's norm at the later ones). Far apart is safe.
   */
  margin: { kept: number; dropped: number };
  /** Product over the stages of the smallest share that counted: the rounding of the last directions is that of A over it. */
  strength: number;
}

/**
 * The reachable subspace by orthonormal stages, range B, then what A adds to it, and so on: the staircase algorithm
 * (P. Van Dooren, "The generalized eigenstructure problem in linear system theory", IEEE Trans. Automatic Control 26
 * (1981), 111-129; C. C. Paige, "Properties of numerical algorithms related to computing controllability", same volume,
 * 130-138) in the form of a block Arnoldi process. Only orthogonal bases are multiplied, never powers of A; a rank is
 * decided at each stage by singular values. The size of an input's unit does not matter: columns of B are normalized.
 *
 * @param A d x d
 * @param B d x k
 * @param sizes what each column of B would be if nothing cancelled in it (its own size if left out): a column that is
 * rounding beside that does nothing
 * @param before strength of what A itself was cut out by, 1 for a matrix as it was computed
 */
export function reachableSubspace(A: Matrix, B: Matrix, sizes?: readonly number[], before = 1): Reachability {
  const whole = norm(A);
  const stages: number[] = [];
  const margin = { kept: Infinity, dropped: 0 };
  let V = new Matrix(A.rows, 0);
  let complement = Matrix.eye(A.rows);
  let block = normalizedColumns(B, sizes);
  let scale = 1;
  let strength = before;
  while (complement.columns > 0 && block.columns > 0) {
    // In coordinates of the complement the new directions are orthogonal to the old ones to rounding.
    const size = scale;
    const found = columnSpace(complement.transpose().mmul(block), (values) => rankByGap(values, size, strength));
    if (found.basis.columns > 0) {
      margin.kept = Math.min(margin.kept, found.kept / scale);
      strength *= Math.min(1, found.kept / scale);
    }
    margin.dropped = Math.max(margin.dropped, found.dropped / (scale || 1));
    if (found.basis.columns === 0) break;
    const fresh = complement.mmul(found.basis);
    stages.push(fresh.columns);
    V = besides(V, fresh);
    complement = complement.mmul(found.complement);
    block = A.mmul(fresh);
    scale = whole;
  }
  return { reachable: V, complement, stages, margin, strength };
}

function normalizedColumns(B: Matrix, sizes?: readonly number[]): Matrix {
  let all = new Matrix(B.rows, 0);
  for (let c = 0; c < B.columns; c++) {
    const column = B.getColumnVector(c);
    const size = sizes?.[c] ?? norm(column);
    if (size > 0) all = besides(all, column.div(size));
  }
  return all;
}

/**
 * The same plant in coordinates in which its rates are of order 1: velocities in a unit `s` of the plant's own, such
 * that |dv'/dq| and |dq'/dv| are alike. Ranks are decided there: a weak coupling of A (steer with heading at walking
 * pace) is then small beside 1, not beside stiffness of 1e3, and the rounding that it is told from is that much less.
 */
export interface BalancedPlant {
  A: Matrix;
  B: Matrix;
  /** Orthonormal basis of what the constraints allow, in those units: states x d. */
  basis: Matrix;
  /** Back: tangent coordinates are `back` times balanced ones, d x d. */
  back: Matrix;
  /** The unit of velocities, 1/s. */
  unit: number;
}

/** @param basis N of the linearization, orthonormal, states x d @param A N^T A N @param B N^T B */
export function balanced(basis: Matrix, A: Matrix, B: Matrix): BalancedPlant {
  const n = basis.rows / 2;
  const whole = basis.mmul(A).mmul(basis.transpose());
  const block = (r: number, c: number): number =>
    Number.isInteger(n) && n > 0 ? norm(whole.subMatrix(r * n, r * n + n - 1, c * n, c * n + n - 1)) : 0;
  // A plant of integrators has no rate of its own.
  const unit = Math.max(Math.sqrt(block(1, 0) / block(0, 1)), block(1, 1));
  return inUnit(basis, A, B, unit > 1e-6 && Number.isFinite(unit) ? unit : 1);
}

/**
 * The plant with its velocities in a unit of that many 1/s (the nearest power of two, so that nothing is rounded).
 *
 * @param basis orthonormal, states x d
 * @param A d x d
 * @param B d x k
 * @param unit 1/s
 */
export function inUnit(basis: Matrix, A: Matrix, B: Matrix, unit: number): BalancedPlant {
  const n = basis.rows / 2;
  const s = 2 ** Math.round(Math.log2(unit));
  const scaled = basis.clone();
  for (let i = n; i < basis.rows; i++) scaled.mulRow(i, 1 / s);
  const { orthogonalMatrix: Q, upperTriangularMatrix: R } = new QrDecomposition(scaled);
  const back = inverse(R);
  return { A: R.mmul(A).mmul(back), B: R.mmul(B), basis: Q, back, unit: s };
}

/**
 * The same plant as its sensors see it, x' = A^T x + C^T u: the dual in the same units, so that what is weak beside what is
 * decided there too. Its basis serves no further.
 * @param C N^T C^T, d x p: what the sensors read of tangent coordinates
 */
export function dualOf({ A, back, basis }: BalancedPlant, C: Matrix): BalancedPlant {
  return { A: A.transpose(), B: back.transpose().mmul(C), basis, back: inverse(back).transpose(), unit: 1 };
}

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
 */
export function splitByReachability(
  A: Matrix,
  B: Matrix,
  sizes?: readonly number[],
  basis?: Matrix | BalancedPlant,
): ReachableSplit {
  const I = Matrix.eye(A.rows);
  const plant = !basis ? { A, B, basis: I, back: I, unit: 1 } : basis instanceof Matrix ? balanced(basis, A, B) : basis;
  const sized = sizes?.map((size) => size / plant.unit);
  const split = splitAt(A, B, plant, reachableSubspace(plant.A, plant.B, sized));
  if (!leavesGrowing(split)) return split;
  // There in the middle of the plant's rates, where fast and slow modes are as far from 1.
  const middle = basis instanceof Matrix ? inUnit(basis, A, B, middleRate(A)) : plant;
  const byModes = reachByModes(
    middle,
    sizes?.map((size) => size / middle.unit),
  );
  return byModes ? splitAt(A, B, middle, byModes) : split;
}

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
