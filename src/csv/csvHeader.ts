import type { SystemMeta } from '../core/model/system.ts';
import { factorOf, RIGHT_UNITS, type Kind } from './csvUnits.ts';

type Systems = Readonly<Record<string, SystemMeta>>;

/** How one column of a file is used. */
export interface ColumnUse {
  /** Position in the file, 0-based; -1 for a time that is counted, not read. */
  index: number;
  /** Canonical name. */
  name: string;
  /** Multiply by this for SI and radians. */
  factor: number;
  /** As written in the file, for messages. */
  title: string;
  /** Without it a row can't be drawn; others may have gaps. */
  needed: boolean;
}

export interface HeaderReading {
  systemId: string;
  /** Time first if the file has one, then coordinates, velocities, the rest. */
  uses: ColumnUse[];
  notes: string[];
  /** Columns named twice. */
  repeated: { title: string; message: string }[];
}

interface Word {
  name: string;
  kind: Kind;
  needed: boolean;
}

const GREEK: Record<string, string> = { α: 'alpha', ψ: 'psi', θ: 'theta', φ: 'phi', ϕ: 'phi', λ: 'lambda', τ: 'tau' };
const UNIT_BEHIND = /^(.+?)\s*[/_,\s]\s*((?:deg|rad|°)(?:\/s)?|(?:mm|cm|km|m)(?:\/s)?|ms|s)$/i;

/** No longer title is a name with a unit; the patterns would take long over it. */
const LONGEST_TITLE = 200;

/** `alpha_fp`, `ALPHA-FP`, `alphaFp` and `α_fp` are one name. */
export function plainName(name: string): string {
  return name
    .toLowerCase()
    .replace(/[αψθφϕλτ]/g, (letter) => GREEK[letter]!)
    .replace(/[\s_-]+/g, '');
}

/** Splits `alpha [deg]` and `time (s)` into name and unit. */
export function splitTitle(title: string): { name: string; unit: string } {
  if (title.length > LONGEST_TITLE) return { name: '', unit: '' };
  const line = title.trim().replace(/\s+/g, ' ');
  const match = /^(.*?)[[(]([^\])]*)[\])]$/.exec(line);
  return match ? { name: match[1]!.trim(), unit: match[2]!.trim() } : { name: line, unit: '' };
}

/** Names a column can have in a system, by plain name. */
function vocabulary(meta: SystemMeta): Map<string, Word> {
  const words = new Map<string, Word>();
  const add = (written: string, name: string, kind: Kind, needed: boolean): void => {
    const plain = plainName(written);
    if (!words.has(plain)) words.set(plain, { name, kind, needed });
  };
  for (const q of meta.coordinates) add(q.name, q.name, q.kind, true);
  for (const q of meta.coordinates) add(`${q.name}_dot`, `${q.name}_dot`, `${q.kind} rate`, true);
  for (const time of ['t', 'time']) add(time, 't', 'time', true);
  for (let i = 1; i <= 2 * meta.coordinates.length; i++) add(`lambda_${i}`, `lambda_${i}`, 'plain', false);
  for (const other of ['energy', 'residual', 'kinetic', 'potential', ...meta.inputs.map((i) => i.name)])
    add(other, other, 'plain', false);
  for (const q of meta.coordinates) add(`f_${q.name}`, `f_${q.name}`, 'plain', false);
  return words;
}

function lookUp(title: string, words: ReadonlyMap<string, Word>): { word: Word; unit: string } | null {
  const { name, unit } = splitTitle(title);
  const word = words.get(plainName(name));
  if (word) return { word, unit };
  const behind = unit === '' ? UNIT_BEHIND.exec(name) : null;
  const found = behind && words.get(plainName(behind[1]!));
  return found ? { word: found, unit: behind[2]! } : null;
}

/** Whether any cell is the name of a column of any system. */
export function namesColumns(cells: readonly string[], systems: Systems): boolean {
  return Object.values(systems).some((meta) => {
    const words = vocabulary(meta);
    return cells.some((cell) => lookUp(cell, words) !== null);
  });
}

/**
 * Finds the system whose coordinates are all there and how each column is used. Where several fit: the preferred one,
 * else the one with most coordinates, else the one whose names are spelled exactly so. A text answer says why none fits.
 */
