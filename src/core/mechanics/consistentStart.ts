import { cholesky, maxAbs, solveLower, solveLowerTransposed, symmetricEigenvalues } from '../linalg/dense.ts';
import { luFactor, luSolve } from '../linalg/lu.ts';
import { type ContactMeta, dependentWords, type System, type SystemMeta } from '../model/system.ts';
import { singularMassWords } from './singularMass.ts';
import { ConstrainedSystem } from './constrainedSystem.ts';
import { Projection } from './projection.ts';

/** A value that the start changed: what `initial` (or rest) said and what it became. */
export interface StartAdjustment {
  name: string;
  from: number;
  to: number;
  named: boolean;
}

export interface ConsistentStart {
  q: Float64Array;
  v: Float64Array;
  adjustments: StartAdjustment[];
  /** Things the person should know that are no change of a value. */
  notes: string[];
}

/** No start satisfies the constraints; the message says which and what would. */
export class StartError extends Error {
  override name = 'StartError';
}

/** Newton on the contact heights: metres below which both points are on the ground. */
const HEIGHT_GOAL = 1e-15;
/** Velocities that remain in conflict by more than this share of their size mean that the named ones contradict each other. */
const CONFLICT = 1e-9;
/** Directions of S weaker than this share of the strongest cannot be reached by the free velocities. */
const UNREACHABLE = 1e-11;

/**
 * Start on the constraint manifold.
 *
 * Positions: with contact, the coordinates named in `contact.solveFor` are solved by damped Newton so that
 * all heights vanish. Velocities: those that `initial` does not name take the smallest change in the mass
 * metric, `min 1/2 dv^T M dv` subject to `Omega (v + dv) = 0` over the free entries; if no such change
 * exists, all give way: `v - M^-1 Omega^T (Omega M^-1 Omega^T)^-1 Omega v`. Held velocities are zero, a clock's is 1.
 * In a system of first order the velocities are its rates.
 *
 * @param system whose constraints hold
 * @param parameters SI, in the meta's order
 * @param constraintSet id
 * @param hold positions of coordinates that are held
 * @param initial coordinates and rates by name, SI
 * @param at the system with these parameters and nothing acting on it, where there is one already
 * @throws StartError when the ground can't be reached or the constraints are dependent at the start
 */
export function consistentStart(
  system: System,
  parameters: Float64Array,
  constraintSet: string,
  hold: readonly number[],
  initial: Readonly<Record<string, number>>,
  at?: ConstrainedSystem,
): ConsistentStart {
  const { coordinates } = system.meta;
  const q = Float64Array.from(coordinates, (c) => initial[c.name] ?? c.rest ?? 0);
  const v = Float64Array.from(coordinates, (c) => initial[`${c.name}_dot`] ?? 0);
  if (system.firstOrder) {
    system.firstOrder.rate(q, parameters, v);
    for (const i of hold) v[i] = 0;
    return { q, v, adjustments: [], notes: [] };
  }
  const asked = { q: q.slice(), v: v.slice() };
  const notes: string[] = [];
  const standStill = (): void => {
    for (const i of hold) v[i] = 0;
    if (system.clock !== undefined) v[system.clock] = asked.v[system.clock] = 1;
  };
  standStill();

  const dynamics = at ?? new ConstrainedSystem(system, parameters, constraintSet, hold, null);
  const contact = dynamics.constraints?.contact;
  if (contact) {
    const free = hold.length > 0 ? new ConstrainedSystem(system, parameters, constraintSet, [], null) : dynamics;
    solveContact(free, contact, q);
  }
  if (dynamics.m > 0) {
    const free = coordinates.map((c, i) => !hold.includes(i) && initial[`${c.name}_dot`] === undefined);
    if (!moveFree(dynamics, q, v, free)) {
      notes.push('the named velocities contradict the constraints, so all velocities were projected onto them');
      v.set(asked.v);
      standStill();
    }
    if (!new Projection(dynamics).project(0, q, v)) {
      const dependentAtStart = (): string => {
        const which = `the constraints "${constraintSet}"`;
        // Without the held coordinates: then it is these that leave no room.
        const alone = hold.length > 0 ? new ConstrainedSystem(system, parameters, constraintSet, [], null) : dynamics;
        if (alone !== dynamics && new Projection(alone).project(0, q.slice(), v.slice()))
          return `${which} and the held coordinates are more than the motion has room for: hold fewer${orFree(system.meta)}`;
        return `${which} are dependent at this start${dependentWords(system.meta, constraintSet)}: change the start${orFree(system.meta)}`;
      };
      throw new StartError(
        dynamics.failure === 'constraint-singular'
          ? dependentAtStart()
          : `the mass matrix is singular at this start: ${singularMassWords(system, parameters, q, hold)}`,
      );
    }
  }
  if (constraintSet !== 'none' && system.clearance && system.clearance(q, parameters) < 0) {
    notes.push(`${system.meta.touchdown?.label ?? 'a part'} starts below the ground`);
  }
  return { q, v, adjustments: adjustmentsOf(system, initial, asked, q, v), notes };
}

