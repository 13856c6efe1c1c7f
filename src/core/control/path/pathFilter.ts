import { cosine, sine } from '../../elementary/trigonometry.ts';
import { Matrix } from 'ml-matrix';
import type { System } from '../../model/system.ts';
import { Formula } from '../../scenario/formula.ts';
import type { LqrControl, Scenario } from '../../scenario/types.ts';
import { GainSchedule } from '../design/gainSchedule.ts';
import { deviationOf, timingOf } from '../design/scenarioControl.ts';
import { located } from '../linearization/preparedPlant.ts';
import { product, symmetricPart } from '../linearization/matrices.ts';
import { exponential } from '../sampled/exponential.ts';
import { held, lagged, memoryOf, sampledCost, type Memory } from '../sampled/hold.ts';
import { followedErrors, observedPlant, processOf, type FollowedError, type ObservedPlant } from '../sampled/kalman.ts';
import { Sensors } from '../sampled/sensors.ts';
import type { PathCurve } from './pathCurve.ts';
import { turnOf } from './turnOf.ts';
import type { Plane, SteadyTurn } from './steadyTurn.ts';

/** A share of the plant's own scale. */
const WEAKEST = 1e-4;
/** At first each state is known to ±0.1 (SI): a path is entered from about its straight motion. */
const KNOWN = 0.1;

/** What the Kalman filter of a follower is made of: the models of its turns, by curvature, and its sensors. */
export interface PathFilter {
  /** Rows of `TurnModel`, by curvature. */
  readonly models: GainSchedule;
  /** Covariance at first, by the same curvatures; 2n x 2n. */
  readonly unknown: readonly Float64Array[];
  readonly curvatures: readonly number[];
  /** How many inputs. */
  readonly inputs: number;
  readonly memory: Memory;
  /** Inputs that lag. */
  readonly slow: readonly number[];
  readonly makeSensors: () => Sensors;
  /** Of the sensors' noise, per sample, squared. */
  readonly variances: readonly number[];
  /** Errors of sensors that are followed. */
  readonly biases: readonly FollowedError[];
  readonly sample: number;
  /** Coordinates that roll on, beside those of the plane. */
  readonly rolls: readonly number[];
  /** The straight motion, from which it starts. */
  readonly start: { q: Float64Array; v: Float64Array };
}

/** A turn's row: q0, v0, u0; for each part of a sample A (e x e) and B (e x k), e = 2n + lagged inputs; F and W (2n x 2n). */
export class TurnModel {
  readonly row: Float64Array;
  readonly q0: Float64Array;
  readonly v0: Float64Array;
  readonly u0: Float64Array;
  readonly parts: readonly { A: Float64Array; B: Float64Array }[];
  /** Transition of a sample, and what the process adds to the covariance meanwhile. */
  readonly F: Float64Array;
  readonly W: Float64Array;

  /** @param n coordinates @param k inputs @param slow how many of them lag @param parts of a sample */
  constructor(n: number, k: number, slow: number, parts: number) {
    const e = 2 * n + slow;
    this.row = new Float64Array(2 * n + k + parts * (e * e + e * k) + 8 * n * n);
    let at = 0;
    const next = (size: number): Float64Array => this.row.subarray(at, (at += size));
    [this.q0, this.v0, this.u0] = [next(n), next(n), next(k)];
    this.parts = Array.from({ length: parts }, () => ({ A: next(e * e), B: next(e * k) }));
    [this.F, this.W] = [next(4 * n * n), next(4 * n * n)];
  }
}

/**
 * @param scenario checked, SI
 * @param system that the scenario names
 * @param control with a path and sensors
 * @param curve of its path
 * @param curvatures of the turns, ascending
 * @param turns at these curvatures
 * @param plane of the system
 * @throws ScenarioError at `control.path` where there is no straight motion to start from, at `control.sensors` where no filter can tell how to stay on it
 */
