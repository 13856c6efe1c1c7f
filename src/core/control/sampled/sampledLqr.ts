import { Matrix } from 'ml-matrix';
import type { LqrDesign } from '../design/lqr.ts';
import { besides } from '../linearization/matrices.ts';
import { modulus, plainEigenvalues, type Complex } from '../linearization/spectrum.ts';
import { solveDare } from './dare.ts';
import { delayedCost, heldWithDelay } from './hold.ts';

/** A regulator as a computer runs it: sampled, held, with a delay from measurement to actuation. */
export interface SampledDesign {
  readonly sample: number;
  readonly delay: number;
  /** `x_{k+1} = A x_k + B u_k` on the reachable, seen quotient; with a delay its state holds past inputs too. */
  readonly A: Matrix;
  readonly B: Matrix;
  /** `u_k = -K x_k` there, and on the states of the system and the past inputs, newest first. */
  readonly K: Matrix;
  readonly gain: Matrix;
  readonly inputGain: Matrix;
  readonly closedLoop: Complex[];
  readonly spectralRadius: number;
  /** Null where the gain is the continuous one. */
  readonly riccatiResidual: number | null;
}

/** The continuous design's own gain, held. @param sample s @param delay s */
export function heldDesign(design: LqrDesign, sample: number, delay: number): SampledDesign {
  const { A, B } = design.quotient;
  const plant = heldWithDelay(A, B, sample, delay);
  const K = besides(design.riccati.gain, new Matrix(B.columns, plant.A.rows - A.rows));
  return report(design, sample, delay, plant.A, plant.B, K, null);
}

/** The regulator of least cost among those that hold their input: exact sampled cost, delay by augmentation. */
export function sampledLqr(design: LqrDesign, sample: number, delay: number): SampledDesign {
  const { A, B, C } = design.quotient;
  const plant = heldWithDelay(A, B, sample, delay);
  const cost = delayedCost(A, B, C.transpose().mmul(C), Matrix.diag([...design.weights.R]), sample, delay);
  const { gain, residual } = solveDare(plant.A, plant.B, cost.Q, cost.R, cost.N);
  return report(design, sample, delay, plant.A, plant.B, gain, residual);
}

function report(
  design: LqrDesign,
  sample: number,
  delay: number,
  A: Matrix,
  B: Matrix,
  K: Matrix,
  riccatiResidual: number | null,
): SampledDesign {
  const { fromStates } = design.quotient;
  const d = fromStates.rows;
  const part = (from: number, to: number): Matrix =>
    to > from ? K.subMatrix(0, K.rows - 1, from, to - 1) : new Matrix(K.rows, 0);
  const closedLoop = plainEigenvalues(Matrix.sub(A, B.mmul(K))).sort((a, b) => modulus(b) - modulus(a));
  return {
    sample,
    delay,
    A,
    B,
    K,
    gain: part(0, d).mmul(fromStates),
    inputGain: part(d, K.columns),
    closedLoop,
    spectralRadius: closedLoop.length > 0 ? modulus(closedLoop[0]!) : 0,
    riccatiResidual,
  };
}
