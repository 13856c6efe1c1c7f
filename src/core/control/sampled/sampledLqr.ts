import { Matrix } from 'ml-matrix';
import type { LqrDesign } from '../design/lqr.ts';
import { besides, columnsOf } from '../linearization/matrices.ts';
import { modulus, plainEigenvalues, type Complex } from '../linearization/spectrum.ts';
import { solveDare } from './dare.ts';
import { heldTwice } from './holdTwice.ts';
import { delayedCost, heldWithDelay, lagged, type SampledPlant } from './hold.ts';

/** A regulator as a computer runs it: sampled, held, with a delay from measurement to actuation. */
export interface SampledDesign {
  readonly sample: number;
  readonly delay: number;
  /** `x_{k+1} = A x_k + B u_k` on the reachable, seen quotient; behind z its state holds what lagging actuators give, then past inputs. */
  readonly A: Matrix;
  readonly B: Matrix;
  /** `u_k = -K x_k` there, and on the states of the system, what lagging actuators give, and past inputs, newest first. */
  readonly K: Matrix;
  readonly gain: Matrix;
  readonly actingGain: Matrix;
  readonly inputGain: Matrix;
  readonly closedLoop: Complex[];
  readonly spectralRadius: number;
  /** Null where the gain is the continuous one. */
  readonly riccatiResidual: number | null;
}

/** Sample time, delay (s), and the time constants of the actuators by input (s; 0: none). */
export interface Timing {
  sample: number;
  delay: number;
  lags?: readonly number[];
}

/**
 * The continuous design's own gain, held.
 *
 * @param design the continuous lqr
 * @param timing sample time, delay and lags, s
 */
export function heldDesign(design: LqrDesign, timing: Timing): SampledDesign {
  const driven = drivenPlant(design, timing);
  const plant = heldWithDelay(driven.A, driven.B, timing.sample, timing.delay);
  const K = besides(design.riccati.gain, new Matrix(plant.B.columns, plant.A.rows - design.quotient.A.rows));
  return report(design, timing, plant, driven.A.rows, K, null);
}

/**
 * The regulator of least cost among those that hold their input: exact sampled cost, delay and lags by augmentation.
 *
 * @param design the continuous lqr
 * @param timing sample time, delay and lags, s
 */
export function sampledLqr(design: LqrDesign, timing: Timing): SampledDesign {
  const { sample, delay } = timing;
  const { C } = design.quotient;
  const { A, B } = drivenPlant(design, timing);
  const plant = heldWithDelay(A, B, sample, delay);
  const Q = Matrix.zeros(A.rows, A.rows);
  if (C.columns > 0) Q.setSubMatrix(C.transpose().mmul(C), 0, 0);
  const R = Matrix.diag([...design.weights.R]);
  const cost = delayedCost(A, B, Q, R, sample, delay);
  const { gain, residual } = solveDare(plant.A, plant.B, cost.Q, cost.R, cost.N, () =>
    heldTwice(A, B, C, R, sample, delay),
  );
  return report(design, timing, plant, A.rows, gain, residual);
}

function drivenPlant({ quotient: { A, B } }: LqrDesign, { lags }: Timing): SampledPlant {
  return lags ? lagged(A, B, lags) : { A, B };
}

/** @param driven how many states the plant has with its lags, without past inputs */
function report(
  design: LqrDesign,
  { sample, delay, lags = [] }: Timing,
  { A, B }: SampledPlant,
  driven: number,
  K: Matrix,
  riccatiResidual: number | null,
): SampledDesign {
  const { fromStates } = design.quotient;
  const d = fromStates.rows;
  const closedLoop = plainEigenvalues(Matrix.sub(A, B.mmul(K))).sort((a, b) => modulus(b) - modulus(a));
  const actingGain = Matrix.zeros(K.rows, K.rows);
  let at = d;
  for (let i = 0; i < K.rows; i++) if (lags[i]) actingGain.setColumn(i, K.getColumn(at++));
  return {
    sample,
    delay,
    A,
    B,
    K,
    gain: columnsOf(K, 0, d).mmul(fromStates),
    actingGain,
    inputGain: columnsOf(K, driven, K.columns),
    closedLoop,
    spectralRadius: closedLoop.length > 0 ? modulus(closedLoop[0]!) : 0,
    riccatiResidual,
  };
}