export function pathFilterOf(
  scenario: Scenario,
  system: System,
  control: LqrControl,
  curve: PathCurve,
  curvatures: readonly number[],
  turns: readonly SteadyTurn[],
  plane: Plane,
): PathFilter {
  const { sensors = {}, process, sample = 0, seed = 0 } = control;
  const { states, motion } = turns[0]!.whole;
  const names = Object.keys(sensors);
  const seen = located('control.sensors', () => turns.map((turn) => seenPart(turn, names, curve, plane)));
  const timing = timingOf(control);
  const memory = memoryOf(sample, timing.delay);
  const intensities = states.map((name) => (process ? (process[name] ?? 0) : 1));
  const rows = turns.map((turn, i) => rowOf(turn, seen[i]!, timing.lags, memory, sample, intensities));
  const straight = turnOf(scenario, system, control, 0);
  return {
    models: new GainSchedule(curvatures, (kappa) => ({
      gain: Matrix.rowVector([...rows[curvatures.indexOf(kappa)]!]),
    })),
    unknown: seen.map(({ toStates: T }) =>
      Float64Array.from(Matrix.mul(T.mmul(T.transpose()), KNOWN ** 2).to1DArray()),
    ),
    curvatures,
    inputs: control.inputs.length,
    memory,
    slow: [...timing.lags.keys()].filter((i) => timing.lags[i]! > 0),
    makeSensors: () => new Sensors(sensors, states, sample, seed),
    variances: Object.values(sensors).map((sensor) => deviationOf(sensor, sample) ** 2),
    biases: followedErrors(sensors),
    sample,
    rolls: system.meta.coordinates.flatMap(({ name }, i) =>
      motion.moving.includes(name) && i !== plane.x && i !== plane.y && i !== plane.heading ? [i] : [],
    ),
    start: { q: straight.motion.q, v: straight.motion.v },
  };
}

/**
 * What of a turn shows in what the sensors read, whichever ways the path heads: each unstable mode must. What shows less than
 * `WEAKEST` is left out: beside what a linearization leaves out, it would be guessed.
 */
function seenPart(
  { motion, whole }: SteadyTurn,
  names: readonly string[],
  curve: PathCurve,
  plane: Plane,
): ObservedPlant {
  const state = [...motion.q, ...motion.v];
  const n = motion.q.length;
  const rows = curve.headings.flatMap((heading) =>
    names.map((text) => {
      const formula = new Formula(text, whole.states);
      const row = whole.states.map((_, i) => formula.slope(state, i));
      alongThePath(row, plane, n, cosine(heading), sine(heading));
      return row;
    }),
  );
  const ofRows = curve.headings.flatMap(() => names);
  return observedPlant(whole, new Matrix(rows), ofRows, WEAKEST);
}

/**
 * A row by places and velocities of the ground, in place, to one by those along and across a path.
 *
 * @param row coefficients of all coordinates, then of their rates (2n)
 * @param plane which coordinates are place and heading
 * @param n number of coordinates
 * @param c cosine of the path's heading
 * @param s sine of the path's heading
 */
export function alongThePath(row: Float64Array | number[], plane: Plane, n: number, c: number, s: number): void {
  for (const offset of [0, n]) {
    const [x, y] = [row[offset + plane.x]!, row[offset + plane.y]!];
    row[offset + plane.x] = c * x + s * y;
    row[offset + plane.y] = c * y - s * x;
  }
}

function rowOf(
  { motion, u0 }: SteadyTurn,
  seen: ObservedPlant,
  lags: readonly number[],
  memory: Memory,
  sample: number,
  intensities: readonly number[],
): Float64Array {
  const { A: seenA, B: seenB, fromStates, toStates } = seen;
  const [n, o, k] = [motion.q.length, seenA.rows, u0.length];
  const driven = lagged(seenA, seenB, lags);
  const slow = driven.A.rows - o;
  // Between the states and the seen part, lagged inputs behind them.
  const [into, out] = [Matrix.zeros(o + slow, 2 * n + slow), Matrix.zeros(2 * n + slow, o + slow)];
  into.setSubMatrix(fromStates, 0, 0);
  out.setSubMatrix(toStates, 0, 0);
  for (let i = 0; i < slow; i++) {
    into.set(o + i, 2 * n + i, 1);
    out.set(2 * n + i, o + i, 1);
  }
  const model = new TurnModel(n, k, slow, memory.acting.length);
  model.q0.set(motion.q);
  model.v0.set(motion.v);
  model.u0.set(u0);
  memory.acting.forEach(({ duration }, i) => {
    const { A, B } = held(driven.A, driven.B, duration);
    model.parts[i]!.A.set(product(out, A, into).to1DArray());
    model.parts[i]!.B.set(out.mmul(B).to1DArray());
  });
  const process = processOf(seen, intensities);
  const grown = symmetricPart(sampledCost(seenA.transpose(), new Matrix(o, 0), process, new Matrix(0, 0), sample).Q);
  model.F.set(product(toStates, exponential(Matrix.mul(seenA, sample)), fromStates).to1DArray());
  model.W.set(product(toStates, grown, toStates.transpose()).to1DArray());
  return model.row;
}
