import { feedbackOf } from '../core/control/design/feedback.ts';
import type { Scenario } from '../core/scenario/types.ts';
import '../core/simulation/everyMotion.ts';
import { Simulation } from '../core/simulation/simulation.ts';
import type { System } from '../core/model/system.ts';

/** What `point` prints; matrices as rows. */
export interface PointReport {
  q: number[];
  v: number[];
  acceleration: number[];
  multipliers: number[];
  massMatrix: number[][];
  kinetic: number;
  potential: number;
  positions: number[][];
}

/** State after the consistent start, with accelerations, multipliers, the free system's mass matrix, energies, body positions. */
export function point(scenario: Scenario, system: System): PointReport {
  const { q, v, dynamics } = new Simulation(scenario, system, { feedback: feedbackOf(scenario, system) });
  const n = q.length;
  const acceleration = new Float64Array(n);
  const multipliers = new Float64Array(dynamics.m);
  if (!dynamics.acceleration(0, q, v, acceleration, multipliers)) {
    throw new Error(`no acceleration at t = 0: ${dynamics.failure}`);
  }
  const massMatrix = new Float64Array(n * n);
  const h = new Float64Array(n);
  system.mechanics(q, v, dynamics.parameters, massMatrix, h);
  const energies = new Float64Array(2);
  system.energy(q, v, dynamics.parameters, energies);
  const poses = new Float64Array(12 * system.meta.bodies.length);
  system.poses(q, dynamics.parameters, poses);
  return {
    q: [...q],
    v: [...v],
    acceleration: [...acceleration],
    multipliers: [...multipliers],
    massMatrix: Array.from({ length: n }, (_, r) => [...massMatrix.subarray(r * n, (r + 1) * n)]),
    kinetic: energies[0]!,
    potential: energies[1]!,
    positions: system.meta.bodies.map((_, b) => [...poses.subarray(12 * b, 12 * b + 3)]),
  };
}
