/** Polynomials as marked LaTeX (`model/typeset.ts`): rates stand last, and what multiplies the same rates is collected. */
import { type Atom, type AtomKind, type Monomial, type Polynomial } from './polynomial.ts';

const ORDER: readonly AtomKind[] = ['part', 'parameter', 'coordinate', 'function', 'sum', 'rate'];
const FUNCTIONS: Readonly<Record<string, string>> = {
  sin: '\\sin',
  cos: '\\cos',
  asin: '\\arcsin',
  acos: '\\arccos',
  atan: '\\arctan',
  sinh: '\\sinh',
  cosh: '\\cosh',
  tanh: '\\tanh',
  exp: '\\exp',
  log: '\\ln',
  log10: '\\log_{10}',
  log2: '\\log_{2}',
};
const AROUND: Readonly<Record<string, readonly [string, string]>> = {
  abs: ['\\left|', '\\right|'],
  floor: ['\\left\\lfloor', '\\right\\rfloor'],
  ceil: ['\\left\\lceil', '\\right\\rceil'],
  cbrt: ['\\sqrt[3]{', '}'],
};
const RELATIONS: Readonly<Record<string, string>> = { lt: '<', le: '\\le', eq: '=' };
/** Largest denominator that is written as one. */
const MOST_DENOMINATOR = 64;

type Powers = readonly (readonly [Atom, number])[];

/**
 * A number as a fraction where it is one that a person would write.
 *
 * @param x any number
 */
export function numberLatex(x: number): string {
  if (!Number.isFinite(x)) return Number.isNaN(x) ? '\\mathrm{NaN}' : x < 0 ? '-\\infty' : '\\infty';
  if (Number.isInteger(x) && Math.abs(x) < 1e9) return String(x);
  const tens = String(Number(x.toPrecision(12)));
  for (let d = 2; d <= MOST_DENOMINATOR; d++) {
    const n = Math.round(x * d);
    if (n === 0 || Math.abs(n) > 999 || Math.abs(n - x * d) > 1e-13 * Math.abs(x * d)) continue;
    // Tenths and hundredths as typed, unless halves or quarters are shorter.
    if (tens.length <= 6 && ![2, 4, 8].includes(d)) break;
    return `${x < 0 ? '- ' : ''}\\tfrac{${Math.abs(n)}}{${d}}`;
  }
  const [mantissa, exponent] = tens.split('e');
  return exponent === undefined ? tens : `${mantissa} \\cdot 10^{${Number(exponent)}}`;
}

/**
 * What is printed of a polynomial.
 *
 * @param p as `Polynomials` makes them
 * @returns marked LaTeX
 */
export function latexOf(p: Polynomial): string {
  const groups = new Map<string, { rates: Powers; terms: Monomial[] }>();
  for (const { coefficient, powers } of p.values()) {
    const rates = powers.filter(([atom]) => atom.kind === 'rate');
    const key = rates.map(([atom, power]) => `${atom.key}^${power}`).join();
    const term = { coefficient, powers: powers.filter(([atom]) => atom.kind !== 'rate') };
    const group = groups.get(key);
    if (group) group.terms.push(term);
    else groups.set(key, { rates, terms: [term] });
  }
  const signed: string[] = [];
  for (const { rates, terms } of groups.values())
    if (rates.length === 0 || terms.length === 1)
      signed.push(...terms.map(({ coefficient, powers }) => termOf(coefficient, [...powers, ...rates])));
    else signed.push(collected(terms, rates));
  return joined(signed);
}

