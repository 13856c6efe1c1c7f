import { several, unary } from '../scenario/expressions/functions.ts';
import { constants, MOST_DEPTH } from '../scenario/expressions/plainText.ts';
import { refuseAmbiguous } from '../scenario/expressions/reading.ts';
import { ExpressionError } from '../scenario/expressions/expressionError.ts';
import type { Graph, Id, OpName } from './graph.ts';
import { asProduct, asRate, closest } from './hints.ts';
import { DescriptionError, type LineToken } from './tokens.ts';

/** Components along the axes of the world. */
export type Vector = readonly [Id, Id, Id];

/** Axes that turn: `R` from their components to the world's, row by row; `spin` their angular velocity in their own components. */
export interface Frame {
  name: string;
  R: readonly Id[];
  spin: Vector;
}

export type Value = { kind: 'scalar'; id: Id } | { kind: 'vector'; ids: Vector } | { kind: 'frame'; frame: Frame };

/** What names mean where an expression stands. */
export interface Scope {
  readonly graph: Graph;
  /** A name, with its prime if it has one; undefined where there is none. */
  look(name: string): Value | undefined;
  /** All names, for those who misspell one. */
  names(): Iterable<string>;
  /** The line that defines a name, wherever it stands; 0 where none does. */
  definedOn(name: string): number;
  /** The line of the input of this name, up to here; 0 where there is none. */
  inputOn(name: string): number;
  /** d/dt. @throws Error with what is wrong where the expression has rates in it */
  rate(ids: readonly Id[]): Id[];
}

export const VECTOR_FUNCTIONS: ReadonlyMap<string, string> = new Map([
  ['dot', 'dot(a, b): the product of two vectors'],
  ['cross', 'cross(a, b): the vector product'],
  ['norm', 'norm(a): the length of a vector'],
  ['unit', 'unit(a): a vector of length 1'],
  ['velocity', 'velocity(P): the rate of a point'],
  ['omega', 'omega(frame): the angular velocity of a frame'],
  ['rate', 'rate(x): d/dt of a number or vector'],
]);

export const isFunctionName = (name: string): boolean =>
  unary.has(name) || several.has(name) || VECTOR_FUNCTIONS.has(name);

const SIGNS = new Map([
  ['?', 1],
  ['<', 2],
  ['>', 2],
  ['<=', 2],
  ['>=', 2],
  ['==', 2],
  ['!=', 2],
  ['+', 3],
  ['-', 3],
  ['*', 4],
  ['/', 4],
]);
/** Functions that are signs here. */
const CHOICES = new Map([
  ['if', 'a choice is written condition ? a : b'],
  ['where', 'a choice is written condition ? a : b'],
  ['square', 'a square is written x^2'],
  ['sqr', 'a square is written x^2'],
]);
const shorten = (text: string): string => (text.length > 40 ? `${text.slice(0, 39)}…` : text);
/** Level of the comparisons. */
const COMPARISON = 2;
/** Parts of one expression. */
const MOST_PARTS = 2000;

/** Reads the tokens of one line from left to right. */
export class Reader {
  readonly tokens: readonly LineToken[];
  readonly line: number;
  private readonly scope: Scope;
  private readonly text: string;
  private depth = 0;
  private parts = 0;
  private stops: ReadonlySet<string> = new Set();
  at = 0;

  /** @param text of the line, at whose end what is missing is told */
  constructor(tokens: readonly LineToken[], line: number, text: string, scope: Scope) {
    this.tokens = tokens;
    this.line = line;
    this.text = text;
    this.scope = scope;
  }

  get next(): LineToken | undefined {
    return this.tokens[this.at];
  }

  fail(reason: string, token: LineToken | undefined = this.next): never {
    if (token) throw new DescriptionError(reason, this.line, token.at + 1, Math.max(1, token.end - token.at));
    throw new DescriptionError(reason, this.line, this.text.length + 1);
  }