function adjustmentsOf(
  system: System,
  initial: Readonly<Record<string, number>>,
  asked: { q: Float64Array; v: Float64Array },
  q: Float64Array,
  v: Float64Array,
): StartAdjustment[] {
  const list: StartAdjustment[] = [];
  const compare = (name: string, from: number, to: number): void => {
    // A last-digit change of the final projection is no news to anyone.
    if (Math.abs(to - from) > 1e-12 * Math.max(1, Math.abs(from)))
      list.push({ name, from, to, named: initial[name] !== undefined });
  };
  system.meta.coordinates.forEach((c, i) => compare(c.name, asked.q[i]!, q[i]!));
  system.meta.coordinates.forEach((c, i) => compare(`${c.name}_dot`, asked.v[i]!, v[i]!));
  return list;
}

/** Damped Newton for as many coordinates as there are contact heights; their gradients are rows of Omega. */
function solveContact(dynamics: ConstrainedSystem, contact: ContactMeta, q: Float64Array): void {
  const { system } = dynamics;
  const index = contact.solveFor.map((name) => system.meta.coordinates.findIndex((c) => c.name === name));
  const k = contact.count;
  const zero = new Float64Array(q.length);
  const J = new Float64Array(k * k);
  const step = new Float64Array(k);
  const pivots = new Int32Array(k);
  dynamics.refreshHeights(q);
  let size = maxAbs(dynamics.heights);
  for (let iteration = 0; iteration < 50 && size > HEIGHT_GOAL; iteration++) {
    dynamics.refreshOmega(q, zero);
    contact.rows.forEach((row, r) => index.forEach((c, s) => (J[r * k + s] = dynamics.omega[row * q.length + c]!)));
    for (let r = 0; r < k; r++) step[r] = -dynamics.heights[r]!;
    if (!luFactor(J, k, pivots)) break;
    luSolve(J, k, pivots, step);
    const before = index.map((c) => q[c]!);
    let damping = 1;
    let next = Infinity;
    for (; damping > 1e-4; damping /= 2) {
      index.forEach((c, s) => (q[c] = before[s]! + damping * step[s]!));
      dynamics.refreshHeights(q);
      next = maxAbs(dynamics.heights);
      if (next < size) break;
    }
    if (!(next < size)) {
      index.forEach((c, s) => (q[c] = before[s]!));
      break;
    }
    size = next;
  }
  // Rounding of heights made of terms of about a metre.
  if (!(size < 1e-12)) {
    const points = system.meta.constraintSets.find(({ id }) => id === dynamics.constraints?.id)?.contact?.points;
    const solved = contact.solveFor.join(' and ');
    if (system.meta.description !== undefined)
      throw new StartError(
        `no ${solved} brings ${points} to zero from this start (nearest: ${size.toPrecision(2)} m): start elsewhere, let another coordinate give way (solve …)${orFree(system.meta)}`,
      );
    throw new StartError(
      `no ${solved} puts ${points} on the ground for this attitude (best: ${size.toExponential(2)} m): change the attitude${orFree(system.meta)}`,
    );
  }
}

/** What is always possible, for a system that can do without constraints: a bicycle can't. */
const orFree = ({ constraintSets }: SystemMeta): string =>
  constraintSets.some(({ id }) => id === 'none') ? ', or choose constraints "none"' : '';

/** Smallest change of the free velocities that meets the constraints; false where there is none. */
function moveFree(d: ConstrainedSystem, q: Float64Array, v: Float64Array, free: readonly boolean[]): boolean {
  const { n, m } = d;
  d.evaluate(0, q, v);
  const index = [...free.keys()].filter((i) => free[i]);
  const k = index.length;
  const residual = new Float64Array(m);
  d.constraintVelocity(v, residual);
  const size = Math.max(1, maxAbs(v));
  if (maxAbs(residual) === 0) return true;
  const M = new Float64Array(k * k);
  index.forEach((i, r) => index.forEach((j, s) => (M[r * k + s] = d.massMatrix[i * n + j]!)));
  if (cholesky(M, k) !== 0) return false;
  const Y = Array.from({ length: m }, (_, r) => {
    const row = Float64Array.from(index, (j) => d.omega[r * n + j]!);
    solveLower(M, k, row);
    return row;
  });
  const w = pseudoSolve(Y, residual);
  const step = new Float64Array(k);
  for (let r = 0; r < m; r++) for (let s = 0; s < k; s++) step[s]! -= Y[r]![s]! * w[r]!;
  solveLowerTransposed(M, k, step);
  index.forEach((i, s) => (v[i]! += step[s]!));
  d.constraintVelocity(v, residual);
  return maxAbs(residual) < CONFLICT * size;
}

/** Least-norm solution of (Y Y^T) w = b through the eigenvectors of the small symmetric matrix. */
function pseudoSolve(Y: readonly Float64Array[], b: Float64Array): Float64Array {
  const m = Y.length;
  const S = new Float64Array(m * m);
  for (let r = 0; r < m; r++)
    for (let s = 0; s < m; s++) S[r * m + s] = Y[r]!.reduce((sum, y, k) => sum + y * Y[s]![k]!, 0);
  const V = new Float64Array(m * m);
  symmetricEigenvalues(S, m, V);
  let largest = 0;
  for (let r = 0; r < m; r++) largest = Math.max(largest, S[r * m + r]!);
  const w = new Float64Array(m);
  for (let e = 0; e < m; e++) {
    const value = S[e * m + e]!;
    if (!(value > UNREACHABLE * largest)) continue;
    let part = 0;
    for (let r = 0; r < m; r++) part += V[r * m + e]! * b[r]!;
    for (let r = 0; r < m; r++) w[r]! += (V[r * m + e]! * part) / value;
  }
  return w;
}
