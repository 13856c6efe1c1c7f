/** The matrices of a system at one moment of a motion. */
import type { Motion } from '../../app/runs/motion.ts';
import { inputsOf } from '../../core/model/inputs.ts';
import { cholesky, solveLower, solveLowerTransposed, symmetricEigenvalues } from '../../core/linalg/dense.ts';
import type { StateOfSystem, Terms } from '../../core/mechanics/terms.ts';
import { sample } from '../../ui/slowTime.ts';

/** All in SI units and radians; n coordinates, m constraint rows. */
export interface Present extends Omit<Terms, 'gamma'> {
  n: number;
  m: number;
  /** Largest over smallest eigenvalue of M, or null where M is not positive definite. */
  condition: number | null;
  /** B u, or null where the motion does not say what its inputs are. */
  inputs: Float64Array | null;
  /** What the constraint rows make of the velocities: zero but for rounding. */
  slip: Float64Array;
  /** Null where they can be had neither from the motion nor by computing them. */
  lambda: Float64Array | null;
  /** Whether lambda was computed here rather than read from the motion. */
  computed: boolean;
}

/** The state to evaluate the equations at; null where the motion has no whole state at that time. */
export function stateAt(motion: Motion, time: number): StateOfSystem | null {
  const { meta } = motion.system;
  const names = meta.coordinates.map(({ name }) => name);
  const q = columnsAt(motion, names, time);
  const v = columnsAt(
    motion,
    names.map((name) => `${name}_dot`),
    time,
  );
  if (!q || !v) return null;
  const p = Float64Array.from(meta.parameters, ({ name, default: value }) => motion.parameters[name] ?? value);
  return { system: meta.id, constraints: motion.constraints, q, v, p };
}

/** What the terms at a state of a motion amount to. */
export function presentOf({ gamma, ...terms }: Terms, { v }: StateOfSystem, motion: Motion, time: number): Present {
  const { mass, h, omega } = terms;
  const [n, m] = [v.length, gamma.length];
  const inputs = forcesAt(motion, time);
  const slip = Float64Array.from({ length: m }, (_, r) =>
    v.reduce((sum, rate, i) => sum + omega[r * n + i]! * rate, 0),
  );
  const recorded = columnsAt(
    motion,
    Array.from({ length: m }, (_, r) => `lambda_${r + 1}`),
    time,
  );
  const held = (motion.scenario?.hold.length ?? 0) > 0;
  const lambda = recorded ?? (inputs && !held && m > 0 ? multipliers(mass, h, inputs, omega, gamma, n, m) : null);
  return {
    ...terms,
    n,
    m,
    condition: conditionOf(mass, n),
    inputs,
    slip,
    lambda,
    computed: recorded === null && lambda !== null,
  };
}

function columnsAt({ trajectory }: Motion, names: readonly string[], time: number): Float64Array | null {
  const values = names.map((name) => sample(trajectory, name, time));
  return values.every((x) => x !== null && Number.isFinite(x)) ? Float64Array.from(values as number[]) : null;
}

/** B u from the recorded inputs; a scenario without any has none. */
function forcesAt(motion: Motion, time: number): Float64Array | null {
  const { meta } = motion.system;
  const known = inputsOf(meta).filter(({ name }) => motion.trajectory.has(name));
  if (known.length === 0 && motion.scenario === null) return null;
  const force = new Float64Array(meta.coordinates.length);
  for (const { name, column } of known) {
    const u = sample(motion.trajectory, name, time);
    if (u === null || !Number.isFinite(u)) return null;
    meta.coordinates.forEach((c, i) => (force[i]! += (column[c.name] ?? 0) * u));
  }
  return force;
}

function conditionOf(mass: Float64Array, n: number): number | null {
  const work = mass.slice();
  symmetricEigenvalues(work, n);
  const values = Array.from({ length: n }, (_, i) => work[i * n + i]!);
  const least = Math.min(...values);
  return least > 0 ? Math.max(...values) / least : null;
}

/** lambda of `(Omega M^-1 Omega^T) lambda = -gamma - Omega M^-1 (h + B u)`, or null where a factor does not exist. */
function multipliers(
  mass: Float64Array,
  h: Float64Array,
  inputs: Float64Array,
  omega: Float64Array,
  gamma: Float64Array,
  n: number,
  m: number,
): Float64Array | null {
  const L = mass.slice();
  if (cholesky(L, n) !== 0) return null;
  const solved = Array.from({ length: m }, (_, r) => {
    const row = omega.slice(r * n, (r + 1) * n);
    solveLower(L, n, row);
    return row;
  });
  const free = h.map((x, i) => x + inputs[i]!);
  solveLower(L, n, free);
  const dot = (a: Float64Array, b: Float64Array) => a.reduce((sum, x, i) => sum + x * b[i]!, 0);
  const S = Float64Array.from({ length: m * m }, (_, k) => dot(solved[Math.floor(k / m)]!, solved[k % m]!));
  const lambda = Float64Array.from({ length: m }, (_, r) => -gamma[r]! - dot(solved[r]!, free));
  if (cholesky(S, m, 1e-13) !== 0) return null;
  solveLower(S, m, lambda);
  solveLowerTransposed(S, m, lambda);
  return lambda;
}

/** Omega^T lambda (n). */
export function constraintForce({ n, m, omega, lambda }: Present): Float64Array | null {
  if (m > 0 && lambda === null) return null;
  return Float64Array.from({ length: n }, (_, i) => {
    let sum = 0;
    for (let r = 0; r < m; r++) sum += omega[r * n + i]! * lambda![r]!;
    return sum;
  });
}
