import type { Matrix } from 'ml-matrix';
import type { Complex } from '../linearization/spectrum.ts';

/** Of the discrete-time algebraic Riccati equation of `dare.ts`. */
export interface DareSolution {
  X: Matrix;
  /** K = (R + B^T X B)^-1 (B^T X A + N^T), k x n: u = -K x. */
  gain: Matrix;
  /** |right side - X| as a share of its terms. */
  residual: number;
  closedLoop: Complex[];
  doublings: number;
}
