import { BackwardDifferences, GAMMA, MAX_ORDER, valueAt } from './backwardDifferences.ts';
import { BdfCorrector, MOST_ITERATIONS } from './bdfCorrector.ts';
import type { BdfEquations } from './bdfEquations.ts';
import type { StepFailure, StepperOptions } from '../contract.ts';
import { AdaptiveStepper } from '../shared/adaptiveStepper.ts';
import { allFinite } from '../shared/finite.ts';
import { GROW_MOST, SAFETY, SHRINK_MOST, smallestStep } from '../shared/stepControl.ts';
import { power } from '../../elementary/powers.ts';

/**
 * What `bdf` and `ida` have in common: backward differentiation of order 1 to 5 for F(t, y, y') = 0, with variable
 * order and quasi-constant step.
 *
 * L. F. Shampine, M. W. Reichelt, "The MATLAB ODE Suite", SIAM J. Sci. Comput. 18 (1997), section 2: formulas, error
 * estimates, choice of order; constants as in SciPy's BDF.
 *
 * A projection moves y by about the local error, O(h^(k+1)). `stateChanged` then moves the whole polynomial with it:
 * D[0] is replaced, the differences stay. The history is then that of z = y - (sum of all moves); its slope is
 * z' = y' between the moves, so the formula loses nothing, and each move enters once, like one more local error. (Had only
 * y_n been replaced, all D[j] would change by the move, and with them the next error estimates.) Such use
 * of projected values keeps the order: E. Eich, SIAM J. Numer. Anal. 30 (1993), "Convergence results for a
 * coordinate projection method". A move far beyond the tolerance is another solution: order 1 again.
 *
 * Not guaranteed: damping of what oscillates fast at orders 3 to 5 (A(alpha)-stable only).
 */

/** No step is changed for less than this gain, so that the factors of the matrix serve on. */
const GROW_FROM = 1.2;
/** After so many rejections of one step the history is no help: order 1 (as DASSL: Brenan, Campbell and Petzold, chapter 5). */
const REJECTIONS_TO_RESTART = 3;
/** A start is not tried below so many of the shortest steps there are: where a reference jumps, slopes are large for a tiny tolerance. */
const FIRST_SHORTEST = 64;
/** Moves of y beyond so many units of the tolerance begin a new history. */
const RESTART_BEYOND = 100;
/** A spacing closer than this to the step is the step: the last digits of the limit are worth no new factors. */
const SAME_STEP = 1e-12;

/** For measurements: the highest order, and the solution before the start, which then begins at that order. */
export interface BdfTuning {
  maxOrder?: number;
  past?: (t: number, y: Float64Array) => void;
}

export class BdfStepper extends AdaptiveStepper {
  private readonly equations: BdfEquations;
  private readonly tuning: BdfTuning;
  private readonly maxOrder: number;
  private readonly controlled: boolean;
  private readonly corrector: BdfCorrector;
  private readonly history: BackwardDifferences;
  /** The polynomial of the last step. */
  private readonly kept: Float64Array[];
  private keptOrder = 0;
  private equalSteps = 0;
  private started = false;
  private readonly scratch: Float64Array;

  constructor(equations: BdfEquations, options: StepperOptions, tuning: BdfTuning) {
    super(equations.dimension, options, equations.counters);
    const vector = (): Float64Array => new Float64Array(equations.dimension);
    this.equations = equations;
    this.tuning = tuning;
    this.maxOrder = tuning.maxOrder ?? MAX_ORDER;
    this.controlled = options.rtol < Infinity;
    this.corrector = new BdfCorrector(equations, options);
    this.history = new BackwardDifferences(equations.dimension);
    this.kept = Array.from({ length: MAX_ORDER + 1 }, vector);
    this.scratch = vector();
  }

  /** Order of the next step; 1 at a start. */
  get order(): number {
    return this.started ? this.history.order : 1;
  }

  override reset(t: number, y: Float64Array): void {
    super.reset(t, y);
    this.kept[0]!.set(y);
    this.keptOrder = 0;
    this.started = false;
  }

  stateChanged(): void {
    if (!this.started) return;
    const { y, scratch, corrector } = this;
    const newest = this.history.D[0]!;
    for (let i = 0; i < y.length; i++) scratch[i] = y[i]! - newest[i]!;
    if (this.controlled && !(corrector.norm(scratch, 1) <= RESTART_BEYOND)) this.restart();
    newest.set(y);
  }

