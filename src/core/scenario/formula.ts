import { closuresOf, mark, type Closures } from './expressions/closures.ts';
import { formulaTree } from './expressions.ts';

/**
 * An expression of several variables, as `alpha + alpha_fp` of the states: the same language as that of inputs
 * (`expressions.ts`), with names in the place of t. Nothing is allocated when it is evaluated.
 */
export class Formula {
  readonly text: string;
  private readonly closures: Closures;
  private readonly seeds: Float64Array;

  /** @param variables names, by whose places values are given @throws ExpressionError */
  constructor(text: string, variables: readonly string[]) {
    this.text = text;
    this.closures = closuresOf(formulaTree(text, variables));
    this.seeds = new Float64Array(variables.length);
  }

  /** @param values one per variable */
  evaluate(values: ArrayLike<number>): number {
    mark.values = values;
    return this.closures.value(0);
  }

  /** Exact derivative by the variable at this place. */
  slope(values: ArrayLike<number>, place: number): number {
    mark.values = values;
    mark.rates = this.seeds;
    this.seeds[place] = 1;
    this.closures.dual(0);
    this.seeds[place] = 0;
    return mark.rate;
  }
}
