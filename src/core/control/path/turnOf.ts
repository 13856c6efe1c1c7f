import { inputsOf } from '../../model/inputs.ts';
import type { System } from '../../model/system.ts';
import type { LqrControl, Scenario } from '../../scenario/types.ts';
import { plantOf } from '../design/scenarioControl.ts';
import { located } from '../linearization/preparedPlant.ts';
import { steadyTurn, type SteadyTurn } from './steadyTurn.ts';

/**
 * The steady turn of a scenario's follower at a curvature, held by its inputs.
 *
 * @param scenario checked, SI
 * @param system that the scenario names
 * @param control with a path
 * @param curvature of the turn, 1/m
 * @throws ScenarioError at `control.path` where there is no such turn
 */
export function turnOf(scenario: Scenario, system: System, control: LqrControl, curvature: number): SteadyTurn {
  const inputs = control.inputs.map((name) => inputsOf(system.meta).find((input) => input.name === name)!);
  return located('control.path', () =>
    steadyTurn(plantOf(scenario, system), control.at as Record<string, number>, curvature, inputs),
  );
}
