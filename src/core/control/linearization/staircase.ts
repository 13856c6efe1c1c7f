import { Matrix } from 'ml-matrix';
import { besides, columnSpace, norm, rankByGap } from './matrices.ts';

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
 * @param weakest share below which a singular value does not count whatever the gaps say; 0: each that is no rounding counts
 * @param all whether each above that share counts, whatever the gaps say
 */
export function reachableSubspace(
  A: Matrix,
  B: Matrix,
  sizes?: readonly number[],
  before = 1,
  weakest = 0,
  all = false,
): Reachability {
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
    const found = columnSpace(complement.transpose().mmul(block), (values) => {
      const strong = values.filter((value) => value > weakest * size).length;
      return all ? strong : Math.min(rankByGap(values, size, strength), strong);
    });
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
