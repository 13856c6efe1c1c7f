import { closuresOf } from './closures.ts';
import { node, number, type Node } from './tree.ts';

/**
 * Differences of large numbers that nearly cancel, written without the difference: each side as a sum of exponentials, whose
 * like terms are taken together.
 *
 *     exp(x) - exp(x - 1)           (1 - e^-1) exp(x)
 *     cosh(x) - sinh(x)             exp(-x)
 *     sqrt(exp(2 x) + 1) - exp(x)   1 / (sqrt(exp(2 x) + 1) + exp(x))        sqrt(P) - Q = (P - Q^2) / (sqrt(P) + Q)
 *     log(exp(x) + 1) - x           log(1 + exp(-x))                         log(P) - L = log(P exp(-L))
 *
 * As doubles their digits are lost from x = 18 on, and all is beyond doubles at 710: no bound of either side tells then what is
 * left. What does not have this form stays as it is written.
 */

/** One term of a sum of exponentials: factor exp(exponent). */
interface Term {
  readonly factor: number;
  /** Null: exp(0). */
  readonly exponent: Node | null;
  /** The exponent as a linear form: coefficients by what they multiply, the constant under the empty name. */
  readonly form: ReadonlyMap<string, number>;
}

/** Sums of more terms are not looked at. */
const MOST_TERMS = 12;
/** Coefficients that differ by rounding alone. */
const SAME = 1e-14;

const CONSTANT = '';

/**
 * The tree with its differences written so.
 *
 * @param root of a formula's tree
 */
export function withoutDifferences(root: Node): Node {
  if (root.constant || root.args.length === 0) return root;
  const args = root.args.map(withoutDifferences);
  const same = args.every((arg, i) => arg === root.args[i]);
  const whole = same ? root : node(root.op, ...args);
  if (whole.op !== '-' && whole.op !== '+') return whole;
  return cancelled(whole) ?? ofTwo(whole) ?? whole;
}

const valueOf = (at: Node): number => closuresOf(at).value(0);

/** One that is taken from another, in whatever order they stand. */
function ofTwo(whole: Node): Node | null {
  const signed = (u: Node, sign: number): [Node, number] => (u.op === 'negative' ? [u.args[0]!, -sign] : [u, sign]);
  const [a, b] = whole.args as [Node, Node];
  const [u, first] = signed(a, 1);
  const [v, second] = signed(b, whole.op === '-' ? -1 : 1);
  if (first === second) return null;
  const [more, less] = first > 0 ? [u, v] : [v, u];
  const forward = ofRoot(more, less) ?? ofLogarithm(more, less);
  const backward = forward ? null : (ofRoot(less, more) ?? ofLogarithm(less, more));
  return forward ?? (backward && node('negative', backward));
}

/** A sum of exponentials some of whose terms cancel. */
function cancelled(whole: Node): Node | null {
  const terms = termsOf(whole);
  if (!terms) return null;
  const left = together(terms);
  return left.cancels ? treeOf(left.terms) : null;
}

/** sqrt(P) - Q, of positive terms. */
function ofRoot(root: Node, q: Node): Node | null {
  if (root.op !== 'sqrt') return null;
  const [inside, beside] = [termsOf(root.args[0]!), termsOf(q)];
  if (!inside || !beside || q.constant || [...inside, ...beside].some(({ factor }) => factor < 0)) return null;
  const square = product(beside, beside);
  const left = square && together([...inside, ...square.map((term) => ({ ...term, factor: -term.factor }))]);
  return left?.cancels ? node('/', treeOf(left.terms), node('+', root, q)) : null;
}

/** c log(P) - L, of positive terms, of which one grows as exp(L / c). */
function ofLogarithm(scaled: Node, l: Node): Node | null {
  if (l.constant) return null;
  const [factor, log] = scaledBy(scaled);
  if (log.op !== 'log' && log.op !== 'ln') return null;
  const terms = termsOf(log.args[0]!);
  if (!terms || terms.length < 2 || terms.some((term) => term.factor < 0)) return null;
  const exponent = node('*', number(-1 / factor), l);
  const rest = product(terms, [{ factor: 1, exponent, form: linearForm(exponent) }]);
  if (!rest?.some(({ form }) => isConstant(form))) return null;
  return node('*', number(factor), node('log', treeOf(together(rest).terms)));
}

/** A constant factor and what it multiplies. */
function scaledBy(of: Node): [number, Node] {
  const [a, b] = of.args;
  if (of.op === '*' && a!.constant) return [valueOf(a!), b!];
  if (of.op === '*' && b!.constant) return [valueOf(b!), a!];
  if (of.op === '/' && b!.constant) return [1 / valueOf(b!), a!];
  return [1, of];
}

const isConstant = (form: Term['form']): boolean => [...form].every(([name, x]) => name === CONSTANT || x === 0);

