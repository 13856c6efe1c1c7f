import { Matrix } from 'ml-matrix';
import { ControlError, solveLinear } from '../linearization/matrices.ts';

/**
 * The exponential of a matrix by scaling and squaring with the diagonal Padé approximant of degree 13 (N. J. Higham,
 * "The scaling and squaring method for the matrix exponential revisited", SIAM J. Matrix Anal. Appl. 26 (2005),
 * 1179-1193, table 2.3 and algorithm 2.3 without its lower degrees, which only save time).
 */
const PADE = [
  64764752532480000, 32382376266240000, 7771770303897600, 1187353796428800, 129060195264000, 10559470521600,
  670442572800, 33522128640, 1323241920, 40840800, 960960, 16380, 182, 1,
];
/** Norm up to which degree 13 is exact to rounding. */
const THETA = 5.371920351148152;

/** @param A n x n @returns e^A */
export function exponential(A: Matrix): Matrix {
  const n = A.rows;
  const I = Matrix.eye(n);
  if (n === 0) return I;
  // The largest column sum.
  const size = Math.max(...Matrix.abs(A).sum('column'));
  if (!Number.isFinite(size)) throw new ControlError('the exponential of a matrix with entries that are not finite');
  const squarings = Math.max(0, Math.ceil(Math.log2(size / THETA)));
  const a = Matrix.mul(A, 2 ** -squarings);
  const [a2, b] = [a.mmul(a), PADE];
  const a4 = a2.mmul(a2);
  const a6 = a2.mmul(a4);
  const sum = (...terms: [Matrix, number][]): Matrix => {
    const total = Matrix.zeros(n, n);
    for (const [M, factor] of terms) total.add(Matrix.mul(M, factor));
    return total;
  };
  const odd = a.mmul(
    a6.mmul(sum([a6, b[13]!], [a4, b[11]!], [a2, b[9]!])).add(sum([a6, b[7]!], [a4, b[5]!], [a2, b[3]!], [I, b[1]!])),
  );
  const even = a6
    .mmul(sum([a6, b[12]!], [a4, b[10]!], [a2, b[8]!]))
    .add(sum([a6, b[6]!], [a4, b[4]!], [a2, b[2]!], [I, b[0]!]));
  let E = solveLinear(Matrix.sub(even, odd), Matrix.add(even, odd));
  if (!E) throw new ControlError('the exponential of this matrix can not be computed');
  for (let k = 0; k < squarings; k++) E = E.mmul(E);
  return E;
}
