/**
 * A hash-consed graph of scalar expressions: equal expressions are one node, whose number is larger than those of its
 * operands, so that walking up the numbers is walking from the inputs to the results.
 *
 * Derivatives are nodes of the same graph, forward (A. Griewank, A. Walther, Evaluating Derivatives, 2nd ed., SIAM 2008,
 * section 3.1) and in reverse (section 3.2). Only what costs nothing is simplified: zeros, ones, numbers and signs.
 */
import { HOST_FUNCTIONS_OF_ONE } from '../engine/host.ts';
import { power } from '../elementary/powers.ts';

export const OPS = [
  'const',
  'input',
  'add',
  'sub',
  'mul',
  'div',
  'neg',
  'sqrt',
  'sin',
  'cos',
  'asin',
  'acos',
  'atan',
  'sinh',
  'cosh',
  'tanh',
  'exp',
  'log',
  'log10',
  'log2',
  'cbrt',
  'abs',
  'floor',
  'ceil',
  'atan2',
  'pow',
  'lt',
  'le',
  'eq',
  'select',
] as const;
export type OpName = (typeof OPS)[number];
export const code = Object.fromEntries(OPS.map((name, k) => [name, k])) as Record<OpName, number>;

/** Of one operand, with the value of numbers. */
const onNumbers: Partial<Record<OpName, (x: number) => number>> = {
  ...HOST_FUNCTIONS_OF_ONE,
  sqrt: Math.sqrt,
  sin: Math.sin,
  cos: Math.cos,
  abs: Math.abs,
  floor: Math.floor,
  ceil: Math.ceil,
};

/** What may leave the range of doubles soon, and what comes to exactly 0 by it. */
const SWELLING: ReadonlySet<OpName> = new Set(['exp', 'cosh', 'sinh']);
const FADING: ReadonlySet<OpName> = new Set(['div', 'exp', 'pow', 'tanh']);

/** Nodes that a graph may have: a board has 40,000 with all its Jacobians, and each takes some 100 bytes. */
export const MOST_NODES = 1_500_000;
/** While it is read, which the page does between two keys: the board has 1,500. */
export const MOST_READ = 150_000;

/** The graph has grown beyond its limit; `work` says what was being made. */
export class GrowthError extends Error {
  override name = 'GrowthError';
}

export type Id = number;

export class Graph {
  readonly op: number[] = [];
  readonly a: number[] = [];
  readonly b: number[] = [];
  /** Third operand of `select`. */
  readonly c: number[] = [];
  /** Of numbers their value, of inputs their position. */
  readonly value: number[] = [];
  /** What is being made, for the message of growth. */
  work = 'the description';

  private readonly known = new Map<number | string, Id>();
  private readonly numbers = new Map<number, Id>();
  /** By a set of functions: whether a node contains one. */
  private readonly contained = new Map<ReadonlySet<OpName>, boolean[]>();
  /** Nodes that it may have. */
  most: number;
  readonly zero: Id;
  readonly one: Id;

  constructor(most: number) {
    this.most = most;
    this.zero = this.number(0);
    this.one = this.number(1);
  }

  get size(): number {
    return this.op.length;
  }

  number(x: number): Id {
    const value = x === 0 ? 0 : x;
    const known = this.numbers.get(value);
    if (known !== undefined) return known;
    const made = this.push(code.const, -1, -1, -1, value);
    this.numbers.set(value, made);
    return made;
  }

  /** A new variable. */
  input(): Id {
    return this.push(code.input, -1, -1, -1, this.op.length);
  }

  isNumber(i: Id): boolean {
    return this.op[i] === code.const;
  }

  is(i: Id, x: number): boolean {
    return this.op[i] === code.const && this.value[i] === x;
  }

  add(a: Id, b: Id): Id {
    const { op, value } = this;
    if (a === this.zero) return b;
    if (b === this.zero) return a;
    if (op[a] === code.const && op[b] === code.const) return this.number(value[a]! + value[b]!);
    if (op[b] === code.neg) return this.sub(a, this.a[b]!);
    if (op[a] === code.neg) return this.sub(b, this.a[a]!);
    return a < b ? this.node(code.add, a, b) : this.node(code.add, b, a);
  }

  sub(a: Id, b: Id): Id {
    const { op, value } = this;
    if (a === b) return this.zero;
    if (b === this.zero) return a;
    if (a === this.zero) return this.neg(b);
    if (op[a] === code.const && op[b] === code.const) return this.number(value[a]! - value[b]!);
    if (op[b] === code.neg) return this.add(a, this.a[b]!);
    if (op[a] === code.neg) return this.neg(this.add(this.a[a]!, b));
    return this.node(code.sub, a, b);
  }

