import { valueAt, weightsAt, type Tableau } from './collocationCoefficients.ts';
import { StageEquations } from './collocationStages.ts';
import { zeroCounters, type OdeProblem, type StepFailure, type Stepper, type StepperOptions } from './contract.ts';
import { allFinite, fixedStep } from './explicitFixed.ts';
import { Jacobian, PATIENT_ITERATIONS, REUSE_BELOW, SimplifiedNewton, roundingFloor, tightScale, type NewtonOutcome } from './newton.ts';
import { errorNorm, firstStep, PiController, stepWithin } from './stepControl.ts';

/**
 * Collocation methods: Gauss with 1 to 4 stages (order 2 s) and Radau IIA with 2 or 3 (order 2 s - 1).
 *
 * Hairer and Wanner, Solving ODEs II, 2nd ed., section IV.8, for both families: unknowns z_i = u(t0 + c_i h) - y0,
 * simplified Newton iterations with the matrix I - h A (x) J, started from the polynomial of the step before.
 *
 *   symbol  here          meaning
 *   z_i     z[i]          increments at the nodes
 *   c, A    tableau       nodes, Runge-Kutta matrix
 *   gamma0  tableau.gamma weight of f(t0, y0) in the embedded formula
 *   u       interpolate   collocation polynomial of degree s: order s between steps, the full order at their ends
 *
 * Error estimate, eq. (8.19) and (8.20): y1 is compared with the formula of order s that has the same nodes and
 * gamma0 f(t0, y0) besides. The difference is gamma0 h times the defect f(t0, y0) - u'(t0), for Gauss as for
 * Radau; it falls like h^(s+1), and (I - h gamma0 J)^-1 bounds it on stiff problems. It overestimates the error at
 * the end of the step (h^(2s+1), h^2s) and is of the size of that between the steps.
 *
 * An infinite `rtol` means equal steps (`step`, 0.001 unless given) without an estimate, each solved to relative
 * 1e-14 or to rounding: so Gauss keeps quadratic invariants and the symplectic structure.
 *
 * Not guaranteed: for Gauss, damping of what is stiff (|R(infinity)| = 1); for large systems, speed: one real
 * factorization of s n unknowns.
 */

