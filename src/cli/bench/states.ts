import { ConstrainedSystem } from '../../core/mechanics/constrainedSystem.ts';
import { Projection } from '../../core/mechanics/projection.ts';
import { checkScenario } from '../../core/scenario/schema.ts';
import type { Scenario } from '../../core/scenario/types.ts';
import { systems } from '../../core/systems/all.ts';

const metas = Object.fromEntries(Object.entries(systems).map(([id, system]) => [id, system.meta]));

export function scenarioOf(raw: unknown): Scenario {
  return checkScenario(raw, metas);
}

/** The dynamics of a scenario without inputs. */
export function dynamicsOf(scenario: Scenario, way: 'shortest' | 'general' = 'shortest'): ConstrainedSystem {
  const system = systems[scenario.system]!;
  const { coordinates, parameters } = system.meta;
  const p = Float64Array.from(parameters, (m) => scenario.parameters[m.name]!);
  const hold = scenario.hold.map((name) => coordinates.findIndex((c) => c.name === name));
  return new ConstrainedSystem(system, p, scenario.constraints, hold, null, way);
}

/** Mulberry32: a small seeded generator of numbers from 0 to 1. */
export function seeded(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), state | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

export interface State {
  q: Float64Array;
  v: Float64Array;
}

/** Angles and positions drawn from -RANGE to RANGE: no two states alike, all within one chart of independent speeds. */
const RANGE = 0.35;

/** States on the constraints, drawn from a seed. */
export function consistentStates(dynamics: ConstrainedSystem, count: number, seed: number): State[] {
  const random = seeded(seed);
  const projection = new Projection(dynamics);
  return Array.from({ length: count }, () => {
    const q = Float64Array.from({ length: dynamics.n }, () => RANGE * (2 * random() - 1));
    const v = Float64Array.from({ length: dynamics.n }, () => 2 * random() - 1);
    for (const i of dynamics.held) v[i] = 0;
    // One projection's fixed factors do not reach the ground from far away.
    for (let k = 0; k < 20; k++)
      if (!projection.project(0, q, v)) throw new Error(`no consistent state: ${dynamics.failure}`);
    return { q, v };
  });
}
