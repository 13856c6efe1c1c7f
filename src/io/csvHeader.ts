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
}

export interface HeaderReading {
  systemId: string;
  uses: ColumnUse[];
  notes: string[];
}

const UNITS = new Map<string, number>([
  ['s', 1], ['sec', 1], ['seconds', 1], ['ms', 1e-3], ['min', 60],
  ['m', 1], ['mm', 1e-3], ['cm', 1e-2], ['km', 1e3], ['in', 0.0254], ['ft', 0.3048],
  ['rad', 1], ['deg', Math.PI / 180], ['degrees', Math.PI / 180], ['°', Math.PI / 180], ['rev', 2 * Math.PI],
  ['m/s', 1], ['mm/s', 1e-3], ['cm/s', 1e-2], ['km/h', 1 / 3.6],
  ['rad/s', 1], ['deg/s', Math.PI / 180], ['°/s', Math.PI / 180], ['rpm', Math.PI / 30],
  ['n', 1], ['j', 1], ['n·m', 1], ['nm', 1], ['1', 1], ['-', 1], ['', 1],
]);

const KINDS: Record<string, readonly string[]> = {
  time: ['s', 'sec', 'seconds', 'ms', 'min', ''],
  length: ['m', 'mm', 'cm', 'km', 'in', 'ft', ''],
  angle: ['rad', 'deg', 'degrees', '°', 'rev', ''],
  'length rate': ['m/s', 'mm/s', 'cm/s', 'km/h', ''],
  'angle rate': ['rad/s', 'deg/s', '°/s', 'rpm', ''],
};

/** `alpha_fp`, `ALPHA-FP` and `alphaFp` are one name. */
export function plainName(name: string): string {
  return name.toLowerCase().replace(/[\s_-]+/g, '');
}

/** Splits `alpha [deg]`, `time (s)` and `alpha_deg`-free titles into name and unit. */
export function splitTitle(title: string): { name: string; unit: string } {
  const match = /^(.*?)\s*[[(]\s*([^\])]*)\s*[\])]\s*$/.exec(title.trim());
  return match ? { name: match[1]!.trim(), unit: match[2]!.trim().toLowerCase() } : { name: title.trim(), unit: '' };
}

/** Names a column can have in a system: canonical name and kind by plain name. */
function vocabulary(meta: SystemMeta): Map<string, { name: string; kind: string }> {
  const words = new Map<string, { name: string; kind: string }>();
  for (const time of ['t', 'time', 'seconds']) words.set(time, { name: 't', kind: 'time' });
  for (const q of meta.coordinates) {
    words.set(plainName(q.name), { name: q.name, kind: q.kind });
    words.set(plainName(`${q.name}_dot`), { name: `${q.name}_dot`, kind: `${q.kind} rate` });
  }
  for (let i = 1; i <= 8; i++) words.set(`lambda${i}`, { name: `lambda_${i}`, kind: 'plain' });
  for (const other of ['energy', 'residual']) words.set(other, { name: other, kind: 'plain' });
  return words;
}

/**
 * Finds the system whose coordinates are all there (the one with most, if several) and how each column is used.
 * A text answer says why no system fits.
 */
export function readHeader(titles: readonly string[], systems: Readonly<Record<string, SystemMeta>>): HeaderReading | string {
  const names = titles.map((t) => plainName(splitTitle(t).name));
  const fitting = Object.entries(systems)
    .filter(([, meta]) => meta.coordinates.every((q) => names.includes(plainName(q.name))))
    .sort((a, b) => b[1].coordinates.length - a[1].coordinates.length)[0];
  if (!fitting) return whyNone(names, systems);
  const [systemId, meta] = fitting;
  const words = vocabulary(meta);
  const uses: ColumnUse[] = [];
  const notes: string[] = [];
  const ignored: string[] = [];
  for (const [index, title] of titles.entries()) {
    const { unit } = splitTitle(title);
    const word = words.get(names[index]!);
    if (!word) {
      if (title.trim()) ignored.push(title.trim());
      continue;
    }
    if (uses.some((u) => u.name === word.name)) {
      notes.push(`column ${index + 1} repeats "${word.name}"; the first is used`);
      continue;
    }
    const factor = UNITS.get(unit);
    const allowed = KINDS[word.kind];
    if (factor === undefined || (allowed && !allowed.includes(unit))) {
      return `column "${title.trim()}": the unit "${unit}" is not understood for ${word.name}; right would be ${(allowed ?? ['']).filter(Boolean).join(', ') || 'none'}`;
    }
    if (factor !== 1) notes.push(`"${title.trim()}" was converted to SI`);
    uses.push({ index, name: word.name, factor, title: title.trim() });
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

function whyNone(names: readonly string[], systems: Readonly<Record<string, SystemMeta>>): string {
  const nearest = Object.values(systems)
    .map((meta) => ({ meta, missing: meta.coordinates.filter((q) => !names.includes(plainName(q.name))).map((q) => q.name) }))
    .sort((a, b) => a.missing.length / a.meta.coordinates.length - b.missing.length / b.meta.coordinates.length)[0]!;
  return `the header names no system's coordinates; nearest is ${nearest.meta.title}, where ${nearest.missing.join(', ')} ${nearest.missing.length === 1 ? 'is' : 'are'} missing`;
}
