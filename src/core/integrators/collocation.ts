import type { Tableau } from './collocationCoefficients.ts';
import { CollocationDefect } from './collocationDefect.ts';
import { CollocationPolynomial } from './collocationPolynomial.ts';
import { StageEquations } from './collocationStages.ts';
import { zeroCounters, type OdeProblem, type StepFailure, type Stepper, type StepperOptions } from './contract.ts';
import { allFinite, fixedStep } from './explicitFixed.ts';
import { Jacobian, PATIENT_ITERATIONS, SimplifiedNewton, roundingFloor, tightScale, type NewtonOutcome } from './newton.ts';
import { errorNorm, firstStep, PiController, stepWithin } from './stepControl.ts';

/**
 * Collocation methods: Gauss with 1 to 4 stages (order 2 s) and Radau IIA with 2 or 3 (order 2 s - 1).
 *
 * Hairer and Wanner, Solving ODEs II, 2nd ed., section IV.8, for both families: unknowns z_i = u(t0 + c_i h) - y0,
 * simplified Newton iterations (`collocationStages.ts`) started from the polynomial of the step before, whose
 * Jacobian and factors are kept while the iterations converge fast.
 *
 * Dense output: u with corrections from its defect, of order s + 2 or that of the steps (`collocationPolynomial.ts`).
 * Step control: by the error between the ends that the last correction makes good (`collocationDefect.ts`). What is
 * delivered there and at the ends is better by an order.
 *
 * An infinite `rtol` means equal steps (`step`, 0.001 unless given) without an estimate, each solved to relative
 * 1e-14 or to rounding: so Gauss keeps quadratic invariants and the symplectic structure.
 *
 * Not guaranteed: for Gauss, damping of what is stiff (|R(infinity)| = 1).
 */

const MOST_ITERATIONS = 7;
/** One more for the fourth stage and so on, as the larger system converges later. */
const MORE_PER_STAGE = 1;
/**
 * What Newton's method may leave, in units of the tolerance. Section IV.8 advises 1e-1 to 1e-2; but in equations of second
 * order positions and velocities take turns at converging, and the rate seen last may be ten times below the next.
 */
