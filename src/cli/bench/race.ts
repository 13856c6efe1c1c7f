import type { Caller, Job } from './apart.ts';
import { Checksum, settle } from './measure.ts';
import { caseNamed, timedRun } from './stepping.ts';
import { otherMethods, reportMethods, type MethodChoice } from '../../core/cases/methodSets.ts';
import { methods } from '../../core/integrators/methods.ts';
import { systems } from '../../core/systems/all.ts';

/** The report's best: collocation, 5.8 s of output in 26.4 s (its Table 1). */
export const REPORT_RATE = 5.8 / 26.4;
/** Runs of each method after the first; the least time counts. */
const REPEATS = 8;

export interface RaceEntry {
  id: string;
  label: string;
  /** Output reached, s; and why it ended there. */
  reached: number;
  end: string;
  /** Processor time, s: the least of the repeats, and the first run in a fresh process, with everything to compile. */
  seconds: number;
  firstSeconds: number;
  /** Seconds of output per second, over the report's best. */
  ratio: number;
  steps: number;
  rejected: number;
  evaluations: number;
  jacobians: number;
  /** Largest |E - E at the start| of a row, of the largest kinetic energy. */
  energyDrift: number;
  /** Largest constraint residual of a row. */
  residual: number;
  checksum: string;
}

/** The falling board as the report has it, for longer, by its four methods and by the default, the last by both engines. */
export function race(duration: number, call: Caller): RaceEntry[] {
  return entrants().map(({ id }) => call(raceJob, id, duration));
}

function entrants(): MethodChoice[] {
  const first = otherMethods.filter((choice) => choice.method.name === methods[0].id);
  const plain = first.map((choice) => ({
    ...choice,
    id: `${choice.id}-typescript`,
    label: `${choice.label}, TypeScript`,
    method: { ...choice.method, engine: 'typescript' as const },
  }));
  return [...reportMethods, ...first, ...plain].filter((choice) => methods.some((m) => m.id === choice.method.name));
}

export const raceJob: Job<[string, number], RaceEntry> = {
  module: import.meta.url,
  name: 'raceJob',
  run: (id, duration) => {
    const choice = entrants().find((c) => c.id === id)!;
    const raw = { ...caseNamed('falling-report'), duration, columns: ['energy', 'residual'], method: choice.method };
    const first = timedRun(raw);
    settle();
    const seconds = Math.min(...Array.from({ length: REPEATS }, () => timedRun(raw).seconds));
    const { simulation } = first;
    const { columns, rows } = simulation.takeChunk();
    const sum = new Checksum();
    for (const column of columns) sum.add(column[rows - 1]!);
    const { steps, rejected, evaluations, jacobians, residual } = simulation.counts;
    const { time: reached, reason: end } = simulation.end!;
    return {
      id,
      label: choice.label,
      reached,
      end,
      seconds,
      firstSeconds: first.seconds,
      ratio: reached / seconds / REPORT_RATE,
      steps,
      rejected,
      evaluations,
      jacobians,
      energyDrift: largestDrift(simulation.dynamics.parameters, columns, simulation.columns.indexOf('energy'), rows),
      residual,
      checksum: sum.text,
    };
  },
};

function largestDrift(p: Float64Array, columns: readonly Float64Array[], energyColumn: number, rows: number): number {
  const system = systems['ripstik']!;
  const n = system.meta.coordinates.length;
  const energy = columns[energyColumn]!;
  const energies = new Float64Array(2);
  let [drift, kinetic] = [0, 0];
  for (let row = 0; row < rows; row++) {
    const state = (from: number): Float64Array => Float64Array.from({ length: n }, (_, i) => columns[from + i]![row]!);
    system.energy(state(1), state(1 + n), p, energies);
    kinetic = Math.max(kinetic, energies[0]!);
    drift = Math.max(drift, Math.abs(energy[row]! - energy[0]!));
  }
  return drift / kinetic;
}
