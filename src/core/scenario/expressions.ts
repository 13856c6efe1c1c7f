import { closuresOf, mark } from './expressions/closures.ts';
import { dualBeyondRange } from './expressions/beyondRange.ts';
import { ExpressionError } from './expressions/expressionError.ts';
import { operators, several, unary } from './expressions/functions.ts';
import { limitOf } from './expressions/limits.ts';
import { parseMath, type MathTree } from './expressions/mathParser.ts';
import { constants, MOST_DEPTH, plainText, type PlainText } from './expressions/plainText.ts';
import { named, node, number, variable, type Node } from './expressions/tree.ts';

export { ExpressionError } from './expressions/expressionError.ts';

/**
 * Expressions typed by people or found in links and files of strangers. mathjs reads the text; its tree is then
 * walked against a list of what is allowed and turned into closures of our own. mathjs evaluates nothing, so no
 * text reaches code, objects, the page or the network.
 */
export interface CompiledExpression {
  evaluate(t: number): number;
  /** Exact d/dt. */
  derivative(t: number): number;
  /** Whether t does not occur. */
  constant: boolean;
  /** What it was compiled to, for other readings of it (`expressions/tree.ts`). */
  readonly tree: Node;
}

const MOST_NODES = 200;

/** mathjs' names for the comparisons of a chain `a < b <= c`. */
const CHAINED = new Map([
  ['smaller', '<'],
  ['smallerEq', '<='],
  ['larger', '>'],
  ['largerEq', '>='],
  ['equal', '=='],
  ['unequal', '!='],
]);

/**
 * Compiles a number or text such as `"22*exp(-10*(t-8)^2)"` or `"45 deg"` (SI, radians).
 *
 * @param text as written
 * @param options names of the independent variable: `['t']`, or none for constants
 * @throws ExpressionError also where a constant, or a constant part, is not a finite number
 */
export function compileExpression(
  text: string | number,
  options: { variables: readonly string[] },
): CompiledExpression {
  if (typeof text === 'number') {
    if (!Number.isFinite(text)) throw new ExpressionError(`${text} is not a finite number`);
    return compiled(number(text));
  }
  return compiled(new Compiler(plainText(text, options.variables), options.variables).compile());
}

/**
 * The tree of a formula of several variables, each a `name` by its place (see `formula.ts`).
 *
 * @param text as written
 * @param variables their names
 * @throws ExpressionError
 */
export function formulaTree(text: string, variables: readonly string[]): Node {
  return new Compiler(plainText(text, variables), variables, true).compile();
}

/** How formulas are rewritten before they are computed: not at all until `expressions/differences.ts` is there (everyMotion.ts). */
let rewritten = (tree: Node): Node => tree;

/** @param rewriting of a formula's tree, that keeps its value */
export function rewriteBy(rewriting: (tree: Node) => Node): void {
  rewritten = rewriting;
}

/**
 * Doubles first; where a number left their range, beyond it; where the formula has no value, its limit. Differences of
 * exponentials that nearly cancel are taken without the difference.
 *
 * @param written tree of a formula of t
 */
export function compiled(written: Node): CompiledExpression {
  const tree = rewritten(written);
  const closures = closuresOf(tree);
  const value = (t: number): number => {
    mark.lost = false;
    const x = closures.value(t);
    return mark.lost || x !== x ? dualBeyondRange(tree, t).value : x;
  };
  const rate = (t: number): number => {
    mark.lost = false;
    closures.dual(t);
    return mark.lost || mark.rate !== mark.rate ? dualBeyondRange(tree, t).rate : mark.rate;
  };
  const orLimit =
    (which: 'value' | 'rate', f: (t: number) => number) =>
    (t: number): number => {
      const x = f(t);
      return x === x ? x : limitOf(tree, which, f, t);
    };
  return { evaluate: orLimit('value', value), derivative: orLimit('rate', rate), constant: tree.constant, tree };
}

/**
 * Value of a constant expression.
 *
 * @param text as written
 * @throws ExpressionError
 */
export function evaluateNumber(text: string | number): number {
  return compileExpression(text, { variables: [] }).evaluate(0);
}

/** The parts of mathjs' nodes that are looked at. */
interface AnyNode {
  type: string;
  value: unknown;
  name: string;
  op: string;
  fn: AnyNode;
  args: AnyNode[];
  content: AnyNode;
  condition: AnyNode;
  trueExpr: AnyNode;
  falseExpr: AnyNode;
  conditionals: string[];
  params: AnyNode[];
}

class Compiler {
  private readonly source: PlainText;
  private readonly variables: readonly string[];
  /** Whether each variable is one of its own. */
  private readonly several: boolean;
  private nodes = 0;

  constructor(source: PlainText, variables: readonly string[], severalVariables = false) {
    this.source = source;
    this.variables = variables;
    this.several = severalVariables;
  }

