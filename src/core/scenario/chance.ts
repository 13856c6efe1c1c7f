/**
 * Numbers that look random and follow from a seed, a stream and a place in it alone: the noise of a sensor at its k-th
 * sample is the same whether the run began at 0 or goes on from a row, and to the last bit on every machine (integers,
 * sums and products only; no logarithm or cosine, whose last bits differ between engines).
 */

/** 32 bits in, 32 bits out; each changes about half of them (A. Appleby, MurmurHash3, the finalizer fmix32). */
function mixed(x: number): number {
  let h = x | 0;
  h = Math.imul(h ^ (h >>> 16), 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return (h ^ (h >>> 16)) >>> 0;
}

/** Odd, from the golden ratio: neighbouring places are far apart before they are mixed. */
const STRIDE = 0x9e3779b9;
const UNIFORMS = 12;

/** The key of a stream of a seed. */
const keyOf = (seed: number, stream: number): number => mixed(mixed(seed + STRIDE) ^ Math.imul(stream + 1, 0x27d4eb2f));

/** Between 0 and 1, neither included. */
const share = (key: number, at: number): number =>
  (mixed(mixed(key + Math.imul(at + 1, STRIDE)) ^ key) + 0.5) / 2 ** 32;

/** Evenly between 0 and 1. @param seed, stream, place whole numbers */
export const uniform = (seed: number, stream: number, place: number): number => share(keyOf(seed, stream), place);

/**
 * One of a normal distribution with mean 0 and deviation 1: twelve uniform numbers less six (N. L. Johnson, S. Kotz and
 * N. Balakrishnan, Continuous Univariate Distributions, vol. 2, section 26.9). Mean, deviation and skewness are exact, the
 * kurtosis is 2.9 in place of 3, and nothing is beyond 6.
 *
 * @param seed whole number
 * @param stream whole number
 * @param place whole number
 */
export function normal(seed: number, stream: number, place: number): number {
  const key = keyOf(seed, stream);
  let sum = -6;
  for (let i = 0; i < UNIFORMS; i++) sum += share(key, place * UNIFORMS + i);
  return sum;
}