  restart(): void {
    this.started = false;
    this.h = this.options.step ?? 0;
  }

  interpolate(t: number, out: Float64Array): void {
    valueAt(this.kept, this.keptOrder, this.fraction(t) - 1, out);
  }

  protected get reason(): string | null {
    return this.equations.failure;
  }

  protected begin(longest: number): StepFailure | null {
    this.corrector.current = false;
    return this.started || this.start(longest) ? null : (this.reason ?? 'non-finite');
  }

  protected attempt(h: number, end: number): number {
    const { corrector, history } = this;
    if (Math.abs(h / history.spacing - 1) > SAME_STEP) {
      history.respace(h);
      this.equalSteps = 0;
    }
    this.outcome = corrector.solve(end, history);
    if (this.outcome !== 'converged') return Infinity;
    const error = corrector.norm(corrector.d, this.errorConstant(history.order));
    return this.controlled ? error : 0;
  }

  protected retry(h: number, error: number, tries: number): number {
    const { corrector } = this;
    if (this.outcome === 'converged') return h * this.shrink(error, tries);
    if (corrector.current) return h / 2;
    corrector.forgetMatrix();
    return h;
  }

  protected accept(h: number, error: number): void {
    const { history, y, kept } = this;
    history.advance(this.corrector.d);
    this.keptOrder = history.order;
    for (let j = 0; j <= history.order; j++) kept[j]!.set(history.D[j]!);
    y.set(history.D[0]!);
    this.h = h;
    this.equalSteps++;
    if (this.equalSteps > history.order) this.chooseNext(h, error);
  }

  /** Order 1 from f at (t, y), or what `tuning` says of the past. */
  private start(longest: number): boolean {
    const { y, scratch: slope, history, corrector, equations, tuning, maxOrder } = this;
    if (!equations.begin(this.t, y, slope) || !allFinite(slope) || !allFinite(y)) return false;
    if (this.keptOrder === 0) this.kept[0]!.set(y);
    corrector.scaleBy(y, 1);
    if (!(this.h > 0)) this.h = equations.firstStep(this.t, y, slope, corrector.scale, longest);
    // Too short a first step is no better: the time has to move, and the error test sees what a longer one misses.
    this.h = Math.min(Math.max(this.h, FIRST_SHORTEST * smallestStep(this.t, longest)), longest);
    if (tuning.past) {
      const values = Array.from({ length: maxOrder + 1 }, () => y.slice());
      for (let j = 1; j <= maxOrder; j++) tuning.past(this.t - j * this.h, values[j]!);
      history.startFrom(values, maxOrder, this.h);
    } else history.start(y, slope, this.h);
    this.equalSteps = 0;
    corrector.reset();
    return (this.started = true);
  }

  private errorConstant(order: number): number {
    return this.equations.kappa[order]! * GAMMA[order]! + 1 / (order + 1);
  }

  /** Room left below the longest step that would pass, more of it where Newton's method was slow. */
  private get safety(): number {
    return (SAFETY * (2 * MOST_ITERATIONS + 1)) / (2 * MOST_ITERATIONS + this.corrector.iterations);
  }

  private shrink(error: number, rejections: number): number {
    const { history } = this;
    const factor =
      error < Infinity ? Math.max(SHRINK_MOST, this.safety * power(error, -1 / (history.order + 1))) : SHRINK_MOST;
    if (rejections < REJECTIONS_TO_RESTART) return factor;
    if (!this.tuning.past) history.order = 1;
    return Math.min(factor, 0.5);
  }

  /** Order and step for the next steps: the order among k - 1, k, k + 1 that allows the longest. */
  private chooseNext(h: number, error: number): void {
    const { history, maxOrder } = this;
    const { order, D } = history;
    if (!this.controlled) {
      history.order = Math.min(maxOrder, order + 1);
      return;
    }
    const reach = (k: number, e: number): number => power(e, -1 / (k + 1));
    let [best, factor] = [order, reach(order, error)];
    for (const k of [order - 1, order + 1]) {
      if (k < 1 || k > maxOrder) continue;
      const other = reach(k, this.corrector.norm(D[k + 1]!, this.errorConstant(k)));
      if (other > factor) [best, factor] = [k, other];
    }
    factor = Math.min(GROW_MOST, this.safety * factor);
    if (factor >= 1 && factor < GROW_FROM) return;
    history.order = best;
    this.h = h * factor;
    this.equalSteps = 0;
  }
}
