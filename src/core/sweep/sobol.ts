/**
 * Sobol's sequence in Gray-code order (I. M. Sobol, USSR Comp. Math. Math. Phys. 7 (1967); I. A. Antonov and V. M. Saleev,
 * 19 (1979)), with the direction numbers `new-joe-kuo-6` of S. Joe and F. Y. Kuo, SIAM J. Sci. Comput. 30 (2008) 2635.
 */

const BITS = 32;

/** Primitive polynomial's degree and inner coefficients, then the first direction numbers; the first dimension has none. */
const DIRECTIONS: readonly (readonly [degree: number, inner: number, ...first: number[]])[] = [
  [1, 0, 1],
  [2, 1, 1, 3],
  [3, 1, 1, 3, 1],
  [3, 2, 1, 1, 1],
  [4, 1, 1, 1, 3, 3],
  [4, 4, 1, 3, 5, 13],
  [5, 2, 1, 1, 5, 5, 17],
  [5, 4, 1, 1, 5, 5, 5],
  [5, 7, 1, 1, 7, 11, 19],
  [5, 11, 1, 1, 5, 1, 1],
  [5, 13, 1, 1, 1, 3, 11],
  [5, 14, 1, 3, 5, 5, 31],
  [6, 1, 1, 3, 3, 9, 7, 49],
  [6, 13, 1, 1, 1, 15, 21, 21],
  [6, 16, 1, 3, 1, 13, 27, 49],
  [6, 19, 1, 1, 1, 15, 7, 5],
];

/** Dimensions that there are. */
export const MOST_SOBOL_DIMENSIONS = DIRECTIONS.length + 1;

const tables = Array.from({ length: MOST_SOBOL_DIMENSIONS }, (_, dimension) => table(dimension));

/**
 * The point of the sequence with this number, as 32 bits: divided by 2^32 it lies in [0, 1).
 *
 * @param index from 0, below 2^32
 * @param dimension from 0, below `MOST_SOBOL_DIMENSIONS`
 */
export function sobol(index: number, dimension: number): number {
  let gray = (index ^ (index >>> 1)) >>> 0;
  let bits = 0;
  for (const direction of tables[dimension]!) {
    if (gray === 0) break;
    if (gray & 1) bits ^= direction;
    gray >>>= 1;
  }
  return bits >>> 0;
}

function table(dimension: number): Uint32Array {
  const v = new Uint32Array(BITS);
  if (dimension === 0) return v.map((_, i) => 1 << (BITS - 1 - i));
  const [degree, inner, ...first] = DIRECTIONS[dimension - 1]!;
  for (let i = 0; i < BITS; i++) {
    if (i < degree) {
      v[i] = first[i]! << (BITS - 1 - i);
      continue;
    }
    let next = v[i - degree]! ^ (v[i - degree]! >>> degree);
    for (let k = 1; k < degree; k++) if ((inner >>> (degree - 1 - k)) & 1) next ^= v[i - k]!;
    v[i] = next;
  }
  return v;
}
