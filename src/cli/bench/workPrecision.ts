import type { Caller, Job } from './apart.ts';
import { Checksum, settle } from './measure.ts';
import { ENOUGH, boards, caseNamed, timedRun } from './stepping.ts';
import { methods, type MethodInfo } from '../../core/integrators/methods.ts';
import type { ScenarioFile } from '../../core/scenario/types.ts';

/**
 * Error at the end of a run against its work, for every method (the diagrams of Hairer, Nørsett and Wanner, Solving
 * ODEs I, section II.10). The two runs are short enough to have one answer: a falling board magnifies a difference
 * by 1e5 within its first second.
 */
export const problems = {
  coasting: { ...boards.coasting, outputStep: 0.5, events: { touchdown: 'ignore' } },
  falling: { ...caseNamed('falling-report'), duration: 1, outputStep: 1 },
} as const satisfies Record<string, ScenarioFile>;

export type Problem = keyof typeof problems;

export interface Settings {
  rtol: readonly number[];
  /** Numbers of steps of fixed-step methods. */
  steps: readonly number[];
  /** A curve ends with the first run that is cut short by this many evaluations. */
  mostEvaluations: number;
  /** rtol of the truth. */
  truth: number;
  /** Each run is repeated for this long, s; its least time counts. */
  seconds: number;
}

export const FULL: Settings = {
  rtol: [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11],
  steps: Array.from({ length: 13 }, (_, k) => 2 ** (k + 5)),
  mostEvaluations: 150_000,
  truth: 1e-13,
  seconds: 0.1,
};
export const BRIEF: Settings = {
  rtol: [1e-4, 1e-6],
  steps: [512, 2048],
  mostEvaluations: 20_000,
  truth: 1e-10,
  seconds: 0,
};

/** atol is this share of rtol, as in the defaults. */
const ATOL = 0.01;

/** Warm-up before a curve is timed, in the time that a point gets. */
const WARM_UP = 10;

export interface WorkPoint {
  method: string;
  stages: number | null;
  /** Of adaptive methods. */
  rtol: number | null;
  /** Of fixed-step methods, s. */
  step: number | null;
  /** Largest of all coordinates and velocities, each relative to its size where that is above 1. */
  error: number;
  evaluations: number;
  jacobians: number;
  steps: number;
  rejected: number;
  /** Processor time, the least of several runs; of the run alone. */
  seconds: number;
}

export interface WorkReport {
  points: WorkPoint[];
  /** Largest difference between the two runs of the truth, in the error's measure: errors below it say nothing. */
  floor: number;
  /** Of all runs' last states. */
  checksum: string;
}

export function workPrecision(problem: Problem, settings: Settings, call: Caller): WorkReport {
  const [truth, other] = [
    call(truthJob, problem, 'dop853', settings.truth),
    call(truthJob, problem, 'gauss', settings.truth),
  ];
  const curves = variants().map(({ id, stages }) => call(curveJob, problem, id, stages, truth, settings));
  const sum = new Checksum();
  for (const { states } of curves) for (const x of states.flat()) sum.add(x);
  return { points: curves.flatMap((curve) => curve.points), floor: errorOf(other, truth), checksum: sum.text };
}

/** Every method with every number of stages it offers. */
function variants(): { id: string; stages: number | null }[] {
  return methods.flatMap((method: MethodInfo) =>
    (method.stages ?? [null]).map((stages) => ({ id: method.id, stages })),
  );
}

export const truthJob: Job<[Problem, 'dop853' | 'gauss', number], number[]> = {
  module: import.meta.url,
  name: 'truthJob',
  run: (problem, name, rtol) => {
    const method = { name, ...(name === 'gauss' ? { stages: 4 } : {}), rtol, atol: ATOL * rtol };
    return lastState({ ...problems[problem], method }, Infinity).state!;
  },
};

export const curveJob: Job<
  [Problem, string, number | null, readonly number[], Settings],
  { points: WorkPoint[]; states: number[][] }
