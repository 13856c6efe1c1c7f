import type { Matrix } from 'ml-matrix';
import { inverse, QrDecomposition } from 'ml-matrix';
import { norm } from './matrices.ts';

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
