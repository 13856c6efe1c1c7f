/**
 * Expressions as sums of products, so that they can be read: like terms are added, sin² + cos² is 1, and what would be too long
 * when multiplied out stays a factor or becomes a part with a letter of its own.
 *
 * A polynomial maps the key of a monomial to its coefficient and powers; its variables are atoms: inputs of the graph,
 * functions, sums in brackets, parts. Every graph node becomes one, operands first, so depth costs no stack.
 */
import { OPS, type Graph, type Id } from './graph.ts';

export type AtomKind = 'part' | 'parameter' | 'coordinate' | 'function' | 'sum' | 'rate';

export interface Atom {
  key: string;
  kind: AtomKind;
  /** Of a symbol or part its mark, of a function its name. */
  name: string;
  of: readonly Polynomial[];
  /** Symbols and signs that it takes to print it. */
  size: number;
}

export interface Monomial {
  coefficient: number;
  /** In the order of the keys. */
  powers: readonly (readonly [Atom, number])[];
}

export type Polynomial = ReadonlyMap<string, Monomial>;

/** Terms up to which a product of sums is multiplied out, and a factor taken into a sum. */
const MOST_PRODUCT = 36;
const MOST_TAKEN_IN = 8;
/** Size beyond which an expression becomes a part. */
const MOST_SIZE = 100;
/** Size beyond which the operand of a function becomes one. */
const MOST_OPERAND = 30;

const keyOf = (powers: Monomial['powers']): string => powers.map(([{ key }, p]) => `${key}^${p}`).join('*');

/**
 * Symbols and signs that it takes to print a polynomial.
 *
 * @param p any
 */
export function sizeOf(p: Polynomial): number {
  let size = 0;
  for (const { powers } of p.values()) size += 1 + powers.reduce((sum, [atom]) => sum + atom.size, 0);
  return size;
}

export class Polynomials {
  /** Parts by their mark: what they stand for, in the order in which they were made. */
  readonly parts = new Map<string, Polynomial>();
  private readonly graph: Graph;
  private readonly made = new Map<Id, Polynomial>();
  private readonly atoms = new Map<string, Atom>();
  private readonly partOf = new Map<string, string>();

  /**
   * @param graph whose nodes are read
   * @param symbols what inputs of the graph are called, and of which kind they are
   * @param named nodes that keep the name which they were given
   */
  constructor(
    graph: Graph,
    symbols: ReadonlyMap<Id, { name: string; kind: AtomKind }>,
    private readonly named: ReadonlyMap<Id, string>,
  ) {
    this.graph = graph;
    for (const [id, { name, kind }] of symbols) this.made.set(id, this.single(this.atom(kind, name, [], 1)));
  }

  of(root: Id): Polynomial {
    if (!this.made.has(root))
      for (const i of this.graph.beyond([root], this.made)) {
        const made = this.bounded(this.build(i));
        const name = this.named.get(i);
        this.made.set(i, name === undefined || sizeOf(made) < 2 ? made : this.part(made, name));
      }
    return this.made.get(root)!;
  }

  private build(i: Id): Polynomial {
    const { graph } = this;
    const op = OPS[graph.op[i]!]!;
    const at = (id: Id): Polynomial => this.made.get(id)!;
    const [a, b] = [at(graph.a[i]!), at(graph.b[i]!)];
    switch (op) {
      case 'const':
        return this.constant(graph.value[i]!);
      case 'input':
        return this.single(this.atom('coordinate', '?', [], 1));
      case 'add':
        return this.add(a, b, 1);
      case 'sub':
        return this.add(a, b, -1);
      case 'neg':
        return this.scale(a, -1);
      case 'mul':
        return this.multiply(a, b);
      case 'div':
        return this.multiply(a, this.power(b, -1));
      case 'sqrt':
        return this.power(a, 0.5);
      case 'pow': {
        const exponent = graph.b[i]!;
        return graph.isNumber(exponent) ? this.power(a, graph.value[exponent]!) : this.call('pow', a, b);
      }
      case 'select':
        return this.call('select', a, b, at(graph.c[i]!));
      case 'lt':
      case 'le':
      case 'eq':
      case 'atan2':
        return this.call(op, a, b);
      default:
        return this.oddOrEven(op, a);
    }
  }

  private oddOrEven(name: string, a: Polynomial): Polynomial {
    const negative = a.size > 0 && [...a.values()].every(({ coefficient }) => coefficient < 0);
    if (negative && ['sin', 'asin', 'atan', 'sinh', 'tanh', 'cbrt'].includes(name))
      return this.scale(this.call(name, this.scale(a, -1)), -1);
    if (negative && ['cos', 'cosh', 'abs'].includes(name)) return this.call(name, this.scale(a, -1));
    return this.call(name, a);
  }

  private call(name: string, ...of: Polynomial[]): Polynomial {
    const operands = of.map((p) => (sizeOf(p) > MOST_OPERAND ? this.part(p) : p));
    return this.single(
      this.atom(
        'function',
        name,
        operands,
        operands.reduce((sum, p) => sum + sizeOf(p), 1),
      ),
    );
  }

  private atom(kind: AtomKind, name: string, of: readonly Polynomial[], size: number): Atom {
    const key = of.length === 0 ? name : `${name}(${of.map((p) => this.keyOfSum(p)).join()})`;
    let atom = this.atoms.get(key);
    if (!atom) this.atoms.set(key, (atom = { key, kind, name, of, size }));
    return atom;
  }

