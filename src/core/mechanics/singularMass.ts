import { symmetricEigenvalues } from '../linalg/dense.ts';
import type { System } from '../model/system.ts';

/** Of the largest part of the motion that costs nothing: less of a coordinate takes no part in it. */
const TAKES_PART = 1e-3;

/**
 * Why the mass matrix is singular at a state, and what to do: the motion that costs no energy is looked for, with each
 * coordinate in units of its own inertia.
 *
 * @param system that the run is of
 * @param parameters of the system
 * @param q coordinates, n
 * @param hold indices of coordinates that stand still
 */
export function singularMassWords(
  system: System,
  parameters: Float64Array,
  q: Float64Array,
  hold: readonly number[] = [],
): string {
  const { attitude, coordinates } = system.meta;
  const pitch = coordinates.findIndex(({ name }) => name === attitude?.angles[1]);
  if (pitch >= 0 && Math.abs(Math.cos(q[pitch]!)) < 1e-3)
    return `the pitch ${attitude!.angles[1]} is at 90°, where the angles have no rates; a free board passes there: choose constraints "none" and hold neither its angles nor a part of its position`;
  const n = q.length;
  const M = new Float64Array(n * n);
  system.mechanics(q, new Float64Array(n), parameters, M, new Float64Array(n));
  const free = [...coordinates.keys()].filter((i) => !hold.includes(i));
  const weightless = free.filter((i) => !(M[i * n + i]! > 0)).map((i) => coordinates[i]!.name);
  if (weightless.length > 0) return `nothing that ${and(weightless)} moves has a mass or inertia: give every body both`;
  const k = free.length;
  const scaled = Float64Array.from({ length: k * k }, (_, at) => {
    const [i, j] = [free[Math.floor(at / k)]!, free[at % k]!];
    return M[i * n + j]! / Math.sqrt(M[i * n + i]! * M[j * n + j]!);
  });
  const vectors = new Float64Array(k * k);
  symmetricEigenvalues(scaled, k, vectors);
  const least = free.reduce((best, _, i) => (scaled[i * k + i]! < scaled[best * k + best]! ? i : best), 0);
  const part = free.map((_, i) => Math.abs(vectors[i * k + least]!));
  const largest = Math.max(...part);
  const together = free.filter((_, i) => part[i]! > TAKES_PART * largest).map((i) => coordinates[i]!.name);
  if (!(largest > 0) || together.length < 2) return 'give every body a mass and inertia';
  return `a motion of ${and(together)} together has no inertia: their axes coincide in this attitude, or a body lacks mass or inertia`;
}

const and = (names: readonly string[]): string =>
  names.length < 2 ? names.join() : `${names.slice(0, -1).join(', ')} and ${names.at(-1)!}`;