  compile(): Node {
    let tree: MathTree;
    try {
      tree = parseMath(this.source.text);
    } catch (error) {
      const message = String((error as Error).message);
      const place = /\(char (\d+)\)/.exec(message);
      const what = message.replace(/\s*\(char \d+\)/, '').replace(/^\w*Error:\s*/, '');
      throw new ExpressionError(
        `not an expression: ${what}`,
        place ? this.source.origin(Math.max(0, Number(place[1]) - 1)) : null,
      );
    }
    return this.walk(tree as unknown as AnyNode, 0);
  }

  private walk(part: AnyNode, depth: number): Node {
    if (++this.nodes > MOST_NODES) throw new ExpressionError(`it has more than ${MOST_NODES} parts`);
    if (depth > 2 * MOST_DEPTH) throw new ExpressionError(`it is nested deeper than ${MOST_DEPTH}`);
    const made = this.nodeOf(part, depth);
    if (!made.constant) return made;
    const value = closuresOf(made).value(0);
    if (!Number.isFinite(value))
      throw new ExpressionError(`${this.shown(part)} is ${value}; a finite number is needed`);
    return number(value);
  }

  private nodeOf(part: AnyNode, depth: number): Node {
    const next = (child: AnyNode): Node => this.walk(child, depth + 1);
    switch (part.type) {
      case 'ConstantNode':
        if (typeof part.value !== 'number') throw new ExpressionError('only numbers are allowed');
        return number(part.value);
      case 'ParenthesisNode':
        return next(part.content);
      case 'SymbolNode':
        return this.symbol(part.name);
      case 'OperatorNode':
        // A sum or product of many parts is a long list, not a deep nest: its left side keeps the depth.
        return this.operator(
          part.op,
          part.args.map((arg, i) => this.walk(arg, depth + (part.args.length === 2 && i === 0 ? 0 : 1))),
        );
      case 'RelationalNode':
        return this.chain(part.conditionals, part.params.map(next));
      case 'ConditionalNode':
        return node('?', next(part.condition), next(part.trueExpr), next(part.falseExpr));
      case 'FunctionNode':
        return this.call(part.fn.type === 'SymbolNode' ? part.fn.name : '', part.args.map(next));
      default:
        throw new ExpressionError(`only a formula of numbers${this.variables.length > 0 ? ' and t' : ''} is allowed`);
    }
  }

  private symbol(name: string): Node {
    const place = this.variables.indexOf(name);
    if (place >= 0) return this.several ? named(place) : variable;
    const value = constants.get(name);
    if (value === undefined) throw new ExpressionError('unknown name');
    return number(value);
  }

  private operator(op: string, args: readonly Node[]): Node {
    if (args.length === 1 && op === '-') return node('negative', args[0]!);
    if (args.length === 1 && op === '+') return args[0]!;
    if (args.length !== 2 || !operators.includes(op))
      throw new ExpressionError(`that operator is not allowed; right would be ${operators.join(' ')}`);
    return node(op, args[0]!, args[1]!);
  }

  /** All comparisons of `a < b < c` hold. The middle is evaluated twice, at one level of nesting only. */
  private chain(conditionals: readonly string[], params: readonly Node[]): Node {
    if (params.slice(1, -1).some((p) => p !== variable && !p.constant)) {
      throw new ExpressionError(
        'only t or a number may stand between two comparisons; join them by a product: (a < b) * (b < c)',
      );
    }
    const tests = conditionals.map((name, i) => this.operator(CHAINED.get(name) ?? '', [params[i]!, params[i + 1]!]));
    return tests.reduce((all, test) => node('*', all, test));
  }

  private call(name: string, args: readonly Node[]): Node {
    const bounds = unary.has(name) ? ([1, 1] as const) : several.get(name);
    if (!bounds) throw new ExpressionError('unknown function');
    const [fewest, most] = bounds;
    if (args.length < fewest || args.length > most) {
      const right = fewest === most ? `${fewest} argument${fewest === 1 ? '' : 's'}` : `${fewest} to ${most} arguments`;
      throw new ExpressionError(`${name} takes ${right}, not ${args.length}`, this.placeOf(name));
    }
    return args.length < 2 && several.has(name)
      ? args[0]!
      : args.length < 2
        ? node(name, args[0]!)
        : args.reduce((all, next) => node(name, all, next));
  }

  private placeOf(name: string): number | null {
    const at = this.source.text.search(new RegExp(`\\b${name}\\s*\\(`));
    return at < 0 ? null : this.source.origin(at);
  }

  private shown(part: AnyNode): string {
    const text = String(part as unknown as MathTree);
    return `"${text.length > 40 ? `${text.slice(0, 39)}…` : text}"`;
  }
}
