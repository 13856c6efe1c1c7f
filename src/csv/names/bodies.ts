/** Several bodies in one table, side by side: which columns belong together. */
import type { Source } from '../source.ts';
import type { Attitude } from './attitude.ts';
import type { Candidate } from './systems.ts';
import { attitudeOf } from './vocabulary.ts';
import { isQuantity } from './phrases.ts';
import { withoutSuffix } from './plainName.ts';

export interface Body {
  name: string;
  /** What stands before the names of its columns. */
  prefix: string;
  columns: ReadonlySet<number>;
}

/** What stands between a body's name and its coordinate's. */
const GENERIC =
  /^(?:pos(?:ition|icion|izione)?|posición|pose|pt|translation|location|loc|coord|rot(?:ation)?|orientation|attitude|quat(?:ernion)?|euler|angles?|linear|angular|velocity|vel|speed|twist|value|mean|state|field|header|[pqvtr])$/i;

/** `cart` of `cart.Position.X`, `/cart/pose/position/x`, `der(cart.x)`; '' where a name has none. */
export function bodyIn(name: string): string {
  if (isQuantity(name)) return '';
  const inner = /^(?:der|d|dot)\s*\(\s*(.+?)\s*\)(?:\/dt)?$/i.exec(name)?.[1] ?? name;
  const words = (withoutSuffix(inner) ?? inner).split(/[./:|\s]+/).filter((word) => word !== '');
  const last = words.pop() ?? '';
  while (words.length > 0 && GENERIC.test(words.at(-1)!)) words.pop();
  const numbered = /^.*[a-zα-ω]_?(\d{1,2})$/i.exec(last)?.[1];
  return [...words, ...(numbered === undefined ? [] : [numbered])].join(' ');
}

/**
 * The bodies of a table that have all coordinates of a system, in the order of their first columns.
 * @param carried whether a name stands only before the first of a body's columns (Qualisys)
 */
export function bodiesOf(
  sources: readonly Source[],
  { meta, hits }: Candidate,
  attitudes: readonly Attitude[],
  carried: boolean,
): Body[] {
  const groups = new Map<string, { prefix: string; columns: Set<number>; words: Map<string, number> }>();
  let held = '';
  const keys = sources.map((source) => {
    const own = bodyIn(source.plain);
    if (own !== '') held = own;
    return carried ? held : own;
  });
  const into = (key: string, column: number, word: string, rank: number): void => {
    const group = groups.get(key) ?? {
      prefix: keys[column]!,
      columns: new Set<number>(),
      words: new Map<string, number>(),
    };
    groups.set(key, group);
    group.columns.add(column);
    if (!group.words.has(word)) group.words.set(word, rank);
  };
  for (const [i, hit] of hits.entries()) {
    if (!hit || hit.word.kind === 'plain') continue;
    const { name } = hit.word;
    let key = keys[i]!;
    // The same name again, without a word to tell them apart: the next body.
    for (let k = 2; groups.get(key)?.words.get(name) === hit.rank; k++) key = `${keys[i]!} ${k}`.trim();
    into(key, i, name, hit.rank);
  }
  const made = attitudeOf(meta);
  for (const { columns } of attitudes)
    for (const column of columns)
      for (const name of Object.values(made ?? {})) if (name) into(keys[column]!, column, name, Infinity);
  return [...groups]
    .filter(([, { words }]) => meta.coordinates.every((q) => words.has(q.name)))
    .map(([name, { prefix, columns }]) => ({ name, prefix, columns }))
    .sort((a, b) => Math.min(...a.columns) - Math.min(...b.columns));
}
