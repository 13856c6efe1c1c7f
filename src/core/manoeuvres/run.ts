import type { Feedback } from '../mechanics/forcing.ts';
import type { System } from '../model/system.ts';
import { columnsOf, groundCoordinates } from '../motion/columns.ts';
import { integral } from '../motion/integral.ts';
import { caseColumns } from '../motion/caseMeasures.ts';
import type { Scenario, ScenarioFile } from '../scenario/types.ts';
import { normal, uniform } from '../scenario/chance.ts';
import { Simulation, type RunEnd } from '../simulation/simulation.ts';
import { reduced, valuesOf } from './measure.ts';
import { patched, type CheckedTest, type Distribution } from './testFile.ts';

/** A number of one run, and how that run ended. */
export interface Measured {
  /** NaN where the run has none. */
  value: number;
  end: RunEnd;
}

/** A run of a test. */
export interface TestRun {
  file: ScenarioFile;
  /**
   * What its controller is designed for: the same without what was drawn of the vehicle, which a controller does not know; but
   * with what was drawn of the controller itself.
   */
  designedFor: ScenarioFile;
  drawn: Record<string, number>;
}

/**
 * One, or as many as the test's spread has, each with what was drawn for it.
 *
 * @param test checked
 * @param file the scenario as written
 */
export function runsOf(test: CheckedTest, file: ScenarioFile): TestRun[] {
  const base = patched(file, test.scenario);
  const { spread } = test;
  if (!spread) return [{ file: base, designedFor: base, drawn: {} }];
  return Array.from({ length: spread.count }, (_, run) => {
    const drawn = Object.fromEntries(
      Object.entries(spread.vary).map(([path, distribution], stream) => [
        path,
        drawnFrom(distribution, spread.seed ?? 0, stream, run),
      ]),
    );
    const withDrawn = (only: RegExp): ScenarioFile =>
      Object.entries(drawn)
        .filter(([path]) => only.test(path))
        .reduce((next, [path, value]) => patched(next, nested(path.split('.'), value)), base);
    return { file: withDrawn(/^/), designedFor: withDrawn(/^control\./), drawn };
  });
}

function drawnFrom(distribution: Distribution, seed: number, stream: number, run: number): number {
  if ('normal' in distribution) return distribution.normal[0] + distribution.normal[1] * normal(seed, stream, run);
  const share = uniform(seed, stream, run);
  if ('uniform' in distribution)
    return distribution.uniform[0] + share * (distribution.uniform[1] - distribution.uniform[0]);
  return distribution.list[Math.floor(share * distribution.list.length)]!;
}

function nested([key, ...rest]: readonly string[], value: number): Record<string, unknown> {
  return { [key!]: rest.length === 0 ? value : nested(rest, value) };
}

/**
 * Computes a run and measures it; its rows are handed to `look`, for a picture.
 *
 * @param test checked
 * @param scenario checked, SI
 * @param system that the scenario names
 * @param feedback by input; null where there is no controller
 * @param look is told the rows, by column
 * @throws ScenarioError, StartError, Error
 */
export function measureRun(
  test: CheckedTest,
  scenario: Scenario,
  system: System,
  feedback: ReadonlyMap<string, Feedback> | null,
  look: (columns: ReadonlyMap<string, Float64Array>) => void = () => {},
): Measured {
  const simulation = new Simulation(scenario, system, { extras: ['energy', 'inputs'], feedback });
  simulation.advance(() => false);
  const { columns, rows } = simulation.takeChunk();
  const recorded = new Map(simulation.columns.map((name, i) => [name, columns[i]!]));
  const end = simulation.end!;
  look(recorded);
  if (end.reason !== 'end' && !test.stops) return { value: NaN, end };
  const t = recorded.get('t')!;
  const from = test.after === undefined ? 0 : t.findIndex((time) => time >= test.after! - 1e-9);
  const column = caseColumns(system, scenario.parameters, (name) => recorded.get(name));
  const { parsed } = test;
  if ('fact' in parsed) return { value: factOf(parsed.fact, system, end, t, column), end };
  const names = columnsOf(system, [...recorded.keys()])
    .map(({ name }) => name)
    .filter((name) => /^[A-Za-z_]\w*$/.test(name));
  const values = valuesOf(parsed.expression, ['t', ...names.filter((n) => n !== 't')], column, rows);
  const start = from < 0 ? rows : from;
  return { value: reduced(parsed.kind, t.subarray(start), values.subarray(start)), end };
}

function factOf(
  fact: string,
  system: System,
  end: RunEnd,
  t: Float64Array,
  column: (name: string) => Float64Array,
): number {
  if (fact === 'time') return end.time;
  const span = t.at(-1)! - t[0]!;
  if (fact === 'distance') return groundCoordinates(system.meta).length > 0 ? column('path').at(-1)! : NaN;
  const work = integral(t, column('power.gross'));
  if (fact === 'work') return work;
  // 1 W for an hour is 1 Wh.
  if (fact === 'batteryHour') return work / span;
  return groundCoordinates(system.meta).length > 0 ? work / column('path').at(-1)! : NaN;
}