const MOST_ITERATIONS = 7;
/** One more for the fourth stage and so on, as the larger system converges later. */
const MORE_PER_STAGE = 1;
/** A step below this many units in the last place of t cannot advance it reliably. */
const SMALLEST_ULPS = 16;
/** First step where f is not a number near the start, so that its size says nothing. */
const CAUTIOUS_STEP = 1e-6;
/** A step that would grow by less is kept, and with it the factors (RADAU5). */
const KEEP_BELOW = 1.2;
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
  private readonly n: number;
  /** Steps follow an error estimate. */
  private readonly controlled: boolean;
  private readonly controller: PiController;
  private readonly newton: SimplifiedNewton;
  private readonly tolerance: number;
  private readonly floor: number;
  private readonly jacobian: Jacobian;
  private readonly stages: StageEquations;
  private factoredFor = 0;
  /** E0 of the step being tried and of the last accepted. */
  private bend: Float64Array;
  private keptBend: Float64Array;
  private readonly rest: Float64Array;
  private readonly f1: Float64Array;
  /** The Jacobian may be used; and it is that at (t, y). */
  private known = false;
  private current = false;
  /** Increments of the step being tried, and of the last accepted one: they change places. */
  private z: Float64Array;
  private kept: Float64Array;
  /** The last polynomial may start Newton's method. */
  private guess = false;
  private readonly weights: Float64Array;
  private readonly endWeights: Float64Array;
  private readonly scale: Float64Array;
  private readonly yNew: Float64Array;
  private readonly error: Float64Array;
  private readonly scratch: Float64Array;
  private readonly f0: Float64Array;
  private readonly y0: Float64Array;
  private h = 0;
  /** The step being tried. */
  private trying = 0;
  private stepTaken = 0;
  private fresh = false;
  /** The step before was rejected, or there is none: eq. (8.20) applies. */
  private wary = true;

  constructor(problem: OdeProblem, options: StepperOptions, tableau: Tableau) {
    const n = problem.dimension;
    const s = tableau.stages;
    const vector = (length = n): Float64Array => new Float64Array(length);
    this.problem = problem;
    this.options = options;
    this.tableau = tableau;
    this.n = n;
    this.controlled = options.rtol < Infinity;
    this.controller = new PiController((globalThis as any).X.order ?? s + 1);
    this.newton = new SimplifiedNewton(this.controlled ? MOST_ITERATIONS + MORE_PER_STAGE * Math.max(0, s - 3) : PATIENT_ITERATIONS);
    // kappa tol as in RADAU5; without a tolerance one unit of `tightScale`.
    this.tolerance = this.controlled ? Math.max((10 * Number.EPSILON) / options.rtol, (globalThis as any).X.kappa ?? Math.min(0.03, Math.sqrt(options.rtol))) : 1;
    this.floor = this.controlled ? Math.min(0.1, roundingFloor(options.rtol)) : roundingFloor();
    this.jacobian = new Jacobian(problem, this.counters);
    this.stages = new StageEquations(problem, this.counters, tableau);
    this.bend = vector();
    this.keptBend = vector();
    this.rest = vector();
    this.f1 = vector();
    this.z = this.stages.z;
    this.kept = vector(s * n);
    this.weights = vector(s);
    this.endWeights = vector(s);
    weightsAt(1, tableau.c, this.endWeights);
    this.y = vector();
    this.scale = vector();
    this.yNew = vector();
    this.error = vector();
    this.scratch = vector();
    this.f0 = vector();
    this.y0 = vector();
  }

  reset(t: number, y: Float64Array): void {
    this.t = this.previousT = t;
    this.y.set(y);
    this.y0.set(y);
    this.kept.fill(0);
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
        // A Jacobian of an earlier state, or a bad guess, is to blame before the step is.
        if (this.current && !this.guess) this.h = h / 2;
        this.guess = false;
        this.known = this.current;
        if (!(this.h > smallest)) return this.reason(outcome);
      }
      this.counters.rejected++;
    }
  }

  interpolate(t: number, out: Float64Array): void {
    const { n, weights, kept } = this;
    const x = this.stepTaken > 0 ? (t - this.previousT) / this.stepTaken : 1;
    weightsAt(x, this.tableau.c, weights);
    const bend = valueAt(this.tableau.bend, x) * ((globalThis as any).X.dense);
    for (let i = 0; i < n; i++) {
      let sum = bend * this.keptBend[i]!;
      for (let s = 0; s < weights.length; s++) sum += weights[s]! * kept[s * n + i]!;
      out[i] = this.y0[i]! + sum;
    }
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

  /** A step of given length; Newton's method is given a second chance with this step's own Jacobian and no guess. */
  private equalStep(limit: number): StepFailure | null {
    const h = fixedStep(this.options, limit - this.t);
    if (!(this.t + h > this.t)) return 'step-too-small';
    // No estimate of the rate is carried over: what is left at the end of one iteration is not looked at again.
    this.newton.reset();
    let outcome = this.solve(h);
    if (outcome !== 'converged') {
      this.known = this.current;
      this.guess = false;
      outcome = this.solve(h);
    }
    if (outcome !== 'converged') return this.reason(outcome);
    this.accept(h, limit);
    return null;
  }

  /** `z` and `yNew` for a step h. */
  private solve(h: number): NewtonOutcome {
    this.trying = h;
    if (!this.known) {
      this.factoredFor = 0;
      if (!this.jacobian.evaluate(this.t, this.y, this.f0)) return 'no-value';
      this.known = this.current = true;
    }
    const X = (globalThis as any).X;
    const ratio = this.factoredFor / h;
    if (!(this.controlled ? ratio > 1 / X.stretch && ratio < X.stretch : ratio === 1) && !this.factor(h)) return 'slow';
    this.predict(h);
    const outcome = this.newton.solve(this.correct, this.tolerance, this.floor);
    if (outcome !== 'converged') return outcome;
    const { n, z, endWeights } = this;
    for (let i = 0; i < n; i++) {
      let sum = 0;
      for (let s = 0; s < endWeights.length; s++) sum += endWeights[s]! * z[s * n + i]!;
      this.yNew[i] = this.y[i]! + sum;
    }
    return allFinite(this.yNew) ? 'converged' : 'no-value';
  }

  private factor(h: number): boolean {
    this.factoredFor = 0;
    if (!this.stages.factor(h, this.jacobian.matrix)) return false;
    this.factoredFor = h;
    return true;
  }

  /** z from the polynomial of the last step, continued beyond its end; else 0. */
  private predict(h: number): void {
    const { n, z, kept, weights, endWeights } = this;
    const { stages, c } = this.tableau;
    const ratio = this.stepTaken > 0 ? h / this.stepTaken : Infinity;
    this.guess &&= ratio <= REACH;
    z.fill(0);
    if (!this.guess) return;
    for (let a = 0; a < stages; a++) {
      weightsAt(1 + c[a]! * ratio, c, weights);
      const bend = ((globalThis as any).X.predict ? 1 : 0) * valueAt(this.tableau.bend, 1 + c[a]! * ratio);
      for (let i = 0; i < n; i++) z[a * n + i]! += bend * this.keptBend[i]!;
      for (let b = 0; b < stages; b++) {
        const weight = weights[b]! - endWeights[b]!;
        for (let i = 0; i < n; i++) z[a * n + i]! += weight * kept[b * n + i]!;
      }
    }
  }

  private readonly correct = (): number => this.stages.correct(this.t, this.y, this.trying, this.scale);

  private errorOf(h: number): number {
    const { y, yNew, error, bend, rest, f0, scratch, n, z } = this;
    const { rtol, atol } = this.options;
    const { gamma, probe } = this.tableau;
    const X = (globalThis as any).X;
    this.startDefect(h, f0, rest);
    bend.set(rest);
    this.stages.damp(bend);
    if (X.est === 'low') {
      for (let i = 0; i < n; i++) error[i] = gamma * bend[i]!;
      let norm = errorNorm(error, y, yNew, rtol, atol);
      if (norm > 1 && this.wary && norm < Infinity) {
        for (let i = 0; i < n; i++) error[i]! += y[i]!;
        if (!this.f(this.t, error, scratch)) return norm;
        this.startDefect(h, scratch, error);
        this.stages.damp(error);
        for (let i = 0; i < n; i++) error[i]! *= gamma;
        norm = errorNorm(error, y, yNew, rtol, atol);
      }
      return norm * X.factor;
    }
    // probe
    const s = this.tableau.stages;
    for (let i = 0; i < n; i++) {
      let u = y[i]! + probe.bend * bend[i]!;
      for (let a = 0; a < s; a++) u += probe.weights[a]! * z[a * n + i]!;
      error[i] = u;
    }
    if (!this.f(this.t + probe.at * h, error, scratch)) return Infinity;
    for (let i = 0; i < n; i++) {
      let slope = probe.bendSlope * rest[i]!;
      for (let a = 0; a < s; a++) slope += probe.slope[a]! * z[a * n + i]!;
      error[i] = probe.gain * (h * scratch[i]! - slope);
    }
    this.stages.damp(error);
    const high = errorNorm(error, y, yNew, rtol, atol);
    if (X.est === 'probe') return high * X.factor;
    for (let i = 0; i < n; i++) error[i] = gamma * bend[i]!;
    const low = errorNorm(error, y, yNew, rtol, atol);
    return X.factor * high * Math.min(1, high / low);
  }

  /** out = h f - h u'(t0). */
  private startDefect(h: number, slope: Float64Array, out: Float64Array): void {
    const { n, z } = this;
    const { stages, startSlope } = this.tableau;
    for (let i = 0; i < n; i++) {
      let own = 0;
      for (let s = 0; s < stages; s++) own += startSlope[s]! * z[s * n + i]!;
      out[i] = h * slope[i]! - own;
    }
  }

  private accept(h: number, limit: number): void {
    this.previousT = this.t;
    this.stepTaken = h;
    this.t = h === limit - this.t ? limit : this.t + h;
    this.y0.set(this.y);
    this.y.set(this.yNew);
    const kept = this.kept;
    this.kept = this.z;
    this.z = this.stages.z = kept;
    const keptBend = this.keptBend;
    this.keptBend = this.bend;
    this.bend = keptBend;
    this.guess = true;
    this.fresh = this.current = this.wary = false;
    this.known = this.newton.theta < ((globalThis as any).X.reuse ?? REUSE_BELOW);
    this.counters.steps++;
  }

  /** The next step: shorter where Newton's method was slow (RADAU5), the same where it would grow little. */
  private chooseNext(h: number, error: number): void {
    const { iterations } = this.newton;
    const effort = (2 * MOST_ITERATIONS + 1) / (2 * MOST_ITERATIONS + iterations);
    const factor = this.controller.accept(error) * effort;
    const next = this.known && factor >= 1 && factor <= (globalThis as any).X.keep ? h : h * factor;
    // A step cut short by the limit says nothing about how long the next may be.
    this.h = h < this.h ? Math.max(this.h, next) : next;
  }
}
