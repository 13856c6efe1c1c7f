import { Trajectory } from '../../motion/trajectory.ts';
import type { Complex } from './spectrum.ts';

/** A mode of a linearization about a steady motion, SI and radians. */
export interface ShownMode {
  coordinates: readonly { name: string; kind: 'length' | 'angle' }[];
  /** Coordinates, then (unless of first order) their rates, N in all. */
  states: readonly string[];
  /** N x N, rows first: of the loop that the mode belongs to. */
  A: readonly (readonly number[])[];
  eigenvalue: Complex;
  /** Real part of the eigenvector in all states, at any phase; of a zero eigenvalue, a vector of its generalized null space. */
  shape: readonly number[];
  /** The steady motion: coordinates at t = 0 and their constant rates. */
  q: readonly number[];
  v: readonly number[];
}

/** Largest angle (rad) and length (m) of what is shown; the one that is reached first decides. */
export const LARGEST_ANGLE = (10 * Math.PI) / 180;
export const LARGEST_LENGTH = 0.5;
/** A mode is shown over this many periods, or time constants where those are shorter, or (neutral ones) seconds. */
const PERIODS = 2;
const CONSTANTS = 4;
const NEUTRAL = 2;
const ROWS = 480;

/**
 * How long a mode is shown, s. `growth` false: as if its real part were 0, which only an oscillation can do.
 *
 * @param growth false: as if the real part were 0
 */
export function modeDuration([re, im]: Complex, growth = true): number {
  const periods = im === 0 ? Infinity : (PERIODS * 2 * Math.PI) / Math.abs(im);
  const constants = re === 0 || (!growth && im !== 0) ? Infinity : CONSTANTS / Math.abs(re);
  const shortest = Math.min(periods, constants);
  return Number.isFinite(shortest) ? shortest : NEUTRAL;
}

/**
 * The steady motion plus `a exp(sigma t) (re cos(omega t) - im sin(omega t))`, as rows of t, coordinates and rates over
 * `modeDuration`; `a` so that the largest angle or length is the one above. A zero eigenvalue goes by the finite series
 * of its chain, `sum of (A t)^j / j!`.
 *
 * @param mode eigenvalue, 1/s, shape and steady motion
 * @param growth false: without `exp(sigma t)`, the shape of an oscillation alone
 */
export function modeTrajectory(mode: ShownMode, growth = true): Trajectory {
  const { coordinates, states, q, v } = mode;
  const n = coordinates.length;
  const duration = modeDuration(mode.eigenvalue, growth);
  const deviation = deviationOf(mode, growth);
  const paths = states.map(() => new Float64Array(ROWS + 1));
  const t = Float64Array.from({ length: ROWS + 1 }, (_, row) => (duration * row) / ROWS);
  t.forEach((time, row) => deviation(time).forEach((x, i) => (paths[i]![row] = x)));
  const scale = Math.min(
    ...coordinates.map(({ kind }, i) => {
      const largest = paths[i]!.reduce((most, x) => Math.max(most, Math.abs(x)), 0);
      return largest > 0 ? (kind === 'angle' ? LARGEST_ANGLE : LARGEST_LENGTH) / largest : Infinity;
    }),
  );
  const a = Number.isFinite(scale) ? scale : 0;
  const columns = paths.map((path, i) => path.map((x, row) => (i < n ? q[i]! + v[i]! * t[row]! : v[i - n]!) + a * x));
  const trajectory = new Trajectory(['t', ...states], ROWS + 1);
  trajectory.append([t, ...columns], ROWS + 1);
  return trajectory;
}

/** The deviation from the steady motion at a time, of any amplitude. */
function deviationOf({ A, eigenvalue: [re, im], shape }: ShownMode, growth: boolean): (time: number) => number[] {
  const times = (x: readonly number[]): number[] =>
    A.map((row) => row.reduce((sum, entry, j) => sum + entry * x[j]!, 0));
  if (im !== 0) {
    // A (x + i y) = (re + i im)(x + i y), so A x = re x - im y.
    const image = times(shape);
    const other = shape.map((x, i) => (re * x - image[i]!) / im);
    const rate = growth ? re : 0;
    return (t) => {
      const [c, s, size] = [Math.cos(im * t), Math.sin(im * t), Math.exp(rate * t)];
      return shape.map((x, i) => size * (x * c - other[i]! * s));
    };
  }
  if (re !== 0) return (t) => shape.map((x) => Math.exp(re * t) * x);
  const chain = chainOf(shape, times);
  return (t) => shape.map((_, i) => chain.reduceRight((sum, term, j) => (sum * t) / (j + 1) + term[i]!, 0));
}

/** A vector, A times it, and so on until nothing but rounding is left. */
function chainOf(shape: readonly number[], times: (x: readonly number[]) => number[]): (readonly number[])[] {
  const size = (x: readonly number[]): number => Math.max(...x.map(Math.abs));
  const chain: (readonly number[])[] = [shape];
  while (chain.length < shape.length) {
    const next = times(chain.at(-1)!);
    if (size(next) <= ROUNDING * size(shape)) break;
    chain.push(next.map((x) => (Math.abs(x) <= ROUNDING * size(next) ? 0 : x)));
  }
  return chain;
}

const ROUNDING = 1e-9;

/**
 * A mode as a motion, and how long it is shown (s).
 *
 * @param mode what is shown
 * @param growth false: as if the real part were 0
 */
export const modeMotion = (mode: ShownMode, growth: boolean): { trajectory: Trajectory; duration: number } => ({
  trajectory: modeTrajectory(mode, growth),
  duration: modeDuration(mode.eigenvalue, growth),
});
