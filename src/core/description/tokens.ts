import type { Token } from '../scenario/expressions/reading.ts';
import { oddCharacter } from './hints.ts';
import { RAISED, SPELLINGS } from '../scenario/expressions/spellings.ts';

/** What is wrong with a description: where, and what would be right. */
export class DescriptionError extends Error {
  override name = 'DescriptionError';
  /** From 1; 0 where it concerns the whole. */
  readonly line: number;
  /** From 1. */
  readonly column: number;
  /** Characters that it concerns. */
  readonly length: number;
  /** The message without its place. */
  readonly reason: string;

  constructor(reason: string, line: number, column = 1, length = 1) {
    super(line > 0 ? `line ${line}, column ${column}: ${reason}` : reason);
    this.reason = reason;
    this.line = line;
    this.column = column;
    this.length = length;
  }
}

export type TokenKind = 'name' | 'number' | 'text' | 'unit' | 'sign';

/** Positions count from 0 in the line. */
export interface LineToken extends Token {
  kind: TokenKind;
}

const WORD = /[A-Za-z_]\w*(?:\.[A-Za-z_]\w*){0,2}['’′]?/y;
const NUMBER = /(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?/y;
const SIGN = /\*\*|<=|>=|==|!=|[-+*/^<>?:(),=]/y;

/**
 * The tokens of one line; a "#" outside a text begins a comment.
 *
 * @param text of the line
 * @param line its number, from 1, for errors
 * @throws DescriptionError
 */
export function tokensOf(text: string, line: number): LineToken[] {
  const tokens: LineToken[] = [];
  const refuse = (reason: string, at: number, length = 1): never => {
    throw new DescriptionError(reason, line, at + 1, length);
  };
  const found = (pattern: RegExp, at: number): string | null => {
    pattern.lastIndex = at;
    return pattern.exec(text)?.[0] ?? null;
  };
  for (let at = 0; at < text.length;) {
    const letter = text[at]!;
    if (letter === '#') break;
    if (/\s/.test(letter)) {
      at++;
      continue;
    }
    const put = (kind: TokenKind, shown: string, length = shown.length): void => {
      tokens.push({ kind, text: shown, at, end: at + length });
      at += length;
    };
    if (letter === '"' || letter === '“') {
      const close = text.slice(at + 1).search(/["”]/);
      if (close < 0) refuse('a closing " is missing', at, text.length - at);
      put('text', text.slice(at + 1, at + 1 + close), close + 2);
      continue;
    }
    if (letter === '[') {
      const close = text.indexOf(']', at);
      if (close < 0) refuse('a "]" is missing: a unit is written [m/s]', at, text.length - at);
      put('unit', text.slice(at + 1, close).trim(), close + 1 - at);
      continue;
    }
    if (RAISED.has(letter)) {
      let end = at;
      let exponent = '';
      while (end < text.length && RAISED.has(text[end]!)) exponent += RAISED.get(text[end++]!);
      tokens.push({ kind: 'sign', text: '^', at, end: at }, { kind: 'sign', text: '(', at, end: at });
      for (const part of exponent.match(/[-+]|\d+/g) ?? [])
        tokens.push({ kind: /\d/.test(part) ? 'number' : 'sign', text: part, at, end });
      tokens.push({ kind: 'sign', text: ')', at: end, end });
      at = end;
      continue;
    }
    const spelled = SPELLINGS.get(letter);
    if (spelled !== undefined) {
      put(/^[a-z]/.test(spelled) ? 'name' : 'sign', spelled, 1);
      continue;
    }
    const word = found(WORD, at);
    const number = word ? null : found(NUMBER, at);
    const sign = word || number ? null : found(SIGN, at);
    if (word) put('name', word.replace(/[’′]$/, "'"), word.length);
    else if (number) put('number', number);
    else if (sign) put('sign', sign === '**' ? '^' : sign, sign.length);
    else refuse(oddCharacter(letter), at);
  }
  return tokens;
}
