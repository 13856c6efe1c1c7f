import { EigenvalueDecomposition, Matrix } from 'ml-matrix';
import { besides, columnSpace, norm } from './matrices.ts';

/** Real and imaginary part, 1/s. */
export type Complex = readonly [number, number];

/**
 * A singular value at or below this share of the matrix's norm is rounding. Exact Jacobians of the board carry errors
 * of 1e-15 of the norm; its weakest true coupling, of steer with heading, is 7e-4 at 1 m/s and still 4e-6 at 1 mm/s.
 */
export const ROUNDING = 1e-11;

/** A real part within this share of the matrix's norm is zero: computed eigenvalues of an undamped oscillation scatter so far. */
export const ON_AXIS = 1e-9;

/** The part of a matrix whose eigenvalues are zero, split off. */
export interface ZeroSplit {
  /** Orthonormal basis of the generalized null space, n x k, invariant; and of its orthogonal complement. */
  zero: Matrix;
  rest: Matrix;
  /** The other eigenvalues: of the matrix on the quotient, (n - k) x (n - k). */
  restA: Matrix;
}

/**
 * Splits off zero eigenvalues by null spaces of A, of A on the quotient, and so on: the staircase idea of
 * V. N. Kublanovskaya, "On a method of solving the complete eigenvalue problem for a degenerate matrix", USSR Comput.
 * Math. and Math. Physics 6 (1966), with singular values for the ranks. A computed multiple zero scatters by the
 * square root of rounding (or worse); its null space does not.
 *
 * @param A d x d
 * @param scale norm of the matrix that A was cut out of: its rounding is what A's entries carry
 */
export function splitZeros(A: Matrix, scale = norm(A)): ZeroSplit {
  const n = A.rows;
  const threshold = ROUNDING * scale;
  let zero = new Matrix(n, 0);
  let rest = Matrix.eye(n);
  let restA = A;
  while (restA.rows > 0) {
    // Null space of restA: what is orthogonal to its rows.
    const { basis, complement } = columnSpace(restA.transpose(), threshold);
    if (complement.columns === 0) break;
    zero = besides(zero, rest.mmul(complement));
    restA = basis.columns > 0 ? basis.transpose().mmul(restA).mmul(basis) : new Matrix(0, 0);
    rest = rest.mmul(basis);
  }
  return { zero, rest, restA };
}

/**
 * Eigenvalues, sorted by real part, then imaginary part: zeros are exact, and so is the real part 0 of an undamped
 * oscillation (to rounding of A). `scale` as in `splitZeros`.
 *
 * @param A d x d
 * @param scale as in `splitZeros`
 */
export function eigenvalues(A: Matrix, scale = norm(A)): Complex[] {
  if (A.rows === 0) return [];
  const { zero, restA } = splitZeros(A, scale);
  const zeros = Array.from({ length: zero.columns }, (): Complex => [0, 0]);
  return [...zeros, ...plainEigenvalues(restA).map((value) => undamped(value, scale))].sort(byParts);
}

function undamped([re, im]: Complex, scale: number): Complex {
  return [im !== 0 && Math.abs(re) <= ROUNDING * scale ? 0 : re, im];
}

/**
 * Eigenvalues as computed (Hessenberg form and shifted QR).
 *
 * @param A d x d
 */
export function plainEigenvalues(A: Matrix): Complex[] {
  if (A.rows === 0) return [];
  const { realEigenvalues, imaginaryEigenvalues } = new EigenvalueDecomposition(A);
  return realEigenvalues.map((re, i): Complex => [re, imaginaryEigenvalues[i]!]);
}

/**
 * Order by real part, then by imaginary part.
 *
 * @param a 1/s
 * @param b 1/s
 */
export function byParts(a: Complex, b: Complex): number {
  return a[0] - b[0] || a[1] - b[1];
}

export function modulus([re, im]: Complex): number {
  return Math.hypot(re, im);
}

/**
 * Absolute value of the difference.
 *
 * @param a 1/s
 * @param b 1/s
 */
export function distance(a: Complex, b: Complex): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1]);
}

/** `10.99` or `-7.59 ± 28.1i`, for people. */
export function complexText([re, im]: Complex): string {
  const short = (x: number): string => String(Number(x.toPrecision(4)));
  return im === 0 ? short(re) : `${short(re)} ± ${short(Math.abs(im))}i`;
}

/** A mode by what moves in it. */
export interface Mode {
  eigenvalue: Complex;
  /** Names of states, the largest first; of coordinates alone where the eigenvalue is not zero (rates follow). */
  moves: string[];
  /** Its shape in all states, its largest coordinate 1 (of a complex mode the real part at that phase). */
  shape: number[];
}

/** Entries below this share of a shape's largest are not what moves. */
const VISIBLE = 0.01;

/**
 * Modes of A by name.
 *
 * @param A d x d
 * @param toStates states x d: what a vector of A's coordinates is in states (coordinates, then velocities)
 * @param states names
 * @param scale as in `splitZeros`
 */
