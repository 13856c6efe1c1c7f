/** What the complex plane shows of its eigenvalues. */

/** Eigenvalues that lie further apart than this are seen better on logarithmic scales. */
const WIDE = 60;

/** Of a logarithmic scale, at most. */
const DECADES = 3;

/** Whether some sizes are so small beside the largest that a linear plane shows them as one point. */
export function isWide(sizes: readonly number[]): boolean {
  const some = sizes.filter((x) => x > 0);
  return some.length > 1 && Math.max(...some) > WIDE * Math.min(...some);
}

/** Where a logarithmic scale becomes linear: a power of ten, at the smallest size but not much below the largest. */
export function bendOf(sizes: readonly number[]): number {
  const some = sizes.filter((x) => x > 0);
  if (some.length === 0) return 1;
  const decade = (x: number): number => Math.floor(Math.log10(x) + 1e-9);
  return 10 ** Math.max(decade(Math.min(...some)), decade(Math.max(...some)) - DECADES);
}

/** Ends of an axis that hold all values and zero, with a little air. */
export function extent(values: readonly number[], air = 0.08): [number, number] {
  const finite = values.filter(Number.isFinite);
  const [low, high] = [Math.min(0, ...finite), Math.max(0, ...finite)];
  const width = high - low || 1;
  return [low - air * width, high + air * width];
}
