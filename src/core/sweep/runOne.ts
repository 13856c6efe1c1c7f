import type { Feedback } from '../mechanics/forcing.ts';
import { StartError } from '../mechanics/consistentStart.ts';
import type { System, SystemMeta } from '../model/system.ts';
import { recipeOf } from '../motion/recipes.ts';
import { extrasFor } from '../motion/sweepMeasures.ts';
import { unknownName } from '../scenario/checker.ts';
import { checkScenario } from '../scenario/schema.ts';
import { ScenarioError, type Scenario } from '../scenario/types.ts';
import { Simulation } from '../simulation/simulation.ts';
import { reduceRun } from './reduceRun.ts';
import type { Study } from './study.ts';

/** One row of a study's results. */
export interface StudyRow {
  index: number;
  /** Varied values, one a path. */
  values: (number | string)[];
  /** One a measure; NaN where the run has none. */
  measures: number[];
  /** Why the run ended, a permanent id: `end`, an event's or a failure's, `refused` where there was no run. */
  reason: string;
  /** When it ended, s. */
  time: number;
  /** What computed it; empty where there was no run. */
  engine: string;
  /** Why there was no run, or it stopped. */
  message: string;
}

/**
 * One run of the study. A scenario that is refused, or has no consistent start, is a row that says so.
 *
 * @param study checked
 * @param index from 0
 * @param system that the study names
 * @param systems metas by id
 * @param feedbackOf designs the run's controller
 */
export function runOne(
  study: Study,
  index: number,
  system: System,
  systems: Readonly<Record<string, SystemMeta>>,
  feedbackOf: (scenario: Scenario, system: System) => ReadonlyMap<string, Feedback> | null,
): StudyRow {
  const values = study.values(index);
  try {
    const scenario = checkScenario(study.scenario(index), systems);
    const feedback = feedbackOf(scenario, system);
    const { values: measures, end, engine } = reduceRun(scenario, system, study.measures, { feedback });
    return { index, values, measures, reason: end.reason, time: end.time, engine, message: end.message };
  } catch (error) {
    if (!(error instanceof ScenarioError || error instanceof StartError)) throw error;
    const measures = study.measures.map(() => NaN);
    return { index, values, measures, reason: 'refused', time: NaN, engine: '', message: error.message };
  }
}

/**
 * Tells a measure of a column that no run has, before anything runs.
 *
 * @param study checked
 * @param system that the study names
 * @param systems metas by id
 * @throws ScenarioError
 */
export function checkMeasures(study: Study, system: System, systems: Readonly<Record<string, SystemMeta>>): void {
  let columns: readonly string[];
  const scenario = checkScenario(study.scenario(0), systems);
  try {
    columns = new Simulation(scenario, system, {
      extras: extrasFor(study.measures, system.meta.inputs),
      feedback: null,
    }).columns;
  } catch {
    return; // This run alone has no start: its row says so.
  }
  const has = (name: string): boolean => columns.includes(name);
  study.measures.forEach((measure, i) => {
    if (!('column' in measure) || has(measure.column)) return;
    if (recipeOf(system, scenario.parameters, has, measure.column)) return;
    throw new ScenarioError(`measures.${i}`, unknownName(measure.column, columns.slice(1)));
  });
}
