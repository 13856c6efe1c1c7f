/**
 * What a BDF method remembers: the backward differences of y over equal steps, that is the polynomial through the
 * last k + 1 values. A change of step resamples this polynomial ("quasi-constant step").
 *
 * L. F. Shampine, M. W. Reichelt, "The MATLAB ODE Suite", SIAM J. Sci. Comput. 18 (1997), section 2: the differences,
 * the prediction, and the change of step by the matrices R and U. Arrangement of the update as in SciPy's BDF.
 *
 * Symbols: D[j] the j-th backward difference of y at t_n (D[0] = y_n), k the order, h the spacing,
 * gamma_j = 1 + 1/2 + ... + 1/j.
 */

export const MAX_ORDER = 5;
const SIZE = MAX_ORDER + 1;

/** Sums of 1/j, so that h y'(t_(n+1)) of the predicted polynomial is the sum of gamma_j D[j]. */
export const GAMMA: readonly number[] = [0, 1, 3 / 2, 11 / 6, 25 / 12, 137 / 60];

export class BackwardDifferences {
  order = 1;
  /** Distance of the points that the differences are taken over. */
  spacing = 0;
  /** D[0] to D[order] are the polynomial; two more serve to judge the next higher order. */
  readonly D: readonly Float64Array[];
  private readonly R = new Float64Array(SIZE * SIZE);
  private readonly U = new Float64Array(SIZE * SIZE);
  private readonly RU = new Float64Array(SIZE * SIZE);
  private readonly column = new Float64Array(SIZE);

  constructor(dimension: number) {
    this.D = Array.from({ length: MAX_ORDER + 3 }, () => new Float64Array(dimension));
  }

  /**
   * Order 1, from a value and its slope.
   * @param y n
   * @param slope y', n
   * @param h spacing, s
   */
  start(y: Float64Array, slope: Float64Array, h: number): void {
    for (const d of this.D) d.fill(0);
    this.D[0]!.set(y);
    for (let i = 0; i < y.length; i++) this.D[1]![i] = h * slope[i]!;
    this.order = 1;
    this.spacing = h;
  }

  /**
   * A given order, from past values.
   * @param values those at t, t - h, ..., t - order h, each n
   * @param h spacing, s
   */
  startFrom(values: readonly Float64Array[], order: number, h: number): void {
    const { D } = this;
    for (const d of D) d.fill(0);
    for (let j = 0; j <= order; j++) D[j]!.set(values[j]!);
    for (let j = 1; j <= order; j++) {
      for (let m = order; m >= j; m--) for (let i = 0; i < D[0]!.length; i++) D[m]![i] = D[m - 1]![i]! - D[m]![i]!;
    }
    this.order = order;
    this.spacing = h;
  }

  /**
   * The same polynomial, seen at another spacing.
   * @param h s
   */
  respace(h: number): void {
    const { D, order, R, U, RU, column } = this;
    resampling(order, h / this.spacing, R);
    resampling(order, 1, U);
    for (let a = 0; a <= order; a++) {
      for (let b = 0; b <= order; b++) {
        let sum = 0;
        for (let c = 0; c <= order; c++) sum += R[a * SIZE + c]! * U[c * SIZE + b]!;
        RU[a * SIZE + b] = sum;
      }
    }
    // The first row and column of RU are those of the identity: y_n stays to the last bit.
    for (let i = 0; i < D[0]!.length; i++) {
      for (let j = 1; j <= order; j++) column[j] = D[j]![i]!;
      for (let j = 1; j <= order; j++) {
        let sum = 0;
        for (let c = 1; c <= order; c++) sum += RU[c * SIZE + j]! * column[c]!;
        D[j]![i] = sum;
      }
    }
    this.spacing = h;
  }

  /**
   * The polynomial one spacing ahead: its value, and its slope by the formula of order k there.
   * @param y n; set
   * @param slope n; set
   */
  predict(y: Float64Array, slope: Float64Array): void {
    const { D, order, spacing } = this;
    for (let i = 0; i < y.length; i++) {
      let value = D[0]![i]!;
      let rate = 0;
      for (let j = 1; j <= order; j++) {
        const d = D[j]![i]!;
        value += d;
        rate += GAMMA[j]! * d;
      }
      y[i] = value;
      slope[i] = rate / spacing;
    }
  }

  /**
   * One spacing ahead; D[j] at t_(n+1) = D[j] at t_n + D[j + 1] at t_(n+1).
   * @param d y less its prediction, n
   */
  advance(d: Float64Array): void {
    const { D, order } = this;
    const [beyond, highest] = [D[order + 2]!, D[order + 1]!];
    for (let i = 0; i < d.length; i++) {
      beyond[i] = d[i]! - highest[i]!;
      highest[i] = d[i]!;
      for (let j = order; j >= 0; j--) D[j]![i]! += D[j + 1]![i]!;
    }
  }
}

/** R of Shampine and Reichelt: products of (i - 1 - r j) / i down each column. */
function resampling(order: number, r: number, R: Float64Array): void {
  for (let j = 0; j <= order; j++) {
    let product = 1;
    R[j] = 1;
    for (let i = 1; i <= order; i++) {
      product *= j === 0 ? 0 : (i - 1 - r * j) / i;
      R[i * SIZE + j] = product;
    }
  }
}

/**
 * Value of the polynomial of differences of an order (Newton's form, for equal steps).
 *
 * @param D differences at t_n, each n
 * @param order of the polynomial; uses differences 0 to this
 * @param s where: at t_n + s h
 * @param out n
 */
export function valueAt(D: readonly Float64Array[], order: number, s: number, out: Float64Array): void {
  out.set(D[0]!);
  let weight = 1;
  for (let j = 1; j <= order; j++) {
    weight *= (s + j - 1) / j;
    for (let i = 0; i < out.length; i++) out[i]! += weight * D[j]![i]!;
  }
}
