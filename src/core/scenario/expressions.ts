import {
  applied,
  choice,
  fixed,
  negated,
  operators,
  rateOf,
  several,
  unary,
  variable,
  type Term,
} from './expressionTerms.ts';
import { constants, ExpressionError, MOST_DEPTH, plainText, type PlainText } from './expressionText.ts';
import { type MathTree, parseMath } from './mathParser.ts';

export { ExpressionError } from './expressionText.ts';

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
 * @param options.variables names of the independent variable: `['t']`, or none for constants
 * @throws ExpressionError also where a constant, or a constant part, is not a finite number
 */
export function compileExpression(
  text: string | number,
  options: { variables: readonly string[] },
): CompiledExpression {
  if (typeof text === 'number') {
    if (!Number.isFinite(text)) throw new ExpressionError(`${text} is not a finite number`);
    return { evaluate: () => text, derivative: () => 0, constant: true };
  }
  const term = new Compiler(plainText(text, options.variables), options.variables).compile();
  return { evaluate: term.value, derivative: (t) => rateOf(term, t), constant: term.constant };
}

/** Value of a constant expression. @throws ExpressionError */
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
  private nodes = 0;

  constructor(source: PlainText, variables: readonly string[]) {
    this.source = source;
    this.variables = variables;
  }

  compile(): Term {
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

  private walk(node: AnyNode, depth: number): Term {
    if (++this.nodes > MOST_NODES) throw new ExpressionError(`it has more than ${MOST_NODES} parts`);
    if (depth > 2 * MOST_DEPTH) throw new ExpressionError(`it is nested deeper than ${MOST_DEPTH}`);
    const term = this.termOf(node, depth);
    if (!term.constant) return term;
    const value = term.value(0);
    if (!Number.isFinite(value))
      throw new ExpressionError(`${this.shown(node)} is ${value}; a finite number is needed`);
    return fixed(value);
  }

  private termOf(node: AnyNode, depth: number): Term {
    const next = (child: AnyNode): Term => this.walk(child, depth + 1);
    switch (node.type) {
      case 'ConstantNode':
        if (typeof node.value !== 'number') throw new ExpressionError('only numbers are allowed');
        return fixed(node.value);
      case 'ParenthesisNode':
        return next(node.content);
      case 'SymbolNode':
        return this.symbol(node.name);
      case 'OperatorNode':
        // A sum or product of many parts is a long list, not a deep nest: its left side keeps the depth.
        return this.operator(
          node.op,
          node.args.map((arg, i) => this.walk(arg, depth + (node.args.length === 2 && i === 0 ? 0 : 1))),
        );
      case 'RelationalNode':
        return this.chain(node.conditionals, node.params.map(next));
      case 'ConditionalNode':
        return choice(next(node.condition), next(node.trueExpr), next(node.falseExpr));
      case 'FunctionNode':
        return this.call(node.fn.type === 'SymbolNode' ? node.fn.name : '', node.args.map(next));
      default:
        throw new ExpressionError(`only a formula of numbers${this.variables.length > 0 ? ' and t' : ''} is allowed`);
    }
  }

  private symbol(name: string): Term {
    if (this.variables.includes(name)) return variable;
    const value = constants.get(name);
    if (value === undefined) throw new ExpressionError('unknown name');
    return fixed(value);
  }

  private operator(op: string, args: readonly Term[]): Term {
    if (args.length === 1 && op === '-') return negated(args[0]!);
    if (args.length === 1 && op === '+') return args[0]!;
    const combine = args.length === 2 ? operators.get(op) : undefined;
    if (!combine)
      throw new ExpressionError(`that operator is not allowed; right would be ${[...operators.keys()].join(' ')}`);
    return combine(args[0]!, args[1]!);
  }

  /** All comparisons of `a < b < c` hold. The middle is evaluated twice, at one level of nesting only. */
  private chain(conditionals: readonly string[], params: readonly Term[]): Term {
    if (params.slice(1, -1).some((p) => p !== variable && !p.constant)) {
      throw new ExpressionError(
        'only t or a number may stand between two comparisons; join them by a product: (a < b) * (b < c)',
      );
    }
    const tests = conditionals.map((name, i) => this.operator(CHAINED.get(name) ?? '', [params[i]!, params[i + 1]!]));
    return tests.reduce(operators.get('*')!);
  }

  private call(name: string, args: readonly Term[]): Term {
    const one = unary.get(name);
    const [fewest, most, combine] = several.get(name) ?? [1, 1, null];
    if (!one && !combine) throw new ExpressionError('unknown function');
    if (args.length < fewest || args.length > most) {
      const right = fewest === most ? `${fewest} argument${fewest === 1 ? '' : 's'}` : `${fewest} to ${most} arguments`;
      throw new ExpressionError(`${name} takes ${right}, not ${args.length}`, this.placeOf(name));
    }
    return one ? applied(one, args[0]!) : args.reduce(combine!);
  }

  private placeOf(name: string): number | null {
    const at = this.source.text.search(new RegExp(`\\b${name}\\s*\\(`));
    return at < 0 ? null : this.source.origin(at);
  }

  private shown(node: AnyNode): string {
    const text = String(node as unknown as MathTree);
    return `"${text.length > 40 ? `${text.slice(0, 39)}…` : text}"`;
  }
}
