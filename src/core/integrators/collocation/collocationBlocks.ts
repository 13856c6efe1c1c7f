import { complexLuFactor, complexLuSolve } from '../../linalg/complexLu.ts';
import { luFactor, luSolve } from '../../linalg/lu.ts';

/**
 * I - h gamma J, factored, for one eigenvalue gamma of a Runge-Kutta matrix.
 *
 * Where y = (q, v) with q' = v, J is [0 I; K D] in blocks, and (I - g J) (x, y) = (a, b), g = h gamma, needs factors
 * of half the dimension alone: (I - g D - g^2 K) y = b + g K a, x = a + g y, as in the authors' RADAU5 for such systems.
 */
export interface Block {
  readonly real: boolean;
  /**
   * @param h length of the step, s
   * @param J df/dy, n x n, row-major; must stay as it is until it is factored again
   * @param secondOrder `isSecondOrder(J)`
   * @returns false if the matrix is singular or not finite
   */
  factor(h: number, J: Float64Array, secondOrder: boolean): boolean;
  /**
   * Solves in place of x + i y; a real block leaves y alone.
   * @param x n
   * @param y n
   */
  solve(x: Float64Array, y: Float64Array): void;
}

/**
 * Whether J is [0 I; K D] to the last bit.
 *
 * @param J n x n, row-major
 * @param n dimension of the state; an odd one is none of second order
 */
export function isSecondOrder(J: Float64Array, n: number): boolean {
  if (n % 2 !== 0) return false;
  const half = n / 2;
  for (let i = 0; i < half; i++) {
    for (let j = 0; j < n; j++) if (J[i * n + j] !== (j === half + i ? 1 : 0)) return false;
  }
  return true;
}

export class RealBlock implements Block {
  readonly real = true;
  private readonly n: number;
  private readonly gamma: number;
  private readonly matrix: Float64Array;
  private readonly pivots: Int32Array;
  private readonly lower: Float64Array;
  private J: Float64Array;
  private secondOrder = false;
  private g = 0;

  constructor(n: number, gamma: number) {
    this.n = n;
    this.gamma = gamma;
    this.matrix = new Float64Array(n * n);
    this.pivots = new Int32Array(n);
    this.lower = new Float64Array(n >> 1);
    this.J = this.matrix;
  }

  factor(h: number, J: Float64Array, secondOrder: boolean): boolean {
    const { n, matrix } = this;
    const g = (this.g = h * this.gamma);
    this.J = J;
    this.secondOrder = secondOrder;
    const size = secondOrder ? n >> 1 : n;
    if (secondOrder) {
      for (let i = 0, to = 0; i < size; i++) {
        const row = (size + i) * n;
        for (let j = 0; j < size; j++) matrix[to++] = -g * (J[row + size + j]! + g * J[row + j]!);
      }
    } else for (let i = 0; i < n * n; i++) matrix[i] = -g * J[i]!;
    for (let i = 0; i < size; i++) matrix[i * size + i]! += 1;
    return luFactor(matrix, size, this.pivots);
  }

  solve(x: Float64Array): void {
    const { n, g, J, lower, matrix, pivots } = this;
    if (!this.secondOrder) return luSolve(matrix, n, pivots, x);
    const half = n >> 1;
    for (let i = 0; i < half; i++) {
      let sum = 0;
      for (let j = 0, at = (half + i) * n; j < half; j++, at++) sum += J[at]! * x[j]!;
      lower[i] = x[half + i]! + g * sum;
    }
    luSolve(matrix, half, pivots, lower);
    for (let i = 0; i < half; i++) {
      x[half + i] = lower[i]!;
      x[i]! += g * lower[i]!;
    }
  }
}

export class ComplexBlock implements Block {
  readonly real = false;
  private readonly n: number;
  private readonly gamma: readonly [number, number];
  private readonly re: Float64Array;
  private readonly im: Float64Array;
  private readonly pivots: Int32Array;
  private readonly lowerRe: Float64Array;
  private readonly lowerIm: Float64Array;
  private J: Float64Array;
  private secondOrder = false;
  private gRe = 0;
  private gIm = 0;

  constructor(n: number, re: number, im: number) {
    this.n = n;
    this.gamma = [re, im];
    this.re = new Float64Array(n * n);
    this.im = new Float64Array(n * n);
    this.pivots = new Int32Array(n);
    this.lowerRe = new Float64Array(n >> 1);
    this.lowerIm = new Float64Array(n >> 1);
    this.J = this.re;
  }

  factor(h: number, J: Float64Array, secondOrder: boolean): boolean {
    const { n, re, im } = this;
    const a = (this.gRe = h * this.gamma[0]);
    const b = (this.gIm = h * this.gamma[1]);
    this.J = J;
    this.secondOrder = secondOrder;
    const size = secondOrder ? n >> 1 : n;
    if (secondOrder) {
      const squareRe = a * a - b * b;
      const squareIm = 2 * a * b;
      for (let i = 0, to = 0; i < size; i++) {
        const row = (size + i) * n;
        for (let j = 0; j < size; j++, to++) {
          const k = J[row + j]!;
          const d = J[row + size + j]!;
          re[to] = -a * d - squareRe * k;
          im[to] = -b * d - squareIm * k;
        }
      }
    } else {
      for (let i = 0; i < n * n; i++) {
        re[i] = -a * J[i]!;
        im[i] = -b * J[i]!;
      }
    }
    for (let i = 0; i < size; i++) re[i * size + i]! += 1;
    return complexLuFactor(re, im, size, this.pivots);
  }

  solve(x: Float64Array, y: Float64Array): void {
    const { n, gRe: a, gIm: b, J, lowerRe, lowerIm, re, im, pivots } = this;
    if (!this.secondOrder) return complexLuSolve(re, im, n, pivots, x, y);
    const half = n >> 1;
    for (let i = 0; i < half; i++) {
      let p = 0;
      let q = 0;
      for (let j = 0, at = (half + i) * n; j < half; j++, at++) {
        p += J[at]! * x[j]!;
        q += J[at]! * y[j]!;
      }
      lowerRe[i] = x[half + i]! + a * p - b * q;
      lowerIm[i] = y[half + i]! + a * q + b * p;
    }
    complexLuSolve(re, im, half, pivots, lowerRe, lowerIm);
    for (let i = 0; i < half; i++) {
      const p = (x[half + i] = lowerRe[i]!);
      const q = (y[half + i] = lowerIm[i]!);
      x[i]! += a * p - b * q;
      y[i]! += a * q + b * p;
    }
  }
}
