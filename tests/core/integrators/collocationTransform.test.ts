// Eigenvalues and eigenvectors of Radau IIA of order 5, beside the digits that Hairer and Wanner's RADAU5 and SciPy print.
import { describe, expect, test } from 'vitest';
import { radau } from '../../../src/core/integrators/collocation/collocationCoefficients.ts';

/** From RADAU5 (and SciPy 1.17.1, integrate/_ivp/radau.py): A = T diag(1/mu) T^-1, by rows. */
const T = [
  [0.09443876248897524, -0.14125529502095421, 0.03002919410514742],
  [0.25021312296533332, 0.20412935229379994, -0.38294211275726192],
  [1, 1, 0],
];
const TI = [
  [4.17871859155190428, 0.32768282076106237, 0.52337644549944951],
  [-4.17871859155190428, -0.32768282076106237, 0.47662355450055044],
  [0.50287263494578682, -2.57192694985560522, 0.59603920482822492],
];
/** mu of the real and of the complex pair, 1 / gamma. */
const MU_REAL = 3 + 3 ** (2 / 3) - 3 ** (1 / 3);
const MU_COMPLEX = [3 + (3 ** (1 / 3) - 3 ** (2 / 3)) / 2, (3 ** (5 / 6) + 3 ** (7 / 6)) / 2] as const;

type Complex = readonly [number, number];
const over = ([a, b]: Complex, [c, d]: Complex): Complex => [
  (a * c + b * d) / (c * c + d * d),
  (b * c - a * d) / (c * c + d * d),
];

describe('the transformation of Radau IIA with three stages', () => {
  const { eigenvalues, T: ours, inverse } = radau(3).transform;
  const near = (a: Complex, b: Complex): void => a.forEach((x, k) => expect(x).toBeCloseTo(b[k]!, 13));

  test('eigenvalues', () => {
    expect(eigenvalues).toHaveLength(2);
    near(over([1, 0], eigenvalues[0]!), [MU_REAL, 0]);
    const [re, im] = over([1, 0], eigenvalues[1]!);
    near([re, Math.abs(im)], MU_COMPLEX);
  });

  // Eigenvectors are determined up to a factor, complex for the pair: ratios to the last component are compared.
  test('eigenvectors, by columns', () => {
    for (let i = 0; i < 3; i++) expect(ours[3 * i]! / ours[6]!).toBeCloseTo(T[i]![0]! / T[2]![0]!, 13);
    const pair = (m: ArrayLike<number>, i: number): Complex => [m[3 * i + 1]!, m[3 * i + 2]!];
    const printed = T.flat();
    for (let i = 0; i < 3; i++) {
      const [re, im] = over(pair(ours, i), pair(ours, 2));
      const [expectedRe, expectedIm] = over(pair(printed, i), pair(printed, 2));
      expect(re).toBeCloseTo(expectedRe, 13);
      expect(Math.abs(im)).toBeCloseTo(Math.abs(expectedIm), 13);
    }
  });

  test('and of their inverse, by rows', () => {
    for (let j = 0; j < 3; j++) expect(inverse[j]! / inverse[0]!).toBeCloseTo(TI[0]![j]! / TI[0]![0]!, 13);
    const pair = (m: ArrayLike<number>, j: number): Complex => [m[3 + j]!, m[6 + j]!];
    const printed = TI.flat();
    for (let j = 0; j < 3; j++) {
      const [re, im] = over(pair(inverse, j), pair(inverse, 0));
      const [expectedRe, expectedIm] = over(pair(printed, j), pair(printed, 0));
      expect(re).toBeCloseTo(expectedRe, 12);
      expect(Math.abs(im)).toBeCloseTo(Math.abs(expectedIm), 12);
    }
  });
});
