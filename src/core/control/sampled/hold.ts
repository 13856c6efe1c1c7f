import { Matrix } from 'ml-matrix';
import { norm, symmetricPart } from '../linearization/matrices.ts';
import { exponential } from './exponential.ts';

/**
 * What a computer sees of `x' = A x + B u` when it samples every h seconds and holds its input in between (zero-order
 * hold): K. J. Åström and B. Wittenmark, Computer-Controlled Systems, 3rd ed., sections 2.3 and 2.5 (delay); the cost by
 * C. F. Van Loan, "Computing integrals involving the matrix exponential", IEEE Trans. Automatic Control 23 (1978),
 * 395-404.
 */

/** `x_{k+1} = A x_k + B u_k`. */
export interface SampledPlant {
  A: Matrix;
  B: Matrix;
}

/** @param A n x n, 1/s @param B n x k @param h sample time, s */
export function held(A: Matrix, B: Matrix, h: number): SampledPlant {
  const [n, k] = [A.rows, B.columns];
  const E = exponential(stackedBlock(A, B, h));
  return { A: part(E, 0, n, 0, n), B: part(E, 0, n, n, k) };
}

/**
 * `x' = A x + B u` driven through first-order lags, `w' = (u - w) / lag`: the state is then (x, those w whose lag is above 0).
 *
 * @param A n x n
 * @param B n x k
 * @param lags by input, s
 */
export function lagged(A: Matrix, B: Matrix, lags: readonly number[]): SampledPlant {
  const slow = [...lags.keys()].filter((i) => lags[i]! > 0);
  const [n, k] = [A.rows, B.columns];
  const size = n + slow.length;
  const [Al, Bl] = [Matrix.zeros(size, size), Matrix.zeros(size, k)];
  if (n > 0) Al.setSubMatrix(A, 0, 0);
  for (let i = 0; i < k; i++) {
    const at = n + slow.indexOf(i);
    for (let r = 0; r < n; r++) (at < n ? Bl : Al).set(r, at < n ? i : at, B.get(r, i));
    if (at < n) continue;
    Al.set(at, at, -1 / lags[i]!);
    Bl.set(at, i, 1 / lags[i]!);
  }
  return { A: Al, B: Bl };
}

/** (A B; 0 0) h, whose exponential is (Ad Bd; 0 I). */
function stackedBlock(A: Matrix, B: Matrix, h: number): Matrix {
  const [n, k] = [A.rows, B.columns];
  const M = Matrix.zeros(n + k, n + k);
  if (n > 0) M.setSubMatrix(Matrix.mul(A, h), 0, 0);
  if (n > 0 && k > 0) M.setSubMatrix(Matrix.mul(B, h), 0, n);
  return M;
}

function part(M: Matrix, row: number, rows: number, column: number, columns: number): Matrix {
  return rows > 0 && columns > 0
    ? M.subMatrix(row, row + rows - 1, column, column + columns - 1)
    : new Matrix(rows, columns);
}

/** A delay as whole samples and the rest of one: which of the past inputs act, and how long, within a sample. */
export interface Memory {
  /** How many past inputs the state holds: ceil(delay / h). */
  count: number;
  /** Ages of the inputs that act within a sample, oldest first, and for how long (s); age 0 is the one asked now. */
  acting: readonly { age: number; duration: number }[];
}

/** A delay that is a whole number of samples but for its last digits (0.015 at 0.005) is that. */
const WHOLE = 1e-9;

/**
 * What a computer has to remember for its delay.
 *
 * @param h sample time, s
 * @param delay s
 */
export function memoryOf(h: number, delay: number): Memory {
  const samples = delay / h;
  const nearest = Math.round(samples);
  if (Math.abs(samples - nearest) < WHOLE) return { count: nearest, acting: [{ age: nearest, duration: h }] };
  const count = Math.ceil(samples);
  const rest = delay - (count - 1) * h;
  return {
    count,
    acting: [
      { age: count, duration: rest },
      { age: count - 1, duration: h - rest },
    ],
  };
}

/**
 * The same with the input acting `delay` seconds after the measurement: the state is then (x, u_{k-1}, ..., u_{k-m}),
 * newest first, m = ceil(delay / h).
 *
 * @param A n x n
 * @param B n x k
 * @param h sample time, s
 * @param delay s
 */
