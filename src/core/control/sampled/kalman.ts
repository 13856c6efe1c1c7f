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
import type { Sensor } from '../../scenario/types.ts';
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
  /** Errors of sensors that are followed are the last states: their random walks, per √s, and how well each is known at first. */
  readonly biases?: readonly FollowedError[];
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

/** An error of a sensor that a filter follows: its place among the sensors, its random walk (per √s), and how well it is known at first. */
export interface FollowedError {
  sensor: string;
  place: number;
  walk: number;
  first: number;
}

/**
 * The errors of sensors that are followed.
 *
 * @param sensors as the scenario has them, by name
 */
export const followedErrors = (sensors: Readonly<Record<string, Sensor>>): FollowedError[] =>
  Object.entries(sensors).flatMap(([sensor, { follow = 0, bias = 0 }], place) =>
    follow > 0 ? [{ sensor, place, walk: follow, first: Math.max(Math.abs(bias), follow) }] : [],
  );

/**
 * The same with the errors of some sensors as states that wander by themselves.
 *
 * @param plant on the seen part
 * @param sensors as the scenario has them, by name, in the order of C's rows
 */
export function withBiases(plant: ObservedPlant, sensors: Readonly<Record<string, Sensor>>): ObservedPlant {
  const followed = followedErrors(sensors);
  const count = followed.length;
  if (count === 0) return plant;
  const { A, B, C, fromStates, toStates } = plant;
  const [o, n] = [A.rows, fromStates.columns];
  const within = (M: Matrix, rows: number, columns: number): Matrix => {
    const larger = Matrix.zeros(rows, columns);
    if (M.rows > 0 && M.columns > 0) larger.setSubMatrix(M, 0, 0);
    return larger;
  };
  const reads = within(C, C.rows, o + count);
  followed.forEach(({ place }, i) => reads.set(place, o + i, 1));
  return {
    ...plant,
    A: within(A, o + count, o + count),
    B: within(B, o + count, B.columns),
    C: reads,
    fromStates: within(fromStates, o + count, n),
    toStates: within(toStates, toStates.rows, o + count),
    biases: followed,
  };
}

/**
 * What the process and the walks of the followed errors add to the covariance, per s.
 *
 * @param plant the part of the linear system that its sensors see
 * @param intensities of the process noise, by state (2n)
 */
export function processOf({ A, fromStates, biases = [] }: ObservedPlant, intensities: readonly number[]): Matrix {
  const W = fromStates.mmul(Matrix.diag([...intensities])).mmul(fromStates.transpose());
  biases.forEach(({ walk }, i) => W.set(A.rows - biases.length + i, A.rows - biases.length + i, walk * walk));
  return W;
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
 * @param plant the part of the linear system that its sensors see
 * @param intensities of the process noise, by state (2n)
 * @param densities of the sensors' noise, per √Hz
 */
export function continuousKalman(
  plant: ObservedPlant,
  intensities: readonly number[],
  densities: readonly number[],
): KalmanFilter {
  const { A, C } = plant;
  try {
    const { X, gain, residual, closedLoop } = solveCare(
      A.transpose(),
      C.transpose(),
      symmetricPart(processOf(plant, intensities)),
      densities.map((d) => d * d),
    );
    return { gain: gain.transpose(), covariance: X, poles: closedLoop, residual };
  } catch (error) {
    throw filterError(error);
  }
}

/**
 * @param plant the part of the linear system that its sensors see
 * @param intensities of the process noise, by state (2n)
 * @param deviations of the sensors' noise per sample
 * @param h sample time, s
 */
export function sampledKalman(
  plant: ObservedPlant,
  intensities: readonly number[],
  deviations: readonly number[],
  h: number,
): KalmanFilter {
  const { A, C } = plant;
  const W = processOf(plant, intensities);
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
      'noise to be followed; give control.process to the states that move in it, or leave it out (1 for each); an error that the other sensors ' +
      'do not tell from a motion can not be followed; noise far below what the process moves is lost in rounding',
  );
}
