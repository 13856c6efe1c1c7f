import type { System } from '../model/system.ts';

/** A state of a system, as plain data. */
export interface StateOfSystem {
  system: string;
  /** A constraint set's id; null: the system's first. */
  constraints: string | null;
  q: Float64Array;
  v: Float64Array;
  /** Parameters in the order of the meta. */
  p: Float64Array;
}

/** The terms of `M a = h + B u + Omega^T lambda`, `Omega a = -gamma` at one state; n coordinates, m constraint rows. */
export interface Terms {
  /** Mass matrix, n x n. */
  mass: Float64Array;
  h: Float64Array;
  /** m x n. */
  omega: Float64Array;
  gamma: Float64Array;
  /** J. */
  kinetic: number;
  potential: number;
  /** f of a system of first order. */
  rate: Float64Array | null;
}

/**
 * Evaluates a system's equations at one state.
 *
 * @param system whose equations they are
 */
export function termsOf(system: System, { constraints, q, v, p }: Omit<StateOfSystem, 'system'>): Terms {
  const n = system.meta.coordinates.length;
  const mass = new Float64Array(n * n);
  const h = new Float64Array(n);
  const energies = new Float64Array(2);
  system.mechanics(q, v, p, mass, h);
  system.energy(q, v, p, energies);
  const set = constraints === null ? Object.values(system.constraintSets)[0] : system.constraintSets[constraints];
  const m = set?.rows ?? 0;
  const omega = new Float64Array(m * n);
  const gamma = new Float64Array(m);
  set?.evaluate(q, v, p, omega, gamma);
  const rate = system.firstOrder ? new Float64Array(n) : null;
  system.firstOrder?.rate(q, p, rate!);
  return { mass, h, omega, gamma, kinetic: energies[0]!, potential: energies[1]!, rate };
}