export function heldWithDelay(A: Matrix, B: Matrix, h: number, delay: number): SampledPlant & { memory: Memory } {
  const [n, k] = [A.rows, B.columns];
  const memory = memoryOf(h, delay);
  const size = n + memory.count * k;
  const Ad = Matrix.zeros(size, size);
  const Bd = Matrix.zeros(size, k);
  // x at the sample's end, part by part.
  let x = Matrix.eye(n, size + k);
  for (const { age, duration } of memory.acting) {
    const piece = held(A, B, duration);
    x = Matrix.add(piece.A.mmul(x), piece.B.mmul(inputOf(age, n, k, size)));
  }
  if (n > 0) {
    Ad.setSubMatrix(part(x, 0, n, 0, size), 0, 0);
    Bd.setSubMatrix(part(x, 0, n, size, k), 0, 0);
  }
  if (memory.count > 0) Bd.setSubMatrix(Matrix.eye(k), n, 0);
  for (let age = 2; age <= memory.count; age++) {
    Ad.setSubMatrix(Matrix.eye(k), n + (age - 1) * k, n + (age - 2) * k);
  }
  return { A: Ad, B: Bd, memory };
}

/** Picks the input of an age out of (x, past inputs, the input asked now). */
function inputOf(age: number, n: number, k: number, size: number): Matrix {
  const P = Matrix.zeros(k, size + k);
  P.setSubMatrix(Matrix.eye(k), 0, age === 0 ? size : n + (age - 1) * k);
  return P;
}

/**
 * The cost of `sampledCost` with a delay, on the state with its memory. What is asked acts for one sample, sooner or
 * later: so `h u^T R u` is counted where it is asked, and only the cost of x where inputs act.
 *
 * @param A n x n
 * @param B n x k
 * @param Q n x n, cost of the state
 * @param R k x k, cost of the inputs
 * @param h sample time, s
 * @param delay s
 */
export function delayedCost(A: Matrix, B: Matrix, Q: Matrix, R: Matrix, h: number, delay: number): SampledCost {
  const [n, k] = [A.rows, B.columns];
  const { count, acting } = memoryOf(h, delay);
  const size = n + count * k;
  const none = Matrix.zeros(k, k);
  let x = Matrix.eye(n, size + k);
  const W = Matrix.zeros(size + k, size + k);
  for (const { age, duration } of acting) {
    const u = inputOf(age, n, k, size);
    const cost = sampledCost(A, B, Q, none, duration);
    const cross = x.transpose().mmul(cost.N).mmul(u);
    W.add(x.transpose().mmul(cost.Q).mmul(x)).add(cross).add(cross.transpose());
    W.add(u.transpose().mmul(cost.R).mmul(u));
    const piece = held(A, B, duration);
    x = Matrix.add(piece.A.mmul(x), piece.B.mmul(u));
  }
  const own = Matrix.add(part(W, size, k, size, k), Matrix.mul(R, h));
  return { Q: part(W, 0, size, 0, size), N: part(W, 0, size, size, k), R: own };
}

/** The integral of `x^T Q x + u^T R u` over one sample, u held, as `x^T Q x + 2 x^T N u + u^T R u` of its start. */
export interface SampledCost {
  Q: Matrix;
  N: Matrix;
  R: Matrix;
}

/** Largest norm of (A B; 0 0) h whose exponential the integral is taken from at once. */
const SHORT = 0.5;

/**
 * By Van Loan's exponential over a part of the sample that is short for the fastest mode, and from there by doubling,
 * W(2 h) = W(h) + phi(h)^T W(h) phi(h), where nothing cancels: at once, a mode that dies away within a sample would stand
 * beside its inverse in one exponential.
 *
 * @param A n x n
 * @param B n x k
 * @param Q n x n
 * @param R k x k
 * @param h s
 */
export function sampledCost(A: Matrix, B: Matrix, Q: Matrix, R: Matrix, h: number): SampledCost {
  const [n, k] = [A.rows, B.columns];
  const size = n + k;
  const F = stackedBlock(A, B, 1);
  const cost = Matrix.zeros(size, size);
  if (n > 0) cost.setSubMatrix(Q, 0, 0);
  if (k > 0) cost.setSubMatrix(R, n, n);
  const unit = norm(cost) || 1;
  const doublings = Math.max(0, Math.ceil(Math.log2((norm(F) * h) / SHORT)));
  const short = h * 2 ** -doublings;
  // exp of (-F^T cost; 0 F) h holds the integral of e^{F^T s} cost e^{F s}.
  const M = Matrix.zeros(2 * size, 2 * size);
  M.setSubMatrix(F.transpose().mul(-short), 0, 0);
  M.setSubMatrix(Matrix.mul(cost, short / unit), 0, size);
  M.setSubMatrix(Matrix.mul(F, short), size, size);
  const E = exponential(M);
  let phi = part(E, size, size, size, size);
  let W = symmetricPart(phi.transpose().mmul(part(E, 0, size, size, size)));
  for (let i = 0; i < doublings; i++) {
    W = symmetricPart(Matrix.add(W, phi.transpose().mmul(W).mmul(phi)));
    phi = phi.mmul(phi);
  }
  W.mul(unit);
  return { Q: part(W, 0, n, 0, n), N: part(W, 0, n, n, k), R: part(W, n, k, n, k) };
}
