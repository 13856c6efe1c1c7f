import { embeddedPairs } from '../integrators/explicit.ts';
import type { OdeProblem, StepperOptions } from '../integrators/contract.ts';
import type { ConstrainedSystem } from '../mechanics/constrainedSystem.ts';
import { machineFor } from './machine.ts';
import { WasmRungeKutta } from './wasmRungeKutta.ts';

/**
 * The stepper that does in WebAssembly what the method's own does in TypeScript, to the bit.
 *
 * @param id of the method
 * @param problem the formulation with multipliers of these dynamics, y = [q, v]
 * @param dynamics the equations that the problem is made of
 * @param options tolerances and steps
 * @returns null where there is none: another family of methods, a system without a tape, held coordinates, or a host that
 *   refuses WebAssembly
 */
export function wasmStepper(
  id: string,
  problem: OdeProblem,
  dynamics: ConstrainedSystem,
  options: StepperOptions,
): WasmRungeKutta | null {
  const tableau = Object.hasOwn(embeddedPairs, id) ? embeddedPairs[id as keyof typeof embeddedPairs] : null;
  const { direct, constraints, n } = dynamics;
  const tape = direct?.direct.tape;
  if (!tableau || !tape || !constraints) return null;
  const machine = machineFor(tape, constraints.id, tableau, constraints.contact, n, direct.forced);
  if (!machine) return null;
  return new WasmRungeKutta(problem, options, tableau, {
    dynamics,
    machine,
    constants: direct.constants,
    forces: direct.forced ? (t, q, v, out) => direct.forces(t, q, v, out) : null,
  });
}