const KAPPA = 1e-3;
/** A Jacobian is kept while an iteration wins this factor: a new one costs as much as one or two iterations. */
const REUSE_BELOW = 0.02;
/** Factors serve steps up to so many times longer or shorter than that they were made for, while they converge. */
const STRETCH = 2;
const STRETCH_IF_SLOW = 1.1;
/** A step below this many units in the last place of t cannot advance it reliably. */
const SMALLEST_ULPS = 16;
/** First step where f is not a number near the start, so that its size says nothing. */
const CAUTIOUS_STEP = 1e-6;
/** The last polynomial says nothing of a step that reaches further than this many of its own. */
const REACH = 4;
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
  private readonly newton: SimplifiedNewton;
  private readonly tolerance: number;
  private readonly floor: number;
  private readonly jacobian: Jacobian;
  private readonly stages: StageEquations;
  private readonly defect: CollocationDefect;
  /** Step for which the stage equations are factored; 0 if the factors are not to be used. */
  private factoredFor = 0;
  /** The Jacobian may be used; and it is that at (t, y). */
  private known = false;
  private current = false;
  /** Polynomials of the step being tried and of the last accepted one: they change places. */
  private trial: CollocationPolynomial;
  private kept: CollocationPolynomial;
  /** The last polynomial may start Newton's method. */
  private guess = false;
  private readonly scale: Float64Array;
  private readonly yNew: Float64Array;
  private readonly error: Float64Array;
  private readonly f0: Float64Array;
  private h = 0;
  /** The step being tried. */
  private trying = 0;
  private stepTaken = 0;
  private fresh = false;
  /** The step before was rejected, or there is none: what is stiff may be damped once more. */
  private wary = true;

  constructor(problem: OdeProblem, options: StepperOptions, tableau: Tableau) {
    const n = problem.dimension;
    const s = tableau.stages;
    this.problem = problem;
    this.options = options;
    this.tableau = tableau;
    this.controlled = options.rtol < Infinity;
    this.controller = new PiController(tableau.corrections.depth === 3 ? s + 2 : s + 1);
    this.newton = new SimplifiedNewton(this.controlled ? MOST_ITERATIONS + MORE_PER_STAGE * Math.max(0, s - 3) : PATIENT_ITERATIONS);
    this.tolerance = this.controlled ? Math.max((10 * Number.EPSILON) / options.rtol, KAPPA) : KAPPA;
    this.floor = this.controlled ? Math.min(0.1, roundingFloor(options.rtol)) : roundingFloor();
    this.jacobian = new Jacobian(problem, this.counters);
    this.stages = new StageEquations(problem, this.counters, tableau);
    this.defect = new CollocationDefect(problem, this.counters, tableau, this.stages);
    this.trial = new CollocationPolynomial(n, tableau);
    this.kept = new CollocationPolynomial(n, tableau);
    this.y = new Float64Array(n);
    this.scale = new Float64Array(n);
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
    this.factoredFor = 0;
    this.known = this.current = this.guess = this.fresh = false;
    this.wary = true;
    this.newton.reset();
    this.controller.reset();
    Object.assign(this.counters, zeroCounters());
  }

  /** The Jacobian and the polynomial stay: they decide how fast Newton's method converges, not to what. */
  stateChanged(): void {
    this.fresh = this.current = false;
  }

  step(limit: number): StepFailure | null {
    const { y, f0, options } = this;
    if (!this.fresh && !this.f(this.t, y, f0)) return this.problem.failure ?? 'non-finite';
    if (!allFinite(f0)) return 'non-finite';
    this.fresh = true;
    this.scaleBy(y);
    if (!this.controlled) return this.equalStep(limit);
    if (!(this.h > 0)) {
      this.h = firstStep((t, x, out) => this.f(t, x, out), this.t, y, f0, this.tableau.stages, options.rtol, options.atol, [this.yNew, this.error]);
      if (!(this.h > 0)) this.h = CAUTIOUS_STEP;
    }
    const smallest = SMALLEST_ULPS * Number.EPSILON * Math.max(Math.abs(this.t), Math.abs(limit - this.t));
    for (;;) {
      const h = stepWithin(this.h, limit - this.t, this.options.maxStep ?? Infinity);
      const outcome = this.solve(h);
      if (outcome === 'converged') {
        const error = this.errorOf(h);
        if (error <= 1) {
          this.accept(h, limit);
          this.chooseNext(h, error);
          return null;
        }
        this.h = h * this.controller.reject(error);
        this.wary = true;
        if (!(this.h > smallest)) return error < Infinity ? 'step-too-small' : (this.problem.failure ?? 'non-finite');
      } else {
        if (!this.known) return this.reason(outcome);
        this.afterFailure(h);
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

  private scaleBy(y: Float64Array): void {
    const { rtol, atol } = this.options;
    if (this.controlled) for (let i = 0; i < y.length; i++) this.scale[i] = atol + rtol * Math.abs(y[i]!);
    else tightScale(y, this.scale);
  }

  /** Newton's method failed: factors of another step, an old Jacobian or a bad guess are to blame before the step is. */
  private afterFailure(h: number): void {
    if (this.factoredFor === h && this.current && !this.guess) this.h = h / 2;
    this.factoredFor = 0;
    this.guess = false;
    this.known = this.current;
  }

  /** A step of given length; Newton's method is given a second chance with this step's own Jacobian and no guess. */
  private equalStep(limit: number): StepFailure | null {
    const h = fixedStep(this.options, limit - this.t);
    if (!(this.t + h > this.t)) return 'step-too-small';
    // No estimate of the rate is carried over: what is left at the end of one iteration is not looked at again.
    this.newton.reset();
    let outcome = this.solve(h);
    if (outcome !== 'converged') {
      this.afterFailure(0);
      outcome = this.solve(h);
    }
    if (outcome !== 'converged') return this.reason(outcome);
    this.defect.measure(this.t, h, this.f0, this.trial, this.factoredFor);
    this.accept(h, limit);
    return null;
  }

  /** The polynomial `trial` and `yNew` for a step h. */
  private solve(h: number): NewtonOutcome {
    this.trying = h;
    if (!this.known) {
      this.factoredFor = 0;
      if (!this.jacobian.evaluate(this.t, this.y, this.f0)) return 'no-value';
      this.known = this.current = true;
    }
    if (!this.factorsServe(h) && !this.factor(h)) return 'slow';
    this.trial.y0.set(this.y);
    this.predict(h);
    const outcome = this.newton.solve(this.correct, this.tolerance, this.floor);
    if (outcome !== 'converged') return outcome;
    this.trial.end(this.yNew);
    return allFinite(this.yNew) ? 'converged' : 'no-value';
  }

  private factorsServe(h: number): boolean {
    const ratio = this.factoredFor / h;
    return this.controlled ? ratio < STRETCH && ratio > 1 / STRETCH : ratio === 1;
  }

  private factor(h: number): boolean {
    this.factoredFor = 0;
    if (!this.stages.factor(h, this.jacobian.matrix)) return false;
    this.factoredFor = h;
    return true;
  }

  /** Increments from the polynomial of the last step, continued beyond its end; else 0. */
  private predict(h: number): void {
    const { stages, c } = this.tableau;
    const { z } = this.trial;
    const ratio = this.stepTaken > 0 ? h / this.stepTaken : Infinity;
    this.guess &&= ratio <= REACH;
    if (!this.guess) z.fill(0);
    else for (let a = 0; a < stages; a++) this.kept.beyond(1 + c[a]! * ratio, z, a * this.y.length);
  }

  private readonly correct = (): number => this.stages.correct(this.t, this.y, this.trying, this.trial.z, this.scale);

  /** Scaled error of the step, to be at most 1; infinite when anything is not a number. */
  private errorOf(h: number): number {
    const { defect, trial } = this;
    if (!defect.measure(this.t, h, this.f0, trial, this.factoredFor)) return Infinity;
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
    this.guess = true;
    this.fresh = this.current = this.wary = false;
    this.counters.steps++;
    if (this.newton.theta < REUSE_BELOW) return;
    // Factors of another step make it slow as well as an old Jacobian does.
    const ratio = this.factoredFor / h;
    if (ratio < STRETCH_IF_SLOW && ratio > 1 / STRETCH_IF_SLOW) this.known = false;
    else this.factoredFor = 0;
  }

  /** The next step: shorter where Newton's method was slow (RADAU5). */
  private chooseNext(h: number, error: number): void {
    const { iterations } = this.newton;
    const effort = (2 * MOST_ITERATIONS + 1) / (2 * MOST_ITERATIONS + iterations);
    const next = h * this.controller.accept(error) * effort;
    // A step cut short by the limit says nothing about how long the next may be.
    this.h = h < this.h ? Math.max(this.h, next) : next;
  }
}
