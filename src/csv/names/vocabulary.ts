import type { SystemMeta } from '../../core/model/system.ts';
import { factorOf, type Kind } from '../units/units.ts';
import { splitTitle, unitBehind, unitsBehind } from '../units/titles.ts';
import { phrasesOf } from './phrases.ts';
import { isOtherQuantity, plainName, ratesOf, withoutPrefix, withoutSuffix } from './plainName.ts';
import { isDateName, isFrameName, timeRank } from '../time/timeNames.ts';

export type Systems = Readonly<Record<string, SystemMeta>>;

export interface Word {
  name: string;
  kind: Kind;
  needed: boolean;
}

/** Names a column can have in a system. */
export interface Vocabulary {
  words: ReadonlyMap<string, Word>;
  /** Other names for its coordinates, which give way to their own. */
  aliases: ReadonlyMap<string, Word>;
  /** What few words say of it in any language. */
  phrase: ReturnType<typeof phrasesOf>;
  /** How many coordinates there are. */
  coordinates: number;
  /** What titles were found to mean: a header is looked at again and again until it is understood. */
  found: Map<string, Hit | null>;
}

export interface Hit {
  word: Word;
  unit: string;
  /** The surer, the lower: own name, name with a unit behind it, other name, rate, name behind a prefix. */
  rank: number;
}

/** Which coordinates a system's attitude is: it has yaw, pitch, roll by these names, or a heading alone, or none. */
export function attitudeOf(meta: SystemMeta): { yaw: string; pitch: string | null; roll: string | null } | null {
  const has = (name: string): boolean => meta.coordinates.some((q) => q.name === name && q.kind === 'angle');
  const plane = meta.coordinates.filter((q) => /^[xy]$/i.test(q.name)).length === 2;
  if (has('yaw')) return { yaw: 'yaw', pitch: has('pitch') ? 'pitch' : null, roll: has('roll') ? 'roll' : null };
  if (!plane || !has('theta')) return null;
  const spatial = has('alpha') && has('psi');
  return { yaw: 'theta', pitch: spatial ? 'psi' : null, roll: spatial ? 'alpha' : null };
}

/** Beside the words of `languages.ts`. */
const HEADINGS = ['orientation', 'orientierung', 'rz', 'rotz', 'eulerz', 'rotationz'];
const PITCHES = ['ry', 'roty', 'eulery'];
const ROLLS = ['rx', 'rotx', 'eulerx', 'bank'];
const POSITIONS = ['pos', 'position', 'p', 't', 'translation', 'coord', 'location', 'loc'];

const MOST_FOUND = 1000;
const known = new WeakMap<SystemMeta, Vocabulary>();

export function vocabularyOf(meta: SystemMeta): Vocabulary {
  const old = known.get(meta);
  if (old) return old;
  const words = new Map<string, Word>();
  const add = (written: string, name: string, kind: Kind, needed: boolean, to = words): void => {
    const plain = plainName(written);
    if (!to.has(plain)) to.set(plain, { name, kind, needed });
  };
  for (const q of meta.coordinates) add(q.name, q.name, q.kind, true);
  for (const q of meta.coordinates) add(`${q.name}_dot`, `${q.name}_dot`, `${q.kind} rate`, true);
  for (let i = 1; i <= 2 * meta.coordinates.length; i++) add(`lambda_${i}`, `lambda_${i}`, 'plain', false);
  for (const other of ['energy', 'residual', 'kinetic', 'potential', ...meta.inputs.map((i) => i.name)])
    add(other, other, 'plain', false);
  for (const q of meta.coordinates) add(`f_${q.name}`, `f_${q.name}`, 'plain', false);
  const aliases = new Map<string, Word>();
  const attitude = attitudeOf(meta);
  for (const [name, others] of [
    [attitude?.yaw, HEADINGS],
    [attitude?.pitch, PITCHES],
    [attitude?.roll, ROLLS],
  ] as const)
    if (name) for (const other of others) add(other, name, 'angle', true, aliases);
  for (const q of meta.coordinates.filter(({ name, kind }) => kind === 'length' && /^[xyz]$/i.test(name)))
    for (const position of POSITIONS) {
      add(position + q.name, q.name, 'length', true, aliases);
      // An array's parts, `position.0`, `pos[0]`.
      if (position.length > 2)
        for (const [open, close] of [
          ['.', ''],
          ['[', ']'],
        ] as const)
          add(`${position}${open}${'xyz'.indexOf(q.name.toLowerCase())}${close}`, q.name, 'length', true, aliases);
      if (position.length > 1) add(q.name + position, q.name, 'length', true, aliases);
    }
  const made = { words, aliases, phrase: phrasesOf(meta), coordinates: meta.coordinates.length, found: new Map() };
  known.set(meta, made);
  return made;
}