  mul(a: Id, b: Id): Id {
    const { op, value } = this;
    if (a === this.zero || b === this.zero) return this.zero;
    if (a === this.one) return b;
    if (b === this.one) return a;
    if (op[a] === code.const && op[b] === code.const) return this.number(value[a]! * value[b]!);
    if (op[a] === code.neg) return this.neg(this.mul(this.a[a]!, b));
    if (op[b] === code.neg) return this.neg(this.mul(a, this.a[b]!));
    if (this.is(a, -1)) return this.neg(b);
    if (this.is(b, -1)) return this.neg(a);
    const [x, y] = a < b ? [a, b] : [b, a];
    return this.node(code.mul, x, y);
  }

  div(a: Id, b: Id): Id {
    const { op, value } = this;
    if (a === this.zero) return a;
    if (b === this.one) return a;
    if (op[b] === code.const) {
      if (op[a] === code.const) return this.number(value[a]! / value[b]!);
      if (value[b] === -1) return this.neg(a);
    }
    if (op[a] === code.neg) return this.neg(this.div(this.a[a]!, b));
    if (op[b] === code.neg) return this.neg(this.div(a, this.a[b]!));
    return this.node(code.div, a, b);
  }

  neg(a: Id): Id {
    const { op } = this;
    if (op[a] === code.const) return this.number(-this.value[a]!);
    if (op[a] === code.neg) return this.a[a]!;
    if (op[a] === code.sub) return this.sub(this.b[a]!, this.a[a]!);
    return this.node(code.neg, a, -1);
  }

  square(a: Id): Id {
    return this.mul(a, a);
  }

  sum(all: readonly Id[]): Id {
    return all.reduce((total, x) => this.add(total, x), this.zero);
  }

  /** A function of one operand. */
  unary(name: OpName, a: Id): Id {
    const f = onNumbers[name];
    if (f && this.isNumber(a)) return this.number(f(this.value[a]!));
    if (this.op[a] === code.neg) {
      if (name === 'sin') return this.neg(this.unary('sin', this.a[a]!));
      if (name === 'cos') return this.unary('cos', this.a[a]!);
    }
    return this.node(code[name], a, -1);
  }

  sin(a: Id): Id {
    return this.unary('sin', a);
  }

  cos(a: Id): Id {
    return this.unary('cos', a);
  }

  sqrt(a: Id): Id {
    return this.unary('sqrt', a);
  }

  atan2(a: Id, b: Id): Id {
    return this.isNumber(a) && this.isNumber(b)
      ? this.number(Math.atan2(this.value[a]!, this.value[b]!))
      : this.node(code.atan2, a, b);
  }

  /** a^b; small whole exponents become products. */
  pow(a: Id, b: Id): Id {
    if (this.isNumber(b)) {
      const n = this.value[b]!;
      if (this.isNumber(a)) return this.number(power(this.value[a]!, n));
      if (Number.isInteger(n) && Math.abs(n) <= 64) {
        const whole = this.wholePower(a, Math.abs(n));
        return n < 0 ? this.div(this.one, whole) : whole;
      }
      if (n === 0.5) return this.sqrt(a);
    }
    return this.node(code.pow, a, b);
  }

  private wholePower(a: Id, n: number): Id {
    if (n === 0) return this.one;
    if (n % 2 === 1) return n === 1 ? a : this.mul(this.wholePower(a, n - 1), a);
    return this.square(this.wholePower(a, n / 2));
  }

  /** 1 or 0. */
  compare(name: 'lt' | 'le' | 'eq', a: Id, b: Id): Id {
    if (this.isNumber(a) && this.isNumber(b)) {
      const [x, y] = [this.value[a]!, this.value[b]!];
      return this.number(Number(name === 'lt' ? x < y : name === 'le' ? x <= y : x === y));
    }
    return this.node(code[name], a, b);
  }

  /** a where the condition is not 0, else b. */
  select(condition: Id, a: Id, b: Id): Id {
    if (a === b) return a;
    if (this.isNumber(condition)) return this.value[condition] !== 0 ? a : b;
    return this.node(code.select, condition, a, b);
  }

  private node(op: number, a: Id, b: Id, c = -1): Id {
    // 5 bits of the operation and 21 of each operand are a whole number that doubles hold.
    const key = c < 0 ? (op * 2097152 + a) * 2097152 + (b < 0 ? 2097151 : b) : `${a} ${b} ${c}`;
    const known = this.known.get(key);
    if (known !== undefined) return known;
    const made = this.push(op, a, b, c, 0);
    this.known.set(key, made);
    return made;
  }

