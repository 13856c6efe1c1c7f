/**
 * Polynomials between the two ends of a step, at the fraction `s` of its length h: the straight line, the cubic Hermite
 * polynomial, and the Hermite polynomial raised by terms that vanish with their slope at both ends.
 *
 * Hairer, Nørsett and Wanner, Solving ODEs I, 2nd ed., section II.6, eq. (6.7); raised in the form of the authors'
 * DOP853 (section II.10).
 */

/**
 * Straight line from y0 (s = 0) to y1 (s = 1).
 * @param s fraction of the step, 0 to 1
 * @param y0 n
 * @param y1 n
 * @param out n
 */
export function linear(s: number, y0: Float64Array, y1: Float64Array, out: Float64Array): void {
  for (let i = 0; i < out.length; i++) out[i] = (1 - s) * y0[i]! + s * y1[i]!;
}

/**
 * Cubic Hermite polynomial of a step from (y0, f0) to (y1, f1); its error is O(h^4).
 * @param s fraction of the step, 0 to 1
 * @param h length of the step, s
 * @param y0 n
 * @param f0 slope at y0, n
 * @param y1 n
 * @param f1 slope at y1, n
 * @param out n
 */
export function hermite(
  s: number,
  h: number,
  y0: Float64Array,
  f0: Float64Array,
  y1: Float64Array,
  f1: Float64Array,
  out: Float64Array,
): void {
  const r = 1 - s;
  for (let i = 0; i < out.length; i++) {
    const difference = y1[i]! - y0[i]!;
    const curvature = r * (h * f0[i]! - difference) - s * (h * f1[i]! - difference);
    out[i] = y0[i]! + s * (difference + r * curvature);
  }
}

/** Number of coefficients that make the cubic Hermite polynomial in `nestedAt`. */
export const HERMITE_TERMS = 3;

/**
 * The first three coefficients of `nestedAt`: those of the cubic Hermite polynomial.
 * @param h length of the step, s
 * @param y0 n
 * @param f0 slope at y0, n
 * @param y1 n
 * @param f1 slope at y1, n
 * @param p at least three vectors of n; the first three are set
 */
export function hermiteCoefficients(
  h: number,
  y0: Float64Array,
  f0: Float64Array,
  y1: Float64Array,
  f1: Float64Array,
  p: readonly Float64Array[],
): void {
  const p0 = p[0]!;
  const p1 = p[1]!;
  const p2 = p[2]!;
  for (let i = 0; i < y0.length; i++) {
    const difference = y1[i]! - y0[i]!;
    const curvature = h * f0[i]! - difference;
    p0[i] = difference;
    p1[i] = curvature;
    p2[i] = difference - h * f1[i]! - curvature;
  }
}

/**
 * y0 + s (p_0 + r (p_1 + s (p_2 + r (p_3 + …)))) with r = 1 - s: p_0 to p_2 are `hermiteCoefficients`, and all further terms
 * have the factor s^2 r^2, which leaves both ends and their slopes as they are.
 * @param s fraction of the step, 0 to 1
 * @param y0 n
 * @param p vectors of n
 * @param terms how many of p are used, at least one
 * @param out n
 */
export function nestedAt(
  s: number,
  y0: Float64Array,
  p: readonly Float64Array[],
  terms: number,
  out: Float64Array,
): void {
  const r = 1 - s;
  const n = out.length;
  out.set(p[terms - 1]!);
  for (let k = terms - 2; k >= 0; k--) {
    const weight = k % 2 === 0 ? r : s;
    const lower = p[k]!;
    for (let i = 0; i < n; i++) out[i] = lower[i]! + weight * out[i]!;
  }
  for (let i = 0; i < n; i++) out[i] = y0[i]! + s * out[i]!;
}
