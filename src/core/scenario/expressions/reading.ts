import { ExpressionError } from './expressionError.ts';

/**
 * The one rule for products without a sign (`2 pi t`, `45 deg`): such a product is a product, and `*` and `/` are taken
 * from left to right. Where it stands behind a division or close behind an exponent, people mean two things by it:
 * `pi/2 deg` is (pi/2) deg to one and pi/(2 deg) to another. Such a text is refused with both spelled out. A plain
 * fraction is one number where a space or a unit follows it: `1/2 pi`, `1/2 deg`, `1/2°`. (docs/expressions.md)
 */

export interface Token {
  text: string;
  /** Where it begins and ends in the plain text. */
  at: number;
  end: number;
}

const UNITS = new Set(['deg', 'rad']);
const isNumber = (token: Token | undefined): boolean => token !== undefined && /^[\d.]/.test(token.text);
const isName = (token: Token | undefined): boolean => token !== undefined && /^[A-Za-z_]/.test(token.text);

/** Factors joined by signs of products and by nothing, at one level of brackets: indices of tokens, -1 for none. */
interface Chain {
  start: number;
  /** The "/" that what comes next is divided by. */
  slash: number;
}

/**
 * @param tokens of the whole text, brackets in pairs, blanks left out
 * @param isFunction whether a name is one of a function
 * @param written the text as given between two places of the plain one
 * @param origin place in the text as given, of a place in the plain one
 * @throws ExpressionError where a product without a sign could mean two things
 */
export function refuseAmbiguous(
  tokens: readonly Token[],
  isFunction: (name: string) => boolean,
  written: (from: number, to: number) => string,
  origin: (at: number) => number,
): void {
  const outer: Chain[] = [];
  let chain: Chain = { start: -1, slash: -1 };
  const between = (from: number, to: number): string => written(tokens[from]!.at, tokens[to]!.end);
  const refuse = (from: number, left: number, at: number): never => {
    const whole = between(from, at - 1);
    const before = between(from, left - 1);
    const behind = between(left, at - 1);
    const joined = between(at, endOfFactor(tokens, at));
    throw new ExpressionError(
      `this can be read in two ways, (${whole}) ${joined} or ${before}(${behind} ${joined}); write the one that is meant`,
      origin(tokens[from]!.at),
    );
  };
  for (let i = 0; i < tokens.length; i++) {
    const token = tokens[i]!;
    const last = tokens[i - 1];
    const called = token.text === '(' && isName(last) && isFunction(last!.text);
    const ended = isNumber(last) || last?.text === ')' || (isName(last) && !isFunction(last!.text));
    if ((isNumber(token) || isName(token) || token.text === '(') && !called) {
      if (chain.start < 0) chain.start = i;
      if (ended) {
        const unit = UNITS.has(token.text);
        const apart = token.at > last!.end || unit;
        const power = exponentStart(tokens, i - 1);
        if (power > 0 && !apart) refuse(factorStart(tokens, power - 2, isFunction), power, i);
        if (chain.slash >= 0) {
          const fraction = chain.slash === i - 2 && chain.start === i - 3 && isNumber(tokens[i - 3]) && isNumber(last);
          if (!fraction || !apart) refuse(chain.start, chain.slash + 1, i);
          chain.slash = -1;
        }
      }
    }
    if (token.text === '(') {
      outer.push(chain);
      chain = { start: -1, slash: -1 };
    } else if (token.text === ')') chain = outer.pop()!;
    else if (token.text === '^') {
      if (last && UNITS.has(last.text) && isNumber(tokens[i - 2])) {
        const number = tokens[i - 2]!.text;
        throw new ExpressionError(
          `this can be read in two ways, (${number} ${last.text})^… or ${number} (${last.text}^…); write the one that is meant`,
          origin(tokens[i - 2]!.at),
        );
      }
    } else if (token.text === '*') chain.slash = -1;
    else if (token.text === '/') chain.slash = i;
    else if (!isNumber(token) && !isName(token) && (ended || (token.text !== '-' && token.text !== '+')))
      chain = { start: -1, slash: -1 };
  }
}

/** Where the exponent begins that ends with token i, a number or name; -1 if that is none. */
function exponentStart(tokens: readonly Token[], i: number): number {
  let start = i;
  if (!isNumber(tokens[i]) && !isName(tokens[i])) return -1;
  while (tokens[start - 1]?.text === '-' || tokens[start - 1]?.text === '+') start--;
  return tokens[start - 1]?.text === '^' ? start : -1;
}

/** Where the factor begins that ends with token i. */
function factorStart(tokens: readonly Token[], i: number, isFunction: (name: string) => boolean): number {
  if (tokens[i]!.text !== ')') return i;
  let start = i;
  for (let open = 0; start >= 0; start--) {
    if (tokens[start]!.text === ')') open++;
    else if (tokens[start]!.text === '(' && --open === 0) break;
  }
  return start > 0 && isName(tokens[start - 1]) && isFunction(tokens[start - 1]!.text) ? start - 1 : start;
}

/** Where the factor ends that begins with token i: a number, a name, a call or brackets. */
function endOfFactor(tokens: readonly Token[], i: number): number {
  let end = i;
  if (isName(tokens[i]) && tokens[i + 1]?.text === '(') end++;
  if (tokens[end]!.text !== '(') return end;
  for (let open = 0; end < tokens.length; end++) {
    if (tokens[end]!.text === '(') open++;
    else if (tokens[end]!.text === ')' && --open === 0) break;
  }
  return end;
}
