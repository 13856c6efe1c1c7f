import { create, parseDependencies, type MathNode } from 'mathjs/number';

/**
 * Expressions typed by people or found in links and files of strangers. mathjs reads the text; its tree is then
 * walked against a list of what is allowed and turned into closures of our own. mathjs evaluates nothing, so no
 * text reaches code, objects, the page or the network.
 *
 * Derivatives with respect to t are exact: every node knows its value and its rate (forward differentiation;
 * Griewank and Walther, Evaluating Derivatives, 2nd ed., SIAM 2008, section 3.1).
 */

/** A text that is no allowed expression: what is wrong, where, what would be right. */
export class ExpressionError extends Error {
  /** 0-based character in the text, or null when it concerns the whole. */
  readonly position: number | null;
  constructor(message: string, position: number | null = null) {
    super(position === null ? message : `${message} (at character ${position + 1})`);
    this.name = 'ExpressionError';
    this.position = position;
  }
}

export interface CompiledExpression {
  evaluate(t: number): number;
  /** Exact d/dt. */
  derivative(t: number): number;
  /** Whether t does not occur. */
  constant: boolean;
}

/** Longer, larger or deeper texts are no formulas; refused before they cost time or stack. */
const MOST_CHARACTERS = 1000;
const MOST_NODES = 300;
const MOST_DEPTH = 60;

interface Term {
  value(t: number): number;
  rate(t: number): number;
  constant: boolean;
}

const { parse } = create({ parseDependencies: parseDependencies! });

const CONSTANTS = new Map<string, number>([
  ['pi', Math.PI],
  ['tau', 2 * Math.PI],
  ['e', Math.E],
  ['deg', Math.PI / 180],
  ['rad', 1],
]);

/** Functions of one argument with their derivatives. */
const UNARY = new Map<string, [f: (x: number) => number, slope: (x: number) => number]>([
  ['sin', [Math.sin, Math.cos]],
  ['cos', [Math.cos, (x) => -Math.sin(x)]],
  ['tan', [Math.tan, (x) => 1 / Math.cos(x) ** 2]],
  ['asin', [Math.asin, (x) => 1 / Math.sqrt(1 - x * x)]],
  ['acos', [Math.acos, (x) => -1 / Math.sqrt(1 - x * x)]],
  ['atan', [Math.atan, (x) => 1 / (1 + x * x)]],
  ['sinh', [Math.sinh, Math.cosh]],
  ['cosh', [Math.cosh, Math.sinh]],
  ['tanh', [Math.tanh, (x) => 1 - Math.tanh(x) ** 2]],
  ['exp', [Math.exp, Math.exp]],
  ['log', [Math.log, (x) => 1 / x]],
  ['ln', [Math.log, (x) => 1 / x]],
  ['log10', [Math.log10, (x) => 1 / (x * Math.LN10)]],
  ['log2', [Math.log2, (x) => 1 / (x * Math.LN2)]],
  ['sqrt', [Math.sqrt, (x) => 0.5 / Math.sqrt(x)]],
  ['cbrt', [Math.cbrt, (x) => 1 / (3 * Math.cbrt(x) ** 2)]],
  ['abs', [Math.abs, Math.sign]],
  ['sign', [Math.sign, () => 0]],
  ['floor', [Math.floor, () => 0]],
  ['ceil', [Math.ceil, () => 0]],
  ['round', [Math.round, () => 0]],
]);

/** Functions of several arguments: how many, and how terms combine. */
const SEVERAL = new Map<string, [least: number, most: number, combine: (args: Term[]) => Term]>([
  ['atan2', [2, 2, ([y, x]) => {
    const [a, b] = [y!, x!];
    return term((t) => Math.atan2(a.value(t), b.value(t)),
      (t) => (b.value(t) * a.rate(t) - a.value(t) * b.rate(t)) / (a.value(t) ** 2 + b.value(t) ** 2), [a, b]);
  }]],
  ['hypot', [1, 8, (args) => term((t) => Math.hypot(...args.map((a) => a.value(t))),
    (t) => args.reduce((sum, a) => sum + a.value(t) * a.rate(t), 0) / Math.hypot(...args.map((a) => a.value(t))), args)]],
  ['min', [1, 8, (args) => chosen(args, (x, y) => x < y)]],
  ['max', [1, 8, (args) => chosen(args, (x, y) => x > y)]],
  ['pow', [2, 2, ([a, b]) => power(a!, b!)]],
  ['mod', [2, 2, ([a, b]) => modulo(a!, b!)]],
]);

