import { sgg } from 'ml-savitzky-golay-generalized';

/** Rows of a fit and the degree of its polynomial: noise of single rows goes, a motion over ten rows stays. */
const WINDOW = 9;
const SHORTEST = 5;
const DEGREE = 3;

/**
 * Rates by differentiation: a cubic fitted to nine rows around each (A. Savitzky, M. J. E. Golay, Anal. Chem. 36 (1964)
 * 1627), to the values and to the times, both over the rows' numbers: rows need not be evenly spaced. Not guaranteed:
 * rates near a jump, which is smoothed over.
 * @param x values of n rows
 * @param t their times, s, rising
 * @returns n rates; null for fewer than five rows
 */
export function ratesOf(x: Float64Array, t: Float64Array): Float64Array | null {
  if (x.length < SHORTEST) return null;
  const options = { windowSize: x.length < WINDOW ? SHORTEST : WINDOW, derivative: 1, polynomial: DEGREE };
  const rates = sgg(x, 1, options);
  const pace = sgg(t, 1, options);
  // Where the fit of uneven times does not rise, the neighbours tell.
  for (let i = 0; i < rates.length; i++) {
    if (pace[i]! > 0) rates[i]! /= pace[i]!;
    else {
      const [a, b] = [Math.max(0, i - 1), Math.min(x.length - 1, i + 1)];
      rates[i] = (x[b]! - x[a]!) / (t[b]! - t[a]!);
    }
  }
  return rates;
}
