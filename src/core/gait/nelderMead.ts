/**
 * The simplex method of Nelder and Mead (Computer Journal 7 (1965) 308) with the rules of Lagarias, Reeds, Wright and
 * Wright (SIAM J. Optimization 9 (1998) 112): minimizes a function of a few variables that has no derivative at hand.
 */

export interface Vertex {
  x: readonly number[];
  value: number;
}

/** Reflection, expansion, contraction and shrinkage, as both papers have them. */
const [REFLECT, EXPAND, CONTRACT, SHRINK] = [1, 2, 0.5, 0.5] as const;

/**
 * Asks for one value at a time: yields the point and is given the function's value there (Infinity where it has none), so
 * that whoever computes it can take its time, show how far it is, and stop.
 *
 * @param start of the first simplex, d numbers
 * @param steps its edges along each axis, d numbers
 * @param tolerance ends once the values of the simplex differ by no more
 * @param most values
 * @returns the best vertex
 */
export function* nelderMead(
  start: readonly number[],
  steps: readonly number[],
  tolerance: number,
  most: number,
): Generator<readonly number[], Vertex, number> {
  const d = start.length;
  let count = 0;
  const at = function* (x: readonly number[]): Generator<readonly number[], Vertex, number> {
    count++;
    return { x, value: yield x };
  };
  const simplex: Vertex[] = [];
  for (let k = 0; k <= d; k++) simplex.push(yield* at(start.map((x, i) => (i === k - 1 ? x + steps[i]! : x))));
  const sort = (): void => void simplex.sort((a, b) => a.value - b.value);
  for (sort(); count < most && !(simplex[d]!.value - simplex[0]!.value <= tolerance); sort()) {
    const [low, high] = [simplex[0]!, simplex[d]!];
    const centre = start.map((_, i) => simplex.slice(0, d).reduce((sum, { x }) => sum + x[i]!, 0) / d);
    const along = (share: number): readonly number[] => centre.map((c, i) => c + share * (c - high.x[i]!));
    const reflected = yield* at(along(REFLECT));
    if (reflected.value < low.value) {
      const expanded = yield* at(along(REFLECT * EXPAND));
      simplex[d] = expanded.value < reflected.value ? expanded : reflected;
      continue;
    }
    if (reflected.value < simplex[d - 1]!.value) {
      simplex[d] = reflected;
      continue;
    }
    const outside = reflected.value < high.value;
    const contracted = yield* at(along(outside ? REFLECT * CONTRACT : -CONTRACT));
    if (outside ? contracted.value <= reflected.value : contracted.value < high.value) simplex[d] = contracted;
    else
      for (let k = 1; k <= d; k++)
        simplex[k] = yield* at(simplex[k]!.x.map((x, i) => low.x[i]! + SHRINK * (x - low.x[i]!)));
  }
  return simplex[0]!;
}
