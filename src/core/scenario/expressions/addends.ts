import { closuresOf } from './closures.ts';
import { node, number, type Node } from './tree.ts';

/**
 * The parts of a sum that depend on t, each without its constant factors. A share of a sum, as the logistic function
 * exp(x) / (1 + exp(x)) and tanh by its exponentials, is 1 / (1 + the others beside it): so its rate is bounded where it
 * nears 1, too, and not by the difference of two large ones.
 *
 * @param of root of the formula's tree
 */
export function addendsOf(of: Node): Node[] {
  return leavesOf(of)
    .filter((leaf) => !leaf.constant && leaf.op !== 't')
    .flatMap((leaf) => (leaf.op === '/' && sharesOf(leaf.args[0]!, leaf.args[1]!)) || [leaf]);
}

/** What a sum adds up, each without its constant factors. */
function leavesOf(of: Node): Node[] {
  const [a, b] = of.args;
  if (of.constant) return [of];
  if (of.op === '+' || of.op === '-') return [...leavesOf(a!), ...leavesOf(b!)];
  if (of.op === 'negative' || (of.op === '/' && b!.constant)) return leavesOf(a!);
  if (of.op === '*' && (a!.constant || b!.constant)) return leavesOf(a!.constant ? b! : a!);
  return [of];
}

interface Term {
  factor: number;
  part: Node;
}

/** The terms of a sum of exponentials, hyperbolic cosines and constants; null where it has others, or negative ones. */
function positiveTerms(of: Node): Term[] | null {
  if (of.constant) {
    const factor = closuresOf(of).value(0);
    return factor > 0 && factor < Infinity ? [{ factor, part: number(1) }] : null;
  }
  const [a, b] = of.args;
  if (of.op === 'exp' || of.op === 'cosh') return [{ factor: 1, part: of }];
  if (of.op === '*' && a!.constant) {
    const terms = positiveTerms(a!) && positiveTerms(b!);
    return terms && terms.map(({ factor, part }) => ({ factor: factor * closuresOf(a!).value(0), part }));
  }
  if (of.op !== '+') return null;
  const [first, second] = [positiveTerms(a!), positiveTerms(b!)];
  return first && second && [...first, ...second];
}

/** Of a quotient whose numerator has but terms of its denominator, the share of each that depends on t. */
function sharesOf(numerator: Node, denominator: Node): Node[] | null {
  const terms = positiveTerms(denominator);
  if (!terms) return null;
  const shares: Node[] = [];
  for (const leaf of leavesOf(numerator)) {
    const at = terms.findIndex(({ part }) => isSame(part, leaf));
    if (at < 0 && !leaf.constant) return null;
    const beside = terms
      .filter((_, i) => i !== at)
      .map(({ factor, part }) => node('*', number(factor), node('/', part, leaf)))
      .reduce((sum, term) => node('+', sum, term), number(terms[at]?.factor ?? 0));
    shares.push(node('/', number(1), leaf.constant ? denominator : beside));
  }
  return shares;
}

const isSame = (a: Node, b: Node): boolean =>
  a === b ||
  (a.op === b.op &&
    Object.is(a.x, b.x) &&
    a.args.length === b.args.length &&
    a.args.every((arg, i) => isSame(arg, b.args[i]!)));
