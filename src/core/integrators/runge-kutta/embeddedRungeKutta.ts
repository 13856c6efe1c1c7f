import { nonzero, stageState, weightedSum, type Combination } from './combine.ts';
import type { EmbeddedTableau } from './tableau.ts';
import type { OdeProblem, StepperOptions } from '../contract.ts';
import { AdaptiveOneStep } from '../shared/adaptiveOneStep.ts';
import { allFinite } from '../shared/finite.ts';
import { HERMITE_TERMS, hermiteCoefficients, nestedAt } from '../shared/interpolation.ts';
import { errorNorm, pairedErrorNorm } from '../shared/stepControl.ts';

/**
 * Embedded explicit Runge-Kutta methods with dense output, by their tableau (`tableau.ts`; the pairs are in `tableaus/`).
 *
 * Hairer, Nørsett and Wanner, Solving ODEs I, 2nd ed., sections II.4 (step control) and II.6 (dense output).
 *
 * Where the error estimate does without the slope at the end of the step, that is made last, for a step that is good
 * otherwise. Stages of the dense output alone are made when `interpolate` is first called after a step; should f have no
 * value at one of them (it had at the ends), the cubic Hermite polynomial of the step stands in, of order 3.
 *
 * Not guaranteed: efficiency on stiff problems (no stiffness detection; the step count tells), nor below a relative
 * tolerance of about 1e-14, where rounding decides.
 */
export class EmbeddedRungeKutta extends AdaptiveOneStep {
  readonly projects = true;

  protected readonly tableau: EmbeddedTableau;
  /** The estimate needs the slope at the end. */
  protected readonly estimateAtEnd: boolean;
  /** Slopes of the step being tried, and of the last accepted one: they change places when a step is accepted. */
  private trial: Slopes;
  protected kept: Slopes;
  /** Of `lowOrderError`; and scratch of the dense output's stages. */
  private readonly scratch: Float64Array;
  /** Ends of the last accepted step; `y` itself may be moved afterwards. */
  protected readonly y0: Float64Array;
  protected y1: Float64Array;
  private readonly coefficients: Float64Array[];
  /** Coefficients of the dense output that are made for the last step: most steps are never looked into. */
  protected terms = 0;

  constructor(problem: OdeProblem, options: StepperOptions, tableau: EmbeddedTableau) {
    super(problem, options, tableau.order, tableau.order);
    const vector = (): Float64Array => new Float64Array(problem.dimension);
    this.tableau = tableau;
    this.estimateAtEnd = tableau.error.length > tableau.stages;
    this.trial = new Slopes(tableau, problem.dimension);
    this.kept = new Slopes(tableau, problem.dimension);
    this.scratch = vector();
    this.y0 = vector();
    this.y1 = vector();
    this.coefficients = Array.from({ length: HERMITE_TERMS + tableau.dense.length }, vector);
  }

  protected get startSlope(): Float64Array {
    return this.trial.k[0]!;
  }

  override reset(t: number, y: Float64Array): void {
    super.reset(t, y);
    this.y1.set(y);
  }

  interpolate(t: number, out: Float64Array): void {
    if (!(this.stepTaken > 0)) {
      out.set(this.y1);
      return;
    }
    if (this.terms === 0) this.makeDense();
    nestedAt(this.fraction(t), this.y0, this.coefficients, this.terms, out);
  }

  protected attempt(h: number): number {
    const { trial, y, yNew, t } = this;
    const { stages, c } = this.tableau;
    const { k, rows } = trial;
    // An evaluation that has no value counts as an error without bound: a shorter step may go around it.
    for (let s = 1; s < stages; s++) {
      stageState(y, h, rows[s]!, yNew);
      if (!this.f(t + c[s]! * h, yNew, k[s]!)) return Infinity;
    }
    stageState(y, h, rows[stages]!, yNew);
    if (this.estimateAtEnd) return this.endSlope(h) ? this.errorOf(h) : Infinity;
    const error = this.errorOf(h);
    return error > 1 || (this.endSlope(h) && allFinite(k[stages]!)) ? error : Infinity;
  }

  protected accept(h: number, error: number): void {
    const { trial, kept, y, y1, yNew } = this;
    const { stages } = this.tableau;
    this.y0.set(y);
    y.set(yNew);
    this.y1 = yNew;
    this.yNew = y1;
    this.trial = kept;
    this.kept = trial;
    kept.k[0]!.set(trial.k[stages]!);
    this.terms = 0;
    this.chooseNext(h, error, 1);
  }

  /** The slope at the new state, which is the next step's first. */
  private endSlope(h: number): boolean {
    const { problem, yNew } = this;
    const t = this.t + h;
    return (!problem.project || problem.project(t, yNew)) && this.f(t, yNew, this.trial.k[this.tableau.stages]!);
  }

  /** Scaled error of the step, to be at most 1; infinite when anything is not a number. */
  private errorOf(h: number): number {
    const { trial, error, scratch: low, y, yNew } = this;
    const { rtol, atol } = this.options;
    weightedSum(trial.error, error);
    if (!trial.lowOrderError) return errorNorm(error, h, y, yNew, rtol, atol);
    weightedSum(trial.lowOrderError, low);
    return pairedErrorNorm(error, low, h, y, yNew, rtol, atol);
  }

  /** Coefficients of the dense output of the last accepted step, with the slopes that only it needs. */
  private makeDense(): void {
    const { kept, y0, y1, stepTaken: h, coefficients: p } = this;
    const { stages } = this.tableau;
    const { k, dense } = kept;
    hermiteCoefficients(h, y0, k[0]!, y1, k[stages]!, p);
    this.terms = HERMITE_TERMS;
    if (!this.extraStages()) return;
    for (let c = 0; c < dense.length; c++) {
      const coefficient = p[HERMITE_TERMS + c]!;
      weightedSum(dense[c]!, coefficient);
      for (let i = 0; i < y0.length; i++) coefficient[i]! *= h;
    }
    this.terms = p.length;
  }

  private extraStages(): boolean {
    const { kept, y0, previousT, stepTaken: h, scratch } = this;
    const { stages, c } = this.tableau;
    const { k, rows } = kept;
    for (let s = stages + 1; s < rows.length; s++) {
      stageState(y0, h, rows[s]!, scratch);
      if (!this.f(previousT + c[s]! * h, scratch, k[s]!) || !allFinite(k[s]!)) return false;
    }
    return true;
  }
}

/** The slopes of one step, and what of them each row of the tableau adds up. */
class Slopes {
  readonly k: readonly Float64Array[];
  readonly rows: readonly Combination[];
  readonly error: Combination;
  readonly lowOrderError: Combination | null;
  readonly dense: readonly Combination[];

  constructor({ A, error, lowOrderError, dense }: EmbeddedTableau, n: number) {
    const k = A.map(() => new Float64Array(n));
    const of = (weights: readonly number[]): Combination => nonzero(weights, k);
    this.k = k;
    this.rows = A.map(of);
    this.error = of(error);
    this.lowOrderError = lowOrderError ? of(lowOrderError) : null;
    this.dense = dense.map(of);
  }
}
