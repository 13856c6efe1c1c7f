import { cases } from '../../core/systems/registry.ts';
import { methods } from '../../core/integrators/methods.ts';
import type { ScenarioFile } from '../../core/scenario/types.ts';
import '../../core/simulation/everyMotion.ts';
import { Simulation } from '../../core/simulation/simulation.ts';
import { systems } from '../../core/systems/all.ts';
import type { Caller, Job } from './apart.ts';
import { Checksum, processorTime, settle, timesOf, type MeasureOptions, type Times } from './measure.ts';
import { scenarioOf } from './states.ts';

/** The boards that methods are timed on: the report's hanging one, and the rolling one just after its release. */
export const boards = {
  hanging: { ...caseNamed('hanging'), duration: 2 },
  coasting: { version: 1, system: 'ripstik', initial: { X_dot: 1, alpha: '0.5 deg' }, duration: 0.5 },
} as const satisfies Record<string, ScenarioFile>;

export type Board = keyof typeof boards;

/** Of fixed-step methods, s; adaptive ones take the default tolerances. */
export const FIXED_STEP = 0.001;

/** Warm-up before anything is counted, in samples' lengths. */
const WARM_UP = 40;

export interface SteppingReport {
  /** Accepted steps per second of processor time: what a run does, with projection, events and rows. */
  stepsPerSecond: number;
  quartiles: readonly [number, number];
  /** Seconds of motion per second of processor time. */
  realTime: number;
  steps: number;
  evaluations: number;
  jacobians: number;
  rejected: number;
  /** Microseconds per step. */
  perStep: Times;
  /** Of the last row. */
  checksum: string;
}

export function caseNamed(id: string): ScenarioFile {
  return cases.find((c) => c.id === id)!.scenario;
}

/** How a run ends that is cut short. */
export const ENOUGH = 'enough';

/** A run to its end, or until `enough`; the clock covers the run alone, not its preparation. */
export function timedRun(raw: unknown, enough: (simulation: Simulation) => boolean = () => false) {
  const scenario = scenarioOf(raw);
  const simulation = new Simulation(scenario, systems[scenario.system]!);
  const wall = performance.now();
  const from = processorTime();
  simulation.advance(() => enough(simulation));
  const seconds = processorTime() - from;
  simulation.stop(ENOUGH, 'cut short');
  return { simulation, seconds, wallSeconds: (performance.now() - wall) / 1000 };
}

/** Steps per second of every method on one board. */
export function stepping(board: Board, options: MeasureOptions, call: Caller): Record<string, SteppingReport> {
  return Object.fromEntries(methods.map(({ id }) => [id, call(steppingJob, id, board, options)]));
}

export const steppingJob: Job<[string, Board, MeasureOptions], SteppingReport> = {
  module: import.meta.url,
  name: 'steppingJob',
  run: steppingOf,
};

function steppingOf(name: string, board: Board, options: MeasureOptions): SteppingReport {
  const { adaptive } = methods.find((m) => m.id === name)!;
  const raw = { ...boards[board], method: adaptive ? { name } : { name, step: FIXED_STEP } };
  let first = timedRun(raw);
  for (let spent = first.seconds; spent < WARM_UP * options.seconds; spent += first.seconds) first = timedRun(raw);
  settle();
  const { counts, end, rows } = first.simulation;
  if (end!.reason !== 'end') throw new Error(`${name} on the ${board} board: ${end!.message}`);
  const sum = new Checksum();
  for (const column of first.simulation.takeChunk().columns) sum.add(column[rows - 1]!);
  const processor: number[] = [];
  const wall: number[] = [];
  for (let sample = 0; sample < options.samples; sample++) {
    let [seconds, wallSeconds, steps] = [0, 0, 0];
    // Short runs are put together until a sample is long enough for the clock.
    while (seconds < options.seconds) {
      const run = timedRun(raw);
      seconds += run.seconds;
      wallSeconds += run.wallSeconds;
      steps += counts.steps;
    }
    processor.push((1e6 * seconds) / steps);
    wall.push((1e6 * wallSeconds) / steps);
  }
  const perStep = timesOf(processor, wall, counts.steps);
  const { steps, evaluations, jacobians, rejected } = counts;
  return {
    stepsPerSecond: 1e6 / perStep.median,
    quartiles: [1e6 / perStep.quartiles[1], 1e6 / perStep.quartiles[0]],
    realTime: boards[board].duration / ((perStep.median * steps) / 1e6),
    steps,
    evaluations,
    jacobians,
    rejected,
    perStep,
    checksum: sum.text,
  };
}