  /** Whether the next token is this word or sign; it is taken. */
  take(text: string): boolean {
    if (this.next?.text !== text || this.next.kind === 'text' || this.next.kind === 'unit') return false;
    this.at++;
    return true;
  }

  expect(text: string, example: string): void {
    if (!this.take(text)) this.fail(`"${text}" is expected here: ${example}`);
  }

  takeKind(kind: LineToken['kind']): LineToken | undefined {
    if (this.next?.kind !== kind) return undefined;
    return this.tokens[this.at++];
  }

  end(example: string): void {
    const { next } = this;
    if (!next) return;
    if (next.kind === 'unit') this.fail('square brackets hold the unit of a name; formulas have round ones', next);
    if (next.text === ',' && this.tokens[this.at - 1]?.kind === 'number')
      this.fail('a "," has no place here; decimals are written with a point', next);
    this.fail(`"${next.text}" has no place here: ${example}`);
  }

  /** A number. @param stops words that end it */
  scalar(...stops: string[]): Id {
    const from = this.next;
    const value = this.expression(stops);
    if (value.kind !== 'scalar') return this.fail(`a number is expected here, not a ${value.kind}`, from);
    return value.id;
  }

  vector(...stops: string[]): Vector {
    const from = this.next;
    const value = this.expression(stops);
    if (value.kind !== 'vector') return this.fail(`a point or vector is expected here, not a ${value.kind}`, from);
    return value.ids;
  }

  /** A name that stands for a frame. */
  frame(): Frame {
    const token = this.takeKind('name') ?? this.fail('the name of a frame is expected here');
    const value = this.scope.look(token.text) ?? this.unknown(token);
    if (value.kind !== 'frame') return this.fail(`"${token.text}" is no frame`, token);
    return value.frame;
  }

  expression(stops: readonly string[]): Value {
    const from = this.at;
    const outer = this.stops;
    this.stops = new Set(stops);
    const value = this.binary(0);
    this.stops = outer;
    this.refuseTwoMeanings(from);
    return value;
  }

  private refuseTwoMeanings(from: number): void {
    try {
      refuseAmbiguous(
        this.tokens.slice(from, this.at),
        (name) => this.calls(name),
        (a, b) => this.text.slice(a, b),
        (at) => at,
      );
    } catch (error) {
      if (!(error instanceof ExpressionError)) throw error;
      throw new DescriptionError(
        error.message.replace(/ \(at character \d+\)$/, ''),
        this.line,
        (error.position ?? 0) + 1,
      );
    }
  }

  private binary(least: number): Value {
    if (++this.depth > MOST_DEPTH) this.fail(`this is nested deeper than ${MOST_DEPTH}`);
    let left = this.signed();
    /** Right side of the comparison that `left` is, for the next in a chain a < b < c: all of them hold. */
    let middle: Value | null = null;
    for (;;) {
      const token = this.next;
      if (!token || this.stops.has(token.text)) break;
      const level = token.kind === 'sign' ? SIGNS.get(token.text) : undefined;
      if (level === undefined) {
        // A product without a sign.
        const begins =
          token.kind === 'number' || token.kind === 'name' || (token.kind === 'sign' && token.text === '(');
        if (!begins || 4 < least) break;
        left = this.product(left, this.power(), token);
        continue;
      }
      if (level < least) break;
      this.at++;
      if (token.text === '?') {
        left = this.choice(left, token);
        continue;
      }
      const right = this.binary(level + 1);
      const made = this.operate(token, middle && level === COMPARISON ? middle : left, right);
      left = middle && level === COMPARISON ? this.product(left, made, token) : made;
      middle = level === COMPARISON ? right : null;
    }
    this.depth--;
    return left;
  }

