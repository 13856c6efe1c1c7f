import type { Tableau } from './collocationCoefficients.ts';
import type { CollocationPolynomial } from './collocationPolynomial.ts';
import type { StageEquations } from './collocationStages.ts';
import type { Counters, OdeProblem } from './contract.ts';

/**
 * Defect of a collocation step at its start and at one more point: what is needed to correct the polynomial between the
 * ends of the step, and an estimate of the error of order s + 1.
 *
 * The start's defect h f(t0, y0) - h u'(t0), times a number, is RADAU5's estimate (Hairer and Wanner, Solving ODEs II,
 * 2nd ed., section IV.8, eq. (8.19)). It falls like h^(s+1), while the error of y1 falls like h^(2s) or h^(2s+1), so
 * that steps chosen by it are far shorter than they need be. Here it corrects the polynomial, and what is judged is the
 * next term of the polynomial's error, O(h^(s+2)): the larger of what follows from the start's defect through the
 * Jacobian, and of the defect that is left at a second point. Dense outputs chosen by their defect: W. Enright,
 * "Analysis of error control strategies for continuous Runge-Kutta methods", SIAM J. Numer. Anal. 26 (1989), 588-599.
 *
 * As in eq. (8.19), all is damped by (I - h gamma J)^-1, so that it stays bounded for what is stiff.
 */
/** What counts of an error that is made good afterwards: what is delivered then is about as accurate as with `dopri5`. */
const LENIENCE = 0.4;
/** And of the error of methods whose ends are no better. */
const STRICTNESS = 2;

export class CollocationDefect {
  private readonly problem: OdeProblem;
  private readonly counters: Counters;
  private readonly tableau: Tableau;
  private readonly stages: StageEquations;
  private readonly start: Float64Array;
  private readonly point: Float64Array;
  private readonly slope: Float64Array;

  constructor(problem: OdeProblem, counters: Counters, tableau: Tableau, stages: StageEquations) {
    const n = problem.dimension;
    this.problem = problem;
    this.counters = counters;
    this.tableau = tableau;
    this.stages = stages;
    this.start = new Float64Array(n);
    this.point = new Float64Array(n);
    this.slope = new Float64Array(n);
  }

  /**
   * Fills the corrections of the polynomial of a step h from t, where f has the value f0 and the equations were factored for
   * the step `factoredFor`. False where f has no value at the second point; then the last correction is zero.
   */
  measure(t: number, h: number, f0: Float64Array, polynomial: CollocationPolynomial, factoredFor: number): boolean {
    const { start, stages, tableau } = this;
    const { bend, twist } = polynomial;
    const n = f0.length;
    this.defectOf(tableau.startSlope, polynomial.z, f0, h, start);
    bend.set(start);
    stages.damp(bend);
    if (tableau.corrections.depth === 1) return true;
    // With R the damping, (R - 1) / gamma is h J to first order, and 2 - R undoes the damping to first order.
    twist.set(bend);
    stages.damp(twist);
    const factor = h / (factoredFor * stages.gamma);
    for (let i = 0; i < n; i++) {
      const change = twist[i]! - bend[i]!;
      bend[i]! -= change;
      twist[i] = factor * change;
    }
    return this.measureRest(t, h, polynomial);
  }

  /** h slope - h u', u' by weights of the increments. */
  private defectOf(weights: Float64Array, z: Float64Array, slope: Float64Array, h: number, out: Float64Array): void {
    const n = slope.length;
    for (let i = 0; i < n; i++) {
      let own = 0;
      for (let s = 0, at = i; s < weights.length; s++, at += n) own += weights[s]! * z[at]!;
      out[i] = h * slope[i]! - own;
    }
  }

  private measureRest(t: number, h: number, polynomial: CollocationPolynomial): boolean {
    const { start, point, slope } = this;
    const { at, slope: weights, m, integral } = this.tableau.corrections;
    const { rest, twist, z } = polynomial;
    rest.fill(0);
    polynomial.at(at, point);
    this.counters.evaluations++;
    if (!this.problem.derivative(t + at * h, point, slope)) return false;
    this.defectOf(weights, z, slope, h, rest);
    for (let i = 0; i < rest.length; i++) rest[i]! -= m * start[i]! + integral * twist[i]!;
    this.stages.damp(rest);
    return true;
  }

  /** Damps once more what the estimate is made of. */
  damp(polynomial: CollocationPolynomial): void {
    const { bend, twist, rest } = polynomial;
    if (this.tableau.corrections.depth === 1) this.stages.damp(bend);
    this.stages.damp(twist);
    this.stages.damp(rest);
  }

  /** Estimated size of the error within the step that the last corrections make good, into out (n). */
  estimate(polynomial: CollocationPolynomial, out: Float64Array): void {
    const { bend, twist, rest } = polynomial;
    const { depth, largest } = this.tableau.corrections;
    if (depth === 1) {
      for (let i = 0; i < out.length; i++) out[i] = STRICTNESS * largest[0] * bend[i]!;
      return;
    }
    const second = LENIENCE * largest[1];
    const third = LENIENCE * largest[2];
    for (let i = 0; i < out.length; i++) {
      const a = second * twist[i]!;
      const b = third * rest[i]!;
      out[i] = Math.sqrt(a * a + b * b);
    }
  }
}
