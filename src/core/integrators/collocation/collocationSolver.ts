import type { Tableau } from './collocationCoefficients.ts';
import type { CollocationPolynomial } from './collocationPolynomial.ts';
import { StageEquations } from './collocationStages.ts';
import type { Counters, OdeProblem, StepperOptions } from '../contract.ts';
import {
  Jacobian,
  MOST_ITERATIONS_FIXED_STEP,
  SimplifiedNewton,
  roundingFloor,
  roundingScale,
  type NewtonOutcome,
} from '../shared/newton.ts';
import { power } from '../../elementary/powers.ts';

/**
 * Solves the equations of collocation steps one after another, by simplified Newton iterations started from the
 * polynomial of the step before. The Jacobian and its factors are kept while the iterations converge fast: Hairer and
 * Wanner, Solving ODEs II, 2nd ed., section IV.8.
 *
 * Not guaranteed: convergence. `startOver` then says whether the step is to blame or what was kept.
 */

const MOST_ITERATIONS = 7;
/** One more for the fourth stage and so on, as the larger system converges later. */
const MORE_PER_STAGE = 1;
/**
 * What Newton's method may leave, in units of the tolerance: section IV.8 advises 1e-1 to 1e-2. It is left in the same
 * direction step after step, and the sharper the tolerance, the more steps there are and the less else there is; RADAU5
 * and SciPy go down with the square root of rtol. Measured: docs/decisions/0019-newton-constants.md.
 */
const kappa = (rtol: number): number => Math.min(3e-2, Math.max(1e-3, 0.3 * power(rtol, 0.25)));
/** In equal steps, in units of the accuracy that equations without a tolerance are solved to. */
const KAPPA_EQUAL_STEPS = 1e-3;
/** A Jacobian is kept while an iteration wins this factor: a new one costs as much as one or two iterations. */
const REUSE_BELOW = 0.05;
/** Factors serve steps up to so many times longer or shorter than that they were made for, while they converge. */
const STRETCH = 2;
const STRETCH_IF_SLOW = 1.1;
/**
 * A rate of convergence belongs to its factors: what is stiff converges like |1 - h / h_f| with factors for h_f. It is
 * measured anew where h is further from h_f by this factor than where it was measured.
 */
const SAME_MISMATCH = 1.02;
/** The last polynomial says nothing of a step that reaches further than this many of its own. */
const MOST_EXTRAPOLATION = 4;

export class CollocationSolver {
  readonly stages: StageEquations;
  /** Step for which the stage equations are factored; 0 if the factors are not to be used. */
  factoredFor = 0;

  private readonly options: StepperOptions;
  private readonly tableau: Tableau;
  private readonly controlled: boolean;
  private readonly newton: SimplifiedNewton;
  private readonly tolerance: number;
  private readonly floor: number;
  private readonly jacobian: Jacobian;
  private readonly scale: Float64Array;
  /** The Jacobian may be used; and it is that at the state the step starts from. */
  private known = false;
  private current = false;
  /** The last polynomial may start Newton's method. */
  private guess = false;
  /** How far h was from that of the factors, as a factor of at least 1, when the rate of convergence was last measured. */
  private measuredMismatch = 1;
  private t = 0;
  private h = 0;
  private y: Float64Array;
  private z: Float64Array;

  constructor(problem: OdeProblem, options: StepperOptions, tableau: Tableau, counters: Counters) {
    const { rtol } = options;
    const s = tableau.stages;
    this.options = options;
    this.tableau = tableau;
    this.controlled = rtol < Infinity;
    this.newton = new SimplifiedNewton(
      this.controlled ? MOST_ITERATIONS + MORE_PER_STAGE * Math.max(0, s - 3) : MOST_ITERATIONS_FIXED_STEP,
    );
    this.tolerance = this.controlled ? Math.max((10 * Number.EPSILON) / rtol, kappa(rtol)) : KAPPA_EQUAL_STEPS;
    this.floor = this.controlled ? Math.min(0.1, roundingFloor(rtol)) : roundingFloor();
    this.jacobian = new Jacobian(problem, counters);
    this.stages = new StageEquations(problem, counters, tableau);
    this.scale = new Float64Array(problem.dimension);
    this.y = this.scale;
    this.z = this.scale;
  }

