/** What `ida` integrates: F(t, y, y') = 0, where some components of y may have no derivative in F. */
export interface DaeProblem {
  readonly dimension: number;
  /** 1 for components whose derivative stands in F, 0 for the algebraic ones. */
  readonly differential: Uint8Array;
  /** Why there was no value, when a function returned false. */
  readonly failure: string | null;
  /**
   * Consistent start: given the differential components of y, completes y with the algebraic ones and gives yp
   * (0 for the algebraic ones) so that F = 0.
   */
  start(t: number, y: Float64Array, yp: Float64Array): boolean;
  /**
   * F(t, y, yp).
   * @param t s
   * @param y `dimension`
   * @param yp derivative of y by time
   * @param out `dimension`
   */
  residual(t: number, y: Float64Array, yp: Float64Array, out: Float64Array): boolean;
  /**
   * dF/dy + cj dF/dyp.
   * @param cj 1/s
   * @param out dimension x dimension, row-major
   */
  jacobian(t: number, y: Float64Array, yp: Float64Array, cj: number, out: Float64Array): boolean;
}
