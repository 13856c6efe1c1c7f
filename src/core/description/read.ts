/** A description's text, read: `docs/own-systems.md` teaches the language. */
import { Builder } from './builder.ts';
import { Reader } from './expression.ts';
import { GrowthError } from './graph.ts';
import type { Model } from './model.ts';
import { noStatement } from './hints.ts';
import { readDefinition, readRate, statements } from './statements.ts';
import { DescriptionError, tokensOf, type LineToken } from './tokens.ts';

export const LONGEST_DESCRIPTION = 40_000;
const MOST_LINES = 1000;
const MOST_FAULTS = 20;

export interface Reading {
  /** Null where there are faults. */
  model: Model | null;
  faults: readonly DescriptionError[];
  /** What is defined, by name, also where something is wrong: for completion. */
  names: Model['names'];
}

/**
 * Reads a description; every line that is wrong is told, each with the first of its faults.
 *
 * @param text the description
 */
export function readDescription(text: string): Reading {
  const builder = new Builder();
  const faults: DescriptionError[] = [];
  const { names } = builder.model;
  const stop = (error: unknown, line: number): void => {
    if (error instanceof GrowthError) faults.push(new DescriptionError(error.message, line));
    else if (error instanceof DescriptionError) faults.push(error);
    else throw error;
  };
  if (text.length > LONGEST_DESCRIPTION) {
    faults.push(
      new DescriptionError(`${text.length} characters are more than a description's ${LONGEST_DESCRIPTION}`, 0),
    );
    return { model: null, faults, names };
  }
  const lines = text.replace(/^\ufeff/, '').split(/\r\n|\r|\n/);
  if (lines.length > MOST_LINES) {
    faults.push(
      new DescriptionError(`${lines.length} lines are more than a description's ${MOST_LINES}`, MOST_LINES + 1),
    );
    return { model: null, faults, names };
  }
  builder.foresee(lines);
  /** Names that a line with a fault was to define: what misses them has no fault of its own. */
  const broken = new Set<string>();
  for (const [k, content] of lines.entries()) {
    let tokens: LineToken[] = [];
    builder.graph.work = `line ${k + 1}`;
    try {
      tokens = tokensOf(content, k + 1);
      if (tokens.length > 0) readLine(new Reader(tokens, k + 1, content, builder), builder);
    } catch (error) {
      const follows = tokens.some(({ text: word }) => broken.has(word.split(/[.']/)[0]!.replace(/_dot$/, '')));
      if (!follows || !(error instanceof DescriptionError)) stop(error, k + 1);
      for (const token of tokens) if (token.kind === 'name' && !names.has(token.text)) broken.add(token.text);
      if (faults.length >= MOST_FAULTS) break;
    }
  }
  if (faults.length > 0) return { model: null, faults, names };
  try {
    return { model: builder.finish(), faults, names };
  } catch (error) {
    stop(error, 0);
    return { model: null, faults, names };
  }
}

function readLine(r: Reader, builder: Builder): void {
  const [first, second] = r.tokens;
  if (first!.text === '/') r.fail('a comment begins with #', first);
  if (first!.kind !== 'name')
    r.fail(
      `a line begins with a word, such as ${Object.keys(statements).slice(0, 5).join(', ')}, or with a name that it defines`,
    );
  const defines = second?.text === '=' && second.kind === 'sign';
  if (defines && /('|_dot)$/.test(first!.text)) readRate(r, builder);
  else if (defines && Object.hasOwn(statements, first!.text))
    r.fail(`"${first!.text}" begins a statement and has no "=" behind it: ${statements[first!.text]!.example}`, second);
  else if (defines) readDefinition(r, builder);
  else if (Object.hasOwn(statements, first!.text)) {
    const statement = statements[first!.text]!;
    r.at = 1;
    statement.read(r, builder);
    r.end(statement.example);
    return;
  } else r.fail(noStatement(first!.text, Object.keys(statements)), first);
  r.end(`a line defines one name`);
}