  private choice(condition: Value, token: LineToken): Value {
    const { graph } = this.scope;
    const test = this.number(condition, token);
    const yes = this.binary(1);
    this.expect(':', 'a choice is written condition ? a : b');
    const no = this.binary(1);
    if (yes.kind === 'vector' && no.kind === 'vector')
      return {
        kind: 'vector',
        ids: [0, 1, 2].map((k) => graph.select(test, yes.ids[k]!, no.ids[k]!)) as unknown as Vector,
      };
    return { kind: 'scalar', id: graph.select(test, this.number(yes, token), this.number(no, token)) };
  }

  private operate(token: LineToken, a: Value, b: Value): Value {
    const { graph } = this.scope;
    const op = token.text;
    if (op === '*') return this.product(a, b, token);
    if ((op === '+' || op === '-') && a.kind === 'vector' && b.kind === 'vector') {
      const one = (x: Id, y: Id): Id => (op === '+' ? graph.add(x, y) : graph.sub(x, y));
      return { kind: 'vector', ids: [one(a.ids[0], b.ids[0]), one(a.ids[1], b.ids[1]), one(a.ids[2], b.ids[2])] };
    }
    if (op === '/' && a.kind === 'vector') {
      const by = this.number(b, token);
      return { kind: 'vector', ids: a.ids.map((x) => graph.div(x, by)) as unknown as Vector };
    }
    if (a.kind !== b.kind) this.fail(`a ${a.kind} and a ${b.kind} can't be joined by "${op}"`, token);
    const [x, y] = [this.number(a, token), this.number(b, token)];
    const truth = (): Id => {
      switch (op) {
        case '<':
          return graph.compare('lt', x, y);
        case '>':
          return graph.compare('lt', y, x);
        case '<=':
          return graph.compare('le', x, y);
        case '>=':
          return graph.compare('le', y, x);
        case '==':
          return graph.compare('eq', x, y);
        default:
          return graph.sub(graph.one, graph.compare('eq', x, y));
      }
    };
    const id = op === '+' ? graph.add(x, y) : op === '-' ? graph.sub(x, y) : op === '/' ? graph.div(x, y) : truth();
    return this.finite({ kind: 'scalar', id }, token);
  }

  private product(a: Value, b: Value, token: LineToken): Value {
    const { graph } = this.scope;
    if (a.kind === 'vector' && b.kind === 'vector')
      this.fail('two vectors are multiplied by dot(a, b) or cross(a, b)', token);
    if (a.kind === 'vector' || b.kind === 'vector') {
      const [vector, by] = a.kind === 'vector' ? [a, b] : [b as { kind: 'vector'; ids: Vector }, a];
      const factor = this.number(by, token);
      return { kind: 'vector', ids: vector.ids.map((x) => graph.mul(factor, x)) as unknown as Vector };
    }
    return this.finite({ kind: 'scalar', id: graph.mul(this.number(a, token), this.number(b, token)) }, token);
  }

  private number(value: Value, token: LineToken): Id {
    if (value.kind !== 'scalar') return this.fail(`a number is expected here, not a ${value.kind}`, token);
    return value.id;
  }

  private finite(value: Value, token: LineToken): Value {
    const { graph } = this.scope;
    if (value.kind === 'scalar' && graph.isNumber(value.id) && !Number.isFinite(graph.value[value.id]))
      this.fail(`this is ${graph.value[value.id]}; a finite number is needed`, token);
    return value;
  }

  private signed(): Value {
    const token = this.next;
    if (token?.kind === 'sign' && (token.text === '-' || token.text === '+')) {
      if (++this.depth > MOST_DEPTH) this.fail(`this is nested deeper than ${MOST_DEPTH}`);
      this.at++;
      const value = this.signed();
      this.depth--;
      if (token.text === '+') return value;
      const { graph } = this.scope;
      if (value.kind === 'vector')
        return { kind: 'vector', ids: value.ids.map((x) => graph.neg(x)) as unknown as Vector };
      return { kind: 'scalar', id: graph.neg(this.number(value, token)) };
    }
    return this.power();
  }

