import { Matrix } from 'ml-matrix';
import { solveCare } from '../design/riccati.ts';
import type { Linearization } from '../linearization/linearize.ts';
import { ControlError, norm, solveLinear, symmetricPart } from '../linearization/matrices.ts';
import { balanced, dualOf } from '../linearization/balance.ts';
import { reachByInput, splitByReachability } from '../linearization/reachability.ts';
import {
  complexText,
  modesOf,
  modulus,
  ON_AXIS,
  plainEigenvalues,
  type Complex,
  type Mode,
} from '../linearization/spectrum.ts';
import { solveDare } from './dare.ts';
import { exponential } from './exponential.ts';
import { sampledCost } from './hold.ts';

/**
 * The stationary Kalman filter of what sensors see: `s' = A s + B u + w`, `y = C s + n`, s the part of the deviations that
 * shows in y (K. J. Åström and B. Wittenmark, Computer-Controlled Systems, 3rd ed., section 11.3; continuous: H. Kwakernaak
 * and R. Sivan, Linear Optimal Control Systems, section 4.3). Its Riccati equations are those of the regulator, transposed.
 */

/** What sensors see of a plant: the twin of reachability. */
export interface ObservedPlant {
  /** On the seen part: o x o, o x k, p x o. */
  readonly A: Matrix;
  readonly B: Matrix;
  readonly C: Matrix;
  /** s = fromStates x (o x 2n); x as far as s tells it = toStates s, so that modes that are seen come back whole. */
  readonly fromStates: Matrix;
  readonly toStates: Matrix;
  /** Modes that no sensor sees, by what moves in them; no filter estimates them. */
  readonly unseen: Mode[];
  /** How many dimensions each sensor sees alone. */
  readonly bySensor: { sensor: string; dimension: number }[];
  /** What decided, as in `Reachability`. */
  readonly margin: { kept: number; dropped: number };
}

/**
 * @param linearization about a steady motion
 * @param C rows of the sensors by all states, p x 2n
 * @param sensors names of C's rows
 * @param weakest share below which what shows is not counted on, as in `reachableSubspace`
 * @throws ControlError naming an unstable mode that no sensor sees
 */
export function observedPlant(
  linearization: Linearization,
  C: Matrix,
  sensors: readonly string[],
  weakest = 0,
): ObservedPlant {
  const { basis: N, tangentA, tangentB, states } = linearization;
  const seenRows = C.mmul(N);
  const [At, Ct] = [tangentA.transpose(), seenRows.transpose()];
  const balance = balanced(N, tangentA, tangentB);
  const dual = dualOf(balance, Ct);
  // What each would read of the states one by one, in the units in which ranks are decided.
  const scaled = C.clone();
  for (let i = states.length / 2; i < states.length; i++) scaled.mulColumn(i, balance.unit);
  const sizes = sensors.map((_, i) => norm(scaled.getRowVector(i)));
  const split = splitByReachability(At, Ct, sizes, dual, weakest);
  const [V, U] = [split.reachable, split.complement];
  const unseen = modesOf(U.transpose().mmul(tangentA).mmul(U), N.mmul(U), states, split.scale);
  const lost = unseen.filter(({ eigenvalue: [re, im] }) => re > ON_AXIS * split.scale && im >= 0);
  if (lost.length > 0)
    throw new ControlError(
      `${[...new Set(sensors)].join(', ')} can't tell how to stabilize this motion: no sensor sees the unstable mode with eigenvalue ${lost
        .map((m) => `${complexText(m.eigenvalue)} (${m.moves.slice(0, 4).join(', ')})`)
        .join('; ')}; name further sensors`,
    );
  return {
    A: split.A.transpose(),
    B: V.transpose().mmul(tangentB),
    C: seenRows.mmul(V),
    fromStates: V.transpose().mmul(N.transpose()),
    toStates: N.mmul(split.W.transpose()),
    unseen,
    bySensor: reachByInput(dual.A, dual.B, sensors, sizes).map(({ input, dimension }) => ({
      sensor: input,
      dimension,
    })),
    margin: split.margin,
  };
}

export interface KalmanFilter {
  /** Continuous: `s' = A s + B u + L (y - C s)`. Sampled: `s += L (y - C s)` at a measurement. o x p. */
  readonly gain: Matrix;
  /** Covariance of what is not known: stationary; of a sampled filter before its measurement. */
  readonly covariance: Matrix;
  /** Of the estimate's error, 1/s; of a sampled filter from sample to sample. */
  readonly poles: Complex[];
  readonly residual: number;
}

/**
 * @param intensities of the process noise, by state (2n)
 * @param densities of the sensors' noise, per √Hz
 */
export function continuousKalman(
  { A, C, fromStates }: ObservedPlant,
  intensities: readonly number[],
  densities: readonly number[],
): KalmanFilter {
  const root = Matrix.diag(intensities.map(Math.sqrt)).mmul(fromStates.transpose());
  try {
    const { X, gain, residual, closedLoop } = solveCare(
      A.transpose(),
      C.transpose(),
      root.transpose().mmul(root),
      densities.map((d) => d * d),
    );
    return { gain: gain.transpose(), covariance: X, poles: closedLoop, residual };
  } catch (error) {
    throw filterError(error);
  }
}

/**
 * @param intensities of the process noise, by state (2n)
 * @param deviations of the sensors' noise per sample
 * @param h sample time, s
 */
export function sampledKalman(
  { A, C, fromStates }: ObservedPlant,
  intensities: readonly number[],
  deviations: readonly number[],
  h: number,
): KalmanFilter {
  const W = fromStates.mmul(Matrix.diag([...intensities])).mmul(fromStates.transpose());
  const none = new Matrix(A.rows, 0);
  const grown = sampledCost(A.transpose(), none, W, new Matrix(0, 0), h).Q;
  const R = Matrix.diag(deviations.map((d) => d * d));
  const Ad = exponential(Matrix.mul(A, h));
  try {
    const { X: P, residual } = solveDare(Ad.transpose(), C.transpose(), symmetricPart(grown), R);
    const gain = correctionGain(P, C, R);
    const error = Ad.mmul(Matrix.sub(Matrix.eye(A.rows), gain.mmul(C)));
    const poles = plainEigenvalues(error).sort((a, b) => modulus(b) - modulus(a));
    return { gain, covariance: P, poles, residual };
  } catch (error) {
    throw filterError(error);
  }
}

/**
 * P C^T (C P C^T + R)^-1: what a measurement corrects of an estimate whose error has the covariance P.
 *
 * @param P d x d, symmetric
 * @param C p x d
 * @param R p x p, symmetric, the noise of the sensors
 */
export function correctionGain(P: Matrix, C: Matrix, R: Matrix): Matrix {
  const PCt = P.mmul(C.transpose());
  const solved = solveLinear(Matrix.add(C.mmul(PCt), R), PCt.transpose());
  if (!solved) throw new ControlError('the sensors are more exact than these numbers can hold; give them more noise');
  return solved.transpose();
}

function filterError(error: unknown): unknown {
  if (!(error instanceof ControlError)) return error;
  return new ControlError(
    'there is no stationary filter for these sensors and this process: a mode that neither grows nor dies needs process ' +
      'noise to be followed; give control.process to the states that move in it, or leave it out (1 for each); noise far below what the process moves is lost in rounding',
  );
}