export function readHeader(
  titles: readonly string[],
  systems: Systems,
  preferred: string | null,
): HeaderReading | string {
  const exact = new Set(titles.map((t) => splitTitle(t).name));
  const rank = (id: string, meta: SystemMeta): number =>
    (id === preferred ? 1e6 : 0) +
    1e3 * meta.coordinates.length +
    meta.coordinates.filter((q) => exact.has(q.name)).length;
  const candidates = Object.entries(systems).map(([id, meta]) => {
    const words = vocabulary(meta);
    const found = titles.map((title) => lookUp(title, words));
    const there = new Set(found.map((f) => f?.word.name));
    return { id, meta, found, missing: meta.coordinates.map((q) => q.name).filter((name) => !there.has(name)) };
  });
  const fitting = candidates
    .filter((c) => c.missing.length === 0)
    .sort((a, b) => rank(b.id, b.meta) - rank(a.id, a.meta))[0];
  const share = (c: { missing: string[]; meta: SystemMeta }): number => c.missing.length / c.meta.coordinates.length;
  const present = (c: { missing: string[]; meta: SystemMeta }): number => c.meta.coordinates.length - c.missing.length;
  // A board with one column missing is not a sleigh, though it has x, y and theta.
  const larger = candidates
    .filter((c) => fitting && present(c) > present(fitting) && 2 * c.missing.length <= present(c))
    .sort((a, b) => present(b) - present(a))[0];
  if (fitting && (!larger || fitting.id === preferred)) return useColumns(titles, fitting);
  const nearest = larger ?? [...candidates].sort((a, b) => share(a) - share(b))[0];
  if (!nearest) return 'there is no system to read it for';
  return `the header names the coordinates of no system; nearest is ${nearest.meta.title}, where ${nearest.missing.join(', ')} ${nearest.missing.length === 1 ? 'is' : 'are'} missing`;
}

function useColumns(
  titles: readonly string[],
  { id, meta, found }: { id: string; meta: SystemMeta; found: readonly ReturnType<typeof lookUp>[] },
): HeaderReading | string {
  const reading: HeaderReading = { systemId: id, uses: [], notes: [], repeated: [] };
  const ignored: string[] = [];
  const converted: string[] = [];
  for (const [index, cell] of titles.entries()) {
    const title = shortened(cell);
    const hit = found[index];
    if (!hit) {
      if (title) ignored.push(title);
      continue;
    }
    const { word, unit } = hit;
    if (reading.uses.some((u) => u.name === word.name)) {
      reading.repeated.push({ title, message: `column ${index + 1} is "${word.name}" again; the first one is used` });
      continue;
    }
    const factor = factorOf(unit, word.kind);
    if (factor === undefined) {
      if (word.needed)
        return `column ${index + 1}, "${title}": the unit "${unit}" is not understood for ${word.name}; right would be ${RIGHT_UNITS[word.kind]}`;
      ignored.push(`${title} (unit not understood)`);
      continue;
    }
    if (factor !== 1) converted.push(title);
    reading.uses.push({ index, name: word.name, factor, title, needed: word.needed });
  }
  reading.uses = inOrder(reading.uses, meta);
  if (converted.length > 0) reading.notes.push(`converted to SI and radians: ${listed(converted)}`);
  if (ignored.length > 0) reading.notes.push(`columns not used: ${listed(ignored)}`);
  return reading;
}

function inOrder(uses: readonly ColumnUse[], meta: SystemMeta): ColumnUse[] {
  const names = meta.coordinates.map((q) => q.name);
  const canon = ['t', ...names, ...names.map((name) => `${name}_dot`)];
  const rank = (u: ColumnUse): number => (canon.includes(u.name) ? canon.indexOf(u.name) : canon.length + u.index);
  return [...uses].sort((a, b) => rank(a) - rank(b));
}

function listed(names: readonly string[]): string {
  return `${names.slice(0, 24).join(', ')}${names.length > 24 ? ` and ${names.length - 24} more` : ''}`;
}

function shortened(title: string): string {
  const line = title.trim().replace(/\s+/g, ' ');
  return line.length > 60 ? `${line.slice(0, 59)}…` : line;
}