/** What a title means in a system, or null. */
export function lookUp(title: string, vocabulary: Vocabulary): Hit | null {
  const { found } = vocabulary;
  const known = found.get(title);
  if (known !== undefined) return known;
  const { name, unit } = splitTitle(title);
  const hit = named(name, unit, vocabulary, 0);
  if (found.size >= MOST_FOUND) found.clear();
  found.set(title, hit);
  return hit;
}

function named(name: string, unit: string, vocabulary: Vocabulary, rank: number): Hit | null {
  const { words, aliases } = vocabulary;
  const own = words.get(plainName(name));
  if (own) return { word: own, unit, rank };
  const other = aliases.get(plainName(name));
  if (other) return { word: other, unit, rank: rank + 2 };
  const phrase = vocabulary.phrase(name);
  const said = phrase && words.get(plainName(phrase.rate ? `${phrase.name}_dot` : phrase.name));
  if (said) return { word: said, unit, rank: rank + (phrase.rate ? 3 : 2) };
  for (const base of ratesOf(name)) {
    const last = withoutPrefix(base);
    const of = [base, ...(last ? [last] : [])]
      .flatMap((n) => words.get(plainName(n)) ?? aliases.get(plainName(n)) ?? [])
      .at(0);
    const rate = of && words.get(plainName(`${of.name}_dot`));
    if (rate) return { word: rate, unit, rank: rank + 3 };
  }
  for (const behind of unit === '' ? unitsBehind(name) : []) {
    const hit = named(behind.name, behind.unit, vocabulary, rank + 1);
    if (hit && factorOf(behind.unit, hit.word.kind) !== undefined) return hit;
  }
  // `p_RS_R_x`: frames between.
  const framed = /^(?:p|pos|position|trans|translation)(?:_[a-z0-9]+){1,3}_([xyz])$/i.exec(name)?.[1];
  if (framed) return named(framed, unit, vocabulary, rank + 3);
  const whole = withoutSuffix(name);
  if (whole) return named(whole, unit, vocabulary, rank + 1);
  const last = rank < 10 ? withoutPrefix(name) : null;
  if (last && isOtherQuantity(name.slice(0, -last.length))) return null;
  if (last) return named(last, unit, vocabulary, rank + 10);
  // `x1`, `theta_2`: one of several bodies, in a system whose coordinates could not be mistaken for it.
  const numbered = rank < 20 && vocabulary.coordinates > 1 ? /^(.*[a-zα-ω])_?\d{1,2}$/i.exec(name) : null;
  return numbered ? named(numbered[1]!, unit, vocabulary, rank + 20) : null;
}

/** How many of some cells name columns: those of the system that knows most of them, and times. */
export function namesColumns(cells: readonly string[], systems: Systems): number {
  const titles = cells
    .map((cell) => cell.trim())
    .filter((cell) => cell !== '' && cell.length < 80 && !/^[+-]?[\d.,]+(?:e[+-]?\d+)?$/i.test(cell));
  const times = titles.filter((title) => {
    const name = splitTitle(title).name;
    return timeRank(unitBehind(name)?.name ?? name) !== null || isDateName(name) || isFrameName(name);
  }).length;
  let most = 0;
  for (const meta of Object.values(systems)) {
    const vocabulary = vocabularyOf(meta);
    most = Math.max(most, titles.filter((title) => lookUp(title, vocabulary) !== null).length);
  }
  return most + times;
}
