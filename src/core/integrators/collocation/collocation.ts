import type { Tableau } from './collocationCoefficients.ts';
import { CollocationDefect } from './collocationDefect.ts';
import { CollocationPolynomial } from './collocationPolynomial.ts';
import { CollocationSolver } from './collocationSolver.ts';
import type { OdeProblem, StepFailure, StepperOptions } from '../contract.ts';
import { AdaptiveOneStep } from '../shared/adaptiveOneStep.ts';
import { allFinite } from '../shared/finite.ts';
import { DEFAULT_STEP } from '../shared/fixedStepper.ts';
import type { NewtonOutcome } from '../shared/newton.ts';
import { errorNorm, fixedWithin } from '../shared/stepControl.ts';

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

export class Collocation extends AdaptiveOneStep {
  /** Steps follow an error estimate. */
  private readonly controlled: boolean;
  private readonly solver: CollocationSolver;
  private readonly defect: CollocationDefect;
  /** Polynomials of the step being tried and of the last accepted one: they change places. */
  private trial: CollocationPolynomial;
  private kept: CollocationPolynomial;
  protected readonly startSlope: Float64Array;
  /** The step before was rejected, or there is none: the estimate of a step that fails may be damped once more. */
  private dampTwice = true;

  constructor(problem: OdeProblem, options: StepperOptions, tableau: Tableau) {
    const n = problem.dimension;
    const { estimateOrder, stages } = tableau;
    super(problem, options, estimateOrder + 1, stages);
    this.controlled = options.rtol < Infinity;
    this.solver = new CollocationSolver(problem, options, tableau, this.counters);
    this.defect = new CollocationDefect(problem, this.counters, tableau, this.solver.stages);
    this.trial = new CollocationPolynomial(n, tableau);
    this.kept = new CollocationPolynomial(n, tableau);
    this.startSlope = new Float64Array(n);
  }

  override reset(t: number, y: Float64Array): void {
    super.reset(t, y);
    this.kept.setConstant(y);
    this.dampTwice = true;
    this.solver.reset();
  }

  override stateChanged(): void {
    super.stateChanged();
    this.solver.stateChanged();
  }

  override restart(): void {
    super.restart();
    this.dampTwice = true;
    this.solver.reset();
  }

  override step(limit: number, maxStep = Infinity): StepFailure | null {
    return this.controlled ? super.step(limit, maxStep) : this.equalStep(limit, maxStep);
  }

  interpolate(t: number, out: Float64Array): void {
    this.kept.at(this.fraction(t), out);
  }

  protected attempt(h: number): number {
    this.outcome = this.solve(h);
    return this.outcome === 'converged' ? this.errorOf(h) : Infinity;
  }

  protected override retry(h: number, error: number, tries: number): number {
    const { solver } = this;
    if (this.outcome === 'converged') {
      this.dampTwice = true;
      return super.retry(h, error, tries);
    }
    if (!solver.hasJacobian) return 0;
    return solver.startOver(h) ? h / 2 : this.h;
  }

  protected accept(h: number, error: number): void {
    this.keep(h);
    this.chooseNext(h, error, this.solver.effort);
  }

  /** A step of given length; Newton's method is given a second chance with this step's own Jacobian and no guess. */
  private equalStep(limit: number, maxStep: number): StepFailure | null {
    const failure = this.beginSlope();
    if (failure) return failure;
    const left = limit - this.t;
    const h = fixedWithin(this.options.step ?? DEFAULT_STEP, left, this.bound(maxStep));
    if (!(this.t + h > this.t)) return 'step-too-small';
    this.outcome = this.solve(h);
    if (this.outcome !== 'converged') {
      this.solver.startOver(h);
      this.outcome = this.solve(h);
    }
    if (this.outcome !== 'converged') return this.failure(Infinity);
    this.defect.measure(this.t, h, this.startSlope, this.trial, this.solver.factoredFor);
    this.previousT = this.t;
    this.stepTaken = h;
    this.t = h === left ? limit : this.t + h;
    this.keep(h);
    this.counters.steps++;
    return null;
  }

  /** The polynomial `trial` and `yNew` for a step h. */
  private solve(h: number): NewtonOutcome {
    const ratio = this.stepTaken > 0 ? h / this.stepTaken : Infinity;
    const outcome = this.solver.solve(this.t, this.y, this.startSlope, h, this.trial, this.kept, ratio);
    if (outcome !== 'converged') return outcome;
    this.trial.end(this.yNew);
    return allFinite(this.yNew) ? 'converged' : 'no-value';
  }

  /** Scaled error of the step, to be at most 1; infinite when anything is not a number. */
  private errorOf(h: number): number {
    const { defect, trial } = this;
    if (!defect.measure(this.t, h, this.startSlope, trial, this.solver.factoredFor)) return Infinity;
    const error = this.estimate();
    if (error <= 1 || !this.dampTwice || !(error < Infinity)) return error;
    defect.damp(trial);
    return this.estimate();
  }

  private estimate(): number {
    const { rtol, atol } = this.options;
    this.defect.estimate(this.trial, this.error);
    return errorNorm(this.error, 1, this.y, this.yNew, rtol, atol);
  }

  /** The tried step is the last accepted one. */
  private keep(h: number): void {
    this.y.set(this.yNew);
    const { kept } = this;
    this.kept = this.trial;
    this.trial = kept;
    this.fresh = this.dampTwice = false;
    this.solver.accepted(h);
  }
}
