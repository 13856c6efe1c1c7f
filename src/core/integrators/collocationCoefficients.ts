import { transformOf, type Transform } from './collocationTransform.ts';

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
  /** Nodes. */
  readonly c: Float64Array;
  /** Runge-Kutta matrix, row-major: a_ij is the integral of the j-th Lagrange polynomial of the nodes to c_i. */
  readonly A: Float64Array;
  readonly transform: Transform;
  /** The size of A's first eigenvalue. */
  readonly gamma: number;
  /** h u'(t0) is the sum of these times u(t0 + c_i h) - y0. */
  readonly startSlope: Float64Array;
  /** Integral of M(x) / M(0) from 0, M the node polynomial, by rising powers. */
  readonly bend: Float64Array;
  readonly probe: Probe;
}

/** One more point of the step, where what is left of the defect is measured. */
export interface Probe {
  readonly at: number;
  readonly weights: Float64Array;
  readonly slope: Float64Array;
  readonly bend: number;
  readonly bendSlope: number;
  readonly gain: number;
}

const PROBE_GRID = 1000;
export const GAUSS_STAGES = [1, 2, 3, 4] as const;
export const RADAU_STAGES = [2, 3] as const;

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

/** @throws RangeError where no such method is at hand */
export function gauss(stages: number): Tableau {
  if (!GAUSS_STAGES.some((s) => s === stages)) throw new RangeError(`gauss: 1 to 4 stages, not ${stages}`);
  return tableau(gaussNodes(stages), 2 * stages);
}

/** @throws RangeError where no such method is at hand */
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
  const M = nodes.reduce<number[]>((product, c) => timesFactor(product, c, 1), [1]);
  const transform = transformOf(nodes, M);
  const gamma = Math.hypot(...transform.eigenvalues[0]!);
  const bend = M.map((a) => a / M[0]!);
  return {
    stages: s,
    order,
    c: Float64Array.from(nodes),
    A,
    transform,
    gamma,
    startSlope: slopeWeights(nodes, 0),
    bend: Float64Array.from(integralOf(bend)),
    probe: probeOf(nodes, M, bend),
  };
}

/** Where N(x) = x M(x), the error of interpolating u' at 0 and the nodes, is largest: there it shows best. */
function probeOf(nodes: number[], M: number[], bend: number[]): Probe {
  const N = [0, ...M];
  const integral = integralOf(N);
  const grid = Array.from({ length: PROBE_GRID + 1 }, (_, k) => k / PROBE_GRID);
  const largest = (p: number[]): number => grid.reduce((best, x) => (Math.abs(valueAt(p, x)) > Math.abs(valueAt(p, best)) ? x : best), 0);
  const at = largest(N);
  const weights = new Float64Array(nodes.length);
  weightsAt(at, Float64Array.from(nodes), weights);
  const worst = Math.abs(valueAt(integral, largest(integral)));
  return { at, weights, slope: slopeWeights(nodes, at), bend: valueAt(integralOf(bend), at), bendSlope: valueAt(bend, at), gain: worst / Math.abs(valueAt(N, at)) };
}

/** h u'(t0 + x h) is the sum of these times u(t0 + c_i h) - y0. */
function slopeWeights(nodes: number[], x: number): Float64Array {
  const all = [0, ...nodes];
  return Float64Array.from(nodes, (_, j) => valueAt(derivativeOf(lagrange(all, j + 1)), x));
}

/** The j-th Lagrange polynomial of the nodes by rising powers. */
function lagrange(nodes: number[], j: number): number[] {
  return nodes.reduce<number[]>((product, c, m) => (m === j ? product : timesFactor(product, c, nodes[j]! - c)), [1]);
}

/** A polynomial times (x - c) / width. */
function timesFactor(polynomial: number[], c: number, width: number): number[] {
  const next = new Array<number>(polynomial.length + 1).fill(0);
  polynomial.forEach((a, power) => {
    next[power]! -= (a * c) / width;
    next[power + 1]! += a / width;
  });
  return next;
}

function integralOf(polynomial: number[]): number[] {
  return [0, ...polynomial.map((a, power) => a / (power + 1))];
}

function derivativeOf(polynomial: number[]): number[] {
  return polynomial.slice(1).map((a, power) => (power + 1) * a);
}

export function valueAt(polynomial: ArrayLike<number>, x: number): number {
  let sum = 0;
  for (let k = polynomial.length - 1; k >= 0; k--) sum = sum * x + polynomial[k]!;
  return sum;
}

/**
 * Weights into `out` (s) by which u(t0 + theta h) - y0 is made from the u(t0 + c_i h) - y0:
 * Lagrange polynomials of the nodes 0, c_1, …, c_s.
 */
export function weightsAt(theta: number, c: Float64Array, out: Float64Array): void {
  for (let i = 0; i < c.length; i++) {
    let weight = theta / c[i]!;
    for (let m = 0; m < c.length; m++) if (m !== i) weight *= (theta - c[m]!) / (c[i]! - c[m]!);
    out[i] = weight;
  }
}
