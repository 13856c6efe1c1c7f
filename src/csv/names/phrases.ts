/** Names of columns made of words that are known: what they say, in whatever language and order. */
import type { SystemMeta } from '../../core/model/system.ts';
import { BESIDE_TIME, TIME_WORDS, WORDS, type Concept } from './languages.ts';
import { remembered } from './remembered.ts';

/** Longer names are no few words. */
const LONGEST = 60;
const LONGEST_ENDING = 3;

interface Lexicon {
  /** Of each first letter: words, their concepts and whether an ending may follow, the longest first. */
  byLetter: ReadonlyMap<string, readonly { word: string; concept: string; open: boolean }[]>;
}

const letter = /\p{L}/u;
/** Letters of words that stand apart from each other; those of Japanese and Chinese do not. */
const spaced = (c: string | undefined): boolean =>
  c !== undefined && letter.test(c) && !/[\p{Script=Han}\p{Script=Hiragana}\p{Script=Katakana}ー]/u.test(c);

/** Small letters without accents, words apart. */
export function spelled(text: string): string {
  return text
    .replace(/(\p{Ll})(?=\p{Lu}\p{Ll})/gu, '$1 ')
    .normalize('NFD')
    .toLowerCase()
    .replace(/[\u0300-\u036f\u3099\u309a]/g, '')
    .replace(/[łøßı]/g, (c) => ({ ł: 'l', ø: 'o', ß: 'ss', ı: 'i' })[c]!)
    .replace(/\b[dl]['’](?=\p{L}{2})|['’]s\b/gu, ' ')
    .replace(/[\s_\-./·:,;]+/g, ' ')
    .trim();
}

function lexiconOf(concepts: Readonly<Record<string, string>>): Lexicon {
  const byLetter = new Map<string, { word: string; concept: string; open: boolean }[]>();
  for (const [concept, words] of Object.entries(concepts))
    for (const written of words.split(' ')) {
      const open = written.endsWith('*');
      const word = spelled(open ? written.slice(0, -1) : written);
      const list = byLetter.get(word[0]!) ?? [];
      byLetter.set(word[0]!, list);
      list.push({ word, concept, open });
    }
  for (const list of byLetter.values()) list.sort((a, b) => b.word.length - a.word.length);
  return { byLetter };
}

/** The concepts of which a text consists, every letter of it; null where one is not known. */
function consumed(text: string, { byLetter }: Lexicon): string[] | null {
  const failed = new Set<number>();
  const from = (start: number, before: string): string[] | null => {
    let at = start;
    while (text[at] === ' ') at++;
    if (at >= text.length) return [];
    if (failed.has(at)) return null;
    for (const { word, concept, open } of byLetter.get(text[at]!) ?? []) {
      if (!text.startsWith(word, at)) continue;
      for (let ending = 0; ending <= (open ? LONGEST_ENDING : 0); ending++) {
        const end = at + word.length + ending;
        if (end > text.length || (ending > 0 && !/^\p{L}+$/u.test(text.slice(at + word.length, end)))) continue;
        if (needsRoom(word, concept, before) && (spaced(text[at - 1]) || spaced(text[end]))) continue;
        if (word === 's' && !(spaced(text[at - 1]) && spaced(text[end]))) continue;
        const rest = from(end, concept);
        if (rest) return [concept, ...rest];
      }
    }
    failed.add(at);
    return null;
  };
  return from(0, '');
}

/** A single letter, and a little word, stand alone, but for German's `s` between words and `positionX`. */
function needsRoom(word: string, concept: string, before: string): boolean {
  if (concept === 'of') return word !== 's' && spaced(word[0]);
  return word.length === 1 && spaced(word) && before !== 'position' && before !== 'rate';
}

let words: Lexicon | null = null;
let times: Lexicon | null = null;

/** What a name says, or null where it holds a word that is not known. */
export const conceptsIn = remembered((name): ReadonlySet<Concept> | null => {
  if (name.length > LONGEST || !/\p{L}/u.test(name)) return null;
  words ??= lexiconOf(WORDS);
  const found = consumed(spelled(name), words);
  return found && (new Set(found) as ReadonlySet<Concept>);
});

/** `Tiempo transcurrido`, `経過時間`, `метка времени`. */
export const isTimePhrase = remembered((name): boolean => {
  if (name.length > LONGEST || !/\p{L}/u.test(name)) return false;
  times ??= lexiconOf({ time: TIME_WORDS, beside: BESIDE_TIME, of: WORDS.of });
  return consumed(spelled(name), times)?.includes('time') === true;
});

