import { consistentStart, type StartAdjustment } from '../../mechanics/consistentStart.ts';
import { ConstrainedSystem } from '../../mechanics/constrainedSystem.ts';
import { AccelerationJacobian } from '../../mechanics/formulations/accelerationJacobian.ts';
import { maxAbs } from '../../linalg/dense.ts';
import type { System } from '../../model/system.ts';
import { ControlError } from './matrices.ts';

/**
 * Steady motion: all velocities are constant, and nothing in the equations depends on the coordinates that move (a
 * board that rolls straight on, a wheel that spins). Rest is the plainest. About it the linearized equations have
 * constant coefficients, with the reference x_ref(t) = (q + v t, v).
 */
export interface SteadyMotion {
  readonly dynamics: ConstrainedSystem;
  /** At t = 0. */
  readonly q: Float64Array;
  readonly v: Float64Array;
  readonly lambda: Float64Array;
  /** Accelerations, where it is steady only as seen from the vehicle (a turn); left out they are zero. */
  readonly acceleration?: Float64Array;
  /** Names of the coordinates that move. */
  readonly moving: readonly string[];
  /** What the consistent start changed of what was asked for. */
  readonly adjustments: readonly StartAdjustment[];
}

/** What of a system stands still or rolls: everything a design needs to know of the scenario but its weights. */
export interface Plant {
  system: System;
  /** Values in the order of the meta. */
  parameters: Float64Array;
  constraints: string;
  /** Indices of held coordinates. */
  hold: readonly number[];
}

/**
 * Accelerations up to this share of what the forces would do to the free bodies are rounding. Angles typed with
 * fewer than ten digits are not the equilibrium, and are refused: expressions such as "-90 deg" are exact.
 */
const STILL = 1e-9;
/** Velocities below this share of the largest come from the projection's rounding. */
const MOVES = 1e-12;
/** How far to look along the motion, in units of the moving coordinates: no simple fraction of a turn. */
const AHEAD = [0.6180339887, 1.9021130326];

/**
 * The steady motion at the point that `at` names; what it leaves open comes from rest and the consistent start.
 *
 * @param plant system, parameters (SI), constraint set and what is held
 * @param at coordinates and rates by name, SI
 * @throws StartError where the point can't meet the constraints, ControlError where it is no steady motion
 */
export function steadyMotionAt(plant: Plant, at: Readonly<Record<string, number>>): SteadyMotion {
  const { system, parameters, constraints, hold } = plant;
  const { q, v, adjustments } = consistentStart(system, parameters, constraints, hold, at);
  const largest = maxAbs(v);
  for (let i = 0; i < v.length; i++) if (Math.abs(v[i]!) <= MOVES * largest) v[i] = 0;
  const dynamics = new ConstrainedSystem(system, parameters, constraints, hold, null);
  const names = system.meta.coordinates.map((c) => c.name);
  if (system.firstOrder) checkStill(system, parameters, q, v, names);
  const lambda = restingMultipliers(dynamics, q, v, names);
  checkCyclic(dynamics, q, v, names);
  return { dynamics, q, v, lambda, moving: names.filter((_, i) => v[i] !== 0), adjustments };
}

/** Of a system of first order only a rest is steady: its velocities are no states. */
function checkStill(
  system: System,
  parameters: Float64Array,
  q: Float64Array,
  v: Float64Array,
  names: readonly string[],
): void {
  const rate = new Float64Array(q.length);
  system.firstOrder!.rate(q, parameters, rate);
  const moving = [...rate.keys()].filter((i) => !(Math.abs(rate[i]!) <= STILL));
  if (moving.length > 0)
    throw new ControlError(refusal(moving.map((i) => `${names[i]!} by ${Number(rate[i]!.toPrecision(3))} per second`)));
  v.fill(0);
}

function refusal(rates: readonly string[]): string {
  return `this is no steady motion: without inputs it would change ${rates.join(', ')}; name a rest or a straight, steady motion`;
}

/** The multipliers of the motion; refuses one that accelerates. */
function restingMultipliers(
  d: ConstrainedSystem,
  q: Float64Array,
  v: Float64Array,
  names: readonly string[],
): Float64Array {
  const a = new Float64Array(d.n);
  const free = new Float64Array(d.n);
  const lambda = new Float64Array(d.m);
  if (!d.acceleration(0, q, v, a, lambda))
    throw new ControlError(`there is no acceleration at this point (${d.failure})`);
  const bodies = new ConstrainedSystem(d.system, d.parameters, 'none', d.held, null);
  if (bodies.acceleration(0, q, v, free, new Float64Array(0)) && maxAbs(a) <= STILL * Math.max(1, maxAbs(free)))
    return lambda;
  const worst = [...a.keys()]
    .sort((i, k) => Math.abs(a[k]!) - Math.abs(a[i]!))
    .filter((i) => Math.abs(a[i]!) > 0.01 * maxAbs(a));
  const rates = worst.slice(0, 3).map((i) => `${names[i]!}_dot by ${Number(a[i]!.toPrecision(3))} per second`);
  throw new ControlError(refusal(rates));
}

/** Refuses a motion whose equations change as it goes on. */
function checkCyclic(d: ConstrainedSystem, q: Float64Array, v: Float64Array, names: readonly string[]): void {
  const speed = maxAbs(v);
  if (speed === 0) return;
  const here = equationsAt(d, q, v);
  const size = maxAbs(here);
  const differs = (moved: Float64Array): boolean => {
    const there = equationsAt(d, moved, v);
    return there.some((x, i) => !(Math.abs(x - here[i]!) <= STILL * size));
  };
  for (const ahead of AHEAD) {
    if (!differs(q.map((x, i) => x + (ahead * v[i]!) / speed))) continue;
    const guilty = [...v.keys()].filter(
      (i) => v[i] !== 0 && differs(q.map((x, k) => (k === i ? x + (ahead * v[k]!) / speed : x))),
    );
    const name = (guilty.length > 0 ? guilty : [...v.keys()].filter((i) => v[i] !== 0))
      .map((i) => names[i]!)
      .join(', ');
    throw new ControlError(`this is no steady motion: the equations depend on ${name}, which moves at this point`);
  }
}

/** The Jacobian of the motion and of the constraints at a state, as one list of numbers. */
function equationsAt(d: ConstrainedSystem, q: Float64Array, v: Float64Array): Float64Array {
  const { n, m } = d;
  const jacobian = new AccelerationJacobian(d);
  const all = new Float64Array(4 * n * n + 2 * m * n).fill(NaN);
  if (!jacobian.ofState(0, q, v, all.subarray(0, 4 * n * n))) return all;
  if (m > 0) {
    d.refreshOmega(q, v);
    all.set(d.omega, 4 * n * n);
    all.set(jacobian.velocityQ, 4 * n * n + m * n);
  }
  return all;
}
