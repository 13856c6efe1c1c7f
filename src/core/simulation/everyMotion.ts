/**
 * Every method on every formulation, by either engine, and formulas without differences that cancel. Imported, it serves every run of the program; the page's first
 * run alone does without, for it should be seen soon.
 */
import type { ConstrainedSystem } from '../mechanics/constrainedSystem.ts';
import { formulations } from '../mechanics/formulations/formulations.ts';
import { createFormulation } from '../mechanics/formulations/registry.ts';
import { wasmStepper } from '../engine/choose.ts';
import { StabilizedDae } from '../mechanics/stabilizedDae.ts';
import { FirstOrder, FirstOrderResidual } from '../mechanics/firstOrder.ts';
import { Ida } from '../integrators/multistep/ida.ts';
import type { MethodInfo } from '../integrators/methods.ts';
import { createStepper } from '../integrators/registry.ts';
import { rewriteBy } from '../scenario/expressions.ts';
import { withoutDifferences } from '../scenario/expressions/differences.ts';
import { ScenarioError, type MethodOptions } from '../scenario/types.ts';
import { makeMotionsBy, MULTIPLIERS, type Motion } from './motion.ts';

makeMotionsBy(everyMotion);
rewriteBy(withoutDifferences);

/** Every stepper on every formulation, or `ida` on the residual as it is. @throws ScenarioError */
function everyMotion(info: MethodInfo, method: MethodOptions, dynamics: ConstrainedSystem): Motion {
  if (dynamics.system.firstOrder) return firstOrderMotion(info, method, dynamics);
  if (info.id === 'ida') {
    if (method.formulation !== undefined)
      throw new ScenarioError('method.formulation', 'is for every method but ida, which takes the residual as it is');
    const dae = new StabilizedDae(dynamics);
    return { engine: 'typescript', map: dae, stepper: new Ida(dae, method) };
  }
  const id = method.formulation ?? MULTIPLIERS;
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
    ...(wasm ? { rowProjection: (rows: ConstrainedSystem) => wasm.projectionOf(rows) } : {}),
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
