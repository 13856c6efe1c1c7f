import type { ConstrainedSystem } from '../mechanics/constrainedSystem.ts';
import { FirstOrder } from '../mechanics/firstOrder.ts';
import type { StateMap } from '../mechanics/formulations/contract.ts';
import type { formulations } from '../mechanics/formulations/formulations.ts';
import { Multipliers } from '../mechanics/formulations/multipliers.ts';
import type { Projection } from '../mechanics/projection.ts';
import type { OdeProblem, Stepper } from '../integrators/contract.ts';
import { explicitSteppers } from '../integrators/explicit.ts';
import { methods, type MethodInfo } from '../integrators/methods.ts';
import { ScenarioError, type EngineId, type MethodOptions } from '../scenario/types.ts';

/** The formulation that WebAssembly is written for, and that is taken where none is named. */
export const MULTIPLIERS: (typeof formulations)[number]['id'] = 'multipliers';

/** What a run advances in time, and what its y means. */
export interface Motion {
  /** What computes the steps. */
  engine: EngineId;
  map: StateMap;
  stepper: Stepper;
  /** The stepper's, for a projection of its steps' ends. `ida` has none: its residual is stabilized. */
  problem?: OdeProblem;
  /** What projects rows, where it is not the dynamics' own. */
  rowProjection?: (dynamics: ConstrainedSystem) => Projection;
}

export type MakeMotion = (info: MethodInfo, method: MethodOptions, dynamics: ConstrainedSystem) => Motion;

/** Makes every motion, once `everyMotion.ts` is imported; until then explicit methods on multipliers alone. */
let make: MakeMotion = plainMotion;

/** @param maker in place of the one that makes plain motions only */
export function makeMotionsBy(maker: MakeMotion): void {
  make = maker;
}

/** Whether a method asks for more than explicit steps on multipliers in TypeScript. */
export const needsEveryMotion = ({ name, formulation = MULTIPLIERS }: MethodOptions): boolean =>
  !Object.hasOwn(explicitSteppers, name) || formulation !== MULTIPLIERS;

/** The same of a whole scenario: exponentials in it may cancel, which is rewritten there. */
export const needsEverything = (scenario: { readonly method: MethodOptions }): boolean =>
  needsEveryMotion(scenario.method) || /exp|sinh|cosh/.test(JSON.stringify(scenario));

/**
 * What advances a run.
 *
 * A step of `ida` can pass over a state with dependent constraints: there only the run's event (or projection) stops it.
 *
 * @param method name, tolerances, formulation and engine
 * @param dynamics the constrained system that is to be advanced
 * @throws ScenarioError
 */
export function motionOf(method: MethodOptions, dynamics: ConstrainedSystem): Motion {
  return make(infoOf(method), method, dynamics);
}

/** Explicit steps on multipliers in TypeScript: what the first run of a page takes, before the rest is loaded. */
function plainMotion({ id }: MethodInfo, method: MethodOptions, dynamics: ConstrainedSystem): Motion {
  if (needsEveryMotion(method)) throw new Error(`${id} is not loaded here: import simulation/everyMotion.ts`);
  const create = explicitSteppers[id as keyof typeof explicitSteppers];
  if (dynamics.system.firstOrder) {
    const map = new FirstOrder(dynamics);
    return { engine: 'typescript', map, stepper: create(map, method) };
  }
  const formulation = new Multipliers(dynamics);
  return { engine: 'typescript', map: formulation, stepper: create(formulation, method), problem: formulation };
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
