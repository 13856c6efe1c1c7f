/**
 * Sums of stages, the inner loops of every explicit Runge-Kutta method.
 *
 * Four stages go through one loop, each as a plain array held in a local: indexing an array of arrays inside the loop
 * costs V8 an order of magnitude.
 */

/** out = sum of weights[j] k[j] over the first `weights.length` of k; all vectors of out's length. */
export function weightedSum(weights: readonly number[], k: readonly Float64Array[], out: Float64Array): void {
  const stages = weights.length;
  const n = out.length;
  out.fill(0);
  let j = 0;
  for (; j + 4 <= stages; j += 4) {
    const a = k[j]!, b = k[j + 1]!, c = k[j + 2]!, d = k[j + 3]!;
    const wa = weights[j]!, wb = weights[j + 1]!, wc = weights[j + 2]!, wd = weights[j + 3]!;
    for (let i = 0; i < n; i++) out[i]! += wa * a[i]! + wb * b[i]! + wc * c[i]! + wd * d[i]!;
  }
  for (; j < stages; j++) {
    const a = k[j]!;
    const wa = weights[j]!;
    if (wa !== 0) for (let i = 0; i < n; i++) out[i]! += wa * a[i]!;
  }
}

/** out = y + h times the weighted sum. */
export function stageState(y: Float64Array, h: number, weights: readonly number[], k: readonly Float64Array[], out: Float64Array): void {
  weightedSum(weights, k, out);
  for (let i = 0; i < out.length; i++) out[i] = y[i]! + h * out[i]!;
}