const OPERATORS = new Map<string, (a: Term, b: Term) => Term>([
  ['+', (a, b) => term((t) => a.value(t) + b.value(t), (t) => a.rate(t) + b.rate(t), [a, b])],
  ['-', (a, b) => term((t) => a.value(t) - b.value(t), (t) => a.rate(t) - b.rate(t), [a, b])],
  ['*', (a, b) => term((t) => a.value(t) * b.value(t), (t) => a.rate(t) * b.value(t) + a.value(t) * b.rate(t), [a, b])],
  ['/', (a, b) => term((t) => a.value(t) / b.value(t),
    (t) => (a.rate(t) - (a.value(t) / b.value(t)) * b.rate(t)) / b.value(t), [a, b])],
  ['^', power],
  ['<', (a, b) => test(a, b, (x, y) => x < y)],
  ['>', (a, b) => test(a, b, (x, y) => x > y)],
  ['<=', (a, b) => test(a, b, (x, y) => x <= y)],
  ['>=', (a, b) => test(a, b, (x, y) => x >= y)],
  ['==', (a, b) => test(a, b, (x, y) => x === y)],
  ['!=', (a, b) => test(a, b, (x, y) => x !== y)],
]);

/**
 * Compiles a number or text such as `"22*exp(-10*(t-8)^2)"` or `"45 deg"` (SI, radians).
 * @throws ExpressionError
 */
export function compileExpression(text: string | number, options: { variables: readonly string[] }): CompiledExpression {
  if (typeof text === 'number') {
    if (!Number.isFinite(text)) throw new ExpressionError(`${text} is not a finite number`);
    return { evaluate: () => text, derivative: () => 0, constant: true };
  }
  const compiled = new Compiler(text, options.variables).term();
  if (compiled.constant && !Number.isFinite(compiled.value(0))) {
    throw new ExpressionError(`"${shorten(text)}" is ${compiled.value(0)}; a finite number is needed`);
  }
  return { evaluate: (t) => compiled.value(t), derivative: (t) => compiled.rate(t), constant: compiled.constant };
}

/** Value of a constant expression. @throws ExpressionError */
export function evaluateNumber(text: string | number): number {
  return compileExpression(text, { variables: [] }).evaluate(0);
}

class Compiler {
  private readonly text: string;
  private readonly variables: readonly string[];
  private nodes = 0;

  constructor(text: string, variables: readonly string[]) {
    if (text.length > MOST_CHARACTERS) throw new ExpressionError(`${text.length} characters are more than the ${MOST_CHARACTERS} allowed`);
    // Characters that keyboards and documents bring.
    this.text = text.replace(/[−–]/g, '-').replace(/[×·]/g, '*').replace(/π/g, 'pi').replace(/°/g, ' deg').replace(/[\t\u00a0\u2009\u202f]/g, ' ');
    this.variables = variables;
  }

