import { transformOf, type Transform } from './collocationTransform.ts';
import { derivativeOf, integralOf, lagrange, nodePolynomial, valueAt } from '../shared/polynomials.ts';

/**
 * Collocation methods by their nodes: everything else follows from these.
 *
 * The polynomial u of degree s with u(t0) = y0 and u' = f(t, u) at the nodes t0 + c_i h gives y1 = u(t0 + h):
 * Hairer, Nørsett and Wanner, Solving ODEs I, 2nd ed., section II.7. Nodes of Gauss (Kuntzmann, Butcher; order
 * 2 s) and Radau IIA (Ehle; order 2 s - 1): Hairer and Wanner, Solving ODEs II, 2nd ed., section IV.5.
 */

export interface Tableau {
  readonly stages: number;
  readonly order: number;
  /** The error estimate falls like h to this power plus one. */
  readonly estimateOrder: number;
  /** Nodes. */
  readonly c: Float64Array;
  /** Runge-Kutta matrix, row-major: a_ij is the integral of the j-th Lagrange polynomial of the nodes to c_i. */
  readonly A: Float64Array;
  readonly transform: Transform;
  /** h u'(t0) is the sum of these times u(t0 + c_i h) - y0. */
  readonly startSlope: Float64Array;
  readonly corrections: Corrections;
}

/**
 * What u lacks between the ends of a step, as three polynomials of x = (t - t0) / h that vanish at 0, each to be
 * multiplied by a vector (`collocationPolynomial.ts`).
 */
export interface Corrections {
  /** How many make sense: all, or the first alone where the ends of the steps are of order s + 1. */
  readonly depth: 1 | 3;
  /** By rising powers: the integral of m(x) = M(x) / M(0), M the node polynomial; its integral; that of N(x) = x M(x) / N(at). */
  readonly shapes: readonly [Float64Array, Float64Array, Float64Array];
  /** Largest size of each in [0, 1]. */
  readonly largest: readonly [number, number, number];
  /** Where N is largest, and what is known there: h u' by u's increments, m and its integral. */
  readonly at: number;
  readonly slope: Float64Array;
  readonly m: number;
  readonly integral: number;
}

export const GAUSS_STAGES = [1, 2, 3, 4] as const;
export const RADAU_STAGES = [2, 3] as const;

/** Points of the unit interval at which a polynomial is looked at for its largest size. */
const SAMPLES = 1000;

/** Zeros of the shifted Legendre polynomial of degree s. */
function gaussNodes(s: number): number[] {
  if (s === 1) return [1 / 2];
  if (s === 2) return [1 / 2 - Math.sqrt(3) / 6, 1 / 2 + Math.sqrt(3) / 6];
  if (s === 3) return [1 / 2 - Math.sqrt(15) / 10, 1 / 2, 1 / 2 + Math.sqrt(15) / 10];
  const inner = Math.sqrt(3 / 7 - (2 / 7) * Math.sqrt(6 / 5)) / 2;
  const outer = Math.sqrt(3 / 7 + (2 / 7) * Math.sqrt(6 / 5)) / 2;
  return [1 / 2 - outer, 1 / 2 - inner, 1 / 2 + inner, 1 / 2 + outer];
}

function radauNodes(s: number): number[] {
  return s === 2 ? [1 / 3, 1] : [(4 - Math.sqrt(6)) / 10, (4 + Math.sqrt(6)) / 10, 1];
}

/**
 * Gauss's method, of order 2 s.
 * @param stages s, 1 to 4
 * @throws RangeError where there is no such method
 */
export function gauss(stages: number): Tableau {
  if (!GAUSS_STAGES.some((s) => s === stages)) throw new RangeError(`gauss: 1 to 4 stages, not ${stages}`);
  return tableau(gaussNodes(stages), 2 * stages);
}

/**
 * Radau IIA, of order 2 s - 1.
 * @param stages s, 2 or 3
 * @throws RangeError where there is no such method
 */
export function radau(stages: number): Tableau {
  if (!RADAU_STAGES.some((s) => s === stages)) throw new RangeError(`radau: 2 or 3 stages, not ${stages}`);
  return tableau(radauNodes(stages), 2 * stages - 1);
}

function tableau(nodes: number[], order: number): Tableau {
  const s = nodes.length;
  const A = new Float64Array(s * s);
  nodes.forEach((_, j) => {
    const integral = integralOf(lagrange(nodes, j));
    nodes.forEach((c, i) => (A[i * s + j] = valueAt(integral, c)));
  });
  const deep = order > s + 1;
  return {
    stages: s,
    order,
    estimateOrder: deep ? s + 1 : s,
    c: Float64Array.from(nodes),
    A,
    transform: transformOf(nodes),
    startSlope: slopeWeights(nodes, 0),
    corrections: correctionsOf(nodes, deep ? 3 : 1),
  };
}

function correctionsOf(nodes: number[], depth: 1 | 3): Corrections {
  const M = nodePolynomial(nodes);
  const m = M.map((a) => a / M[0]!);
  const integral = integralOf(m);
  const N = [0, ...M];
  const at = largestAt(N);
  const shapes = [integral, integralOf(integral), integralOf(N.map((a) => a / valueAt(N, at)))] as const;
  const [a, b, c] = shapes;
  return {
    depth,
    shapes: [Float64Array.from(a), Float64Array.from(b), Float64Array.from(c)],
    largest: [largestSize(a), largestSize(b), largestSize(c)],
    at,
    slope: slopeWeights(nodes, at),
    m: valueAt(m, at),
    integral: valueAt(integral, at),
  };
}

/** Where in [0, 1] a polynomial is largest in size. */
function largestAt(polynomial: ArrayLike<number>): number {
  let best = 0;
  for (let k = 0; k <= SAMPLES; k++)
    if (Math.abs(valueAt(polynomial, k / SAMPLES)) > Math.abs(valueAt(polynomial, best))) best = k / SAMPLES;
  return best;
}

function largestSize(polynomial: ArrayLike<number>): number {
  return Math.abs(valueAt(polynomial, largestAt(polynomial)));
}

/** h u'(t0 + x h) is the sum of these times u(t0 + c_i h) - y0. */
function slopeWeights(nodes: number[], x: number): Float64Array {
  const all = [0, ...nodes];
  return Float64Array.from(nodes, (_, j) => valueAt(derivativeOf(lagrange(all, j + 1)), x));
}

/**
 * Weights by which u(t0 + x h) - y0 is made from the u(t0 + c_i h) - y0: Lagrange polynomials of the nodes 0, c_1, …, c_s.
 * @param x fraction of the step
 * @param c nodes, s
 * @param out s
 */
export function weightsAt(x: number, c: Float64Array, out: Float64Array): void {
  for (let i = 0; i < c.length; i++) {
    let weight = x / c[i]!;
    for (let m = 0; m < c.length; m++) if (m !== i) weight *= (x - c[m]!) / (c[i]! - c[m]!);
    out[i] = weight;
  }
}
