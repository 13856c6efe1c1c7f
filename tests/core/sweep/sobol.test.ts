import { expect, test } from 'vitest';
import { normalQuantile } from '../../../src/core/sweep/normalQuantile.ts';
import { MOST_SOBOL_DIMENSIONS, sobol } from '../../../src/core/sweep/sobol.ts';

// Of SciPy 1.17, scipy.stats.qmc.Sobol(17, scramble=False), times 2^32: some rows, some columns.
const COLUMNS = [0, 1, 2, 5, 9, 13, 16];
const ROWS: Readonly<Record<number, readonly number[]>> = {
  1: [2147483648, 2147483648, 2147483648, 2147483648, 2147483648, 2147483648, 2147483648],
  2: [3221225472, 1073741824, 1073741824, 3221225472, 3221225472, 1073741824, 3221225472],
  3: [1073741824, 3221225472, 3221225472, 1073741824, 1073741824, 3221225472, 1073741824],
  5: [3758096384, 3758096384, 536870912, 2684354560, 536870912, 536870912, 3758096384],
  11: [1879048192, 2415919104, 805306368, 268435456, 268435456, 805306368, 2415919104],
  37: [3959422976, 2751463424, 2483027968, 1275068416, 738197504, 3690987520, 3422552064],
  63: [67108864, 3422552064, 1543503872, 603979776, 2483027968, 3288334336, 335544320],
};

test("Sobol's points are SciPy's", () => {
  for (const [index, row] of Object.entries(ROWS)) expect(COLUMNS.map((k) => sobol(+index, k))).toEqual(row);
});

test('every dimension fills 256 equal parts once', () => {
  for (let k = 0; k < MOST_SOBOL_DIMENSIONS; k++)
    expect(new Set(Array.from({ length: 256 }, (_, i) => sobol(i, k) >>> 24)).size, `dimension ${k}`).toBe(256);
});

// Of scipy.stats.norm.ppf.
test.each([
  [1e-9, -5.9978070150076865],
  [0.001, -3.090232306167813],
  [0.07, -1.4757910281791706],
  [0.3, -0.5244005127080409],
  [0.5, 0],
  [0.9, 1.2815515655446004],
  [1 - 2 ** -33, 6.3379577545537895],
])('the normal quantile of %d', (p, quantile) => {
  expect(Math.abs(normalQuantile(p) - quantile)).toBeLessThanOrEqual(4e-15 * Math.abs(quantile));
});
