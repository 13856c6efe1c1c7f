import { ComplexBlock, isSecondOrder, RealBlock, type Block } from './collocationBlocks.ts';
import type { Tableau } from './collocationCoefficients.ts';
import type { Counters, OdeProblem } from '../contract.ts';

/**
 * The equations of one collocation step, z = h (A (x) I) F(z), by simplified Newton iterations
 * z += (I - h A (x) J)^-1 (h (A (x) I) F(z) - z), in the coordinates in which the matrix falls apart into one real and
 * some complex blocks of the problem's own dimension (`collocationTransform.ts`): Hairer and Wanner, Solving ODEs II,
 * 2nd ed., section IV.8.
 *
 * The matrix may be of another h than the step: then it is still right for what is not stiff.
 */
/** The most stages there are. */
const ROWS = 4;

export class StageEquations {
  /** What `damp` damps with: the real part of the first eigenvalue of A. */
  readonly gamma: number;

  private readonly problem: OdeProblem;
  private readonly counters: Counters;
  private readonly tableau: Tableau;
  private readonly n: number;
  private readonly blocks: readonly Block[];
  /** Of ROWS rows, those beyond the stages zero. */
  private readonly slopes: Float64Array;
  private readonly residual: Float64Array;
  /** The rows of `slopes`. */
  private readonly rows: readonly Float64Array[];
  private readonly point: Float64Array;
  private readonly slope: Float64Array;
  private readonly unused: Float64Array;

  constructor(problem: OdeProblem, counters: Counters, tableau: Tableau) {
    const n = (this.n = problem.dimension);
    this.problem = problem;
    this.counters = counters;
    this.tableau = tableau;
    this.blocks = tableau.transform.eigenvalues.map(([re, im]) =>
      im === 0 ? new RealBlock(n, re) : new ComplexBlock(n, re, im),
    );
    this.gamma = tableau.transform.eigenvalues[0]![0];
    this.slopes = new Float64Array(ROWS * n);
    this.residual = new Float64Array(ROWS * n);
    this.rows = Array.from({ length: ROWS }, (_, a) => this.slopes.subarray(a * n, (a + 1) * n));
    this.point = new Float64Array(n);
    this.slope = new Float64Array(n);
    this.unused = new Float64Array(n);
  }

  /**
   * Factors for a step and a Jacobian.
   * @param h length of the step, s
   * @param J df/dy, n x n, row-major
   * @returns false where a block is singular
   */
  factor(h: number, J: Float64Array): boolean {
    this.counters.factorizations++;
    const secondOrder = isSecondOrder(J, this.n);
    for (const block of this.blocks) if (!block.factor(h, J, secondOrder)) return false;
    return true;
  }

  /**
   * One iteration for a step from (t, y).
   * @param t s
   * @param y n
   * @param h length of the step, s
   * @param z increments u(t + c_i h) - y, s x n; moved
   * @param scale one unit of each component, n
   * @returns the scaled norm of how far, NaN where f has no value
   */
  correct(t: number, y: Float64Array, h: number, z: Float64Array, scale: Float64Array): number {
    const { n, slopes, point, slope, residual } = this;
    const { stages: s, A, c, transform } = this.tableau;
    for (let a = 0; a < s; a++) {
      const row = a * n;
      for (let i = 0; i < n; i++) point[i] = y[i]! + z[row + i]!;
      this.counters.evaluations++;
      if (!this.problem.derivative(t + c[a]! * h, point, slope)) return NaN;
      for (let i = 0; i < n; i++) slopes[row + i] = h * slope[i]!;
    }
    multiply(A, s, n, slopes, residual);
    for (let i = 0; i < s * n; i++) residual[i]! -= z[i]!;
    multiply(transform.inverse, s, n, residual, slopes);
    this.solveBlocks();
    multiply(transform.T, s, n, slopes, residual);
    let sum = 0;
    for (let a = 0; a < s; a++) {
      for (let i = 0; i < n; i++) {
        const increment = residual[a * n + i]!;
        z[a * n + i]! += increment;
        const r = increment / scale[i]!;
        sum += r * r;
      }
    }
    return Math.sqrt(sum / (s * n));
  }

  /**
   * (I - h gamma J)^-1 x in place of x, or its real part where gamma is complex: damps what is stiff.
   * @param x n
   */
  damp(x: Float64Array): void {
    this.unused.fill(0);
    this.blocks[0]!.solve(x, this.unused);
  }

  /** Each block in place of its row, or two rows, of `slopes`. */
  private solveBlocks(): void {
    const { blocks, rows } = this;
    let row = 0;
    for (const block of blocks) {
      block.solve(rows[row]!, block.real ? this.unused : rows[row + 1]!);
      row += block.real ? 1 : 2;
    }
  }
}

/** out = (matrix (x) I) x, matrix s x s, x and out of ROWS rows of n: four terms at once, which is faster than a loop. */
function multiply(matrix: Float64Array, s: number, n: number, x: Float64Array, out: Float64Array): void {
  for (let a = 0; a < s; a++) {
    const first = matrix[a * s]!;
    const second = s > 1 ? matrix[a * s + 1]! : 0;
    const third = s > 2 ? matrix[a * s + 2]! : 0;
    const fourth = s > 3 ? matrix[a * s + 3]! : 0;
    const row = a * n;
    for (let i = 0; i < n; i++)
      out[row + i] = first * x[i]! + second * x[n + i]! + third * x[2 * n + i]! + fourth * x[3 * n + i]!;
  }
}