const QUANTITIES: readonly Concept[] = ['yaw', 'pitch', 'roll', 'steer', 'lean', 'spin', 'turn', 'angle'];
const PLACES: readonly Concept[] = ['x', 'y', 'z', 'position', 'height'];
/** What a phrase must name beside front and rear. */
const TELLING: readonly Concept[] = [
  ...(['yaw', 'pitch', 'roll', 'steer', 'lean', 'spin', 'x', 'y', 'z', 'height'] as const),
  ...(['board', 'caster', 'pendulum', 'cart', 'wheel'] as const),
];

/** Whether a name says what is measured and not of which body. */
export const isQuantity = (name: string): boolean => {
  const found = conceptsIn(name);
  return found !== null && [...found].every((c) => c === 'of' || c === 'rate' || isMeasured(c));
};
const isMeasured = (concept: Concept): boolean => QUANTITIES.includes(concept) || PLACES.includes(concept);

/** A coordinate as its name and its label say it. */
interface Spoken {
  name: string;
  kind: string;
  own: ReadonlySet<Concept>;
  all: ReadonlySet<Concept>;
}

/** What parts a label's clauses: `pitch of the rear frame, nose down`. */
const CLAUSES = /[,()]|\s(?:on|in|of|from)\s/;
const without = (set: ReadonlySet<Concept>, ...out: Concept[]): Set<Concept> =>
  new Set([...set].filter((concept) => !out.includes(concept)));

/** Reads phrases for one system. */
export function phrasesOf(meta: SystemMeta): (name: string) => { name: string; rate: boolean } | null {
  const spoken = meta.coordinates.map(({ name, kind, label }): Spoken => {
    const own = told(conceptsIn(name) ?? new Set());
    const clauses = label.split(CLAUSES).map((clause) => told(conceptsIn(clause) ?? new Set()));
    const all = new Set([...own, ...clauses.flatMap((clause) => [...clause])]);
    if (clauses.length > 0 && conceptsIn(label.split(CLAUSES)[0]!)?.has('caster')) all.add('caster');
    // The turn of a wheel is what is measured of it.
    if (all.delete('wheel')) all.add('spin');
    return { name, kind, own, all };
  });
  return (name) => {
    const found = conceptsIn(name);
    // Of a plate or a caster in front the angle is meant, also unsaid.
    const sided = found && (found.has('front') || found.has('rear')) && (found.has('board') || found.has('caster'));
    if (!found || !(sided || [...found].some((c) => c === 'rate' || isMeasured(c)))) return null;
    const rate = found.has('rate');
    const kind = [...found].some((c) => PLACES.includes(c))
      ? 'length'
      : [...found].some((c) => QUANTITIES.includes(c))
        ? 'angle'
        : null;
    const wanted = told(found);
    const of = spoken.filter((q) => kind === null || q.kind === kind);
    const hit = nearest(wanted, of) ?? inOtherWords(wanted, of);
    return hit && { name: hit.name, rate };
  };
}

/** Without what is understood anyhow. */
function told(found: ReadonlySet<Concept>): Set<Concept> {
  let set = without(found, 'of', 'angle', 'position', 'rate');
  if (set.has('steer')) set = without(set, 'wheel', 'caster', 'turn');
  if (set.has('wheel') && (set.has('turn') || set.has('spin'))) set = without(set, 'wheel', 'turn').add('spin');
  if (set.has('yaw') || set.has('pitch') || set.has('roll')) set = without(set, 'turn', 'lean');
  return set.has('front') || set.has('rear') ? set : without(set, 'board');
}

/** The one coordinate that is all that is wanted, and least beside it. */
function nearest(wanted: ReadonlySet<Concept>, spoken: readonly Spoken[]): Spoken | null {
  if (![...wanted].some((concept) => TELLING.includes(concept))) return null;
  const fitting = spoken
    .filter(({ all }) => [...wanted].every((concept) => all.has(concept)))
    .map((q) => ({ q, beside: q.all.size - wanted.size }))
    .sort((a, b) => a.beside - b.beside);
  return fitting[0] && fitting[0].beside !== fitting[1]?.beside ? fitting[0].q : null;
}

/** What can mean but one thing in a system that says it otherwise. */
function inOtherWords(wanted: ReadonlySet<Concept>, spoken: readonly Spoken[]): Spoken | null {
  // Of two wheels the front one steers.
  if (wanted.has('steer') && wanted.has('front')) return nearest(without(wanted, 'front'), spoken);
  if (wanted.has('rider')) {
    const rest = without(wanted, 'rider');
    return spoken.find(({ own }) => own.size === rest.size && own.has('lean') && rest.has('lean')) ?? null;
  }
  const turns =
    wanted.size === 1 && wanted.has('wheel') && !spoken.some(({ all }) => all.has('steer') || all.has('yaw'));
  const spins = turns ? spoken.filter(({ all }) => all.has('spin')) : [];
  return spins.length === 1 ? spins[0]! : null;
}
