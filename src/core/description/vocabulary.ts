import { several, unary } from '../scenario/expressions/functions.ts';
import { constants } from '../scenario/expressions/plainText.ts';
import { VECTOR_FUNCTIONS } from './expression.ts';
import { statements } from './statements.ts';

/** The words of the language, for colours, completion and help. */
export const vocabulary: {
  /** First words of lines, with an example each and the words that may follow. */
  readonly statements: readonly { word: string; example: string; words: readonly string[] }[];
  readonly functions: readonly string[];
  /** What functions of vectors do, by name. */
  readonly vectorFunctions: ReadonlyMap<string, string>;
  readonly constants: readonly string[];
} = {
  statements: Object.entries(statements).map(([word, { example, words = [] }]) => ({ word, example, words })),
  functions: [...unary, ...several.keys(), ...VECTOR_FUNCTIONS.keys()],
  vectorFunctions: VECTOR_FUNCTIONS,
  constants: [...constants.keys(), 't', 'world'],
};
