import type { SystemMeta } from '../core/systems/types.ts';

/** How one column of a file is used. */
export interface ColumnUse {
  /** Position in the file, 0-based. */
  index: number;
  /** Canonical name. */
  name: string;
  /** Multiply by this for SI and radians. */
  factor: number;
  /** As written in the file, for messages. */
  title: string;
  /** Without it a row can still be drawn. */
  optional: boolean;
}

export interface HeaderReading {
  systemId: string;
  uses: ColumnUse[];
  notes: string[];
}

const UNITS = new Map<string, number>([
  ['s', 1], ['sec', 1], ['seconds', 1], ['ms', 1e-3], ['us', 1e-6], ['µs', 1e-6], ['min', 60],
  ['m', 1], ['mm', 1e-3], ['cm', 1e-2], ['km', 1e3], ['in', 0.0254], ['ft', 0.3048],
  ['rad', 1], ['deg', Math.PI / 180], ['degrees', Math.PI / 180], ['°', Math.PI / 180], ['rev', 2 * Math.PI],
  ['m/s', 1], ['mm/s', 1e-3], ['cm/s', 1e-2], ['km/h', 1 / 3.6],
  ['rad/s', 1], ['deg/s', Math.PI / 180], ['°/s', Math.PI / 180], ['rpm', Math.PI / 30],
  ['n', 1], ['j', 1], ['n·m', 1], ['nm', 1], ['1', 1], ['-', 1], ['', 1],
]);

const KINDS = {
  time: ['s', 'sec', 'seconds', 'ms', 'us', 'µs', 'min', ''],
  length: ['m', 'mm', 'cm', 'km', 'in', 'ft', ''],
  angle: ['rad', 'deg', 'degrees', '°', 'rev', ''],
  'length rate': ['m/s', 'mm/s', 'cm/s', 'km/h', ''],
  'angle rate': ['rad/s', 'deg/s', '°/s', 'rpm', ''],
  // Multipliers, energy, residual, inputs: whatever SI unit they have.
  other: ['n', 'n·m', 'nm', 'j', 'm', 'm/s', '1', '-', ''],
} as const satisfies Record<string, readonly string[]>;

type Kind = keyof typeof KINDS;

/** No longer title is a name with a unit; the pattern below would take long over it. */
const LONGEST_TITLE = 200;

/** `alpha_fp`, `ALPHA-FP` and `alphaFp` are one name. */
export function plainName(name: string): string {
  return name.toLowerCase().replace(/[\s_-]+/g, '');
}

/** Splits titles such as `alpha [deg]` and `time (s)` into name and unit. */
export function splitTitle(title: string): { name: string; unit: string } {
  if (title.length > LONGEST_TITLE) return { name: title, unit: '' };
  const match = /^(.*?)\s*[[(]\s*([^\])]*)\s*[\])]\s*$/.exec(title.trim());
  return match ? { name: match[1]!.trim(), unit: match[2]!.trim().toLowerCase() } : { name: title.trim(), unit: '' };
}

/** Names a column can have in a system: canonical name and kind by plain name. */
function vocabulary(meta: SystemMeta): Map<string, { name: string; kind: Kind }> {
  const words = new Map<string, { name: string; kind: Kind }>();
  for (const time of ['t', 'time', 'seconds']) words.set(time, { name: 't', kind: 'time' });
  for (const q of meta.coordinates) {
    words.set(plainName(q.name), { name: q.name, kind: q.kind });
    words.set(plainName(`${q.name}_dot`), { name: `${q.name}_dot`, kind: `${q.kind} rate` });
  }
  for (let i = 1; i <= 8; i++) words.set(`lambda${i}`, { name: `lambda_${i}`, kind: 'other' });
  const others = ['energy', 'residual', ...meta.inputs.map((i) => i.name), ...meta.coordinates.map((q) => `f_${q.name}`)];
  for (const other of others) if (!words.has(plainName(other))) words.set(plainName(other), { name: other, kind: 'other' });
  return words;
}

/**
 * Finds the system whose coordinates are all there (the preferred one or the one with most, if several) and how each
 * column is used. A text answer says why no system fits.
 */
export function readHeader(titles: readonly string[], systems: Readonly<Record<string, SystemMeta>>, preferred?: string): HeaderReading | string {
  const names = titles.map((t) => plainName(splitTitle(t).name));
  const present = new Set(names);
  const found = Object.entries(systems).map(([id, meta]) => {
    const missing = meta.coordinates.filter((q) => !present.has(plainName(q.name))).map((q) => q.name);
    return { id, meta, missing, there: meta.coordinates.length - missing.length };
  });
  const fitting = found
    .filter((f) => f.missing.length === 0)
    .sort((a, b) => Number(b.id === preferred) - Number(a.id === preferred) || b.there - a.there)[0];
  const nearest = [...found].sort((a, b) => a.missing.length / a.meta.coordinates.length - b.missing.length / b.meta.coordinates.length)[0];
  if (!fitting) return nearest ? missingFrom(nearest) : 'no systems are known';
  // A board with one column missing is not a sleigh, though it has x, y and theta.
  const larger = found.filter((f) => f.there > fitting.there && 2 * f.missing.length <= f.there).sort((a, b) => b.there - a.there)[0];
  if (larger && fitting.id !== preferred) return missingFrom(larger);
  const { id: systemId, meta } = fitting;
  const words = vocabulary(meta);
  const uses: ColumnUse[] = [];
  const notes: string[] = [];
  const ignored: string[] = [];
  for (const [index, title] of titles.entries()) {
    const { unit } = splitTitle(title);
    const word = words.get(names[index]!);
    if (!word) {
      if (title.trim()) ignored.push(shorten(title));
      continue;
    }
    if (uses.some((u) => u.name === word.name)) {
      notes.push(`column ${index + 1} repeats "${word.name}"; the first is used`);
      continue;
    }
    const factor = UNITS.get(unit);
    const allowed: readonly string[] = KINDS[word.kind];
    if (factor === undefined || !allowed.includes(unit)) {
      return `column "${shorten(title)}": the unit "${unit}" is not understood for ${word.name}; right would be ${allowed.filter(Boolean).join(', ')}`;
    }
    if (factor !== 1) notes.push(`"${shorten(title)}" was converted to SI`);
    uses.push({ index, name: word.name, factor, title: shorten(title), optional: word.kind === 'other' });
  }
  if (!uses.some((u) => u.name === 't')) return 'there is no time column; name one "t" or "time [s]"';
  if (ignored.length > 0) notes.push(`columns not used: ${ignored.slice(0, 12).join(', ')}${ignored.length > 12 ? ` and ${ignored.length - 12} more` : ''}`);
  return { systemId, uses: order(uses, meta), notes };
}

/** Time, coordinates and velocities in their own order, then the rest as the file has it. */
function order(uses: readonly ColumnUse[], meta: SystemMeta): ColumnUse[] {
  const canon = ['t', ...meta.coordinates.map((q) => q.name), ...meta.coordinates.map((q) => `${q.name}_dot`)];
  const rank = (u: ColumnUse): number => (canon.includes(u.name) ? canon.indexOf(u.name) : canon.length + u.index);
  return [...uses].sort((a, b) => rank(a) - rank(b));
}

function missingFrom({ meta, missing }: { meta: SystemMeta; missing: readonly string[] }): string {
  return `the header names no system's coordinates; nearest is ${meta.title}, where ${missing.join(', ')} ${missing.length === 1 ? 'is' : 'are'} missing`;
}

function shorten(title: string): string {
  const text = title.trim().replace(/\s+/g, ' ');
  return text.length > 60 ? `${text.slice(0, 59)}…` : text;
}