> = {
  module: import.meta.url,
  name: 'curveJob',
  run: (problem, name, stages, truth, settings) => {
    const { adaptive } = methods.find((m) => m.id === name)!;
    const { duration } = problems[problem];
    const fixed = settings.steps.map((steps) => ({ step: duration / steps }));
    const varied = settings.rtol.map((rtol) => ({ rtol, atol: ATOL * rtol }));
    const raws = (adaptive ? varied : fixed).map((setting) => ({
      ...problems[problem],
      method: { name, ...(stages === null ? {} : { stages }), ...setting } as Record<string, unknown>,
    }));
    // First all of them once, for the numbers; then again as a warm-up; then each for its time.
    const runs = raws.map((raw) => ({ raw, ...lastState(raw, settings.mostEvaluations) }));
    const cut = runs.findIndex((run) => run.end === ENOUGH);
    // A run that failed (a step too coarse for the motion) leaves no point; a finer one may succeed.
    const kept = (cut < 0 ? runs : runs.slice(0, cut)).filter((run) => run.state !== null);
    for (let spent = 0; spent < WARM_UP * settings.seconds && kept.length > 0;)
      for (const { raw } of kept) spent += timedRun(raw).seconds;
    settle();
    const points = kept.map(({ raw, state, counts }) => ({
      method: name,
      stages,
      rtol: (raw.method['rtol'] as number | undefined) ?? null,
      step: (raw.method['step'] as number | undefined) ?? null,
      error: digits(errorOf(state!, truth)),
      evaluations: counts.evaluations,
      jacobians: counts.jacobians,
      steps: counts.steps,
      rejected: counts.rejected,
      seconds: digits(leastTime(raw, settings.seconds)),
    }));
    return { points, states: kept.map((run) => run.state!) };
  },
};

/** q and v at the end, or null where the run did not get there; work, and why it ended. */
function lastState(raw: unknown, mostEvaluations: number) {
  const { simulation } = timedRun(raw, (s) => s.counts.evaluations > mostEvaluations);
  const { columns, rows } = simulation.takeChunk();
  const end = simulation.end!.reason;
  return { state: end === 'end' ? columns.slice(1).map((c) => c[rows - 1]!) : null, counts: simulation.counts, end };
}

function leastTime(raw: unknown, seconds: number): number {
  let [least, total] = [Infinity, 0];
  for (let k = 0; k < 2 || total < seconds; k++) {
    const run = timedRun(raw).seconds;
    least = Math.min(least, run);
    total += run;
    if (seconds === 0) break;
  }
  return least;
}

export function errorOf(state: readonly number[], truth: readonly number[]): number {
  return Math.max(...state.map((x, i) => Math.abs(x - truth[i]!) / Math.max(1, Math.abs(truth[i]!))));
}

/** Measured numbers, as many digits as they are worth. */
function digits(x: number): number {
  return Number(x.toPrecision(5));
}

/** What a curve costs at an error, by straight lines between its points on logarithmic axes; null beyond its ends. */
export function costAt(points: readonly WorkPoint[], error: number, cost: 'evaluations' | 'seconds'): number | null {
  for (let k = 1; k < points.length; k++) {
    const [a, b] = [points[k - 1]!, points[k]!];
    if (a.error > error && b.error <= error) {
      const share = Math.log(a.error / error) / Math.log(a.error / b.error);
      return a[cost] * (b[cost] / a[cost]) ** share;
    }
  }
  return null;
}

export function csvOf({ points }: WorkReport): string {
  const names = [
    'method',
    'stages',
    'rtol',
    'step',
    'error',
    'evaluations',
    'jacobians',
    'steps',
    'rejected',
    'seconds',
  ] as const;
  return (
    [names.join(','), ...points.map((point) => names.map((name) => point[name] ?? '').join(','))].join('\n') + '\n'
  );
}
