import { cosine } from '../elementary/trigonometry.ts';
import { lagrange, valueAt } from '../integrators/shared/polynomials.ts';

/**
 * The polynomial through a function's values at Chebyshev's extrema of an interval, in Bernstein's form: it lies between the
 * least and the greatest of the coefficients, and turns no more often than their differences change sign.
 *
 * G. Farin, Curves and Surfaces for CAGD, 5th ed., sections 5.1 to 5.3 (convex hull, variation diminishing); L. N. Trefethen,
 * Approximation Theory and Approximation Practice, chapters 2, 3 and 8 (nodes, coefficients, how far they tell the error).
 *
 * On [0, 1]: x_j = (1 - cos(j pi / n)) / 2, b = B f(x).
 */
export class BernsteinFit {
  readonly degree: number;
  /** Where the function is looked at, 0 and 1 among them, rising. */
  readonly nodes: readonly number[];
  /** Coefficients of the last fit, degree + 1. */
  readonly coefficients: Float64Array;
  least = 0;
  greatest = 0;
  /** Size of its last two Chebyshev coefficients: about what a smooth function differs from it by. */
  tail = 0;
  /** How often the differences of its coefficients change sign: the polynomial turns so often or less, by an even number. */
  turns = 0;
  /** Whether it falls at the start. */
  falls = false;
  private readonly matrix: Float64Array;
  /** Rows that give the last two Chebyshev coefficients. */
  private readonly last: Float64Array;
  private readonly basis: readonly (readonly number[])[];

  /** @param degree n, at least 2 */
  constructor(degree: number) {
    const n = (this.degree = degree);
    const nodes = Array.from({ length: n + 1 }, (_, j) => 0.5 - 0.5 * cosine((j * Math.PI) / n));
    this.nodes = nodes;
    this.coefficients = new Float64Array(n + 1);
    this.matrix = new Float64Array((n + 1) * (n + 1));
    this.last = new Float64Array(2 * (n + 1));
    this.basis = nodes.map((_, j) => lagrange(nodes, j));
    this.basis.forEach((power, j) => {
      for (let k = 0; k <= n; k++) {
        let b = 0;
        for (let i = 0; i <= k; i++) b += (power[i]! * choose(k, i)) / choose(n, i);
        this.matrix[k * (n + 1) + j] = b;
      }
      const end = j === 0 || j === n ? 0.5 : 1;
      this.last[j] = (end * cosine((j * Math.PI * (n - 1)) / n) * 2) / n;
      this.last[n + 1 + j] = (end * cosine(j * Math.PI)) / n;
    });
  }

  /** @param values of the function at the nodes, degree + 1 */
  fit(values: Float64Array): void {
    const { degree: n, coefficients, matrix, last } = this;
    let [least, greatest, before, turns] = [Infinity, -Infinity, 0, 0];
    for (let k = 0; k <= n; k++) {
      let b = 0;
      for (let j = 0; j <= n; j++) b += matrix[k * (n + 1) + j]! * values[j]!;
      coefficients[k] = b;
      if (b < least) least = b;
      if (b > greatest) greatest = b;
      if (k === 0) continue;
      const difference = b - coefficients[k - 1]!;
      if (before === 0) this.falls = difference < 0;
      if (difference * before < 0) turns++;
      if (difference !== 0) before = difference;
    }
    let [c, d] = [0, 0];
    for (let j = 0; j <= n; j++) {
      c += last[j]! * values[j]!;
      d += last[n + 1 + j]! * values[j]!;
    }
    this.tail = Math.abs(c) + Math.abs(d);
    this.turns = turns;
    [this.least, this.greatest] = [least, greatest];
  }

  /**
   * The polynomial's value, from the values that it goes through.
   *
   * @param values at the nodes, degree + 1
   * @param x in [0, 1]
   */
  through(values: Float64Array, x: number): number {
    let sum = 0;
    for (let j = 0; j <= this.degree; j++) sum += values[j]! * valueAt(this.basis[j]!, x);
    return sum;
  }
}

function choose(n: number, k: number): number {
  let product = 1;
  for (let i = 1; i <= k; i++) product = (product * (n - k + i)) / i;
  return product;
}