  term(): Term {
    if (this.text.trim() === '') throw new ExpressionError('it is empty; a number or an expression is needed');
    this.refuseDeep();
    // One formula on one line: the reader would take these as blocks, comments or strings.
    const odd = /[;\n\r#"'`[\]{}\\]/.exec(this.text);
    if (odd) throw new ExpressionError(`"${odd[0] === '\n' || odd[0] === '\r' ? 'line break' : odd[0]}" has no place in an expression`, odd.index);
    let tree: MathNode;
    try {
      tree = parse(this.text);
    } catch (error) {
      const place = /\(char (\d+)\)/.exec(String((error as Error).message));
      const what = String((error as Error).message).replace(/\s*\(char \d+\)/, '').replace(/^\w*Error:\s*/, '');
      throw new ExpressionError(`"${shorten(this.text)}" is not an expression: ${what}`, place ? Math.max(0, Number(place[1]) - 1) : null);
    }
    return this.walk(tree, 0);
  }

  /** Deep nesting would overflow the reader's own stack. */
  private refuseDeep(): void {
    let depth = 0;
    let run = 0;
    for (let i = 0; i < this.text.length; i++) {
      const c = this.text[i]!;
      if (c === '(') depth++;
      else if (c === ')') depth--;
      run = c === '-' || c === '+' || c === '^' || c === '!' ? run + 1 : c === ' ' ? run : 0;
      if (depth > MOST_DEPTH || run > MOST_DEPTH) throw new ExpressionError(`it is nested deeper than ${MOST_DEPTH}`, i);
    }
  }

  private walk(node: MathNode, depth: number): Term {
    if (++this.nodes > MOST_NODES || depth > MOST_DEPTH) throw new ExpressionError(`it has more than ${MOST_NODES} parts or is nested deeper than ${MOST_DEPTH}`);
    const next = (child: MathNode): Term => this.walk(child, depth + 1);
    const n = node as unknown as AnyNode;
    switch (n.type) {
      case 'ConstantNode':
        if (typeof n.value !== 'number') throw new ExpressionError(`${String(n.value)} is not a number`);
        return constant(n.value);
      case 'ParenthesisNode':
        return next(n.content);
      case 'SymbolNode':
        return this.symbol(n.name);
      case 'OperatorNode':
        return this.operator(n.op, n.args.map(next));
      case 'RelationalNode':
        throw new ExpressionError('chained comparisons are not understood; compare two numbers at a time');
      case 'ConditionalNode':
        return choice(next(n.condition), next(n.trueExpr), next(n.falseExpr));
      case 'FunctionNode':
        return this.call(n.fn, n.args.map(next));
      default:
        throw new ExpressionError(`${REFUSED.get(n.type) ?? 'that form'} is not allowed here; a formula of numbers${this.variables.length ? ' and t' : ''} is`);
    }
  }

  private symbol(name: string): Term {
    if (this.variables.includes(name)) return { value: (t) => t, rate: () => 1, constant: false };
    const value = CONSTANTS.get(name);
    if (value !== undefined) return constant(value);
    const known = [...this.variables, ...CONSTANTS.keys()].join(', ');
    const hint = UNARY.has(name) || SEVERAL.has(name) ? `"${name}" is a function: write ${name}(…)` : `unknown name "${shorten(name)}"; known: ${known}`;
    throw new ExpressionError(hint, this.place(name));
  }

  private operator(op: string, args: Term[]): Term {
    if (args.length === 1 && op === '-') return term((t) => -args[0]!.value(t), (t) => -args[0]!.rate(t), args);
    if (args.length === 1 && op === '+') return args[0]!;
    const combine = args.length === 2 ? OPERATORS.get(op) : undefined;
    if (!combine) throw new ExpressionError(`the operator "${op}" is not allowed here; right would be + - * / ^ and comparisons`, this.place(op));
    return combine(args[0]!, args[1]!);
  }

  private call(fn: AnyNode, args: Term[]): Term {
    const name = fn.type === 'SymbolNode' ? fn.name : '';
    const unary = UNARY.get(name);
    if (unary) {
      if (args.length !== 1) throw new ExpressionError(`${name} takes one argument, not ${args.length}`, this.place(name));
      const [f, slope] = unary;
      const x = args[0]!;
      return term((t) => f(x.value(t)), (t) => (x.constant ? 0 : slope(x.value(t)) * x.rate(t)), args);
    }
    const several = SEVERAL.get(name);
    if (!several) throw new ExpressionError(`unknown function "${shorten(name || 'that')}"; known: ${[...UNARY.keys(), ...SEVERAL.keys()].join(', ')}`, this.place(name));
    const [least, most, combine] = several;
    if (args.length < least || args.length > most) throw new ExpressionError(`${name} takes ${least === most ? least : `${least} to ${most}`} arguments, not ${args.length}`, this.place(name));
    return combine(args);
  }

  private place(name: string): number | null {
    const at = name ? this.text.indexOf(name) : -1;
    return at < 0 ? null : at;
  }
}

/** The parts of mathjs' nodes that are looked at. */
interface AnyNode {
  type: string;
  value: unknown;
  name: string;
  op: string;
  fn: AnyNode;
  args: MathNode[];
  content: MathNode;
  condition: MathNode;
  trueExpr: MathNode;
  falseExpr: MathNode;
}

const REFUSED = new Map([
  ['AssignmentNode', 'an assignment'],
  ['FunctionAssignmentNode', 'defining a function'],
  ['AccessorNode', 'reaching into an object'],
  ['IndexNode', 'an index'],
  ['ArrayNode', 'a list'],
  ['ObjectNode', 'an object'],
  ['RangeNode', 'a range'],
  ['BlockNode', 'more than one expression'],
]);

function term(value: Term['value'], rate: Term['rate'], parts: readonly Term[]): Term {
  const isConstant = parts.every((p) => p.constant);
  if (!isConstant) return { value, rate, constant: false };
  return constant(value(0));
}

function constant(number: number): Term {
  return { value: () => number, rate: () => 0, constant: true };
}

function power(a: Term, b: Term): Term {
  if (b.constant) {
    const n = b.value(0);
    return term((t) => Math.pow(a.value(t), n), (t) => (n === 0 ? 0 : n * Math.pow(a.value(t), n - 1) * a.rate(t)), [a, b]);
  }
  const value = (t: number): number => Math.pow(a.value(t), b.value(t));
  const rate = (t: number): number =>
    value(t) * b.rate(t) * Math.log(a.value(t)) + (a.constant ? 0 : b.value(t) * Math.pow(a.value(t), b.value(t) - 1) * a.rate(t));
  return term(value, rate, [a, b]);
}

/** Floored remainder: the sign of the divisor, so that mod(t, 2) is periodic for negative t as well. */
function modulo(a: Term, b: Term): Term {
  const turns = (t: number): number => Math.floor(a.value(t) / b.value(t));
  return term((t) => a.value(t) - b.value(t) * turns(t), (t) => a.rate(t) - b.rate(t) * turns(t), [a, b]);
}

function chosen(args: readonly Term[], better: (x: number, y: number) => boolean): Term {
  const pick = (t: number): Term => args.reduce((best, a) => (better(a.value(t), best.value(t)) ? a : best));
  return term((t) => pick(t).value(t), (t) => pick(t).rate(t), args);
}

function choice(condition: Term, yes: Term, no: Term): Term {
  const pick = (t: number): Term => (condition.value(t) !== 0 ? yes : no);
  return term((t) => pick(t).value(t), (t) => pick(t).rate(t), [condition, yes, no]);
}

function test(a: Term, b: Term, holds: (x: number, y: number) => boolean): Term {
  return term((t) => (holds(a.value(t), b.value(t)) ? 1 : 0), () => 0, [a, b]);
}

function shorten(text: string): string {
  return text.length > 40 ? `${text.slice(0, 39)}…` : text;
}
