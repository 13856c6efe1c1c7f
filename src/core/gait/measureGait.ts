/** What a gait does once it has settled: its speed, what a metre of it costs, and the amplitude that holds a speed. */
import { integral } from '../motion/integral.ts';
import { caseColumns } from '../motion/caseMeasures.ts';
import type { System } from '../model/system.ts';
import { checkScenario } from '../scenario/schema.ts';
import { Simulation } from '../simulation/simulation.ts';
import { gaitScenario, startAt, type Gait } from './gait.ts';

export interface GaitReport {
  gait: Gait;
  /** Mean over the strokes, along the path, m/s. */
  speed: number;
  /** Where the speed would go, by its drift over the strokes and how fast drag lets it, m/s. */
  settledSpeed: number;
  /** Work of the feet less what stays as energy, J/m along the path. */
  cost: number;
  /** The same where nothing is given back: the work of muscles, J/m. */
  grossCost: number;
  /** Cost over weight, a pure number. */
  transport: number;
  /** Largest torque of a foot, N·m. */
  torque: number;
}

export interface GaitRun {
  /** m/s at the start. */
  speed: number;
  /** What of the system is not as its meta has it. */
  parameters?: Readonly<Record<string, number>>;
}

/** Rows a stroke: a trapezium over whole strokes is then exact to rounding for what a gait is made of. */
const ROWS = 64;
/** At least so long until it is measured, and measured, s: three times what drag takes to forget a speed. */
const SETTLE = 15;
const MEASURE = 6;
/** Tolerances at which costs repeat to five digits. */
const METHOD = { name: 'dopri5', rtol: 1e-6, atol: 1e-8 } as const;

/** Why a gait has no figures. */
export class GaitError extends Error {}

/**
 * Runs a gait and measures its last strokes.
 *
 * @param system one whose meta says what its feet are
 * @param gait of both feet; rad, Hz
 * @throws GaitError for a board that falls
 */
export function measureGait(system: System, gait: Gait, { speed, parameters = {} }: GaitRun): GaitReport {
  const { meta } = system;
  const strokes = (seconds: number): number => Math.ceil(seconds * gait.frequency);
  const [settle, count] = [strokes(SETTLE), strokes(MEASURE)];
  const scenario = checkScenario(
    gaitScenario(meta, gait, {
      parameters,
      initial: startAt(meta, speed),
      duration: (settle + count) / gait.frequency,
      outputStep: 1 / (gait.frequency * ROWS),
      method: METHOD,
      events: Object.fromEntries(meta.touchdown ? [['touchdown', 'ignore']] : []),
    }),
    { [meta.id]: meta },
  );
  const simulation = new Simulation(scenario, system, { extras: ['inputs', 'energy'] });
  simulation.advance(() => false);
  const end = simulation.end!;
  if (end.reason !== 'end') throw new GaitError(`the board does not ride with this gait: ${end.message}`);
  const { columns, rows } = simulation.takeChunk();
  const first = rows - 1 - count * ROWS;
  const column = caseColumns(system, scenario.parameters, (name) => {
    const at = simulation.columns.indexOf(name);
    return at < 0 ? undefined : columns[at]!;
  });
  const [t, speeds] = [column('t'), column('speed')];
  const over = (values: Float64Array): number => integral(t, values, first, rows);
  const time = t[rows - 1]! - t[first]!;
  const distance = over(speeds);
  const energy = column('energy');
  const kept = energy[rows - 1]! - energy[first]!;
  const work = over(column('power')) - kept;
  const mass = massOf(system, scenario.parameters);
  const gravity = scenario.parameters['gravity'] ?? 9.81;
  const half = Math.floor(count / 2);
  const meanFrom = (row: number): number => {
    const end = row + half * ROWS;
    return integral(t, speeds, row, end + 1) / (t[end]! - t[row]!);
  };
  const drift = (meanFrom(first + half * ROWS) - meanFrom(first)) / (half / gait.frequency);
  const drag = meta.gait?.drag === undefined ? 0 : scenario.parameters[meta.gait.drag]!;
  return {
    gait,
    speed: distance / time,
    settledSpeed: distance / time + (drag > 0 ? (drift * mass) / (2 * drag) : 0),
    cost: work / distance,
    grossCost: over(column('power.gross')) / distance,
    transport: work / distance / (mass * gravity),
    torque: meta.gait!.feet.reduce(
      (most, foot) =>
        column(foot)
          .subarray(first)
          .reduce((so, u) => Math.max(so, Math.abs(u)), most),
      0,
    ),
  };
}

/** Total mass, kg: what resists a push along X with everything else at rest. */
function massOf(system: System, parameters: Readonly<Record<string, number>>): number {
  const { coordinates, parameters: named } = system.meta;
  const n = coordinates.length;
  const [q, v, M, h] = [n, n, n * n, n].map((size) => new Float64Array(size));
  system.mechanics(
    q!,
    v!,
    Float64Array.from(named, ({ name }) => parameters[name]!),
    M!,
    h!,
  );
  return M![0]!;
}

/** A speed is met when it is within this share of it. */
const CLOSE = 2e-4;
const MOST_TRIES = 8;
/** Amplitudes that a foot can follow, rad. */
const AMPLITUDES = [0.005, 1] as const;

/**
 * The amplitude with which a gait holds a speed: secant steps on the settled speed, which grows with the amplitude.
 *
 * @param system with feet in its meta
 * @param gait whose amplitude is where to begin
 * @param run the speed that is to be held, m/s
 * @returns the last report, whose speed is the one asked for
 * @throws GaitError where no amplitude does
 */
export function* holdSpeed(system: System, gait: Gait, run: GaitRun): Generator<GaitReport, GaitReport> {
  let report = measureGait(system, gait, run);
  let before: GaitReport | null = null;
  for (let i = 0; i < MOST_TRIES; i++) {
    yield report;
    if (Math.abs(report.settledSpeed - run.speed) < CLOSE * run.speed) return report;
    const { amplitude } = report.gait;
    const slope: number =
      before && before.gait.amplitude !== amplitude
        ? (report.settledSpeed - before.settledSpeed) / (amplitude - before.gait.amplitude)
        : run.speed / amplitude;
    const step = (run.speed - report.settledSpeed) / (slope > 0 ? slope : run.speed / amplitude);
    const next = Math.min(Math.max(amplitude + step, amplitude / 2, AMPLITUDES[0]), amplitude * 2, AMPLITUDES[1]);
    before = report;
    report = measureGait(system, { ...gait, amplitude: next }, run);
  }
  throw new GaitError(
    `no amplitude up to ${AMPLITUDES[1]} rad holds ${run.speed} m/s with this gait: the last one gave ${report.settledSpeed.toPrecision(4)} m/s`,
  );
}
