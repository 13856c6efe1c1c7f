import type { Tableau } from './collocationCoefficients.ts';
import type { CollocationPolynomial } from './collocationPolynomial.ts';
import type { StageEquations } from './collocationStages.ts';
import type { Counters, OdeProblem } from '../contract.ts';

/**
 * The defect f(t, u) - u' of a collocation step, measured at its start and at one more point: it gives the corrections of
 * the polynomial between the ends (`collocationPolynomial.ts`), and the error estimate.
 *
 * The defect at the start, times a number, is RADAU5's estimate (Hairer and Wanner, Solving ODEs II, 2nd ed., section
 * IV.8, eq. (8.19)). It falls like h^(s+1), while the error of y1 falls like h^(2s) or h^(2s+1), so that at usual
 * tolerances steps chosen by it are far shorter than they need be. Here it corrects the polynomial, and what is judged is
 * the next term of the polynomial's error, O(h^(s+2)): what follows from the start's defect through the Jacobian, and
 * the defect that is left at a second point. Control of a continuous method by its defect: W. Enright, "Analysis of error
 * control strategies for continuous Runge-Kutta methods", SIAM J. Numer. Anal. 26 (1989), 588-599.
 *
 * As in eq. (8.19) all is damped by (I - h gamma J)^-1, so that it stays bounded for what is stiff; and once more, in place
 * of eq. (8.20), at the start of a run and after a rejected step.
 */

/** What counts of an error that is made good afterwards: what is delivered then is about as accurate as with `dopri5`. */
const ESTIMATE_FACTOR = 0.3;
/** And of the error of methods whose ends are no better. */
const SINGLE_ESTIMATE_FACTOR = 2;

export class CollocationDefect {
  private readonly problem: OdeProblem;
  private readonly counters: Counters;
  private readonly tableau: Tableau;
  private readonly stages: StageEquations;
  /** Of the three corrections only the first makes sense. */
  private readonly single: boolean;
  private readonly start: Float64Array;
  private readonly point: Float64Array;
  private readonly slope: Float64Array;

  constructor(problem: OdeProblem, counters: Counters, tableau: Tableau, stages: StageEquations) {
    const n = problem.dimension;
    this.problem = problem;
    this.counters = counters;
    this.tableau = tableau;
    this.stages = stages;
    this.single = tableau.corrections.depth === 1;
    this.start = new Float64Array(n);
    this.point = new Float64Array(n);
    this.slope = new Float64Array(n);
  }

  /**
   * Fills the corrections of the polynomial of a step.
   * @param t start of the step, s
   * @param h its length, s
   * @param f0 f(t, y), n
   * @param factoredFor length that the stage equations were factored for, s
   * @returns false where f has no value at the second point; the last correction is zero then
   */
  measure(t: number, h: number, f0: Float64Array, polynomial: CollocationPolynomial, factoredFor: number): boolean {
    const { start, stages, tableau } = this;
    const { startDefect, propagated } = polynomial;
    defectOf(tableau.startSlope, polynomial.z, f0, h, start);
    startDefect.set(start);
    stages.damp(startDefect);
    if (this.single) return true;
    // With R the damping, (R - 1) / gamma is h J to first order, and 2 - R undoes the damping to first order.
    propagated.set(startDefect);
    stages.damp(propagated);
    const factor = h / (factoredFor * stages.gamma);
    for (let i = 0; i < startDefect.length; i++) {
      const change = propagated[i]! - startDefect[i]!;
      startDefect[i]! -= change;
      propagated[i] = factor * change;
    }
    return this.measureSecond(t, h, polynomial);
  }

  private measureSecond(t: number, h: number, polynomial: CollocationPolynomial): boolean {
    const { start, point, slope } = this;
    const { at, slope: weights, m, integral } = this.tableau.corrections;
    const { secondDefect, propagated, z } = polynomial;
    secondDefect.fill(0);
    polynomial.at(at, point);
    this.counters.evaluations++;
    if (!this.problem.derivative(t + at * h, point, slope)) return false;
    defectOf(weights, z, slope, h, secondDefect);
    for (let i = 0; i < secondDefect.length; i++) secondDefect[i]! -= m * start[i]! + integral * propagated[i]!;
    this.stages.damp(secondDefect);
    return true;
  }

  /** Damps once more what the estimate is made of. */
  damp(polynomial: CollocationPolynomial): void {
    const { startDefect, propagated, secondDefect } = polynomial;
    if (this.single) return this.stages.damp(startDefect);
    this.stages.damp(propagated);
    this.stages.damp(secondDefect);
  }

  /**
   * Estimated error within the step, as far as it counts.
   * @param out n
   */
  estimate(polynomial: CollocationPolynomial, out: Float64Array): void {
    const { startDefect, propagated, secondDefect } = polynomial;
    const { largest } = this.tableau.corrections;
    for (let i = 0; i < out.length; i++) {
      out[i] = this.single
        ? SINGLE_ESTIMATE_FACTOR * largest[0] * startDefect[i]!
        : ESTIMATE_FACTOR * hypotenuse(largest[1] * propagated[i]!, largest[2] * secondDefect[i]!);
    }
  }
}

/** h slope - h u', where u' has these weights of the increments z. */
function defectOf(weights: Float64Array, z: Float64Array, slope: Float64Array, h: number, out: Float64Array): void {
  const n = slope.length;
  for (let i = 0; i < n; i++) {
    let own = 0;
    for (let s = 0, at = i; s < weights.length; s++, at += n) own += weights[s]! * z[at]!;
    out[i] = h * slope[i]! - own;
  }
}

function hypotenuse(a: number, b: number): number {
  return Math.sqrt(a * a + b * b);
}
