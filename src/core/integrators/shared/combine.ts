/**
 * Sums of stages, the inner loops of every explicit Runge-Kutta method.
 *
 * Four stages go through one loop, each as a plain array held in a local: indexing an array of arrays inside the loop
 * costs V8 an order of magnitude, and every loop more a tenth of a cheap derivative. All sums run from the first stage
 * to the last, so that a method's digits don't depend on how it is cut.
 */

/** out = sum of weights[j] k[j] over the first `weights.length` of k; all vectors of out's length. */
export function weightedSum(weights: readonly number[], k: readonly Float64Array[], out: Float64Array): void {
  const n = out.length;
  let j = firstOf(weights, k, out);
  for (; j + 1 < weights.length; j += 2) {
    const a = k[j]!,
      b = k[j + 1]!;
    const wa = weights[j]!,
      wb = weights[j + 1]!;
    for (let i = 0; i < n; i++) out[i] = out[i]! + wa * a[i]! + wb * b[i]!;
  }
  if (j < weights.length) {
    const a = k[j]!;
    const wa = weights[j]!;
    for (let i = 0; i < n; i++) out[i]! += wa * a[i]!;
  }
}

/** out = y + h times the weighted sum. */
export function stageState(
  y: Float64Array,
  h: number,
  weights: readonly number[],
  k: readonly Float64Array[],
  out: Float64Array,
): void {
  weightedSum(weights, k, out);
  for (let i = 0; i < out.length; i++) out[i] = y[i]! + h * out[i]!;
}

/** The sum of the first stages, as many as it says: four where there are so many. */
function firstOf(weights: readonly number[], k: readonly Float64Array[], out: Float64Array): number {
  const n = out.length;
  const a = k[0]!,
    wa = weights[0]!;
  if (weights.length === 1) {
    for (let i = 0; i < n; i++) out[i] = wa * a[i]!;
    return 1;
  }
  const b = k[1]!,
    wb = weights[1]!;
  if (weights.length === 2) {
    for (let i = 0; i < n; i++) out[i] = wa * a[i]! + wb * b[i]!;
    return 2;
  }
  const c = k[2]!,
    wc = weights[2]!;
  if (weights.length === 3) {
    for (let i = 0; i < n; i++) out[i] = wa * a[i]! + wb * b[i]! + wc * c[i]!;
    return 3;
  }
  const d = k[3]!,
    wd = weights[3]!;
  for (let i = 0; i < n; i++) out[i] = wa * a[i]! + wb * b[i]! + wc * c[i]! + wd * d[i]!;
  return 4;
}
