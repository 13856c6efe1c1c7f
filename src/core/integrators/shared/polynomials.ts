/** Real polynomials as lists of coefficients by rising powers: `polynomial[k]` belongs to x^k. */

/**
 * The value at x.
 *
 * @param polynomial coefficients, the constant first
 * @param x where
 */
export function valueAt(polynomial: ArrayLike<number>, x: number): number {
  let sum = 0;
  for (let k = polynomial.length - 1; k >= 0; k--) sum = sum * x + polynomial[k]!;
  return sum;
}

/**
 * The derivative.
 *
 * @param polynomial coefficients, the constant first
 */
export function derivativeOf(polynomial: readonly number[]): number[] {
  return polynomial.slice(1).map((a, power) => (power + 1) * a);
}

/**
 * The integral from 0.
 *
 * @param polynomial coefficients, the constant first
 */
export function integralOf(polynomial: readonly number[]): number[] {
  return [0, ...polynomial.map((a, power) => a / (power + 1))];
}

/**
 * (x - c_1) … (x - c_s).
 * @param nodes c_1 … c_s
 */
export function nodePolynomial(nodes: readonly number[]): number[] {
  return nodes.reduce<number[]>((product, c) => timesFactor(product, c, 1), [1]);
}

/**
 * The polynomial that is 1 at the j-th node and 0 at the others.
 * @param nodes s of them
 * @param j from 0
 */
export function lagrange(nodes: readonly number[], j: number): number[] {
  return nodes.reduce<number[]>((product, c, m) => (m === j ? product : timesFactor(product, c, nodes[j]! - c)), [1]);
}

/** A polynomial times (x - c) / width. */
function timesFactor(polynomial: readonly number[], c: number, width: number): number[] {
  const next = new Array<number>(polynomial.length + 1).fill(0);
  polynomial.forEach((a, power) => {
    next[power]! -= (a * c) / width;
    next[power + 1]! += a / width;
  });
  return next;
}
