import type { SystemMeta } from '../model/system.ts';
import { leastSizes } from '../simulation/trust.ts';
import { resample } from './resample.ts';
import type { Trajectory } from './trajectory.ts';

export interface Parting {
  /** Time (s) up to which all runs agree to so many digits, as `simulate --verify` counts them. */
  until: Readonly<Record<'4' | '2' | '1', number>>;
  /** To which all of them came, s. */
  compared: number;
}

/**
 * Where runs of one scenario part: digits to which all of them agree, -log10 of the largest spread of a coordinate beside
 * the largest it was so far. That they agree makes none of them right; that they part makes all but one wrong.
 *
 * @param meta of the system that all are of
 * @param runs two or more
 * @returns null for fewer than two, or where they share no time
 */
export function partingOf(meta: SystemMeta, runs: readonly Trajectory[]): Parting | null {
  const [first] = runs;
  if (!first || runs.length < 2 || runs.some((run) => run.length < 2)) return null;
  const compared = Math.min(...runs.map((run) => run.end));
  // The coarsest rows: between its rows a run is only interpolated.
  const coarsest = runs.reduce((shortest, run) => (run.length < shortest.length ? run : shortest), first);
  const times = coarsest.column('t')!.filter((t) => t <= compared);
  if (times.length < 2) return null;
  const worst = new Float64Array(times.length);
  const least = leastSizes(meta);
  for (const [k, { name }] of meta.coordinates.entries()) {
    const values = runs.map((run) => resample(run, name, times)!);
    let size = least[k]!;
    for (const i of times.keys()) {
      const here = values.map((column) => column[i]!);
      size = Math.max(size, ...here.map(Math.abs));
      const spread = (Math.max(...here) - Math.min(...here)) / size;
      worst[i] = Math.max(worst[i]!, Number.isNaN(spread) ? Infinity : spread);
    }
  }
  const until = (digits: number): number => {
    const lost = worst.findIndex((spread) => !(spread <= 10 ** -digits));
    return lost < 0 ? compared : lost === 0 ? 0 : times[lost - 1]!;
  };
  return { until: { 4: until(4), 2: until(2), 1: until(1) }, compared };
}
