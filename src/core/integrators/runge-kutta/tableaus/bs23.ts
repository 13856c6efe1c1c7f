import type { EmbeddedTableau } from '../tableau.ts';

/**
 * Bogacki and Shampine's pair of order 3(2); between the ends of its steps the cubic Hermite polynomial, of order 3.
 *
 * P. Bogacki, L. F. Shampine, "A 3(2) pair of Runge-Kutta formulas", Appl. Math. Lett. 2 (1989), 321-325; b minus
 * the embedded weights 7/24, 1/4, 1/3, 1/8.
 */
export const bs23: EmbeddedTableau = {
  order: 3,
  stages: 3,
  c: [0, 1 / 2, 3 / 4, 1],
  A: [[], [1 / 2], [0, 3 / 4], [2 / 9, 1 / 3, 4 / 9]],
  error: [-5 / 72, 1 / 12, 1 / 9, -1 / 8],
  dense: [],
};
