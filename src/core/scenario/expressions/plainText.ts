import { RAISED, SPELLINGS } from './spellings.ts';
import { ExpressionError } from './expressionError.ts';
import { several, unary } from './functions.ts';
import { refuseAmbiguous, type Token } from './reading.ts';

export const MOST_CHARACTERS = 1000;
/** Brackets, exponents, signs and conditions within each other. */
export const MOST_DEPTH = 60;

/** Names that stand for a number. */
export const constants: ReadonlyMap<string, number> = new Map([
  ['pi', Math.PI],
  ['tau', 2 * Math.PI],
  ['e', Math.E],
  ['deg', Math.PI / 180],
  ['rad', 1],
]);

const isFunction = (name: string): boolean => unary.has(name) || several.has(name);

/** What stands for a character in the plain text: names apart from what is beside them. */
const PLAIN = new Map([
  ...[...SPELLINGS].map(([letter, plain]): [string, string] => [letter, /\w/.test(plain) ? ` ${plain} ` : plain]),
  ['\t', ' '],
  ['\u00a0', ' '],
  ['\u2009', ' '],
  ['\u202f', ' '],
]);

const TOKEN = /\s+|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|[A-Za-z_]\w*|<=|>=|==|!=|[-+*/^<>?:(),]/y;

/** What a person may have meant by a character that has no place here. */
const ODD = new Map([
  ['=', 'an assignment or definition is not allowed; == compares'],
  ['%', '"%" is not understood; write mod(a, b), or divide by 100'],
  ['!', 'a factorial is not understood'],
  ['.', 'a "." stands only within a number'],
  ['[', 'lists and indices are not allowed'],
  ['{', 'objects are not allowed'],
  ['"', 'texts are not allowed'],
  ["'", 'texts are not allowed'],
  [';', 'one expression only'],
  ['\n', 'one line only'],
  ['\r', 'one line only'],
]);

/** The text in plain characters, and where each came from. */
export interface PlainText {
  text: string;
  /** Position in the original text of a position in the plain one. */
  origin(at: number): number;
}

/**
 * Spells a text plainly and looks at every character, bracket and name before a parser sees it: what gets past is
 * short, shallow and names only what is known.
 *
 * @param original as written
 * @param variables names that are known
 * @throws ExpressionError
 */
export function plainText(original: string, variables: readonly string[]): PlainText {
  if (original.length > MOST_CHARACTERS)
    throw new ExpressionError(`${original.length} characters are more than the ${MOST_CHARACTERS} allowed`);
  if (original.trim() === '') throw new ExpressionError('it is empty; a number or an expression is needed');
  let text = '';
  const from: number[] = [];
  for (let i = 0; i < original.length; i++) {
    const start = i;
    let piece = PLAIN.get(original[i]!) ?? original[i]!;
    if (original.startsWith('**', i)) {
      piece = '^';
      i++;
    } else if (RAISED.has(piece)) {
      while (RAISED.has(original[i + 1]!)) i++;
      piece = raisedPower(original, start, i + 1);
    }
    for (let k = 0; k < piece.length; k++) from.push(start);
    text += piece;
  }
  const plain = { text, origin: (at: number) => from[at] ?? original.length };
  scan(plain, original, variables);
  return plain;
}

/** `10²³` is 10^(23). What stands before must be what is raised, and nothing may raise that again. */
function raisedPower(original: string, start: number, end: number): string {
  const written = original.slice(start, end);
  const digits = [...written].map((c) => RAISED.get(c)!).join('');
  const before = original.slice(0, start).trimEnd();
  const name = /[A-Za-z_]\w*$/.exec(before)?.[0];
  if (name && isFunction(name))
    throw new ExpressionError(`write the power behind the brackets: ${name}(…)${written}`, start);
  if (!/^[+-]?\d+$/.test(digits)) throw new ExpressionError(`"${written}" is no exponent; write ^(…)`, start);
  if (!/[\w).πτ°º]$/.test(before)) throw new ExpressionError(`"${written}" has nothing before it to raise`, start);
  if (/^\s*(\^|\*\*)/.test(original.slice(end)))
    throw new ExpressionError(`a power of a power needs brackets: (x${written})^y or x^(${digits}^y)?`, start);
  return `^(${digits})`;
}

function scan({ text, origin }: PlainText, original: string, variables: readonly string[]): void {
  let open = 0;
  let nested = 0;
  let powers = 0;
  let run = 0;
  const tokens: Token[] = [];
  for (let at = 0; at < text.length; at = TOKEN.lastIndex) {
    TOKEN.lastIndex = at;
    const token = TOKEN.exec(text)?.[0];
    if (token === undefined) {
      const odd = String.fromCodePoint(original.codePointAt(origin(at))!);
      throw new ExpressionError(ODD.get(odd) ?? `"${odd}" has no place in an expression`, origin(at));
    }
    if (token === '(') open++;
    if (token === ')' && --open < 0) throw new ExpressionError('a ")" without its "("', origin(at));
    if (token === ',' && open === 0)
      throw new ExpressionError('a "," has no place here; decimals are written with a point', origin(at));
    if (token === '?') nested++;
    if (!/^\s/.test(token)) tokens.push({ text: token, at, end: TOKEN.lastIndex });
    // Exponents and runs of signs are read by recursion too.
    if (token === '^') powers++;
    run = token === '-' || token === '+' ? run + 1 : /^\s/.test(token) ? run : 0;
    if (Math.max(open + nested, powers, run) > MOST_DEPTH)
      throw new ExpressionError(`it is nested deeper than ${MOST_DEPTH}`, origin(at));
    if (/^[A-Za-z_]/.test(token)) checkName(token, /^\s*\(/.test(text.slice(TOKEN.lastIndex)), origin(at), variables);
  }
  if (open === 0) {
    const written = (from: number, to: number): string => {
      let end = to;
      while (end < text.length && origin(end) === origin(to - 1)) end++;
      return original.slice(origin(from), origin(end)).trim();
    };
    refuseAmbiguous(tokens, isFunction, written, origin);
  } else throw new ExpressionError(open === 1 ? 'a ")" is missing' : `${open} ")" are missing`, original.length);
}

function checkName(name: string, called: boolean, position: number, variables: readonly string[]): void {
  const isNumber = variables.includes(name) || constants.has(name);
  if (called ? isFunction(name) : isNumber) return;
  const shown = name.length > 40 ? `${name.slice(0, 39)}…` : name;
  if (called && isNumber) throw new ExpressionError(`"${name}" is not a function; write ${name} * (…)`, position);
  if (called)
    throw new ExpressionError(
      `unknown function "${shown}"; known: ${[...unary.keys(), ...several.keys()].join(', ')}`,
      position,
    );
  if (isFunction(name)) throw new ExpressionError(`"${name}" is a function; write ${name}(…)`, position);
  if (name === 't') throw new ExpressionError('this is a constant, so "t" has no place in it', position);
  throw new ExpressionError(
    `unknown name "${shown}"; known: ${[...variables, ...constants.keys()].join(', ')}`,
    position,
  );
}
