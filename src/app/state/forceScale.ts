/** The scale of the force arrows: steps of 1, 2, 5, and a round force whose arrow makes a readable bar. */

/** Metres of arrow per newton, from a millimetre for 20 N to a decimetre for 1 N. */
export const FORCE_SCALES: readonly number[] = [5e-5, 1e-4, 2e-4, 5e-4, 1e-3, 2e-3, 5e-3, 0.01, 0.02, 0.05, 0.1];

/** The step nearest to a scale. */
export function scaleIndex(metresPerNewton: number): number {
  const away = (scale: number): number => Math.abs(Math.log(scale / metresPerNewton));
  return FORCE_SCALES.reduce((best, scale, i) => (away(scale) < away(FORCE_SCALES[best]!) ? i : best), 0);
}

/** Shortest bar of the legend (CSS pixels); the longest is at most 2.5 times that. */
const SHORTEST = 32;

/** The smallest force of 1, 2 or 5 times a power of ten (N) whose arrow is long enough to read, and its length (CSS pixels). */
export function legendBar(metresPerNewton: number, pixelsPerMetre: number): { newtons: number; pixels: number } | null {
  const each = metresPerNewton * pixelsPerMetre;
  if (!(each > 0) || !Number.isFinite(each)) return null;
  const least = SHORTEST / each;
  const ten = 10 ** Math.floor(Math.log10(least));
  const newtons = Number((([1, 2, 5].find((n) => n * ten >= least * (1 - 1e-9)) ?? 10) * ten).toPrecision(1));
  return { newtons, pixels: newtons * each };
}