  private power(): Value {
    const base = this.primary();
    const token = this.next;
    if (token?.text !== '^' || token.kind !== 'sign') return base;
    this.at++;
    if (++this.depth > MOST_DEPTH) this.fail(`this is nested deeper than ${MOST_DEPTH}`);
    const exponent = this.signed();
    this.depth--;
    return this.finite(
      { kind: 'scalar', id: this.scope.graph.pow(this.number(base, token), this.number(exponent, token)) },
      token,
    );
  }

  private primary(): Value {
    const { graph } = this.scope;
    const token = this.next;
    if (!token) return this.fail('something is missing at the end of the line');
    if (++this.parts > MOST_PARTS) this.fail(`a line has at most ${MOST_PARTS} parts`);
    this.at++;
    if (token.kind === 'number') {
      const x = Number(token.text);
      return Number.isFinite(x)
        ? { kind: 'scalar', id: graph.number(x) }
        : this.fail('this number is too large', token);
    }
    if (token.kind === 'name')
      return this.next?.kind === 'sign' && this.next.text === '(' && this.calls(token.text)
        ? this.call(token)
        : this.named(token);
    if (token.text === '(' && token.kind === 'sign') {
      const parts = this.list(token);
      if (parts.length === 1) return parts[0]!;
      if (parts.length !== 3) return this.fail(`a vector has three components, not ${parts.length}`, token);
      return { kind: 'vector', ids: parts.map((part) => this.number(part, token)) as unknown as Vector };
    }
    if (token.kind === 'text') return this.fail('a number is expected here, not a text', token);
    if (token.kind === 'unit')
      return this.fail('a unit stands behind the name that it belongs to: parameter m [kg] = 2', token);
    if (token.text === '=') return this.fail('"=" has no place here; the value stands behind the word itself', token);
    return this.fail(`"${token.text}" has no place here; a number, a name or a bracket is expected`, token);
  }

  /** Expressions between brackets, behind the opening one. */
  private list(open: LineToken): Value[] {
    const outer = this.stops;
    this.stops = new Set();
    const parts: Value[] = [];
    do parts.push(this.binary(0));
    while (this.take(','));
    if (!this.take(')')) this.fail(this.next ? `")" or "," is expected here` : 'a ")" is missing', this.next ?? open);
    this.stops = outer;
    return parts;
  }

  /** Whether a bracket behind a name holds what it is called with, and not a factor. */
  private calls(name: string): boolean {
    const value = this.scope.look(name);
    return value ? value.kind === 'frame' : !constants.has(name);
  }

  private named(token: LineToken): Value {
    const { graph } = this.scope;
    const value = this.scope.look(token.text);
    if (value) {
      return value;
    }
    const input = this.scope.inputOn(token.text);
    if (input > 0)
      this.fail(
        `"${token.text}" is the input of line ${input}: it acts on what that line says, and stands in no formula`,
        token,
      );
    const constant = constants.get(token.text);
    const later = this.scope.definedOn(token.text);
    if (constant !== undefined && later >= this.line)
      this.fail(
        `"${token.text}" is declared on line ${later}, which has to stand above this one; the number is written out`,
        token,
      );
    if (constant !== undefined) return { kind: 'scalar', id: graph.number(constant) };
    const [owner, part, component] = token.text.split('.');
    if (component !== undefined) return this.ofAxis(this.componentOf(owner!, part!, token), component, token);
    if (part !== undefined) return this.componentOf(owner!, part, token);
    if (isFunctionName(token.text)) return this.fail(`"${token.text}" is a function; write ${token.text}(…)`, token);
    return this.unknown(token);
  }

