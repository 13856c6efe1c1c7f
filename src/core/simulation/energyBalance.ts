import type { Forcing } from '../mechanics/forcing.ts';
import type { ConstrainedSystem } from '../mechanics/constrainedSystem.ts';
import type { System } from '../model/system.ts';

/**
 * A kinetic energy below this part of the energy's own size is rounding of a system at rest: an energy drift beside it
 * would say nothing.
 */
const AT_REST = 1e-10;

/** W at a time and state. */
export type Power = (t: number, q: Float64Array, v: Float64Array) => number;

/** What energy did over a motion. */
export interface EnergyNumbers {
  /**
   * (E - E at the start) / largest kinetic energy so far, of a system that is driven (E - E at the start - work); null for a
   * system at rest: there that means nothing.
   */
  energyDrift: number | null;
  /** E - E at the start, J. */
  energyChange: number;
  /**
   * What inputs, controllers, pushes, drives and forces of a description put in, J; null where nothing acts. `energyChange - work` is what dampers took and what
   * the method lost.
   */
  work: number | null;
}

/** Nodes and weights of Gauss and Legendre's quadrature with three points on [0, 1]: exact to degree 5, as the dense outputs are. */
const NODES = [0.5 - Math.sqrt(0.15), 0.5, 0.5 + Math.sqrt(0.15)] as const;
const WEIGHTS = [5 / 18, 4 / 9, 5 / 18] as const;

/** Keeps the energies of a run's rows, and the work of what acts from outside step by step. */
export class EnergyBalance {
  private start = NaN;
  private energy = NaN;
  private largestKinetic = 0;
  private largestSize = 0;
  private work = 0;
  private readonly forcing: Forcing | null;
  private readonly power: Power | null;
  private readonly force: Float64Array;

  /**
   * @param n coordinates
   * @param power what the system's own forces and drives put in, W
   */
  constructor(forcing: Forcing | null, n: number, power: Power | null = null) {
    this.forcing = forcing;
    this.power = power;
    this.force = new Float64Array(n);
  }

  /** A row's kinetic and potential energy, J. */
  row(kinetic: number, potential: number): void {
    this.energy = kinetic + potential;
    if (Number.isNaN(this.start)) this.start = this.energy;
    this.largestKinetic = Math.max(this.largestKinetic, kinetic);
    this.largestSize = Math.max(this.largestSize, Math.abs(potential));
  }

  /** Adds the work over a step. @param at puts the state at a time into q and v */
  step(from: number, to: number, q: Float64Array, v: Float64Array, at: (t: number) => void): void {
    const { forcing, force } = this;
    if (!forcing && !this.power) return;
    for (let k = 0; k < NODES.length; k++) {
      const t = from + NODES[k]! * (to - from);
      at(t);
      force.fill(0);
      forcing?.(t, q, v, force);
      let power = this.power?.(t, q, v) ?? 0;
      for (let i = 0; i < force.length; i++) power += force[i]! * v[i]!;
      this.work += WEIGHTS[k]! * (to - from) * power;
    }
  }

  get numbers(): EnergyNumbers {
    const energyChange = this.energy - this.start;
    const lost = this.power ? energyChange - this.work : energyChange;
    return {
      energyDrift: driftOf(lost, this.largestKinetic, this.largestSize),
      energyChange,
      work: this.forcing || this.power ? this.work : null,
    };
  }
}

/**
 * An energy change beside the largest kinetic energy, or null for a system at rest.
 *
 * @param change of the energy, J
 * @param kinetic largest kinetic energy, J
 * @param size the largest energy, J
 */
export function driftOf(change: number, kinetic: number, size: number): number | null {
  return kinetic > AT_REST * size && kinetic > 0 ? change / kinetic : null;
}

/**
 * What drives and forces of the system itself put in, W; null where there are none.
 *
 * @param system that the run is of
 * @param dynamics looks at each state; none that steps are taken with
 */
export function outsidePowerOf(system: System, dynamics: ConstrainedSystem): Power | null {
  if (!system.outsidePower) return null;
  const a = new Float64Array(dynamics.n);
  const lambda = new Float64Array(dynamics.m);
  return (t, q, v) => {
    if (system.clock !== undefined && !dynamics.acceleration(t, q, v, a, lambda)) return NaN;
    let power = system.outsidePower!(q, v, a, dynamics.parameters);
    if (system.clock !== undefined) for (let r = 0; r < dynamics.m; r++) power -= lambda[r]! * dynamics.drift[r]!;
    return power;
  };
}
