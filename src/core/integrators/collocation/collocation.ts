import type { Tableau } from './collocationCoefficients.ts';
import { CollocationDefect } from './collocationDefect.ts';
import { CollocationPolynomial } from './collocationPolynomial.ts';
import { CollocationSolver } from './collocationSolver.ts';
import { zeroCounters, type OdeProblem, type StepFailure, type Stepper, type StepperOptions } from '../contract.ts';
import { allFinite, fixedStep } from '../runge-kutta/explicitFixed.ts';
import type { NewtonOutcome } from '../shared/newton.ts';
import { errorNorm, firstStep, PiController, stepWithin } from '../shared/stepControl.ts';

/**
 * Collocation methods: Gauss with 1 to 4 stages (order 2 s) and Radau IIA with 2 or 3 (order 2 s - 1).
 *
 * Hairer and Wanner, Solving ODEs II, 2nd ed., section IV.8, for both families; in parts:
 *
 *   collocationCoefficients   what follows from the nodes
 *   collocationTransform      eigenvalues and eigenvectors of the Runge-Kutta matrix
 *   collocationBlocks         the linear systems that are left for each eigenvalue
 *   collocationStages         one Newton iteration for the increments z_i = u(t0 + c_i h) - y0
 *   collocationSolver         when to make a new Jacobian or new factors, and from where to start
 *   collocationPolynomial     dense output: u corrected by its defect, of order s + 2 or that of the steps
 *   collocationDefect         the corrections, and the error estimate
 *
 * Steps are chosen by the error between the ends that the last corrections make good. What is delivered there and at
 * the ends is better by an order.
 *
 * An infinite `rtol` means equal steps (`step`, 0.001 unless given) without an estimate, each solved to relative
 * 1e-14 or to rounding: so Gauss keeps quadratic invariants and the symplectic structure.
 *
 * Not guaranteed: for Gauss, damping of what is stiff (|R(infinity)| = 1).
 */

/** A step below this many units in the last place of t cannot advance it reliably. */
const SMALLEST_ULPS = 16;
/** First step where f is not a number near the start, so that its size says nothing. */
const CAUTIOUS_STEP = 1e-6;

export class Collocation implements Stepper {
  t = 0;
  previousT = 0;
  readonly y: Float64Array;
  readonly counters = zeroCounters();

  private readonly problem: OdeProblem;
  private readonly options: StepperOptions;
  private readonly tableau: Tableau;
  /** Steps follow an error estimate. */
  private readonly controlled: boolean;
  private readonly controller: PiController;
  private readonly solver: CollocationSolver;
  private readonly defect: CollocationDefect;
  /** Polynomials of the step being tried and of the last accepted one: they change places. */
  private trial: CollocationPolynomial;
  private kept: CollocationPolynomial;
  private readonly yNew: Float64Array;
  private readonly error: Float64Array;
  private readonly f0: Float64Array;
  private h = 0;
  private stepTaken = 0;
  /** f0 is f(t, y). */
  private fresh = false;
  /** The step before was rejected, or there is none: what is stiff may be damped once more. */
  private wary = true;

  constructor(problem: OdeProblem, options: StepperOptions, tableau: Tableau) {
    const n = problem.dimension;
    this.problem = problem;
    this.options = options;
    this.tableau = tableau;
    this.controlled = options.rtol < Infinity;
    this.solver = new CollocationSolver(problem, options, tableau, this.counters);
    this.defect = new CollocationDefect(problem, this.counters, tableau, this.solver.stages);
    this.controller = new PiController(this.defect.estimateOrder + 1);
    this.trial = new CollocationPolynomial(n, tableau);
    this.kept = new CollocationPolynomial(n, tableau);
    this.y = new Float64Array(n);
    this.yNew = new Float64Array(n);
    this.error = new Float64Array(n);
    this.f0 = new Float64Array(n);
  }

  reset(t: number, y: Float64Array): void {
    this.t = this.previousT = t;
    this.y.set(y);
    this.kept.settle(y);
    this.stepTaken = 0;
    this.h = this.options.step ?? 0;
    this.fresh = false;
    this.wary = true;
    this.solver.reset();
    this.controller.reset();
    Object.assign(this.counters, zeroCounters());
  }

  stateChanged(): void {
    this.fresh = false;
    this.solver.stateChanged();
  }

