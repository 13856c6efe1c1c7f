import { Matrix } from 'ml-matrix';
import { inputsOf } from '../../model/inputs.ts';
import { MOST_MEMORY } from '../../scenario/computer.ts';
import { Formula } from '../../scenario/formula.ts';
import { ScenarioError, type LqrControl, type Scenario, type Sensor } from '../../scenario/types.ts';
import type { InputMeta, System, SystemMeta } from '../../model/system.ts';
import { designLqr, type LqrDesign, type Weights } from './lqr.ts';
import { located, preparedPlant, type PreparedPlant } from '../linearization/preparedPlant.ts';
import {
  continuousKalman,
  observedPlant,
  sampledKalman,
  withBiases,
  type KalmanFilter,
  type ObservedPlant,
} from '../sampled/kalman.ts';
import { heldDesign, sampledLqr, type SampledDesign, type Timing } from '../sampled/sampledLqr.ts';
import type { Plant, SteadyMotion } from '../linearization/steadyMotion.ts';

// What a scenario says about its plant, its operating point and its controller, as the control code takes it.

/**
 * The scenario's system with its parameters and constraint set.
 *
 * @param scenario checked, SI
 * @param system that the scenario names
 */
export function plantOf(scenario: Scenario, system: System): Plant {
  const { meta } = system;
  return {
    system,
    parameters: Float64Array.from(meta.parameters, (p) => scenario.parameters[p.name]!),
    constraints: scenario.constraints,
    hold: scenario.hold.map((name) => meta.coordinates.findIndex((c) => c.name === name)),
  };
}

/**
 * The steady motion at `control.at`, or at `at` without an lqr.
 *
 * @param scenario checked, SI
 * @param system that the scenario names
 * @throws ScenarioError with the path of the point that is none
 */
export function operatingPoint(scenario: Scenario, system: System): SteadyMotion {
  return preparedOf(scenario, system).motion;
}

/**
 * The plant at that point, with the inputs that a linearization is for.
 *
 * @param scenario checked, SI
 * @param system that the scenario names
 * @throws ScenarioError as `operatingPoint`
 */
export function preparedOf(scenario: Scenario, system: System): PreparedPlant {
  const { control } = scenario;
  const [path, at] = control?.type === 'lqr' ? ['control.at', control.at ?? {}] : ['at', scenario.at];
  return preparedPlant(
    plantOf(scenario, system),
    at as Record<string, number>,
    linearizedInputs(scenario, system.meta),
    path,
  );
}

/**
 * The inputs that a linearization is for: the controller's, or all that the system names.
 *
 * @param scenario checked, SI
 * @param meta of the system
 */
export function linearizedInputs(scenario: Scenario, meta: SystemMeta): InputMeta[] {
  const { control } = scenario;
  if (control?.type !== 'lqr') return [...meta.inputs];
  const all = inputsOf(meta);
  return control.inputs.map((name) => all.find((input) => input.name === name)!);
}

/**
 * Q is the identity if none is given, and 0 for unnamed states if some are; R is 1 where it is not given.
 *
 * @param control the scenario's own
 * @param meta of the system
 */
export function weightsOf(control: LqrControl, meta: SystemMeta): Weights {
  const names = meta.coordinates.map((c) => c.name);
  const states = [...names, ...names.map((name) => `${name}_dot`)];
  const named = Object.keys(control.Q ?? {}).length > 0 ? control.Q! : null;
  return {
    Q: states.map((name) => (named ? Number(named[name] ?? 0) : 1)),
    R: control.inputs.map((name) => Number(control.R?.[name] ?? 1)),
  };
}

/**
 * @param scenario checked, SI
 * @param system that the scenario names
 * @throws ScenarioError at `control.at` for a point that is no steady motion, at `control` for a design that can't be had
 */
export function lqrOf(scenario: Scenario, system: System): LqrDesign {
  const { control } = scenario;
  if (control?.type !== 'lqr') throw new ScenarioError('control', 'must be of type "lqr"');
  const prepared = preparedOf(scenario, system);
  return located('control', () => designLqr(prepared.plant, weightsOf(control, system.meta)));
}

/**
 * A scenario's regulator as its computer runs it; null where it has no `control.sample`, or holds the continuous gain with
 * more inputs on their way than a matrix is to be made of.
 *
 * @param design the continuous lqr
 * @throws ScenarioError at `control` where there is no sampled design
 */
export function sampledDesignOf({ control }: Scenario, design: LqrDesign): SampledDesign | null {
  if (control?.type !== 'lqr' || !control.sample) return null;
  const timing = timingOf(control);
  if (timing.delay > MOST_MEMORY * timing.sample && control.design !== 'sampled') return null;
  return located('control', () =>
    control.design === 'sampled' ? sampledLqr(design, timing) : heldDesign(design, timing),
  );
}

export function timingOf({ sample = 0, delay = 0, inputs, actuators = {} }: LqrControl): Required<Timing> {
  return { sample, delay, lags: inputs.map((name) => actuators[name]?.lag ?? 0) };
}

/** The Kalman filter of a scenario's sensors: sampled where its controller is. */
export interface FilterDesign {
  readonly sensors: readonly string[];
  readonly plant: ObservedPlant;
  readonly filter: KalmanFilter;
  /** Of the noise: per sample, or per √Hz of a continuous filter. */
  readonly deviations: readonly number[];
}

/**
 * Null without `control.sensors`.
 * @throws ScenarioError at `control.sensors`
 */
export function filterOf({ control }: Scenario, { linearization }: LqrDesign): FilterDesign | null {
  if (control?.type !== 'lqr' || !control.sensors) return null;
  const { sensors, process, sample } = control;
  const { states, motion } = linearization;
  const names = Object.keys(sensors);
  const state = [...motion.q, ...motion.v];
  const rows = names.map((text) => {
    const formula = new Formula(text, states);
    return states.map((_, i) => formula.slope(state, i));
  });
  const intensities = states.map((name) => (process ? (process[name] ?? 0) : 1));
  return located('control.sensors', () => {
    const plant = withBiases(observedPlant(linearization, new Matrix(rows), names), sensors);
    const deviations = Object.values(sensors).map((sensor) => deviationOf(sensor, sample));
    const filter = sample
      ? sampledKalman(plant, intensities, deviations, sample)
      : continuousKalman(plant, intensities, deviations);
    return { sensors: names, plant, filter, deviations };
  });
}

/**
 * What a filter takes for a sensor's noise: per sample, or per √Hz without a sample time. Rounding to steps is noise of a
 * twelfth of their square (Åström and Wittenmark, section 9.8).
 *
 * @param sensor the scenario's own
 * @param sample s; undefined for a continuous filter
 */
export function deviationOf({ noise, density = 0, resolution = 0 }: Sensor, sample: number | undefined): number {
  if (!sample) return density;
  return Math.hypot(noise ?? density / Math.sqrt(sample), resolution / Math.sqrt(12));
}
