import type { Counters } from '../contract.ts';

/** F(t, y, y') = 0, as the BDF methods see it: what tells `bdf` from `ida`. */
export interface BdfEquations {
  readonly dimension: number;
  /** Which components have a derivative in F; null: all. Only these are tested for their error. */
  readonly differential: Uint8Array | null;
  /** By order: 0 for BDF, or the constants of the NDF. */
  readonly kappa: readonly number[];
  readonly counters: Counters;
  readonly failure: string | null;
  /**
   * Derivative at (t, y); also the components of y that follow from the others.
   * @param t s
   * @param y n
   * @param slope y', n; set
   * @returns false where there is none
   */
  begin(t: number, y: Float64Array, slope: Float64Array): boolean;
  /**
   * Step of order 1 to begin with, s.
   * @param slope y', n
   * @param scale tolerance of each component, n
   * @param longest nothing is looked at further ahead than this, s
   */
  firstStep(t: number, y: Float64Array, slope: Float64Array, scale: Float64Array, longest: number): number;
  /**
   * F(t, y, y').
   * @param out n
   * @returns false where it has no value
   */
  residual(t: number, y: Float64Array, slope: Float64Array, out: Float64Array): boolean;
  /**
   * dF/dy + cj dF/dy'.
   * @param cj 1/s
   * @param renew with derivatives of this state, else older ones will do
   * @param out n x n, row-major
   */
  matrix(t: number, y: Float64Array, slope: Float64Array, cj: number, renew: boolean, out: Float64Array): boolean;
  /** Whether `matrix` used older derivatives. */
  readonly matrixIsOld: boolean;
}
