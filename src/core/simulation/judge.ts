import { ConstrainedSystem } from '../mechanics/constrainedSystem.ts';
import { Projection } from '../mechanics/projection.ts';
import { driftOf } from './energyBalance.ts';
import type { System } from '../model/system.ts';

/** How well recorded numbers keep energy and constraints. */
export interface Judgement {
  /** (E at the end - E at the start) / largest kinetic energy; null for a system at rest, where that means nothing. */
  energyDrift: number | null;
  /** E at the end - E at the start, J. */
  energyChange: number;
  /** Largest of |Omega v| (m/s) and |contact heights| (m). */
  residual: number;
}

/**
 * Judges a motion by the system's own equations, from coordinates and velocities alone.
 *
 * @param system by whose equations it is judged
 * @param parameters by name, SI
 * @param constraints id of the constraint set
 * @param column values of a named column, or undefined
 * @returns null when a velocity is not recorded (positions alone tell neither), and for a system of first order
 */
export function judgeMotion(
  system: System,
  parameters: Readonly<Record<string, number>>,
  constraints: string,
  column: (name: string) => Float64Array | undefined,
): Judgement | null {
  const { coordinates, order } = system.meta;
  if (order === 1) return null;
  const positions = coordinates.map((c) => column(c.name));
  const velocities = coordinates.map((c) => column(`${c.name}_dot`));
  const rows = positions[0]?.length ?? 0;
  if (rows === 0 || [...positions, ...velocities].some((c) => c === undefined)) return null;
  const p = Float64Array.from(system.meta.parameters, (m) => parameters[m.name] ?? m.default);
  const projection = new Projection(new ConstrainedSystem(system, p, constraints, [], null));
  const q = new Float64Array(coordinates.length);
  const v = new Float64Array(coordinates.length);
  const energies = new Float64Array(2);
  let first = 0;
  let kinetic = 0;
  let size = 0;
  let residual = 0;
  for (let row = 0; row < rows; row++) {
    for (let i = 0; i < q.length; i++) {
      q[i] = positions[i]![row]!;
      v[i] = velocities[i]![row]!;
    }
    system.energy(q, v, p, energies);
    if (row === 0) first = energies[0]! + energies[1]!;
    kinetic = Math.max(kinetic, energies[0]!);
    size = Math.max(size, Math.abs(energies[1]!));
    residual = Math.max(residual, projection.residual(q, v));
  }
  const energyChange = energies[0]! + energies[1]! - first;
  const energyDrift = system.clock === undefined ? driftOf(energyChange, kinetic, size) : null;
  return { energyDrift, energyChange, residual };
}
