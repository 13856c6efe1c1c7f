import { inputsOf } from '../../model/inputs.ts';
import { ScenarioError, type LqrControl, type Scenario } from '../../scenario/types.ts';
import type { InputMeta, System, SystemMeta } from '../../model/system.ts';
import { designLqr, type LqrDesign, type Weights } from './lqr.ts';
import { located, preparedPlant, type PreparedPlant } from '../linearization/preparedPlant.ts';
import { heldDesign, sampledLqr, type SampledDesign } from '../sampled/sampledLqr.ts';
import type { Plant, SteadyMotion } from '../linearization/steadyMotion.ts';

/** What a scenario says about its plant, its operating point and its controller, as the control code takes it. */

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
 * @throws ScenarioError with the path of the point that is none
 */
export function operatingPoint(scenario: Scenario, system: System): SteadyMotion {
  return preparedOf(scenario, system).motion;
}

/** The plant at that point, with the inputs that a linearization is for. @throws ScenarioError as `operatingPoint` */
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

/** The inputs that a linearization is for: the controller's, or all that the system names. */
export function linearizedInputs(scenario: Scenario, meta: SystemMeta): InputMeta[] {
  const { control } = scenario;
  if (control?.type !== 'lqr') return [...meta.inputs];
  const all = inputsOf(meta);
  return control.inputs.map((name) => all.find((input) => input.name === name)!);
}

/** Q is the identity if none is given, and 0 for unnamed states if some are; R is 1 where it is not given. */
export function weightsOf(control: LqrControl, meta: SystemMeta): Weights {
  const names = meta.coordinates.map((c) => c.name);
  const states = [...names, ...names.map((name) => `${name}_dot`)];
  const named = Object.keys(control.Q ?? {}).length > 0 ? control.Q! : null;
  return {
    Q: states.map((name) => (named ? Number(named[name] ?? 0) : 1)),
    R: control.inputs.map((name) => Number(control.R?.[name] ?? 1)),
  };
}

/** @throws ScenarioError at `control.at` for a point that is no steady motion, at `control` for a design that can't be had */
export function lqrOf(scenario: Scenario, system: System): LqrDesign {
  const { control } = scenario;
  if (control?.type !== 'lqr') throw new ScenarioError('control', 'must be of type "lqr"');
  const prepared = preparedOf(scenario, system);
  return located('control', () => designLqr(prepared.plant, weightsOf(control, system.meta)));
}

/**
 * A scenario's regulator as its computer runs it; null where it has no `control.sample`.
 * @throws ScenarioError at `control` where there is no sampled design
 */
export function sampledDesignOf({ control }: Scenario, design: LqrDesign): SampledDesign | null {
  if (control?.type !== 'lqr' || !control.sample) return null;
  const { sample, delay = 0 } = control;
  return located('control', () =>
    control.design === 'sampled' ? sampledLqr(design, sample, delay) : heldDesign(design, sample, delay),
  );
}