  private push(op: number, a: Id, b: Id, c: Id, value: number): Id {
    if (this.op.length >= this.most)
      throw new GrowthError(
        `${this.work} has grown beyond ${this.most} operations; write it with fewer coordinates, or with coordinates in which it is shorter`,
      );
    this.op.push(op);
    this.a.push(a);
    this.b.push(b);
    this.c.push(c);
    this.value.push(value);
    return this.op.length - 1;
  }

  /** What the roots are made of, themselves included, operands before what they are operands of. */
  reach(roots: readonly Id[]): Int32Array {
    const top = roots.reduce((most, i) => Math.max(most, i), -1);
    const seen = new Uint8Array(top + 1);
    for (const i of roots) seen[i] = 1;
    let count = 0;
    for (let i = top; i >= 0; i--) {
      if (seen[i] === 0) continue;
      count++;
      const [a, b, c] = [this.a[i]!, this.b[i]!, this.c[i]!];
      if (a >= 0) seen[a] = 1;
      if (b >= 0) seen[b] = 1;
      if (c >= 0) seen[c] = 1;
    }
    const list = new Int32Array(count);
    for (let i = 0, k = 0; i <= top; i++) if (seen[i] === 1) list[k++] = i;
    return list;
  }

  /** The same without what is known already, and what only that is made of. */
  beyond(roots: readonly Id[], known: { has(i: Id): boolean }): Id[] {
    const found = new Set<Id>();
    const waiting = [...roots];
    for (let i = waiting.pop(); i !== undefined; i = waiting.pop()) {
      if (found.has(i) || known.has(i)) continue;
      found.add(i);
      for (const x of [this.a[i]!, this.b[i]!, this.c[i]!]) if (x >= 0) waiting.push(x);
    }
    return [...found].sort((x, y) => x - y);
  }

  /** Whether any of some variables occurs in an expression. */
  depends(root: Id, variables: ReadonlySet<Id>): boolean {
    return this.reach([root]).some((i) => variables.has(i));
  }

  /** Derivatives of the roots in the direction that gives each variable of `seed` its rate; other variables stand still. */
  forward(roots: readonly Id[], seed: ReadonlyMap<Id, Id>, order = this.reach(roots)): Id[] {
    const rate = new Map<Id, Id>(seed);
    this.spread(order, rate);
    return roots.map((i) => rate.get(i) ?? this.zero);
  }

  /** Adds the rates of nodes, given in order, to those that are known; what stands still has none. */
  spread(order: Iterable<Id>, rate: Map<Id, Id>): void {
    for (const i of order) {
      if (rate.has(i)) continue;
      const a = this.a[i]!;
      const da = a < 0 ? undefined : rate.get(a);
      const b = this.b[i]!;
      const db = b < 0 ? undefined : rate.get(b);
      const c = this.c[i]!;
      const dc = c < 0 ? undefined : rate.get(c);
      if (da === undefined && db === undefined && dc === undefined) continue;
      const made = this.rateOf(i, da ?? this.zero, db ?? this.zero, dc ?? this.zero);
      if (made !== this.zero) rate.set(i, made);
    }
  }

  private rateOf(i: Id, da: Id, db: Id, dc: Id): Id {
    const [a, b] = [this.a[i]!, this.b[i]!];
    switch (OPS[this.op[i]!]!) {
      case 'add':
        return this.add(da, db);
      case 'sub':
        return this.sub(da, db);
      case 'mul':
        return this.add(this.limited(da, b), this.limited(a, db));
      case 'div':
        return this.div(this.sub(da, this.limited(i, db)), b);
      case 'neg':
        return this.neg(da);
      case 'select':
        return this.select(a, db, dc);
      default: {
        const [pa, pb] = this.slopes(i);
        return this.add(this.limited(pa, da), pb === undefined ? this.zero : this.limited(pb, db));
      }
    }
  }

  /**
   * A product in a chain of derivatives. Where an exponential has left the range of doubles and what is made of it is at its
   * limit all the same (1/cosh(x), atan(exp(x))), a slope of 0 meets one without bound: the limit is 0.
   */
  private limited(x: Id, y: Id): Id {
    const made = this.mul(x, y);
    for (const [slope, rate] of [
      [x, y],
      [y, x],
    ] as const)
      if (made !== this.zero && this.contains(rate, SWELLING) && this.contains(slope, FADING))
        return this.select(this.compare('eq', slope, this.zero), this.zero, made);
    return made;
  }

  /** Whether one of some functions is in it. */
  private contains(i: Id, names: ReadonlySet<OpName>): boolean {
    const found = this.contained.get(names) ?? [];
    this.contained.set(names, found);
    for (let k = found.length; k <= i; k++)
      found[k] =
        names.has(OPS[this.op[k]!]!) ||
        [this.a[k]!, this.b[k]!, this.c[k]!].some((part) => part >= 0 && part < k && found[part] === true);
    return found[i]!;
  }