/** What the terms share, times the rest in brackets, times the rates. */
function collected(terms: readonly Monomial[], rates: Powers): string {
  const shared = terms[0]!.powers.flatMap(([atom, power]) => {
    const all = terms.map(({ powers }) => powers.find(([other]) => other === atom)?.[1] ?? 0);
    const least = Math.min(...all);
    return power > 0 && least > 0 ? [[atom, least] as const] : [];
  });
  const rest = terms.map(({ coefficient, powers }) => ({
    coefficient,
    powers: powers.flatMap(([atom, power]) => {
      const left = power - (shared.find(([other]) => other === atom)?.[1] ?? 0);
      return left === 0 ? [] : [[atom, left] as const];
    }),
  }));
  const [one] = rest.map(({ coefficient }) => coefficient);
  const same = rest.every(({ coefficient }) => Math.abs(coefficient) === Math.abs(one!));
  const negative = rest.every(({ coefficient }) => coefficient < 0);
  const front = (same ? Math.abs(one!) : 1) * (negative ? -1 : 1);
  const inside = joined(rest.map(({ coefficient, powers }) => termOf(coefficient / front, powers)));
  return termOf(front, [...shared, ...rates], `\\left(${inside}\\right)`);
}

function joined(signed: readonly string[]): string {
  if (signed.length === 0) return '0';
  const first = signed.findIndex((term) => !term.startsWith('-'));
  const order = first > 0 ? [signed[first]!, ...signed.slice(0, first), ...signed.slice(first + 1)] : signed;
  return order.map((term, k) => (k === 0 ? term : term.startsWith('-') ? ` ${term}` : ` + ${term}`)).join('');
}

function termOf(coefficient: number, powers: Powers, bracket = ''): string {
  const rank = ([atom]: readonly [Atom, number]): number => ORDER.indexOf(atom.kind);
  const sorted = [...powers].sort((x, y) => rank(x) - rank(y));
  const before = sorted.filter(([atom, power]) => power > 0 && atom.kind !== 'rate').map(factorOf);
  const rates = sorted.filter(([atom, power]) => power > 0 && atom.kind === 'rate').map(factorOf);
  const below = sorted.filter(([, power]) => power < 0).map(([atom, power]) => factorOf([atom, -power]));
  const size = Math.abs(coefficient);
  const above = [...before, ...(bracket ? [bracket] : []), ...rates].join(' \\, ');
  const sign = coefficient < 0 ? '- ' : '';
  if (below.length === 0) {
    if (above === '') return `${sign}${numberLatex(size)}`;
    return `${sign}${size === 1 ? '' : `${numberLatex(size)} \\, `}${above}`;
  }
  const whole = Number.isInteger(size) && size !== 1 && above !== '' ? `${numberLatex(size)} \\, ${above}` : above;
  const outside = whole !== above || size === 1 || above === '' ? '' : `${numberLatex(size)} \\, `;
  return `${sign}${outside}\\dfrac{${whole || numberLatex(size)}}{${below.join(' \\, ')}}`;
}

function factorOf([atom, power]: readonly [Atom, number]): string {
  const raised = (base: string): string => (power === 1 ? base : `${base}^{${numberLatex(power)}}`);
  if (power === 0.5) return `\\sqrt{${atom.kind === 'sum' ? latexOf(atom.of[0]!) : factorOf([atom, 1])}}`;
  if (atom.kind === 'sum') return raised(`\\left(${latexOf(atom.of[0]!)}\\right)`);
  if (atom.kind !== 'function') return raised(`\\s{${atom.name}}`);
  const [a, b, c] = atom.of.map(latexOf);
  if (Object.hasOwn(FUNCTIONS, atom.name)) {
    const f = FUNCTIONS[atom.name]!;
    const plain = /^\\s\{[^}]+\}$/.test(a!);
    return `${power === 1 ? f : `${f}^{${numberLatex(power)}}`} ${plain ? `{${a}}` : `\\left(${a}\\right)`}`;
  }
  if (Object.hasOwn(AROUND, atom.name)) return raised(`${AROUND[atom.name]![0]} ${a} ${AROUND[atom.name]![1]}`);
  if (Object.hasOwn(RELATIONS, atom.name)) return raised(`\\left[${a} ${RELATIONS[atom.name]} ${b}\\right]`);
  if (atom.name === 'select')
    return raised(`\\begin{cases} ${b} & \\text{if } ${a} \\ne 0 \\\\ ${c} & \\text{otherwise} \\end{cases}`);
  if (atom.name === 'pow') return raised(`{\\left(${a}\\right)^{${b}}}`);
  return raised(`\\operatorname{${atom.name}}\\left(${atom.of.map(latexOf).join(',\\ ')}\\right)`);
}