export function modesOf(A: Matrix, toStates: Matrix, states: readonly string[], scale = norm(A)): Mode[] {
  if (A.rows === 0) return [];
  const { zero, rest, restA } = splitZeros(A, scale);
  // A system of first order has no rates among its states.
  const coordinateCount = states.at(-1)!.endsWith('_dot') ? states.length / 2 : states.length;
  const modes: Mode[] = [];
  if (zero.columns > 0) {
    for (const shape of echelon(toStates.mmul(zero)))
      modes.push({ eigenvalue: [0, 0], moves: movers(shape, states), shape });
  }
  for (const { value, re, im } of eigenvectors(A, restA, zero, rest)) {
    const shape = atLargestPhase(toStates.mmul(re), toStates.mmul(im), coordinateCount);
    // Rates are the eigenvalue times the coordinates: they say nothing more.
    const coordinates = shape.map((x, i) => (i < coordinateCount ? x : 0));
    modes.push({ eigenvalue: undamped(value, scale), moves: movers(coordinates, states), shape });
  }
  return modes.sort((a, b) => byParts(a.eigenvalue, b.eigenvalue));
}

/** Eigenvectors of A for eigenvalues other than zero, from those of the quotient; a conjugate pair gives two. */
function eigenvectors(
  A: Matrix,
  restA: Matrix,
  zero: Matrix,
  rest: Matrix,
): { value: Complex; re: Matrix; im: Matrix }[] {
  if (restA.rows === 0) return [];
  const { realEigenvalues, imaginaryEigenvalues, eigenvectorMatrix: E } = new EigenvalueDecomposition(restA);
  return realEigenvalues.map((lambda, i) => {
    const mu = imaginaryEigenvalues[i]!;
    // A pair's vectors stand as columns re, im of the member with the positive imaginary part.
    const [r, s] = mu === 0 ? [i, -1] : mu > 0 ? [i, i + 1] : [i - 1, i];
    const re = E.getColumnVector(r);
    const im = s < 0 ? Matrix.zeros(E.rows, 1) : E.getColumnVector(s).mul(mu > 0 ? 1 : -1);
    return { value: [lambda, mu] as Complex, ...lift(A, zero, rest, [lambda, mu], re, im) };
  });
}

/** y = rest w + zero u with A y = lambda y: (lambda - A_zz) u = A_zr w, solved over the reals as a pair. */
function lift(
  A: Matrix,
  zero: Matrix,
  rest: Matrix,
  [a, b]: Complex,
  re: Matrix,
  im: Matrix,
): { re: Matrix; im: Matrix } {
  const [yr, yi] = [rest.mmul(re), rest.mmul(im)];
  const k = zero.columns;
  if (k === 0) return { re: yr, im: yi };
  const Z = zero.transpose();
  const N = Z.mmul(A).mmul(zero);
  // N is nilpotent: (lambda - N)^-1 = sum of N^j / lambda^(j + 1).
  let [tr, ti] = [Z.mmul(A).mmul(yr), Z.mmul(A).mmul(yi)];
  const size = a * a + b * b;
  const divide = (x: Matrix, y: Matrix): [Matrix, Matrix] => [
    Matrix.add(Matrix.mul(x, a / size), Matrix.mul(y, b / size)),
    Matrix.sub(Matrix.mul(y, a / size), Matrix.mul(x, b / size)),
  ];
  for (let j = 0; j < k; j++) {
    [tr, ti] = divide(tr, ti);
    yr.add(zero.mmul(tr));
    yi.add(zero.mmul(ti));
    [tr, ti] = [N.mmul(tr), N.mmul(ti)];
  }
  return { re: yr, im: yi };
}

/** A complex shape turned so that its largest coordinate is 1 (its rates are the eigenvalue times that). */
function atLargestPhase(re: Matrix, im: Matrix, coordinateCount: number): number[] {
  let best = 0;
  const size = (i: number): number => Math.hypot(re.get(i, 0), im.get(i, 0));
  for (let i = 0; i < coordinateCount; i++) if (size(i) > size(best)) best = i;
  const [a, b] = [re.get(best, 0), im.get(best, 0)];
  const square = a * a + b * b;
  return Array.from({ length: re.rows }, (_, i) => (re.get(i, 0) * a + im.get(i, 0) * b) / square);
}

/**
 * A readable basis of a subspace: reduced by complete pivoting so that each vector has a state of its own (entry 1,
 * where the others have 0). Among nearly equal pivots the first state is taken.
 */
function echelon(T: Matrix): number[][] {
  const vectors = T.transpose().to2DArray();
  const own: number[] = [];
  for (let k = 0; k < vectors.length; k++) {
    let [row, column, largest] = [k, 0, 0];
    for (let i = 0; i < T.rows; i++) {
      if (own.includes(i)) continue;
      for (let r = k; r < vectors.length; r++) {
        const size = Math.abs(vectors[r]![i]!);
        if (size > 1.000001 * largest) [row, column, largest] = [r, i, size];
      }
    }
    own.push(column);
    [vectors[k], vectors[row]] = [vectors[row]!, vectors[k]!];
    const pivot = vectors[k]![column]!;
    vectors[k] = vectors[k]!.map((x) => x / pivot);
    vectors.forEach((v, r) => {
      if (r === k) return;
      const factor = v[column]!;
      vectors[r] = v.map((x, i) => x - factor * vectors[k]![i]!);
    });
  }
  return vectors.map((v) => {
    const largest = Math.max(...v.map(Math.abs));
    return v.map((x) => (Math.abs(x) < 1e-9 * largest ? 0 : x / largest));
  });
}

function movers(shape: readonly number[], states: readonly string[]): string[] {
  const largest = Math.max(...shape.map(Math.abs));
  // Rounded, so that equal sizes stand in the order of the states.
  const size = (i: number): number => Math.round((1e6 * Math.abs(shape[i]!)) / largest);
  return [...shape.keys()]
    .filter((i) => Math.abs(shape[i]!) > VISIBLE * largest)
    .sort((a, b) => size(b) - size(a))
    .map((i) => states[i]!);
}
