import type { LqrDesign } from './lqr.ts';
import { ControlError, toRowMajor } from '../linearization/matrices.ts';

/**
 * Gains over a speed (or any other number): designed at some values, interpolated between them entry by entry, held
 * beyond the ends. Cubic Hermite pieces with Fritsch and Butland's slopes, so that no entry overshoots its neighbours
 * (F. N. Fritsch, J. Butland, "A method for constructing local monotone piecewise cubic interpolants", SIAM J. Sci.
 * Stat. Comput. 5 (1984), 300-304).
 *
 * Not guaranteed: stability between the values; `closedLoopFamily` with an interpolated gain shows it.
 */
export class GainSchedule {
  readonly values: readonly number[];
  /** Inputs k, states 2n. */
  readonly rows: number;
  readonly columns: number;
  private readonly gains: readonly Float64Array[];
  private readonly slopes: readonly Float64Array[];

  /** @param values ascending, at least one; `design` gives the gain at each */
  constructor(values: readonly number[], design: (value: number) => Pick<LqrDesign, 'gain'>) {
    if (values.length === 0 || values.some((x, i) => i > 0 && !(x > values[i - 1]!))) {
      throw new ControlError('a schedule needs ascending values, at least one');
    }
    const gains = values.map((value) => design(value).gain);
    this.values = values;
    this.rows = gains[0]!.rows;
    this.columns = gains[0]!.columns;
    this.gains = gains.map(toRowMajor);
    this.slopes = slopesOf(values, this.gains);
  }

  /** K at a value into `out` (k x 2n, row-major). */
  at(value: number, out: Float64Array): void {
    const { values, gains, slopes } = this;
    const i = this.piece(value);
    const j = Math.min(i + 1, values.length - 1);
    const h = values[j]! - values[i]!;
    const s = h > 0 ? Math.max(0, Math.min(1, (value - values[i]!) / h)) : 0;
    const [a, b, da, db] = [gains[i]!, gains[j]!, slopes[i]!, slopes[j]!];
    const rest = 1 - s;
    for (let e = 0; e < out.length; e++) {
      out[e] = rest * rest * ((1 + 2 * s) * a[e]! + s * h * da[e]!) + s * s * ((3 - 2 * s) * b[e]! - rest * h * db[e]!);
    }
  }

  /** dK/dvalue into `out`; 0 beyond the ends, where K is held. */
  slopeAt(value: number, out: Float64Array): void {
    const { values, gains, slopes } = this;
    if (!(value > values[0]! && value < values.at(-1)!)) return void out.fill(0);
    const i = this.piece(value);
    const h = values[i + 1]! - values[i]!;
    const s = (value - values[i]!) / h;
    const [a, b, da, db] = [gains[i]!, gains[i + 1]!, slopes[i]!, slopes[i + 1]!];
    for (let e = 0; e < out.length; e++) {
      out[e] = (6 * s * (1 - s) * (b[e]! - a[e]!)) / h + (1 - s) * (1 - 3 * s) * da[e]! + s * (3 * s - 2) * db[e]!;
    }
  }

  /** Index of the value that a piece begins with. */
  private piece(value: number): number {
    let i = 0;
    while (i < this.values.length - 2 && value > this.values[i + 1]!) i++;
    return i;
  }
}

/** Slopes at the values: a weighted harmonic mean of the neighbouring secants where these agree in sign, else 0. */
function slopesOf(values: readonly number[], gains: readonly Float64Array[]): Float64Array[] {
  return values.map((_, i) => {
    const slopes = new Float64Array(gains[i]!.length);
    if (i === 0 || i === values.length - 1) return slopes;
    const [h, k] = [values[i]! - values[i - 1]!, values[i + 1]! - values[i]!];
    return slopes.map((_, e) => {
      const before = (gains[i]![e]! - gains[i - 1]![e]!) / h;
      const after = (gains[i + 1]![e]! - gains[i]![e]!) / k;
      const share = (h + 2 * k) / (3 * (h + k));
      return before * after > 0 ? (before * after) / (share * after + (1 - share) * before) : 0;
    });
  });
}
