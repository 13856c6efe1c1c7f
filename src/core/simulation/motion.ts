import type { ConstrainedSystem } from '../mechanics/constrainedSystem.ts';
import type { StateMap } from '../mechanics/formulations/contract.ts';
import { formulations } from '../mechanics/formulations/formulations.ts';
import { createFormulation } from '../mechanics/formulations/registry.ts';
import { wasmStepper } from '../engine/choose.ts';
import { StabilizedDae } from '../mechanics/stabilizedDae.ts';
import { FirstOrder, FirstOrderResidual } from '../mechanics/firstOrder.ts';
import type { OdeProblem, Stepper } from '../integrators/contract.ts';
import { Ida } from '../integrators/multistep/ida.ts';
import { methods, type MethodInfo } from '../integrators/methods.ts';
import { createStepper } from '../integrators/registry.ts';
import { ScenarioError, type EngineId, type MethodOptions } from '../scenario/types.ts';

/** The formulation that WebAssembly is written for. */
const MULTIPLIERS: (typeof formulations)[number]['id'] = 'multipliers';

/** What a run advances in time, and what its y means. */
export interface Motion {
  /** What computes the steps. */
  engine: EngineId;
  map: StateMap;
  stepper: Stepper;
  /** The stepper's, for a projection of its steps' ends. `ida` has none: its residual is stabilized. */
  problem?: OdeProblem;
}

/**
 * Every stepper on every formulation, or `ida` on the residual as it is.
 *
 * A step of `ida` can pass over a state with dependent constraints: there only the run's event (or projection) stops it.
 *
 * @throws ScenarioError
 */
export function motionOf(method: MethodOptions, dynamics: ConstrainedSystem): Motion {
  const info = infoOf(method);
  if (dynamics.system.firstOrder) return firstOrderMotion(info, method, dynamics);
  if (info.id === 'ida') {
    if (method.formulation !== undefined)
      throw new ScenarioError('method.formulation', 'is for every method but ida, which takes the residual as it is');
    const dae = new StabilizedDae(dynamics);
    return { engine: 'typescript', map: dae, stepper: new Ida(dae, method) };
  }
  const id = method.formulation ?? formulations[0].id;
  const formulation = createFormulation(id, dynamics);
  if (!formulation)
    throw new ScenarioError(
      'method.formulation',
      `"${id}" is not available; right would be ${formulations.map((f) => f.id).join(', ')}`,
    );
  const wasm =
    method.engine !== 'typescript' && id === MULTIPLIERS ? wasmStepper(info.id, formulation, dynamics, method) : null;
  return {
    engine: wasm ? 'wasm' : 'typescript',
    map: formulation,
    stepper: wasm ?? createStepper(info.id, formulation, method)!,
    problem: formulation,
  };
}

/** There is nothing to formulate, so any formulation is the same. */
function firstOrderMotion({ id }: MethodInfo, method: MethodOptions, dynamics: ConstrainedSystem): Motion {
  const map = new FirstOrder(dynamics);
  return {
    engine: 'typescript',
    map,
    stepper: id === 'ida' ? new Ida(new FirstOrderResidual(map), method) : createStepper(id, map, method)!,
  };
}

function infoOf({ name, stages }: MethodOptions): MethodInfo {
  const info: MethodInfo | undefined = methods.find((m) => m.id === name);
  if (!info)
    throw new ScenarioError(
      'method.name',
      `"${name}" is not available; right would be ${methods.map((m) => m.id).join(', ')}`,
    );
  if (stages !== undefined && !info.stages?.includes(stages)) {
    throw new ScenarioError(
      'method.stages',
      info.stages
        ? `${info.id} has ${info.stages.join(', ')} stages, not ${stages}`
        : `${info.id} has no choice of stages; leave it out`,
    );
  }
  return info;
}
