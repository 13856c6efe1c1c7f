import type { BdfEquations } from './bdfEquations.ts';
import { BdfStepper, type BdfTuning } from './bdfStepper.ts';
import { zeroCounters, type StepperOptions } from '../contract.ts';
import type { DaeProblem } from '../shared/dae.ts';

/**
 * BDF of order 1 to 5 on the fully implicit F(t, y, y') = 0, for index 1 and semi-explicit index 2; what SUNDIALS'
 * IDA and DASSL do, here in the quasi-constant-step form of `BdfStepper`. `y` is the full vector, algebraic components
 * included.
 *
 * The BDF (kappa = 0) converge with order k for systems of index 1 and 2 (K. Brenan, S. Campbell, L. Petzold, Numerical
 * Solution of Initial-Value Problems in Differential-Algebraic Equations, SIAM 1996, section 3.2).
 *
 * Errors are tested on the differential components: after each change of step those of index-2 multipliers are of
 * a lower order in h though they leave the rest as it is, and a test of them would reject forever (same book,
 * chapter 5; IDA's "suppress algebraic variables"). For a problem of index 1, `testAll` tests everything.
 *
 * The matrix is taken anew, from exact derivatives, whenever order or step change.
 */
const KAPPA = [0, 0, 0, 0, 0, 0] as const;
/** The first step moves y by this many units of the tolerance (IDA's rule); order 1 then has a negligible error. */
const FIRST_MOVE = 0.5;
/** Longest first step, for what stands still. */
const FIRST_LONGEST = 1e-3;

export class Ida extends BdfStepper {
  constructor(problem: DaeProblem, options: StepperOptions, tuning: BdfTuning & { testAll?: boolean } = {}) {
    super(new DaeEquations(problem, tuning.testAll ?? false), options, tuning);
  }
}

class DaeEquations implements BdfEquations {
  readonly dimension: number;
  readonly differential: Uint8Array | null;
  readonly kappa = KAPPA;
  readonly counters = zeroCounters();
  readonly matrixIsOld = false;
  private readonly problem: DaeProblem;

  constructor(problem: DaeProblem, testAll: boolean) {
    this.problem = problem;
    this.dimension = problem.dimension;
    this.differential = testAll ? null : problem.differential;
  }

  get failure(): string | null {
    return this.problem.failure;
  }

  begin(t: number, y: Float64Array, slope: Float64Array): boolean {
    return this.problem.start(t, y, slope);
  }

  firstStep(_t: number, _y: Float64Array, slope: Float64Array, scale: Float64Array): number {
    let sum = 0;
    for (let i = 0; i < slope.length; i++) {
      const part = slope[i]! / scale[i]!;
      sum += part * part;
    }
    return Math.min(FIRST_LONGEST, FIRST_MOVE / Math.sqrt(sum / slope.length));
  }

  residual(t: number, y: Float64Array, slope: Float64Array, out: Float64Array): boolean {
    this.counters.evaluations++;
    return this.problem.residual(t, y, slope, out);
  }

  matrix(t: number, y: Float64Array, slope: Float64Array, cj: number, _renew: boolean, out: Float64Array): boolean {
    this.counters.jacobians++;
    return this.problem.jacobian(t, y, slope, cj, out);
  }
}
