/** The gait that costs least at a speed, over frequency, phase between the feet and harmonics; its amplitude holds the speed. */
import type { System } from '../model/system.ts';
import type { Gait } from './gait.ts';
import { GaitError, holdSpeed, type GaitReport, type GaitRun } from './measureGait.ts';
import { nelderMead } from './nelderMead.ts';

export interface Search {
  /** Orders of harmonics that may come in. */
  harmonics: readonly number[];
  /** A foot goes no further, rad. */
  mostAmplitude: number;
  /** Hz. */
  frequencies: readonly [low: number, high: number];
  /** Gaits that are tried. */
  most: number;
}

export const SEARCH: Search = { harmonics: [], mostAmplitude: 0.35, frequencies: [0.5, 4], most: 60 };

export interface SearchState {
  tried: number;
  /** The cheapest so far; null until one holds the speed. */
  best: GaitReport | null;
}

/** Edges of the first simplex: a fifth in frequency, a quarter turn of phase, a tenth of the amplitude in a harmonic. */
const [FREQUENCY_STEP, PHASE_STEP, HARMONIC_STEP] = [Math.log(1.2), Math.PI / 4, 0.1] as const;
/** J/m. */
const TOLERANCE = 2e-5;

/**
 * Searches from a gait on; yields after every run.
 *
 * @param system with feet in its meta
 * @param start where the search begins
 * @param run the speed that is to be held, m/s
 * @param search its steps and limits
 * @returns the cheapest gait that was found
 * @throws GaitError where none holds the speed
 */
export function* optimiseGait(
  system: System,
  start: Gait,
  run: GaitRun,
  search: Search = SEARCH,
): Generator<SearchState, GaitReport> {
  const state: SearchState = { tried: 0, best: null };
  let { amplitude } = start;
  const given = search.harmonics.map((order) => start.harmonics.find((h) => h.order === order));
  const first = [Math.log(start.frequency), start.phase, ...given.flatMap((h) => [h?.cosine ?? 0, h?.sine ?? 0])];
  const gaitAt = ([frequency, phase, ...rest]: readonly number[]): Gait => ({
    ...start,
    amplitude,
    frequency: Math.exp(frequency!),
    phase: phase!,
    harmonics: search.harmonics.map((order, k) => ({ order, cosine: rest[2 * k]!, sine: rest[2 * k + 1]! })),
  });
  const cost = function* (x: readonly number[]): Generator<SearchState, number> {
    const gait = gaitAt(x);
    const [low, high] = search.frequencies;
    if (gait.frequency < low || gait.frequency > high) return Infinity;
    try {
      const holding = holdSpeed(system, gait, run);
      for (let next = holding.next(); ; next = holding.next()) {
        if (!next.done) {
          yield state;
          continue;
        }
        const report = next.value;
        if (report.gait.amplitude > search.mostAmplitude) return Infinity;
        amplitude = report.gait.amplitude;
        if (!state.best || report.cost < state.best.cost) state.best = report;
        return report.cost;
      }
    } catch (error) {
      if (!(error instanceof GaitError)) throw error;
      return Infinity;
    }
  };
  const edges = [FREQUENCY_STEP, PHASE_STEP, ...given.flatMap(() => [HARMONIC_STEP, HARMONIC_STEP])];
  const simplex = nelderMead(first, edges, TOLERANCE, search.most);
  for (let asked = simplex.next(); !asked.done;) {
    const value = yield* cost(asked.value);
    state.tried++;
    yield state;
    asked = simplex.next(value);
  }
  if (!state.best) throw new GaitError(`no gait was found that holds ${run.speed} m/s`);
  return state.best;
}
