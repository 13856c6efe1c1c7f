import type { Scenario } from '../../scenario/types.ts';
import type { System } from '../../model/system.ts';
import type { LqrDesign } from '../design/lqr.ts';
import { filterOf, lqrOf, sampledDesignOf } from '../design/scenarioControl.ts';
import { programOf, type ControllerProgram } from './program.ts';
import { modulus, type Complex, type Mode } from '../linearization/spectrum.ts';
import { marginsOf, type Margins } from '../margins.ts';

/** `Margins` as JSON has them: null where there is no bound (Infinity). */
export interface MarginsReport {
  /** s */
  delay: number | null;
  /** s */
  sampleTime: number | null;
  /** By input: factors, down and up. */
  gain: Record<string, [number, number | null]>;
  /** By input, rad. */
  phase: Record<string, number | null>;
  disc: number;
}

/** `x_{k+1} = A x_k + B u_k`, `u_k = -K x_k` on the reachable, seen quotient and the inputs on their way. */
export interface SampledReport {
  A: number[][];
  B: number[][];
  K: number[][];
  /** Of the closed loop's eigenvalues, descending. */
  moduli: number[];
  spectralRadius: number;
  /** Null where the gain is the continuous one. */
  riccatiResidual: number | null;
}

/** What a scenario's sensors see, and the Kalman filter of them. */
export interface EstimatorReport {
  sensors: readonly string[];
  /** How many of the dimensions that the constraints allow show in the sensors. */
  dimension: number;
  bySensor: { sensor: string; dimension: number }[];
  unseen: Mode[];
  /** Sensors whose errors are followed: these are the last of s. */
  biases: string[];
  /** On the seen part: `s' = A s + B u`, y = C s, s = fromStates x; what is estimated of x is toStates s. */
  A: number[][];
  B: number[][];
  C: number[][];
  /** Continuous: `s' = A s + B u + L (y - C s)`; sampled: `s += L (y - C s)` at a measurement. */
  L: number[][];
  fromStates: number[][];
  toStates: number[][];
  /** Of the estimate's error: eigenvalues (1/s) of a continuous filter, moduli from sample to sample of a sampled one. */
  eigenvalues: Complex[] | null;
  moduli: number[] | null;
  riccatiResidual: number;
}

/** What running a scenario's regulator on a computer takes, and what comes of the one that it names. */
export interface ComputerReport {
  /** Of the continuous gain, on the modes that its design placed; null without an lqr, or where there are none. */
  margins: MarginsReport | null;
  /** Null without `control.sample`. */
  sampled: SampledReport | null;
  /** Null without `control.sensors`. */
  estimator: EstimatorReport | null;
  /** What runs it; null without `control.sample`, and for a follower of a path, which changes with the place. */
  controller: ControllerProgram | null;
}

/**
 * @param scenario checked, SI
 * @param system that the scenario names
 * @throws ScenarioError where the design can't be had
 */
export function computerReport(scenario: Scenario, system: System): ComputerReport {
  if (scenario.control?.type !== 'lqr') return { margins: null, sampled: null, estimator: null, controller: null };
  const design = lqrOf(scenario, system);
  const { A, B } = design.quotient;
  const sampled = sampledDesignOf(scenario, design);
  return {
    margins: A.rows > 0 ? plain(marginsOf({ A, B, K: design.riccati.gain }, design.linearization.inputs)) : null,
    sampled: sampled && {
      A: sampled.A.to2DArray(),
      B: sampled.B.to2DArray(),
      K: sampled.K.to2DArray(),
      moduli: sampled.closedLoop.map(modulus),
      spectralRadius: sampled.spectralRadius,
      riccatiResidual: sampled.riccatiResidual,
    },
    estimator: estimatorReport(scenario, design),
    controller: scenario.control.path ? null : programOf(scenario, design),
  };
}

function estimatorReport(scenario: Scenario, design: LqrDesign): EstimatorReport | null {
  const found = filterOf(scenario, design);
  if (!found) return null;
  const { sensors, plant, filter } = found;
  const sampled = Boolean(scenario.control?.sample);
  return {
    sensors,
    dimension: plant.A.rows - (plant.biases ?? []).length,
    bySensor: plant.bySensor,
    unseen: plant.unseen,
    biases: (plant.biases ?? []).map(({ sensor }) => sensor),
    A: plant.A.to2DArray(),
    B: plant.B.to2DArray(),
    C: plant.C.to2DArray(),
    L: filter.gain.to2DArray(),
    fromStates: plant.fromStates.to2DArray(),
    toStates: plant.toStates.to2DArray(),
    eigenvalues: sampled ? null : filter.poles,
    moduli: sampled ? filter.poles.map(modulus) : null,
    riccatiResidual: filter.residual,
  };
}

const bounded = (x: number): number | null => (x < Infinity ? x : null);

function plain({ delay, sampleTime, gain, phase, disc }: Margins): MarginsReport {
  const byInput = <T, R>(record: Record<string, T>, make: (value: T) => R): Record<string, R> =>
    Object.fromEntries(Object.entries(record).map(([name, value]) => [name, make(value)]));
  return {
    delay: bounded(delay),
    sampleTime: bounded(sampleTime),
    gain: byInput(gain, ([down, up]): [number, number | null] => [down, bounded(up)]),
    phase: byInput(phase, bounded),
    disc,
  };
}
