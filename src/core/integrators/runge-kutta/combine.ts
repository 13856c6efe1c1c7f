/**
 * Sums of stages, the inner loops of every explicit Runge-Kutta method.
 *
 * Up to six stages go through one loop, each as a plain array held in a local: indexing an array of arrays inside the
 * loop costs V8 an order of magnitude, and every loop more a tenth of a cheap derivative. All sums run from the first
 * stage to the last, so that a method's digits don't depend on how it is cut. Zero weights are left out beforehand.
 */

/** A weighted sum of slopes. */
export interface Combination {
  readonly weights: Float64Array;
  /** As many, each of n; those that the weights belong to. */
  readonly slopes: readonly Float64Array[];
}

/**
 * The combination without what has no weight.
 * @param weights of the first slopes
 * @param k slopes, each of n
 */
export function nonzero(weights: readonly number[], k: readonly Float64Array[]): Combination {
  return {
    weights: Float64Array.from(weights.filter((w) => w !== 0)),
    slopes: k.filter((_, j) => (weights[j] ?? 0) !== 0),
  };
}

/**
 * out = y + h times the weighted sum.
 *
 * @param y n
 * @param h step, s
 * @param sum what is summed: slopes (n each) with their weights
 * @param out n
 */
export function stageState(y: Float64Array, h: number, sum: Combination, out: Float64Array): void {
  const { weights: w, slopes: k } = sum;
  const n = out.length;
  switch (w.length) {
    case 1: {
      const a = k[0]!;
      const wa = w[0]!;
      for (let i = 0; i < n; i++) out[i] = y[i]! + h * (wa * a[i]!);
      return;
    }
    case 2: {
      const a = k[0]!,
        b = k[1]!;
      const wa = w[0]!,
        wb = w[1]!;
      for (let i = 0; i < n; i++) out[i] = y[i]! + h * (wa * a[i]! + wb * b[i]!);
      return;
    }
    case 3: {
      const a = k[0]!,
        b = k[1]!,
        c = k[2]!;
      const wa = w[0]!,
        wb = w[1]!,
        wc = w[2]!;
      for (let i = 0; i < n; i++) out[i] = y[i]! + h * (wa * a[i]! + wb * b[i]! + wc * c[i]!);
      return;
    }
    case 4: {
      const a = k[0]!,
        b = k[1]!,
        c = k[2]!,
        d = k[3]!;
      const wa = w[0]!,
        wb = w[1]!,
        wc = w[2]!,
        wd = w[3]!;
      for (let i = 0; i < n; i++) out[i] = y[i]! + h * (wa * a[i]! + wb * b[i]! + wc * c[i]! + wd * d[i]!);
      return;
    }
    case 5: {
      const a = k[0]!,
        b = k[1]!,
        c = k[2]!,
        d = k[3]!,
        e = k[4]!;
      const wa = w[0]!,
        wb = w[1]!,
        wc = w[2]!,
        wd = w[3]!,
        we = w[4]!;
      for (let i = 0; i < n; i++) out[i] = y[i]! + h * (wa * a[i]! + wb * b[i]! + wc * c[i]! + wd * d[i]! + we * e[i]!);
      return;
    }
    case 6: {
      const a = k[0]!,
        b = k[1]!,
        c = k[2]!,
        d = k[3]!,
        e = k[4]!,
        f = k[5]!;
      const wa = w[0]!,
        wb = w[1]!,
        wc = w[2]!,
        wd = w[3]!,
        we = w[4]!,
        wf = w[5]!;
      for (let i = 0; i < n; i++)
        out[i] = y[i]! + h * (wa * a[i]! + wb * b[i]! + wc * c[i]! + wd * d[i]! + we * e[i]! + wf * f[i]!);
      return;
    }
    default:
      weightedSum(sum, out);
      for (let i = 0; i < n; i++) out[i] = y[i]! + h * out[i]!;
  }
}

/**
 * out = the weighted sum.
 *
 * @param sum what is summed: slopes (n each) with their weights
 * @param out n
 */
export function weightedSum(sum: Combination, out: Float64Array): void {
  const { weights: w, slopes: k } = sum;
  const n = out.length;
  switch (w.length) {
    case 0:
      out.fill(0);
      return;
    case 1: {
      const a = k[0]!;
      const wa = w[0]!;
      for (let i = 0; i < n; i++) out[i] = wa * a[i]!;
      return;
    }
    case 2: {
      const a = k[0]!,
        b = k[1]!;
      const wa = w[0]!,
        wb = w[1]!;
      for (let i = 0; i < n; i++) out[i] = wa * a[i]! + wb * b[i]!;
      return;
    }
    case 3: {
      const a = k[0]!,
        b = k[1]!,
        c = k[2]!;
      const wa = w[0]!,
        wb = w[1]!,
        wc = w[2]!;
      for (let i = 0; i < n; i++) out[i] = wa * a[i]! + wb * b[i]! + wc * c[i]!;
      return;
    }
    case 4: {
      const a = k[0]!,
        b = k[1]!,
        c = k[2]!,
        d = k[3]!;
      const wa = w[0]!,
        wb = w[1]!,
        wc = w[2]!,
        wd = w[3]!;
      for (let i = 0; i < n; i++) out[i] = wa * a[i]! + wb * b[i]! + wc * c[i]! + wd * d[i]!;
      return;
    }
    case 5: {
      const a = k[0]!,
        b = k[1]!,
        c = k[2]!,
        d = k[3]!,
        e = k[4]!;
      const wa = w[0]!,
        wb = w[1]!,
        wc = w[2]!,
        wd = w[3]!,
        we = w[4]!;
      for (let i = 0; i < n; i++) out[i] = wa * a[i]! + wb * b[i]! + wc * c[i]! + wd * d[i]! + we * e[i]!;
      return;
    }
    case 6: {
      const a = k[0]!,
        b = k[1]!,
        c = k[2]!,
        d = k[3]!,
        e = k[4]!,
        f = k[5]!;
      const wa = w[0]!,
        wb = w[1]!,
        wc = w[2]!,
        wd = w[3]!,
        we = w[4]!,
        wf = w[5]!;
      for (let i = 0; i < n; i++) out[i] = wa * a[i]! + wb * b[i]! + wc * c[i]! + wd * d[i]! + we * e[i]! + wf * f[i]!;
      return;
    }
    default:
      longSum(w, k, out);
  }
}

/** More than six: six, and then pairs. */
function longSum(w: Float64Array, k: readonly Float64Array[], out: Float64Array): void {
  const a = k[0]!,
    b = k[1]!,
    c = k[2]!,
    d = k[3]!,
    e = k[4]!,
    f = k[5]!;
  const wa = w[0]!,
    wb = w[1]!,
    wc = w[2]!,
    wd = w[3]!,
    we = w[4]!,
    wf = w[5]!;
  const n = out.length;
  for (let i = 0; i < n; i++) out[i] = wa * a[i]! + wb * b[i]! + wc * c[i]! + wd * d[i]! + we * e[i]! + wf * f[i]!;
  let j = 6;
  for (; j + 1 < w.length; j += 2) {
    const p = k[j]!,
      q = k[j + 1]!;
    const wp = w[j]!,
      wq = w[j + 1]!;
    for (let i = 0; i < n; i++) out[i] = out[i]! + wp * p[i]! + wq * q[i]!;
  }
  if (j < w.length) {
    const p = k[j]!,
      wp = w[j]!;
    for (let i = 0; i < n; i++) out[i]! += wp * p[i]!;
  }
}
