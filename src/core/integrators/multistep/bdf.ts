import type { BdfEquations } from './bdfEquations.ts';
import { BdfStepper, type BdfTuning } from './bdfStepper.ts';
import { zeroCounters, type OdeProblem, type StepperOptions } from '../contract.ts';
import { Jacobian } from '../shared/newton.ts';
import { firstStep } from '../shared/stepControl.ts';

/**
 * The numerical differentiation formulas of order 1 to 5, BDF with a smaller constant of the error, for y' = f(t, y):
 * F = y' - f(t, y) in `BdfStepper`.
 *
 * kappa: Shampine and Reichelt (1997), section 2, as in SciPy's BDF (0 at order 5, where it would cost stability). One Jacobian serves
 * until Newton's method fails with it, whatever the step; differences where the problem has no exact one.
 */
const KAPPA = [0, -0.185, -1 / 9, -0.0823, -0.0415, 0] as const;

export class Bdf extends BdfStepper {
  constructor(problem: OdeProblem, options: StepperOptions, tuning: BdfTuning = {}) {
    super(new OdeEquations(problem, options), options, tuning);
  }
}

class OdeEquations implements BdfEquations {
  readonly dimension: number;
  readonly differential = null;
  readonly kappa = KAPPA;
  readonly counters = zeroCounters();
  matrixIsOld = false;
  private readonly problem: OdeProblem;
  private readonly options: StepperOptions;
  private readonly jacobian: Jacobian;
  private readonly f0: Float64Array;
  private readonly scratch: readonly [Float64Array, Float64Array];
  private known = false;

  constructor(problem: OdeProblem, options: StepperOptions) {
    this.dimension = problem.dimension;
    this.problem = problem;
    this.options = options;
    this.jacobian = new Jacobian(problem, this.counters);
    this.f0 = new Float64Array(problem.dimension);
    this.scratch = [new Float64Array(problem.dimension), new Float64Array(problem.dimension)];
  }

  get failure(): string | null {
    return this.problem.failure;
  }

  begin(t: number, y: Float64Array, slope: Float64Array): boolean {
    this.known = false;
    return this.f(t, y, slope);
  }

  firstStep(t: number, y: Float64Array, slope: Float64Array, _scale: Float64Array, longest: number): number {
    const { rtol, atol } = this.options;
    return firstStep((s, x, out) => this.f(s, x, out), t, y, slope, 1, rtol, atol, this.scratch, longest);
  }

  residual(t: number, y: Float64Array, slope: Float64Array, out: Float64Array): boolean {
    if (!this.f(t, y, out)) return false;
    for (let i = 0; i < y.length; i++) out[i] = slope[i]! - out[i]!;
    return true;
  }

  matrix(t: number, y: Float64Array, _slope: Float64Array, cj: number, renew: boolean, out: Float64Array): boolean {
    this.matrixIsOld = this.known && !renew;
    if (!this.matrixIsOld) {
      this.known =
        (this.problem.jacobian !== undefined || this.f(t, y, this.f0)) && this.jacobian.evaluate(t, y, this.f0);
      if (!this.known) return false;
    }
    const J = this.jacobian.matrix;
    const n = y.length;
    for (let i = 0; i < n * n; i++) out[i] = -J[i]!;
    for (let i = 0; i < n; i++) out[i * n + i]! += cj;
    return true;
  }

  private f(t: number, y: Float64Array, out: Float64Array): boolean {
    this.counters.evaluations++;
    return this.problem.derivative(t, y, out);
  }
}