  /** Derivatives of a function's node by its operands. */
  private slopes(i: Id): [Id, Id?] {
    const [a, b, one] = [this.a[i]!, this.b[i]!, this.one];
    const half = this.number(0.5);
    switch (OPS[this.op[i]!]!) {
      case 'sqrt':
        return [this.div(half, i)];
      case 'sin':
        return [this.cos(a)];
      case 'cos':
        return [this.neg(this.sin(a))];
      case 'asin':
        return [this.div(one, this.sqrt(this.sub(one, this.square(a))))];
      case 'acos':
        return [this.neg(this.div(one, this.sqrt(this.sub(one, this.square(a)))))];
      case 'atan':
        return [this.div(one, this.add(one, this.square(a)))];
      case 'sinh':
        return [this.unary('cosh', a)];
      case 'cosh':
        return [this.unary('sinh', a)];
      case 'tanh':
        return [this.sub(one, this.square(i))];
      case 'exp':
        return [i];
      case 'log':
        return [this.div(one, a)];
      case 'log10':
        return [this.div(this.number(1 / Math.LN10), a)];
      case 'log2':
        return [this.div(this.number(1 / Math.LN2), a)];
      case 'cbrt':
        return [this.div(one, this.mul(this.number(3), this.square(i)))];
      case 'abs':
        return [this.select(this.compare('lt', a, this.zero), this.number(-1), one)];
      case 'atan2': {
        const size = this.add(this.square(a), this.square(b));
        return [this.div(b, size), this.neg(this.div(a, size))];
      }
      case 'pow': {
        const byBase = this.mul(b, this.pow(a, this.sub(b, one)));
        return [byBase, this.isNumber(b) ? this.zero : this.mul(i, this.unary('log', a))];
      }
      default:
        return [this.zero, this.zero];
    }
  }

  /** Derivatives of one root by many variables. */
  gradient(root: Id, variables: readonly Id[]): Id[] {
    const order = this.reach([root]);
    const bar = new Map<Id, Id>([[root, this.one]]);
    const give = (i: Id, x: Id): void => {
      if (x === this.zero || this.op[i] === code.const) return;
      const had = bar.get(i);
      bar.set(i, had === undefined ? x : this.add(had, x));
    };
    for (let k = order.length - 1; k >= 0; k--) {
      const i = order[k]!;
      const g = bar.get(i);
      if (g === undefined) continue;
      const [a, b] = [this.a[i]!, this.b[i]!];
      switch (OPS[this.op[i]!]!) {
        case 'const':
        case 'input':
          break;
        case 'add':
          give(a, g);
          give(b, g);
          break;
        case 'sub':
          give(a, g);
          give(b, this.neg(g));
          break;
        case 'mul':
          give(a, this.limited(g, b));
          give(b, this.limited(g, a));
          break;
        case 'div':
          give(a, this.div(g, b));
          give(b, this.neg(this.mul(this.div(g, b), i)));
          break;
        case 'neg':
          give(a, this.neg(g));
          break;
        case 'select':
          give(b, this.select(a, g, this.zero));
          give(this.c[i]!, this.select(a, this.zero, g));
          break;
        default: {
          const [pa, pb] = this.slopes(i);
          give(a, this.limited(g, pa));
          if (pb !== undefined) give(b, this.limited(g, pb));
        }
      }
    }
    return variables.map((v) => bar.get(v) ?? this.zero);
  }

  /** The roots with some nodes replaced by others. */
  replace(roots: readonly Id[], by: ReadonlyMap<Id, Id>): Id[] {
    const made = new Map<Id, Id>(by);
    for (const i of this.reach(roots)) {
      if (made.has(i)) continue;
      const [a, b, c] = [this.a[i]!, this.b[i]!, this.c[i]!];
      const [x, y, z] = [made.get(a) ?? a, made.get(b) ?? b, made.get(c) ?? c];
      if (x !== a || y !== b || z !== c) made.set(i, this.again(i, x, y, z));
    }
    return roots.map((i) => made.get(i) ?? i);
  }

  private again(i: Id, a: Id, b: Id, c: Id): Id {
    const name = OPS[this.op[i]!]!;
    switch (name) {
      case 'add':
      case 'sub':
      case 'mul':
      case 'div':
      case 'pow':
      case 'atan2':
        return this[name](a, b);
      case 'neg':
        return this.neg(a);
      case 'lt':
      case 'le':
      case 'eq':
        return this.compare(name, a, b);
      case 'select':
        return this.select(a, b, c);
      default:
        return this.unary(name, a);
    }
  }
}