/** As a sum of exponentials, or null. */
function termsOf(of: Node): Term[] | null {
  if (of.constant) {
    const factor = valueOf(of);
    return Number.isFinite(factor) ? [{ factor, exponent: null, form: new Map() }] : null;
  }
  const [a, b] = of.args;
  const times = (terms: Term[] | null, by: number): Term[] | null =>
    terms && terms.map((term) => ({ ...term, factor: term.factor * by }));
  switch (of.op) {
    case 'exp':
      return [{ factor: 1, exponent: a!, form: linearForm(a!) }];
    case 'cosh':
    case 'sinh': {
      const minus = node('negative', a!);
      return [
        { factor: 0.5, exponent: a!, form: linearForm(a!) },
        { factor: of.op === 'cosh' ? 0.5 : -0.5, exponent: minus, form: linearForm(minus) },
      ];
    }
    case 'negative':
      return times(termsOf(a!), -1);
    case '+':
    case '-': {
      const [first, second] = [termsOf(a!), times(termsOf(b!), of.op === '-' ? -1 : 1)];
      return first && second && first.length + second.length <= MOST_TERMS ? [...first, ...second] : null;
    }
    case '*':
      return product(termsOf(a!), termsOf(b!));
    case '/':
      return b!.constant ? times(termsOf(a!), 1 / valueOf(b!)) : null;
    case '^':
    case 'pow': {
      const power = b!.constant ? valueOf(b!) : NaN;
      const terms = termsOf(a!);
      return power === 2 ? product(terms, terms) : null;
    }
    default:
      return null;
  }
}

function product(a: readonly Term[] | null, b: readonly Term[] | null): Term[] | null {
  if (!a || !b || a.length * b.length > MOST_TERMS) return null;
  return a.flatMap((u) =>
    b.map((v) => {
      const exponent = u.exponent && v.exponent ? node('+', u.exponent, v.exponent) : (u.exponent ?? v.exponent);
      return { factor: u.factor * v.factor, exponent, form: plus(u.form, v.form, 1) };
    }),
  );
}

/** Like terms as one; whether any cancelled, in part or all. */
function together(terms: readonly Term[]): { terms: Term[]; cancels: boolean } {
  const kept: Term[] = [];
  let cancels = false;
  for (const term of terms) {
    const at = kept.findIndex(({ form }) => isLike(form, term.form));
    if (at < 0) {
      kept.push(term);
      continue;
    }
    const like = kept[at]!;
    const added = term.factor * Math.exp((term.form.get(CONSTANT) ?? 0) - (like.form.get(CONSTANT) ?? 0));
    if (!Number.isFinite(added)) return { terms: [...terms], cancels: false };
    cancels ||= like.factor * added < 0;
    const factor = like.factor + added;
    const isLeft = Math.abs(factor) > SAME * Math.abs(added);
    if (isLeft) kept[at] = { ...like, factor };
    else kept.splice(at, 1);
  }
  return { terms: kept, cancels };
}

function isLike(a: Term['form'], b: Term['form']): boolean {
  const size = Math.max(0, ...[...a, ...b].map(([name, x]) => (name === CONSTANT ? 0 : Math.abs(x))));
  return [...plus(a, b, -1)].every(([name, x]) => name === CONSTANT || Math.abs(x) <= SAME * size);
}

function treeOf(terms: readonly Term[]): Node {
  const trees = terms.map(({ factor, exponent, form }) => {
    const isOne = !exponent || isConstant(form);
    if (isOne) return number(factor * Math.exp(form.get(CONSTANT) ?? 0));
    const power = node('exp', exponent);
    return factor === 1 ? power : node('*', number(factor), power);
  });
  return trees.length === 0 ? number(0) : trees.reduce((sum, tree) => node('+', sum, tree));
}

/** a + sign b. */
function plus(a: Term['form'], b: Term['form'], sign: number): Map<string, number> {
  const sum = new Map(a);
  for (const [name, x] of b) {
    const [before, added] = [sum.get(name) ?? 0, sign * x];
    const total = before + added;
    // What is left by rounding alone is nothing.
    sum.set(name, Math.abs(total) <= SAME * Math.abs(before) ? 0 : total);
  }
  return sum;
}

/** What the node is linear in, and by which factors. */
function linearForm(of: Node): Map<string, number> {
  if (of.constant) return new Map([[CONSTANT, valueOf(of)]]);
  const [a, b] = of.args;
  const times = (form: Map<string, number>, by: number): Map<string, number> =>
    new Map([...form].map(([name, x]) => [name, x * by]));
  if (of.op === '+' || of.op === '-') return plus(linearForm(a!), linearForm(b!), of.op === '+' ? 1 : -1);
  if (of.op === 'negative') return times(linearForm(a!), -1);
  const [factor, rest] = scaledBy(of);
  return rest === of ? new Map([[nameOf(of), 1]]) : times(linearForm(rest), factor);
}

const nameOf = ({ op, x, args }: Node): string =>
  op === 'number' || op === 'name' ? `${op} ${x}` : args.length === 0 ? op : `${op}(${args.map(nameOf).join(',')})`;
