import type { Matrix } from 'ml-matrix';
import { DoubleDouble } from '../../linalg/doubleDouble.ts';
import { twice } from '../design/twice.ts';
import { memoryOf } from './hold.ts';
import type { PreciseProblem } from './dareTwice.ts';

/**
 * Plant and cost of `hold.ts` in twice the precision, by Taylor series over a short part of the sample and doubling.
 */

/** Norm of (A B; 0 0) h from which the series are summed, and how far: 0.5^m / m! is then below 1e-32. */
const SHORT = 0.25;
const TERMS = 24;

/** Copies a block of one matrix into another. */
function put(
  to: DoubleDouble,
  row: number,
  column: number,
  from: DoubleDouble,
  rows: number,
  r0 = 0,
  c0 = 0,
  columns = from.columns,
): void {
  for (let i = 0; i < rows; i++) {
    for (let j = 0; j < columns; j++) {
      const [a, b] = [(row + i) * to.columns + column + j, (r0 + i) * from.columns + c0 + j];
      to.hi[a] = from.hi[b]!;
      to.lo[a] = from.lo[b]!;
    }
  }
}

function block(from: DoubleDouble, row: number, rows: number, column: number, columns: number): DoubleDouble {
  const M = new DoubleDouble(rows, columns);
  put(M, 0, 0, from, rows, row, column, columns);
  return M;
}

const scaled = (A: DoubleDouble, by: number): DoubleDouble => new DoubleDouble(A.rows, A.columns).plus(A, by);

/** e^{F h}, and the integral of e^{F^T s} C e^{F s} over h. */
function piece(F: DoubleDouble, C: DoubleDouble, h: number): { phi: DoubleDouble; W: DoubleDouble } {
  const doublings = Math.max(0, Math.ceil(Math.log2((F.norm() * h) / SHORT)));
  const f = scaled(F, h * 2 ** -doublings);
  const ft = f.transpose();
  let power = DoubleDouble.identity(F.rows);
  let phi = power;
  let term = scaled(C, h * 2 ** -doublings);
  let W = term;
  for (let m = 1; m <= TERMS; m++) {
    power = over(power.times(f), m);
    phi = phi.plus(power);
    term = over(ft.times(term).plus(term.times(f)), m + 1);
    W = W.plus(term);
  }
  for (let i = 0; i < doublings; i++) {
    W = W.plus(phi.transpose().times(W).times(phi)).symmetric();
    phi = phi.times(phi);
  }
  return { phi, W };
}

/** Every entry divided by a number. */
function over(A: DoubleDouble, by: number): DoubleDouble {
  return DoubleDouble.identity(A.rows, by).solve(A)!;
}

/**
 * @param A n x n, 1/s
 * @param B n x k
 * @param C with the state's cost |C x|², p x n
 * @param R k x k, cost of the inputs
 * @param h sample time, s
 * @param delay s
 */
export function heldTwice(A: Matrix, B: Matrix, C: Matrix, R: Matrix, h: number, delay: number): PreciseProblem {
  const [n, k] = [A.rows, B.columns];
  const { count, acting } = memoryOf(h, delay);
  const size = n + count * k;
  const F = new DoubleDouble(n + k, n + k);
  put(F, 0, 0, twice(A), n);
  put(F, 0, n, twice(B), n);
  const cost = new DoubleDouble(n + k, n + k);
  const c = twice(C);
  put(cost, 0, 0, c.transpose().times(c), C.columns);
  let x = new DoubleDouble(n, size + k);
  put(x, 0, 0, DoubleDouble.identity(n), n);
  let W = new DoubleDouble(size + k, size + k);
  for (const { age, duration } of acting) {
    const z = new DoubleDouble(n + k, size + k);
    put(z, 0, 0, x, n);
    put(z, n, age === 0 ? size : n + (age - 1) * k, DoubleDouble.identity(k), k);
    const part = piece(F, cost, duration);
    W = W.plus(z.transpose().times(part.W).times(z));
    x = block(part.phi.times(z), 0, n, 0, size + k);
  }
  const [Ad, Bd] = [new DoubleDouble(size, size), new DoubleDouble(size, k)];
  put(Ad, 0, 0, x, n, 0, 0, size);
  put(Bd, 0, 0, x, n, 0, size, k);
  if (count > 0) put(Bd, n, 0, DoubleDouble.identity(k), k);
  if (count > 1) put(Ad, n + k, n, DoubleDouble.identity((count - 1) * k), (count - 1) * k);
  return {
    A: Ad,
    B: Bd,
    Q: block(W, 0, size, 0, size),
    N: block(W, 0, size, size, k),
    R: block(W, size, k, size, k).plus(twice(R), h),
  };
}
