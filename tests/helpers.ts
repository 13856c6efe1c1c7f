import { feedbackOf } from '../src/core/control/feedback.ts';
import { checkScenario } from '../src/core/scenario/schema.ts';
import type { Scenario } from '../src/core/scenario/types.ts';
import { Simulation, type RunCounts, type RunEnd } from '../src/core/simulation/simulation.ts';
import { systems } from '../src/core/systems/registry.ts';

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
  const simulation = new Simulation(scenario, system, { extras: ['lambda', 'energy', 'residual', 'inputs'], feedback: feedbackOf(scenario, system) });
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

/** Mulberry32: a small seeded generator, so that a failure can be repeated from the seed it prints. */
export function seeded(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), state | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}
