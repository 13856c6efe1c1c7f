/**
 * An embedded pair of explicit Runge-Kutta formulas as data: all that tells one pair from another.
 *
 * Symbols as in Hairer, Nørsett and Wanner, Solving ODEs I, 2nd ed., section II.1: with k_1 = f(t, y) and
 * k_i = f(t + c_i h, y + h (a_i1 k_1 + … + a_i,i-1 k_(i-1))), the step ends at y1 = y + h (b_1 k_1 + … + b_s k_s).
 * One more slope follows, k_(s+1) = f(t + h, y1): it is the next step's first ("first same as last"), and serves the
 * dense output.
 */
export interface EmbeddedTableau {
  /** Order of y1; the estimated error falls like h to this power. */
  readonly order: number;
  /** s, stages that y1 is made of. */
  readonly stages: number;
  /** c_1 … c_s, then 1 for the end of the step, then the nodes of further stages for the dense output alone. */
  readonly c: readonly number[];
  /** Row i: the weights a_ij of the slopes before it. Row s (from 0) is b. */
  readonly A: readonly (readonly number[])[];
  /** b minus the weights of the embedded formula; with or without a weight for the slope at the end. */
  readonly error: readonly number[];
  /** b minus the weights of a second embedded formula, of low order, as in DOP853 (`pairedErrorNorm`). */
  readonly lowOrderError?: readonly number[];
  /**
   * Weights of all slopes in what is added to the cubic Hermite polynomial of the step: h times these sums are the
   * coefficients p_3, p_4, … of `nestedAt` (shared/interpolation.ts). Empty: the Hermite polynomial, of order 3.
   */
  readonly dense: readonly (readonly number[])[];
}
