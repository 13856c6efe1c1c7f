import { ConstrainedSystem } from '../src/core/mechanics/constrainedSystem.ts';
import { consistentStart } from '../src/core/mechanics/consistentStart.ts';
import { actuationOf } from '../src/core/simulation/actuation.ts';
import type { Forcing } from '../src/core/mechanics/forcing.ts';
import { systems } from '../src/core/systems/all.ts';
import { scenarioOf } from './helpers.ts';

/** A scenario's mechanics with its consistent start; `forcing` in place of its inputs where it is given. */
export function mechanicsOf(raw: unknown, forcing?: Forcing) {
  const scenario = scenarioOf(raw);
  const system = systems[scenario.system]!;
  const { meta } = system;
  const parameters = Float64Array.from(meta.parameters, (p) => scenario.parameters[p.name]!);
  const hold = scenario.hold.map((name) => meta.coordinates.findIndex((c) => c.name === name));
  const { q, v } = consistentStart(system, parameters, scenario.constraints, hold, scenario.initial);
  const dynamics = new ConstrainedSystem(
    system,
    parameters,
    scenario.constraints,
    hold,
    forcing ?? actuationOf(scenario, system.meta).forcing,
  );
  return { scenario, dynamics, q, v, n: dynamics.n };
}
