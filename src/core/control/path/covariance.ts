/**
 * The covariance of an estimate's errors: of deviations, and behind them of the sensors' errors that are followed, which wander by
 * themselves. Row-major; nothing is allocated once it is made.
 */
export class Covariance {
  private readonly P: Float64Array;
  private readonly product: Float64Array;
  private readonly seen: Float64Array;
  private readonly deviations: number;
  private readonly size: number;

  /** @param deviations how many @param others how many behind them */
  constructor(deviations: number, others: number) {
    this.deviations = deviations;
    this.size = deviations + others;
    this.P = new Float64Array(this.size * this.size);
    this.product = new Float64Array(this.size * this.size);
    this.seen = new Float64Array(this.size);
  }

  /**
   * @param block of the deviations, row-major
   * @param others deviations of the others
   */
  start(block: Float64Array, others: readonly number[]): void {
    const { P, deviations: d, size } = this;
    P.fill(0);
    for (let r = 0; r < d; r++) P.set(block.subarray(r * d, (r + 1) * d), r * size);
    others.forEach((first, i) => (P[(d + i) * (size + 1)] = first * first));
  }

  /** All is known. */
  clear(): void {
    this.P.fill(0);
  }

  /**
   * A sensor has read `off` more than was expected: adds what that makes of the estimate onto `change`, of which it was not
   * expected yet (a measurement at a time: R. E. Kalman's gain, without an inverse).
   *
   * @param slopes of what the sensor reads, by deviation and other
   * @param variance of its noise
   */
  take(slopes: Float64Array, off: number, variance: number, change: Float64Array): void {
    const { P, seen, size } = this;
    let [missing, whole] = [off, variance];
    for (let r = 0; r < size; r++) {
      let sum = 0;
      for (let k = 0; k < size; k++) sum += P[r * size + k]! * slopes[k]!;
      seen[r] = sum;
      whole += slopes[r]! * sum;
      missing -= slopes[r]! * change[r]!;
    }
    for (let r = 0; r < size; r++) {
      const gain = seen[r]! / whole;
      change[r]! += gain * missing;
      for (let k = 0; k < size; k++) P[r * size + k]! -= gain * seen[k]!;
    }
  }

  /**
   * To the next sample.
   *
   * @param F transition of the deviations
   * @param W what the process adds to their covariance
   * @param walked what is added to the variance of each other
   */
  grow(F: Float64Array, W: Float64Array, walked: readonly number[]): void {
    const { P, product, deviations: d, size } = this;
    for (let r = 0; r < d; r++)
      for (let c = 0; c < size; c++) {
        let sum = 0;
        for (let k = 0; k < d; k++) sum += F[r * d + k]! * P[k * size + c]!;
        product[r * size + c] = sum;
      }
    for (let r = 0; r < d; r++) {
      for (let c = 0; c <= r; c++) {
        let sum = W[r * d + c]!;
        for (let k = 0; k < d; k++) sum += product[r * size + k]! * F[c * d + k]!;
        P[r * size + c] = sum;
        P[c * size + r] = sum;
      }
      for (let c = d; c < size; c++) {
        P[r * size + c] = product[r * size + c]!;
        P[c * size + r] = product[r * size + c]!;
      }
    }
    walked.forEach((more, i) => (P[(d + i) * (size + 1)]! += more));
  }
}