  step(limit: number): StepFailure | null {
    const { y, f0, options, solver } = this;
    if (!this.fresh && !this.f(this.t, y, f0)) return this.problem.failure ?? 'non-finite';
    if (!allFinite(f0)) return 'non-finite';
    this.fresh = true;
    if (!this.controlled) return this.equalStep(limit);
    if (!(this.h > 0)) {
      this.h = firstStep(
        (t, x, out) => this.f(t, x, out),
        this.t,
        y,
        f0,
        this.tableau.stages,
        options.rtol,
        options.atol,
        [this.yNew, this.error],
      );
      if (!(this.h > 0)) this.h = CAUTIOUS_STEP;
    }
    const smallest = SMALLEST_ULPS * Number.EPSILON * Math.max(Math.abs(this.t), Math.abs(limit - this.t));
    for (;;) {
      const h = stepWithin(this.h, limit - this.t, options.maxStep ?? Infinity);
      const outcome = this.solve(h);
      if (outcome === 'converged') {
        const error = this.errorOf(h);
        if (error <= 1) {
          this.accept(h, limit);
          // A step cut short by the limit says nothing about how long the next may be.
          const next = h * this.controller.accept(error) * solver.effort;
          this.h = h < this.h ? Math.max(this.h, next) : next;
          return null;
        }
        this.h = h * this.controller.reject(error);
        this.wary = true;
        if (!(this.h > smallest)) return error < Infinity ? 'step-too-small' : (this.problem.failure ?? 'non-finite');
      } else {
        if (!solver.hasJacobian) return this.reason(outcome);
        if (solver.startOver(h)) this.h = h / 2;
        if (!(this.h > smallest)) return this.reason(outcome);
      }
      this.counters.rejected++;
    }
  }

  interpolate(t: number, out: Float64Array): void {
    this.kept.at(this.stepTaken > 0 ? (t - this.previousT) / this.stepTaken : 1, out);
  }

  private f(t: number, y: Float64Array, out: Float64Array): boolean {
    this.counters.evaluations++;
    return this.problem.derivative(t, y, out);
  }

  private reason(outcome: NewtonOutcome): StepFailure {
    return outcome === 'slow' ? 'newton' : (this.problem.failure ?? 'non-finite');
  }

  /** A step of given length; Newton's method is given a second chance with this step's own Jacobian and no guess. */
  private equalStep(limit: number): StepFailure | null {
    const h = fixedStep(this.options, limit - this.t);
    if (!(this.t + h > this.t)) return 'step-too-small';
    let outcome = this.solve(h);
    if (outcome !== 'converged') {
      this.solver.startOver(h);
      outcome = this.solve(h);
    }
    if (outcome !== 'converged') return this.reason(outcome);
    this.defect.measure(this.t, h, this.f0, this.trial, this.solver.factoredFor);
    this.accept(h, limit);
    return null;
  }

  /** The polynomial `trial` and `yNew` for a step h. */
  private solve(h: number): NewtonOutcome {
    const ratio = this.stepTaken > 0 ? h / this.stepTaken : Infinity;
    const outcome = this.solver.solve(this.t, this.y, this.f0, h, this.trial, this.kept, ratio);
    if (outcome !== 'converged') return outcome;
    this.trial.end(this.yNew);
    return allFinite(this.yNew) ? 'converged' : 'no-value';
  }

  /** Scaled error of the step, to be at most 1; infinite when anything is not a number. */
  private errorOf(h: number): number {
    const { defect, trial } = this;
    if (!defect.measure(this.t, h, this.f0, trial, this.solver.factoredFor)) return Infinity;
    const error = this.judge();
    if (error <= 1 || !this.wary || !(error < Infinity)) return error;
    defect.damp(trial);
    return this.judge();
  }

  private judge(): number {
    const { rtol, atol } = this.options;
    this.defect.estimate(this.trial, this.error);
    return errorNorm(this.error, this.y, this.yNew, rtol, atol);
  }

  private accept(h: number, limit: number): void {
    this.previousT = this.t;
    this.stepTaken = h;
    this.t = h === limit - this.t ? limit : this.t + h;
    this.y.set(this.yNew);
    const { kept } = this;
    this.kept = this.trial;
    this.trial = kept;
    this.fresh = this.wary = false;
    this.solver.accepted(h);
    this.counters.steps++;
  }
}