  private componentOf(owner: string, part: string, token: LineToken): Value {
    const value = this.scope.look(owner);
    const k = ['x', 'y', 'z'].indexOf(part);
    if (value === undefined) return this.unknown({ ...token, text: owner });
    const rate = value.kind === 'scalar' && asRate(`${owner}.${part}`, new Set(this.scope.names()));
    if (rate) return this.fail(rate, token);
    if (k < 0 || value.kind === 'scalar')
      return this.fail(
        value.kind === 'scalar'
          ? `"${owner}" is a number and has no "${part}"`
          : `only x, y and z stand behind "${owner}."`,
        token,
      );
    if (value.kind === 'vector') return { kind: 'scalar', id: value.ids[k]! };
    const { R } = value.frame;
    return { kind: 'vector', ids: [R[k]!, R[3 + k]!, R[6 + k]!] };
  }

  /** `rod.x.z`: a component of a frame's axis in the world. */
  private ofAxis(value: Value, component: string, token: LineToken): Value {
    const k = ['x', 'y', 'z'].indexOf(component);
    if (value.kind !== 'vector' || k < 0)
      return this.fail('two points stand behind a frame alone: rod.x.z is the height of its first axis', token);
    return { kind: 'scalar', id: value.ids[k]! };
  }

  private unknown(token: LineToken): never {
    const name = token.text;
    const unknown = `unknown name "${shorten(name)}"`;
    const later = this.scope.definedOn(name);
    if (later === this.line)
      this.fail(`${unknown}: it is this line that defines it, from names of the lines above`, token);
    if (later > this.line)
      this.fail(`${unknown}: it is defined below, on line ${later}; that line has to stand above this one`, token);
    const known = new Set(this.scope.names());
    const rate = asRate(name, known);
    if (rate) this.fail(`${unknown}; ${rate}`, token);
    const near = closest(name, known);
    const product = asProduct(name, known);
    if (product && near?.toLowerCase() !== name.toLowerCase())
      this.fail(`${unknown}; a product has a space or * between its factors: ${product}`, token);
    return this.fail(
      near ? `${unknown}; did you mean ${near}?` : `${unknown}: a name is defined on a line above`,
      token,
    );
  }

  private call(token: LineToken): Value {
    const open = this.next!;
    const name = token.text;
    const target = this.scope.look(name);
    if (target === undefined && !isFunctionName(name)) {
      const known = [...unary, ...several.keys(), ...VECTOR_FUNCTIONS.keys()];
      const near = closest(name, [...known, ...this.scope.names()]);
      const hint = asRate(name, new Set(this.scope.names())) ?? (near ? `did you mean ${near}?` : CHOICES.get(name));
      this.fail(`unknown function "${shorten(name)}"${hint ? `; ${hint}` : ''}`, token);
    }
    this.at++;
    const args = this.list(open);
    if (target?.kind === 'frame') {
      if (args.length !== 3) this.fail(`${name}(…) makes a vector of three components, not ${args.length}`, token);
      const [x, y, z] = args.map((arg) => this.number(arg, token)) as unknown as Vector;
      return { kind: 'vector', ids: turned(this.scope.graph, target.frame.R, [x, y, z]) };
    }
    return VECTOR_FUNCTIONS.has(name) ? this.vectorCall(token, args) : this.scalarCall(token, args);
  }

  private scalarCall(token: LineToken, args: readonly Value[]): Value {
    const { graph } = this.scope;
    const name = token.text;
    const [fewest, most] = unary.has(name) ? [1, 1] : several.get(name)!;
    if (args.length < fewest || args.length > most) {
      const right = fewest === most ? `${fewest} argument${fewest === 1 ? '' : 's'}` : `${fewest} to ${most} arguments`;
      this.fail(`${name} takes ${right}, not ${args.length}`, token);
    }
    const [first, ...rest] = args.map((arg) => this.number(arg, token)) as [Id, ...Id[]];
    const id =
      args.length < 2
        ? several.has(name)
          ? first
          : ofOne(graph, name, first)
        : rest.reduce((all, x) => ofTwo(graph, name, all, x), first);
    return this.finite({ kind: 'scalar', id }, token);
  }

