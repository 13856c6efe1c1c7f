/** What a person may have meant by what has no place: the mistakes that are made most, and what would be right. */
import { GREEK } from './symbols.ts';

/** Characters that other languages and keyboards bring. */
const ODD: Readonly<Record<string, string>> = {
  '%': '"%" is not understood; a comment begins with #, a remainder is mod(a, b)',
  ';': 'one statement a line: begin a new line in place of ";"',
  '.': 'a "." stands within a number, or between a name and x, y or z',
  '{': 'a "{" has no place here; formulas have round brackets',
  '}': 'a "}" has no place here; formulas have round brackets',
  ']': 'a "]" without its "["; a unit is written [m/s], and formulas have round brackets',
  '|': 'a "|" has no place here; a size is written abs(x), the length of a vector norm(a)',
  '`': "a rate is written with an apostrophe: x'",
  '´': "a rate is written with an apostrophe: x'",
  '&': 'a "&" has no place here; two conditions at once are their product',
  '½': 'write 1/2',
  '¼': 'write 1/4',
  '√': 'write sqrt(…)',
  "'": "one apostrophe is a rate, x'; accelerations follow from the equations of motion and are not written",
  '’': "one apostrophe is a rate, x'; accelerations follow from the equations of motion and are not written",
};

const letters = new Map(Object.entries(GREEK).map(([name, letter]) => [letter, name]));
letters.set('ϕ', 'phi').set('ϑ', 'theta').set('ϵ', 'epsilon').set('µ', 'mu').set('Δ', 'Delta');

/**
 * Why a character stands in no statement.
 *
 * @param letter one character
 */
export function oddCharacter(letter: string): string {
  if (Object.hasOwn(ODD, letter)) return ODD[letter]!;
  if (/\p{L}/u.test(letter))
    return `"${letter}" is spelled out: ${letters.get(letter) ?? 'letters are a to z, Greek ones alpha, theta, phi'}`;
  return `"${letter}" has no place here`;
}

/** First words that other programs have. */
const STATEMENTS: Readonly<Record<string, string>> = {
  lagrangian: 'kinetic and potential, a line each',
  lagrange: 'kinetic and potential, a line each',
  energy: 'kinetic and potential, a line each',
  constraint: 'velocity … = 0, or height … = 0; constraints NAME names a set of them',
  holonomic: 'height … = 0',
  nonholonomic: 'velocity … = 0',
  friction: 'damper, loss or force',
  gravity: 'parameter gravity [m/s²] = 9.81',
  mass: 'body NAME mass m at P',
  inertia: 'body NAME mass m inertia (Ixx, Iyy, Izz) at P',
  var: 'coordinate or parameter',
  variable: 'coordinate or parameter',
  variables: 'coordinate or parameter',
  state: 'coordinate',
  constant: 'parameter',
  const: 'parameter',
  coords: 'coordinate',
  initial: 'coordinate x = 0.1, or the start in the panel',
  name: 'system "…"',
  title: 'system "…"',
  joint: 'frame, turned by a coordinate',
  motor: 'input',
};

/**
 * Why a line begins with no statement.
 *
 * @param word its first
 * @param known the statements
 */
export function noStatement(word: string, known: readonly string[]): string {
  const lower = word.toLowerCase();
  const begun = word.length > 1 ? known.find((name) => name.startsWith(lower)) : undefined;
  const near = Object.hasOwn(STATEMENTS, lower) ? STATEMENTS[lower]! : (begun ?? closest(word, known));
  const begins = `"${word.slice(0, 40)}" begins no statement`;
  return near ? `${begins}; did you mean ${near}?` : `${begins}; there are ${known.join(', ')}, and NAME = …`;
}

/** Functions by which other languages write a rate. */
const RATES = new Set(['d', 'dt', 'der', 'diff', 'ddt', 'derivative', 'deriv', 'dot']);

/**
 * What is said of a rate that is written as elsewhere, `xdot`, `dx`, `d(x)/dt`, `x.dot`; null for anything else.
 *
 * @param name that is not known
 * @param known all names that are
 */
export function asRate(name: string, known: ReadonlySet<string>): string | null {
  const of = /^(.+?)(?:_?d?dot|[._]d+t?|\.dot)$/.exec(name)?.[1] ?? /^d(.+)$/.exec(name)?.[1] ?? '';
  if (/_?ddot$|''$/.test(name) && known.has(of))
    return `an acceleration follows from the equations of motion and is not written; a rate is ${of}'`;
  if (of && known.has(`${of}'`)) return `the rate of ${of} is written ${of}'`;
  return RATES.has(name.toLowerCase()) ? "the rate of x is written x', of an expression rate(…)" : null;
}

/**
 * Names one after the other that a person has written as one, `ml` for m l; null where it is nothing of that kind.
 *
 * @param name that is not known
 * @param known all names that are
 */
export function asProduct(name: string, known: ReadonlySet<string>): string | null {
  const parts: string[] = [];
  for (let at = 0; at < name.length;) {
    let end = name.length;
    while (end > at && !known.has(name.slice(at, end))) end--;
    if (end === at) return null;
    parts.push(name.slice(at, end));
    at = end;
  }
  return parts.length > 1 && parts.length < 5 ? parts.join(' ') : null;
}

/**
 * The known name that differs least, where that is little.
 *
 * @param name as it was typed
 * @param known all that there are
 */
export function closest(name: string, known: Iterable<string>): string | null {
  let best: string | null = null;
  let least = Math.max(1, Math.floor(name.length / 3)) + 1;
  for (const other of known) {
    // Of one or two letters any other one is as near: those alike count, and what lacks its apostrophe or digit.
    const alike =
      other.toLowerCase() === name.toLowerCase() ||
      (other.startsWith(name) && /^['\d]$/.test(other.slice(name.length)));
    if (name.length < 3 && !alike) continue;
    const far = distance(name.toLowerCase(), other.toLowerCase(), least);
    if (far < least) [best, least] = [other, far];
  }
  return best;
}

/** Letters to change, add or leave out, as far as `most`. */
function distance(a: string, b: string, most: number): number {
  if (Math.abs(a.length - b.length) >= most || a.length > 60) return most;
  let row = Array.from({ length: b.length + 1 }, (_, k) => k);
  for (let i = 1; i <= a.length; i++) {
    const next = [i];
    for (let k = 1; k <= b.length; k++)
      next[k] = Math.min(row[k]! + 1, next[k - 1]! + 1, row[k - 1]! + Number(a[i - 1] !== b[k - 1]));
    row = next;
  }
  return row[b.length]!;
}
