/** What the page says of eigenvalues: pairs as one, frequency, damping and time constant, which input reaches what. */
import type { ControlAnalysis } from '../../core/control/analysis.ts';
import type { Complex, Mode } from '../../core/control/linearization/spectrum.ts';
import { formatShort, MINUS } from '../../ui/kit/format.ts';

export type Loop = 'open' | 'closed';

/** A mode, or a conjugate pair of them. */
export interface ModeRow {
  key: string;
  loop: Loop;
  /** Imaginary part not negative; parts that are rounding are 0. */
  eigenvalue: Complex;
  moves: readonly string[];
  /** In all states. */
  shape: readonly number[];
}

/** A real part within this share of the largest eigenvalue is rounding. */
const ROUNDING = 1e-9;

/** One row a pair, the fastest growing first. */
export function modeRows(modes: readonly Mode[], loop: Loop): ModeRow[] {
  const scale = Math.max(0, ...modes.map(({ eigenvalue: [re, im] }) => Math.hypot(re, im)));
  return modes
    .filter((mode) => mode.eigenvalue[1] >= 0)
    .map(({ eigenvalue: [re, im], moves, shape }) => ({
      eigenvalue: [Math.abs(re) <= ROUNDING * scale ? 0 : re, im] as Complex,
      moves,
      shape,
    }))
    .sort((a, b) => b.eigenvalue[0] - a.eigenvalue[0] || b.eigenvalue[1] - a.eigenvalue[1])
    .map((row, i) => ({ key: `${loop}-${i}`, loop, ...row }));
}

/** Of an eigenvalue: damped frequency (Hz), damping ratio, and the time (s) in which it grows or decays by the factor e. */
export interface Qualities {
  frequency: number | null;
  damping: number | null;
  time: number | null;
  kind: 'grows' | 'decays' | 'neutral';
}

export function qualitiesOf([re, im]: Complex): Qualities {
  const modulus = Math.hypot(re, im);
  return {
    frequency: im !== 0 ? Math.abs(im) / (2 * Math.PI) : null,
    damping: modulus > 0 ? -re / modulus + 0 : null,
    time: re !== 0 ? 1 / Math.abs(re) : null,
    kind: re > 0 ? 'grows' : re < 0 ? 'decays' : 'neutral',
  };
}

/** `−7.585 ± 28.15i`. */
export function eigenvalueText([re, im]: Complex, digits = 4): string {
  if (im === 0) return formatShort(re, digits);
  const imaginary = `${formatShort(Math.abs(im), digits)}i`;
  return re === 0 ? `±${imaginary}` : `${formatShort(re, digits)} ± ${imaginary}`;
}

/** Rows at one place in the plane. */
export interface Cluster {
  eigenvalue: Complex;
  rows: ModeRow[];
}

export function clustersOf(rows: readonly ModeRow[]): Cluster[] {
  const scale = Math.max(0, ...rows.map(({ eigenvalue: [re, im] }) => Math.hypot(re, im)));
  const clusters: Cluster[] = [];
  for (const row of rows) {
    const near = clusters.find(
      (c) => c.rows[0]!.loop === row.loop && apart(c.eigenvalue, row.eigenvalue) <= ROUNDING * scale,
    );
    if (near) near.rows.push(row);
    else clusters.push({ eigenvalue: row.eigenvalue, rows: [row] });
  }
  return clusters;
}

const apart = (a: Complex, b: Complex): number => Math.hypot(a[0] - b[0], a[1] - b[1]);

/** How many of the modes at one eigenvalue each input reaches by itself. */
export interface ReachRow {
  eigenvalue: Complex;
  moves: readonly string[];
  of: number;
  reached: readonly number[];
}

export function reachRows({ modes, reachability }: Pick<ControlAnalysis, 'modes' | 'reachability'>): ReachRow[] {
  const clusters = clustersOf(modeRows(modes, 'open'));
  const missed = reachability.byInput.map((input) => counts(input.missed, clusters));
  return clusters.map(({ eigenvalue, rows }, i) => ({
    eigenvalue,
    moves: [...new Set(rows.flatMap((row) => row.moves))],
    of: rows.length,
    reached: missed.map((byCluster) => rows.length - byCluster[i]!),
  }));
}

/** Of a list of eigenvalues (upper half), how many belong to each cluster. */
function counts(values: readonly Complex[], clusters: readonly Cluster[]): number[] {
  const result = clusters.map(() => 0);
  for (const value of values.filter(([, im]) => im >= 0)) {
    let best = -1;
    clusters.forEach(({ eigenvalue, rows }, i) => {
      if (result[i]! < rows.length && (best < 0 || apart(eigenvalue, value) < apart(clusters[best]!.eigenvalue, value)))
        best = i;
    });
    if (best >= 0) result[best]!++;
  }
  return result;
}

/** The largest real part, 1/s. */
export function fastestGrowth(values: readonly Complex[]): number {
  return Math.max(...values.map(([re]) => re));
}

/** `+10.99`, with its sign. */
export const signed = (x: number, digits = 4): string =>
  x > 0 ? `+${formatShort(x, digits)}` : formatShort(x, digits).replace('-', MINUS);