  private vectorCall(token: LineToken, args: readonly Value[]): Value {
    const { graph } = this.scope;
    const name = token.text;
    const wanted = name === 'dot' || name === 'cross' ? 2 : 1;
    if (args.length !== wanted) {
      const rate =
        name === 'dot' && args[0]?.kind === 'scalar' ? "; the rate of x is written x', of an expression rate(…)" : '';
      this.fail(`${VECTOR_FUNCTIONS.get(name)}; it takes ${wanted}, not ${args.length}${rate}`, token);
    }
    const [a, b] = args;
    if (name === 'omega') {
      if (a!.kind !== 'frame') return this.fail(VECTOR_FUNCTIONS.get(name)!, token);
      return { kind: 'vector', ids: turned(graph, a!.frame.R, a!.frame.spin) };
    }
    if (name === 'rate' && a!.kind === 'scalar') return { kind: 'scalar', id: this.rate([a!.id], token)[0]! };
    if (a!.kind !== 'vector' || (b && b.kind !== 'vector')) return this.fail(VECTOR_FUNCTIONS.get(name)!, token);
    const [u, w] = [a!.ids, b?.ids ?? a!.ids];
    switch (name) {
      case 'dot':
        return { kind: 'scalar', id: dot(graph, u, w) };
      case 'cross':
        return { kind: 'vector', ids: cross(graph, u, w) };
      case 'norm':
        return { kind: 'scalar', id: graph.sqrt(dot(graph, u, u)) };
      case 'unit': {
        const length = graph.sqrt(dot(graph, u, u));
        return { kind: 'vector', ids: u.map((x) => graph.div(x, length)) as unknown as Vector };
      }
      default:
        return { kind: 'vector', ids: this.rate(u, token) as unknown as Vector };
    }
  }

  private rate(ids: readonly Id[], token: LineToken): Id[] {
    try {
      return this.scope.rate(ids);
    } catch (error) {
      if (error instanceof RateError) return this.fail(error.message, token);
      throw error;
    }
  }
}

/** A rate of what has rates in it: an acceleration, which only the equations of motion give. */
export class RateError extends Error {}

export const dot = (graph: Graph, a: Vector, b: Vector): Id => graph.sum(a.map((x, k) => graph.mul(x, b[k]!)));

/**
 * The cross product a x b.
 *
 * @param graph that holds the nodes
 * @param a three nodes
 * @param b three nodes
 */
export function cross(graph: Graph, a: Vector, b: Vector): Vector {
  const part = (i: 0 | 1 | 2, j: 0 | 1 | 2): Id => graph.sub(graph.mul(a[i], b[j]), graph.mul(a[j], b[i]));
  return [part(1, 2), part(2, 0), part(0, 1)];
}

/** R x. */
export const turned = (graph: Graph, R: readonly Id[], x: Vector): Vector =>
  [0, 3, 6].map((row) => graph.sum(x.map((component, k) => graph.mul(R[row + k]!, component)))) as unknown as Vector;

function ofOne(graph: Graph, name: string, x: Id): Id {
  switch (name) {
    case 'tan':
      return graph.div(graph.sin(x), graph.cos(x));
    case 'ln':
      return graph.unary('log', x);
    case 'sign':
      return graph.sub(graph.compare('lt', graph.zero, x), graph.compare('lt', x, graph.zero));
    case 'round':
      return graph.unary('floor', graph.add(x, graph.number(0.5)));
    default:
      return graph.unary(name as OpName, x);
  }
}

function ofTwo(graph: Graph, name: string, x: Id, y: Id): Id {
  switch (name) {
    case 'atan2':
      return graph.atan2(x, y);
    case 'pow':
      return graph.pow(x, y);
    case 'mod':
      return graph.sub(x, graph.mul(y, graph.unary('floor', graph.div(x, y))));
    case 'hypot':
      return graph.sqrt(graph.add(graph.square(x), graph.square(y)));
    case 'min':
      return graph.select(graph.compare('lt', y, x), y, x);
    default:
      return graph.select(graph.compare('lt', x, y), y, x);
  }
}
