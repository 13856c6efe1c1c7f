import { Matrix } from 'ml-matrix';
import { columnSpace, ControlError, norm, solveLinear } from './matrices.ts';
import { ON_AXIS, plainEigenvalues, splitZeros } from './spectrum.ts';

/**
 * Orthonormal basis of the invariant subspace of A (d x d) that belongs to eigenvalues on the imaginary axis.
 *
 * Zeros alone are split off by null spaces. With undamped oscillations among decaying or growing modes the spectral
 * projector is taken from two matrix signs, (sign(A + delta) - sign(A - delta)) / 2 (N. J. Higham, Functions of
 * Matrices, SIAM 2008, chapter 5).
 *
 * @param A d x d
 * @param scale norm of the matrix that A was cut out of
 */
export function axisSubspace(A: Matrix, scale: number): Matrix {
  const d = A.rows;
  const { zero, restA } = splitZeros(A, scale);
  const others = plainEigenvalues(restA).map(([re]) => Math.abs(re));
  const off = others.filter((re) => re > ON_AXIS * scale);
  const count = d - off.length;
  if (off.length === 0) return Matrix.eye(d);
  if (count === zero.columns) return zero;
  // Between what counts as on the axis and the nearest mode off it, in the middle of their orders of magnitude.
  const delta = Math.sqrt(ON_AXIS * scale * Math.min(...off));
  const shift = Matrix.eye(d).mul(delta);
  const projector = Matrix.sub(matrixSign(Matrix.add(A, shift)), matrixSign(Matrix.sub(A, shift))).mul(0.5);
  const { basis } = columnSpace(projector, 0.5);
  if (basis.columns !== count) throw new ControlError('modes on and near the imaginary axis can not be told apart');
  return basis;
}

const MOST_ITERATIONS = 100;

/** Sign of a matrix without eigenvalues on the imaginary axis: Newton's iteration, scaled by norms (Higham, section 5.5). */
function matrixSign(A: Matrix): Matrix {
  const I = Matrix.eye(A.rows);
  let X = A;
  for (let k = 0; k < MOST_ITERATIONS; k++) {
    const inverse = solveLinear(X, I);
    if (!inverse) break;
    const mu = Math.sqrt(norm(inverse) / norm(X));
    const next = Matrix.add(Matrix.mul(X, mu / 2), inverse.mul(1 / (2 * mu)));
    const change = norm(Matrix.sub(next, X));
    X = next;
    if (change <= 1e-14 * A.rows * norm(X)) return X;
  }
  throw new ControlError('modes on and near the imaginary axis can not be told apart');
}