  reset(): void {
    this.factoredFor = 0;
    this.known = this.current = this.guess = false;
    this.measuredMismatch = 1;
    this.newton.reset();
  }

  /** The state the next step starts from was moved. The Jacobian and the guess stay: they decide how fast, not to what. */
  stateChanged(): void {
    this.current = false;
  }

  /** There is a Jacobian; if not, a failed `solve` found none. */
  get hasJacobian(): boolean {
    return this.known;
  }

  /** At most 1, and less for a step that took more iterations (RADAU5): a factor for the length of the next step. */
  get effort(): number {
    return (2 * MOST_ITERATIONS + 1) / (2 * MOST_ITERATIONS + this.newton.iterations);
  }

  /**
   * Increments of `trial` for a step from (t, y).
   * @param t s
   * @param y n
   * @param f0 f(t, y), n
   * @param h length of the step, s
   * @param trial receives y and the increments
   * @param last the polynomial of the step before
   * @param ratio h by the length of that step
   */
  solve(
    t: number,
    y: Float64Array,
    f0: Float64Array,
    h: number,
    trial: CollocationPolynomial,
    last: CollocationPolynomial,
    ratio: number,
  ): NewtonOutcome {
    this.t = t;
    this.y = y;
    this.h = h;
    this.z = trial.z;
    if (!this.known) {
      this.factoredFor = 0;
      if (!this.jacobian.evaluate(t, y, f0)) return 'no-value';
      this.known = this.current = true;
    }
    if (!this.factorsServe(h) && !this.factor(h)) return 'slow';
    this.scaleBy(y);
    trial.y0.set(y);
    this.predict(trial, last, ratio);
    // In equal steps no rate is carried over: what is left at the end of one iteration is not looked at again.
    const mismatch = Math.max(h / this.factoredFor, this.factoredFor / h);
    if (!this.controlled || mismatch > SAME_MISMATCH * this.measuredMismatch) this.newton.reset();
    const outcome = this.newton.solve(this.correct, this.tolerance, this.floor);
    if (this.newton.iterations > 1) this.measuredMismatch = mismatch;
    return outcome;
  }

  /**
   * After a failure: a bad guess, an old Jacobian or factors of another step are to blame before the step is.
   * @returns whether the step is
   */
  startOver(h: number): boolean {
    const all = this.current && !this.guess && (this.factoredFor === h || this.factoredFor === 0);
    this.factoredFor = 0;
    this.guess = false;
    this.known = this.current;
    return all;
  }

  accepted(h: number): void {
    this.guess = true;
    this.current = false;
    if (this.newton.theta < REUSE_BELOW) return;
    // Factors of another step make it slow as well as an old Jacobian does.
    if (within(this.factoredFor / h, STRETCH_IF_SLOW)) this.known = false;
    else this.factoredFor = 0;
  }

  private scaleBy(y: Float64Array): void {
    const { rtol, atol } = this.options;
    if (this.controlled) for (let i = 0; i < y.length; i++) this.scale[i] = atol + rtol * Math.abs(y[i]!);
    else roundingScale(y, this.scale);
  }

  private factorsServe(h: number): boolean {
    return this.controlled ? within(this.factoredFor / h, STRETCH) : this.factoredFor === h;
  }

  private factor(h: number): boolean {
    this.factoredFor = 0;
    if (!this.stages.factor(h, this.jacobian.matrix)) return false;
    this.factoredFor = h;
    return true;
  }

  /** Increments from the polynomial of the last step, continued beyond its end; else 0. */
  private predict(trial: CollocationPolynomial, last: CollocationPolynomial, ratio: number): void {
    const { stages, c } = this.tableau;
    this.guess &&= ratio <= MOST_EXTRAPOLATION;
    if (!this.guess) trial.z.fill(0);
    else for (let a = 0; a < stages; a++) last.extrapolate(1 + c[a]! * ratio, trial.z, a * this.y.length);
  }

  private readonly correct = (): number => this.stages.correct(this.t, this.y, this.h, this.z, this.scale);
}

function within(ratio: number, factor: number): boolean {
  return ratio < factor && ratio * factor > 1;
}
