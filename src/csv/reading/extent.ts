/** Least and largest of some numbers; those that are none are passed over. */
export interface Extent {
  low: number;
  high: number;
}

const known = new WeakMap<Float64Array, Extent>();

/** Looked at once: what a column reaches decides about seams and about units. */
export function extentOf(x: Float64Array): Extent {
  const old = known.get(x);
  if (old) return old;
  let [low, high] = [Infinity, -Infinity];
  for (let i = 0; i < x.length; i++) {
    const v = x[i]!;
    if (v < low) low = v;
    if (v > high) high = v;
  }
  const extent = { low, high };
  known.set(x, extent);
  return extent;
}

/** The numbers were changed. */
export const forgetExtent = (x: Float64Array): boolean => known.delete(x);
