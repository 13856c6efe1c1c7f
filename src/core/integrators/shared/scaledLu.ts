import { luFactor, luSolve } from '../../linalg/lu.ts';

/**
 * LU factors of dF/dy + cj dF/dy' with scaled columns and rows.
 *
 * In a system of index 2 the condition of this matrix grows like h^-2; with the columns of what has no derivative
 * multiplied by cj (about 1/h) and all rows brought to size 1 it stays bounded: L. Petzold, P. Lötstedt,
 * "Numerical solution of nonlinear differential equations with algebraic constraints II", SIAM J. Sci. Stat. Comput. 7
 * (1986), 720-733; K. Brenan, S. Campbell, L. Petzold, Numerical Solution of Initial-Value Problems in
 * Differential-Algebraic Equations (SIAM 1996), chapter 5.
 */
export class ScaledLu {
  /** Row-major; to be filled by the caller, factored in place. */
  readonly matrix: Float64Array;
  private readonly n: number;
  private readonly differential: Uint8Array | null;
  private readonly pivots: Int32Array;
  private readonly rows: Float64Array;
  private readonly columns: Float64Array;

  /** @param differential which columns keep their size; null: all */
  constructor(n: number, differential: Uint8Array | null) {
    this.n = n;
    this.differential = differential;
    this.matrix = new Float64Array(n * n);
    this.pivots = new Int32Array(n);
    this.rows = new Float64Array(n);
    this.columns = new Float64Array(n).fill(1);
  }

  /**
   * @param cj what columns of the others are multiplied by, 1/s
   * @returns false if the matrix is singular or not finite
   */
  factor(cj: number): boolean {
    const { n, matrix, rows, columns, differential } = this;
    if (differential) for (let j = 0; j < n; j++) columns[j] = differential[j] ? 1 : cj;
    for (let i = 0; i < n; i++) {
      let largest = 0;
      for (let j = 0; j < n; j++) {
        matrix[i * n + j]! *= columns[j]!;
        largest = Math.max(largest, Math.abs(matrix[i * n + j]!));
      }
      if (!(largest > 0 && largest < Infinity)) return false;
      rows[i] = 1 / largest;
      for (let j = 0; j < n; j++) matrix[i * n + j]! *= rows[i]!;
    }
    return luFactor(matrix, n, this.pivots);
  }

  /**
   * Solves in place of b.
   * @param b n
   */
  solve(b: Float64Array): void {
    const { n, rows, columns } = this;
    for (let i = 0; i < n; i++) b[i]! *= rows[i]!;
    luSolve(this.matrix, n, this.pivots, b);
    for (let i = 0; i < n; i++) b[i]! *= columns[i]!;
  }
}
