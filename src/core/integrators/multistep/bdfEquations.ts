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
  /** Derivative at (t, y); also the components of y that follow from the others. */
  begin(t: number, y: Float64Array, slope: Float64Array): boolean;
  /**
   * Step of order 1 to begin with, s.
   * @param slope y', n
   * @param scale tolerance of each component, n
   * @param longest nothing is looked at further ahead than this, s
   */
  firstStep(t: number, y: Float64Array, slope: Float64Array, scale: Float64Array, longest: number): number;
  residual(t: number, y: Float64Array, slope: Float64Array, out: Float64Array): boolean;
  /** dF/dy + cj dF/dy'; with derivatives of this state if `renew`, else older ones will do. */
  matrix(t: number, y: Float64Array, slope: Float64Array, cj: number, renew: boolean, out: Float64Array): boolean;
  /** Whether `matrix` used older derivatives. */
  readonly matrixIsOld: boolean;
}
