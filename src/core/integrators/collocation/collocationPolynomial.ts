import { weightsAt, type Tableau } from './collocationCoefficients.ts';
import { valueAt } from '../shared/polynomials.ts';

/**
 * What lies between the ends of one collocation step, as a function of x = (t - t0) / h: the collocation polynomial u
 * and three corrections to it.
 *
 * u is of order s only between the ends (error O(h^(s+1)) within a step), while y1 = u(t0 + h) is of order 2 s or
 * 2 s - 1. What it lacks obeys e' = J e + d + …, d = f(t, u) - u' its defect, e = 0 at the start. d vanishes at the
 * nodes, hence d = m(x) d(t0) to the lowest order, M(x) = (x - c_1) … (x - c_s), m = M / M(0); `collocationDefect.ts`
 * measures it at the start and at one more point:
 *
 *   vector    shape                              what it makes good
 *   startDefect    integral of m          h d at the start: O(h^(s+1))
 *   propagated     the integral of that   h J startDefect: O(h^(s+2))
 *   secondDefect   integral of N = x M    what is left of the defect at one more point: O(h^(s+2))
 *
 * The error between the ends then is O(h^(s+3)), or that of y1 if this is larger; an old Jacobian leaves a part of the
 * O(h^(s+2)). For Gauss with one stage and Radau with two, whose ends are of order s + 1, `startDefect` is all that makes sense,
 * and the others are zero. Interpolants from the defect: W. Enright, K. Jackson, S. Nørsett, P. Thomsen, "Interpolants for
 * Runge-Kutta formulas", ACM Trans. Math. Software 12 (1986), 193-218.
 */
export class CollocationPolynomial {
  /** Increments u(t0 + c_i h) - y0, s x n. */
  readonly z: Float64Array;
  readonly y0: Float64Array;
  readonly startDefect: Float64Array;
  readonly propagated: Float64Array;
  readonly secondDefect: Float64Array;

  private readonly tableau: Tableau;
  private readonly weights: Float64Array;
  private readonly endWeights: Float64Array;
  private readonly ends: Float64Array;

  constructor(n: number, tableau: Tableau) {
    const s = tableau.stages;
    this.tableau = tableau;
    this.z = new Float64Array(s * n);
    this.y0 = new Float64Array(n);
    this.startDefect = new Float64Array(n);
    this.propagated = new Float64Array(n);
    this.secondDefect = new Float64Array(n);
    this.weights = new Float64Array(s);
    this.endWeights = new Float64Array(s);
    weightsAt(1, tableau.c, this.endWeights);
    this.ends = Float64Array.from(tableau.corrections.shapes, (shape) => valueAt(shape, 1));
  }

  /**
   * The constant y.
   * @param y n
   */
  setConstant(y: Float64Array): void {
    this.y0.set(y);
    for (const part of [this.z, this.startDefect, this.propagated, this.secondDefect]) part.fill(0);
  }

  /**
   * u at the end of the step, y1.
   * @param out n
   */
  end(out: Float64Array): void {
    const { y0, z, endWeights } = this;
    const n = out.length;
    for (let i = 0; i < n; i++) {
      let sum = 0;
      for (let s = 0; s < endWeights.length; s++) sum += endWeights[s]! * z[s * n + i]!;
      out[i] = y0[i]! + sum;
    }
  }

  /**
   * The corrected polynomial; it meets both ends.
   * @param x fraction of the step, 0 to 1
   * @param out n
   */
  at(x: number, out: Float64Array): void {
    const { weights, ends } = this;
    const { c, corrections } = this.tableau;
    const [first, second, third] = corrections.shapes;
    weightsAt(x, c, weights);
    this.combine(
      valueAt(first, x) - x * ends[0]!,
      valueAt(second, x) - x * ends[1]!,
      valueAt(third, x) - x * ends[2]!,
      out,
      0,
    );
    for (let i = 0; i < out.length; i++) out[i]! += this.y0[i]!;
  }

  /**
   * The corrected polynomial beyond its end, less what it is there.
   * @param x fraction of the step, more than 1
   * @param out receives n values
   * @param offset from this index on
   */
  extrapolate(x: number, out: Float64Array, offset: number): void {
    const { weights, endWeights, ends } = this;
    const { c, corrections } = this.tableau;
    const [first, second, third] = corrections.shapes;
    weightsAt(x, c, weights);
    for (let s = 0; s < weights.length; s++) weights[s]! -= endWeights[s]!;
    this.combine(
      valueAt(first, x) - ends[0]!,
      valueAt(second, x) - ends[1]!,
      valueAt(third, x) - ends[2]!,
      out,
      offset,
    );
  }

  private combine(a: number, b: number, c: number, out: Float64Array, offset: number): void {
    const { z, startDefect, propagated, secondDefect, weights } = this;
    const n = startDefect.length;
    for (let i = 0; i < n; i++) {
      let sum = a * startDefect[i]! + b * propagated[i]! + c * secondDefect[i]!;
      for (let s = 0, at = i; s < weights.length; s++, at += n) sum += weights[s]! * z[at]!;
      out[offset + i] = sum;
    }
  }
}
