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
  /** gamma_0 of the error estimate: the real eigenvalue of A, or the mean of its eigenvalues where none is real. */
  readonly gamma: number;
  /** h u'(t0) is the sum of these times u(t0 + c_i h) - y0. */
  readonly startSlope: Float64Array;
}

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

/**
 * Real eigenvalue of A for an odd number of stages, and for an even number, where there is none, the geometric mean of
 * the complex ones: det(A) to the power 1/s. The determinant is the last coefficient of the denominator of the
 * stability function (Hairer and Wanner II, section IV.3), a Padé approximation of the exponential: 1/2, 1/12, 1/120, 1/1680 for
 * Gauss, 1/6, 1/60 for Radau IIA.
 */
const GAUSS_GAMMA = [0, 1 / 2, Math.sqrt(1 / 12), 0.21531442311611218, Math.pow(1 / 1680, 1 / 4)] as const;
const RADAU_GAMMA = [0, 1, Math.sqrt(1 / 6), (6 + Math.cbrt(81) - Math.cbrt(9)) / 30] as const;

/** @throws RangeError where no such method is at hand */
export function gauss(stages: number): Tableau {
  if (!GAUSS_STAGES.some((s) => s === stages)) throw new RangeError(`gauss: 1 to 4 stages, not ${stages}`);
  return tableau(gaussNodes(stages), 2 * stages, GAUSS_GAMMA[stages]!);
}

/** @throws RangeError where no such method is at hand */
export function radau(stages: number): Tableau {
  if (!RADAU_STAGES.some((s) => s === stages)) throw new RangeError(`radau: 2 or 3 stages, not ${stages}`);
  return tableau(radauNodes(stages), 2 * stages - 1, RADAU_GAMMA[stages]!);
}

function tableau(nodes: number[], order: number, gamma: number): Tableau {
  const s = nodes.length;
  const A = new Float64Array(s * s);
  const startSlope = new Float64Array(s);
  for (let j = 0; j < s; j++) {
    // Coefficients of the j-th Lagrange polynomial by rising powers, multiplied together factor by factor.
    let polynomial = [1];
    for (let m = 0; m < s; m++) {
      if (m === j) continue;
      const width = nodes[j]! - nodes[m]!;
      const next = new Array<number>(polynomial.length + 1).fill(0);
      polynomial.forEach((a, power) => {
        next[power]! -= (a * nodes[m]!) / width;
        next[power + 1]! += a / width;
      });
      polynomial = next;
    }
    startSlope[j] = polynomial[0]! / nodes[j]!;
    for (let i = 0; i < s; i++) {
      A[i * s + j] = polynomial.reduce((sum, a, power) => sum + (a * Math.pow(nodes[i]!, power + 1)) / (power + 1), 0);
    }
  }
  return { stages: s, order, c: Float64Array.from(nodes), A, gamma, startSlope };
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
