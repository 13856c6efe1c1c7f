import { feedbackOf } from '../src/core/control/design/feedback.ts';
export { seeded } from '../src/cli/bench/states.ts';
import { checkScenario } from '../src/core/scenario/schema.ts';
import type { Scenario } from '../src/core/scenario/types.ts';
import '../src/core/simulation/everyMotion.ts';
import { Simulation, type Continuation, type RunCounts, type RunEnd } from '../src/core/simulation/simulation.ts';
import { systems } from '../src/core/systems/all.ts';

export const metas = Object.fromEntries(Object.entries(systems).map(([id, s]) => [id, s.meta]));

export function scenarioOf(raw: unknown): Scenario {
  return checkScenario(raw, metas);
}

export interface FinishedRun {
  columns: Map<string, Float64Array>;
  rows: number;
  end: RunEnd;
  counts: RunCounts;
  simulation: Simulation;
}

/** Runs a scenario file to its end, with all extra columns. */
export function runOf(raw: unknown): FinishedRun {
  const scenario = scenarioOf(raw);
  const system = systems[scenario.system]!;
  const simulation = new Simulation(scenario, system, {
    extras: ['lambda', 'energy', 'residual', 'inputs'],
    feedback: feedbackOf(scenario, system),
  });
  simulation.advance(() => false);
  const { columns, rows } = simulation.takeChunk();
  return {
    columns: new Map(simulation.columns.map((name, i) => [name, columns[i]!])),
    rows,
    end: simulation.end!,
    counts: simulation.counts,
    simulation,
  };
}

/** State at the end of a run, or why there is none. */
export function endOf(raw: object, from?: Continuation): Continuation {
  const scenario = scenarioOf({ outputStep: 1000, ...raw });
  const system = systems[scenario.system]!;
  const simulation = new Simulation(scenario, system, { feedback: feedbackOf(scenario, system), from });
  simulation.advance(() => false);
  if (simulation.end!.reason !== 'end') throw new Error(simulation.end!.message);
  const { columns, rows } = simulation.takeChunk();
  const last = columns.map((c) => c[rows - 1]!);
  const n = system.meta.coordinates.length;
  return { time: last[0]!, q: last.slice(1, n + 1), v: last.slice(n + 1, 2 * n + 1) };
}

/** Largest difference of two states. */
export const distance = (a: Continuation, b: Continuation): number =>
  Math.max(...[...a.q, ...a.v].map((x, i) => Math.abs(x - [...b.q, ...b.v][i]!)));