  private keyOfSum(p: Polynomial): string {
    return [...p]
      .map(([key, { coefficient }]) => `${coefficient}*${key}`)
      .sort()
      .join('+');
  }

  private single(atom: Atom, power = 1): Polynomial {
    const powers = [[atom, power]] as const;
    return new Map([[keyOf(powers), { coefficient: 1, powers }]]);
  }

  private constant(x: number): Polynomial {
    return x === 0 ? new Map() : new Map([['', { coefficient: x, powers: [] }]]);
  }

  scale(p: Polynomial, by: number): Polynomial {
    return new Map([...p].map(([key, m]) => [key, { ...m, coefficient: m.coefficient * by }]));
  }

  private add(a: Polynomial, b: Polynomial, sign: number): Polynomial {
    const sum = new Map(a);
    for (const [key, m] of b) this.put(sum, key, m.powers, sign * m.coefficient);
    return this.pythagoras(sum);
  }

  private put(sum: Map<string, Monomial>, key: string, powers: Monomial['powers'], by: number): void {
    const had = sum.get(key)?.coefficient ?? 0;
    const coefficient = had + by;
    // What rounding leaves of terms that cancel is nothing.
    if (Math.abs(coefficient) <= 1e-14 * Math.abs(by)) sum.delete(key);
    else sum.set(key, { coefficient, powers });
  }

  /** c sin²x + c cos²x is c. */
  private pythagoras(sum: Map<string, Monomial>): Polynomial {
    for (const [key, { coefficient, powers }] of [...sum]) {
      if (!sum.has(key)) continue;
      for (const [k, [atom, power]] of powers.entries()) {
        if (atom.name !== 'sin' || power < 2) continue;
        const rest = this.without(powers, k, power - 2);
        const cos = this.atom('function', 'cos', atom.of, atom.size);
        const other = this.product(rest, [[cos, 2]]);
        const twin = sum.get(keyOf(other));
        if (!twin || Math.abs(twin.coefficient - coefficient) > 1e-14 * Math.abs(coefficient)) continue;
        sum.delete(key);
        sum.delete(keyOf(other));
        this.put(sum, keyOf(rest), rest, coefficient);
        return this.pythagoras(sum);
      }
    }
    return sum;
  }

  private without(powers: Monomial['powers'], at: number, left: number): Monomial['powers'] {
    return powers.flatMap(([atom, power], k) =>
      k !== at ? [[atom, power] as const] : left > 0 ? [[atom, left] as const] : [],
    );
  }

  private product(a: Monomial['powers'], b: Monomial['powers']): Monomial['powers'] {
    const powers = new Map(a);
    for (const [atom, power] of b) powers.set(atom, (powers.get(atom) ?? 0) + power);
    return [...powers].filter(([, power]) => power !== 0).sort(([x], [y]) => (x.key < y.key ? -1 : 1));
  }

  private multiply(a: Polynomial, b: Polynomial): Polynomial {
    const [least, most] = a.size < b.size ? [a, b] : [b, a];
    if (least.size === 1 ? most.size > MOST_TAKEN_IN && sizeOf(least) > 1 : a.size * b.size > MOST_PRODUCT)
      return this.multiply(this.single1(a), this.single1(b));
    const product = new Map<string, Monomial>();
    for (const x of a.values())
      for (const y of b.values()) {
        const powers = this.product(x.powers, y.powers);
        this.put(product, keyOf(powers), powers, x.coefficient * y.coefficient);
      }
    return this.pythagoras(product);
  }

  /** The same as one factor. */
  private single1(p: Polynomial): Polynomial {
    return p.size < 2 ? p : this.bracket(p);
  }

  private bracket(p: Polynomial, power = 1): Polynomial {
    const size = sizeOf(p);
    if (size > MOST_OPERAND) {
      const [{ powers }] = [...this.part(p).values()] as [Monomial];
      return this.single(powers[0]![0], power);
    }
    return this.single(this.atom('sum', '', [p], size + 1), power);
  }

  private power(p: Polynomial, exponent: number): Polynomial {
    if (p.size === 0) return exponent > 0 ? p : this.call('pow', p, this.constant(exponent));
    if (p.size > 1) return this.bracket(p, exponent);
    const [{ coefficient, powers }] = [...p.values()] as [Monomial];
    if (powers.length === 0) return this.constant(coefficient ** exponent);
    // A root of a power or of a number of unknown sign is not taken apart.
    if (!Number.isInteger(exponent) && !(coefficient === 1 && powers.length === 1 && powers[0]![1] === 1))
      return this.bracket(p, exponent);
    const raised = powers.map(([atom, power]) => [atom, power * exponent] as const);
    return new Map([[keyOf(raised), { coefficient: coefficient ** exponent, powers: raised }]]);
  }

  private bounded(p: Polynomial): Polynomial {
    return sizeOf(p) > MOST_SIZE ? this.part(p) : p;
  }

  /** A part that stands for an expression: the same for the same. */
  private part(p: Polynomial, name?: string): Polynomial {
    const key = this.keyOfSum(p);
    let mark = this.partOf.get(key);
    if (mark === undefined) {
      mark = name ?? `part.${[...this.parts.keys()].filter((m) => m.startsWith('part.')).length + 1}`;
      this.partOf.set(key, mark);
      this.parts.set(mark, p);
    }
    return this.single(this.atom('part', mark, [], 1));
  }
}
