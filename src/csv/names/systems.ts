import type { SystemMeta } from '../../core/model/system.ts';
import { splitTitle, unitBehind } from '../units/titles.ts';
import { attitudeOf, lookUp, vocabularyOf, type Hit, type Systems } from './vocabulary.ts';

/** A system that a header may be of, and what each column is in it. */
export interface Candidate {
  id: string;
  meta: SystemMeta;
  hits: readonly (Hit | null)[];
  /** Coordinates that are there, and those that have to be and are not. */
  present: number;
  missing: readonly string[];
}

export interface Fit {
  candidate: Candidate | null;
  /** Why none fits: the nearest, and what is missing. */
  reason: string;
}

/**
 * Finds the system whose coordinates are all there. Where several fit: the preferred one, else the one with most
 * coordinates, else the one whose names are spelled exactly so.
 * @param titles with their units; null for a column that has a meaning already
 * @param chosen what a person said of columns: their index by canonical name, -1 for none
 * @param attitude whether a quaternion gives yaw, pitch and roll
 */
export function fitSystem(
  titles: readonly (string | null)[],
  systems: Systems,
  preferred: string | null,
  chosen: ReadonlyMap<string, number>,
  attitude: boolean,
): Fit {
  const exact = new Set(titles.map((t) => /^[^[({]*/.exec(t ?? '')![0].trim()));
  const candidates = Object.entries(systems).map(([id, meta]) => candidate(id, meta, titles, chosen, attitude));
  const rank = ({ id, meta, present }: Candidate): number =>
    (id === preferred ? 1e6 : 0) + 1e3 * present + meta.coordinates.filter((q) => exact.has(q.name)).length;
  const present = (c: Candidate): number => c.present;
  const share = (c: Candidate): number => c.missing.length / c.meta.coordinates.length;
  const fitting = candidates.filter((c) => c.missing.length === 0).sort((a, b) => rank(b) - rank(a))[0];
  // A board with one column missing is not a sleigh, though it has x, y and theta.
  const larger = candidates
    .filter((c) => fitting && present(c) > present(fitting) && 2 * c.missing.length <= present(c))
    .sort((a, b) => present(b) - present(a))[0];
  if (fitting && (!larger || fitting.id === preferred)) return { candidate: fitting, reason: '' };
  const nearest = larger ?? [...candidates].sort((a, b) => share(a) - share(b))[0];
  if (!nearest) return { candidate: null, reason: 'there is no system to read it for' };
  if (present(nearest) === 0) return { candidate: null, reason: 'the names are those of no system' };
  return {
    candidate: null,
    reason: `the header names the coordinates of no system; nearest is ${nearest.meta.title}, where ${nearest.missing.join(', ')} ${nearest.missing.length === 1 ? 'is' : 'are'} missing`,
  };
}

export function candidate(
  id: string,
  meta: SystemMeta,
  titles: readonly (string | null)[],
  chosen: ReadonlyMap<string, number>,
  attitude: boolean,
): Candidate {
  const vocabulary = vocabularyOf(meta);
  const taken = new Set(chosen.values());
  const hits = titles.map((title, i) => {
    if (title === null || taken.has(i)) return null;
    const hit = lookUp(title, vocabulary);
    return hit && !chosen.has(hit.word.name) ? hit : null;
  });
  for (const [name, index] of chosen) {
    const word = [...vocabulary.words.values()].find((w) => w.name === name);
    if (word && index >= 0) hits[index] = { word, unit: unitIn(titles[index] ?? ''), rank: -1 };
  }
  const there = new Set(hits.map((hit) => hit?.word.name));
  const made = attitude ? Object.values(attitudeOf(meta) ?? {}) : [];
  const away = meta.coordinates.map((q) => q.name).filter((name) => !there.has(name) && !made.includes(name));
  return {
    id,
    meta,
    hits,
    present: meta.coordinates.length - away.length,
    // What is held by default stands still where a file does not name it.
    missing: away.filter((name) => !meta.held?.includes(name)),
  };
}

function unitIn(title: string): string {
  const { name, unit } = splitTitle(title);
  return unit || (unitBehind(name)?.unit ?? '');
}
