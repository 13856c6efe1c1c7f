/**
 * The core as a library, for Node and browsers: scenarios in, numbers out, the same as the page and the command line give.
 *
 * ```js
 * import { simulate, linearize } from 'ripstik-lab';
 * const run = await simulate({ version: 1, system: 'ripstik', initial: { X_dot: 1, alpha: '10 deg' }, duration: 2 });
 * console.log(run.end.reason, run.column('alpha').at(-1));
 * ```
 */
import type { ControlReport } from '../core/control/design/report.ts';
import type { Feedback } from '../core/mechanics/forcing.ts';
import type { System } from '../core/model/system.ts';
import { settled, type Written } from '../core/scenario/own.ts';
import { checkScenario } from '../core/scenario/schema.ts';
import type { EngineId, Scenario, ScenarioFile } from '../core/scenario/types.ts';
import type { RunEnd } from '../core/simulation/simulation.ts';
import type { StudyRow } from '../core/sweep/runOne.ts';
import type { StudyFile } from '../core/sweep/study.ts';
import { learnSystemOf, loadSystem, systemMetas } from '../core/systems/registry.ts';

export { StartError } from '../core/mechanics/consistentStart.ts';
export { ScenarioError } from '../core/scenario/types.ts';
export { cases, systemIds, systemMetas } from '../core/systems/registry.ts';
export type { ControlReport, EngineId, RunEnd, Scenario, ScenarioFile, StudyFile, StudyRow };

/** A scenario as its file has it: the id of a system, or the text of its description. */
export type ScenarioInput = Written<ScenarioFile>;

/** A finished run. */
export interface Run {
  /** `t`, coordinates, rates, and what `columns` of the scenario asks for. */
  names: readonly string[];
  /** One array a name, one number a row; SI, radians. */
  columns: readonly Float64Array[];
  /** @throws RangeError where there is no such column */
  column(name: string): Float64Array;
  end: RunEnd;
  engine: EngineId;
  warnings: readonly string[];
}

/** Rows between two turns of the event loop, so that a page stays alive. */
const CHUNK_ROWS = 1024;

/**
 * Runs a scenario.
 *
 * @param scenario as its file has it
 * @param signal ends the run with the reason of the signal
 * @throws ScenarioError with the path of what is wrong, StartError where no start meets the constraints
 */
export async function simulate(
  scenario: ScenarioInput,
  { signal }: { signal?: Pick<AbortSignal, 'throwIfAborted'> } = {},
): Promise<Run> {
  const { checked, system } = await load(scenario);
  const [{ Simulation }, feedback] = await Promise.all([
    import('../core/simulation/simulation.ts'),
    feedbackFor(checked, system),
    import('../core/simulation/everyMotion.ts'),
  ]);
  const simulation = new Simulation(checked, system, { feedback });
  const chunks: Float64Array[][] = [];
  do {
    signal?.throwIfAborted();
    simulation.advance(() => simulation.rows >= CHUNK_ROWS);
    const { columns, rows } = simulation.takeChunk();
    if (rows > 0) chunks.push(columns.map((column) => column.slice(0, rows)));
    await new Promise((resolve) => setTimeout(resolve));
  } while (!simulation.end);
  const names = [...simulation.columns];
  const columns = names.map((_, k) => joined(chunks.map((chunk) => chunk[k]!)));
  return {
    names,
    columns,
    column(name) {
      const place = names.indexOf(name);
      if (place < 0) throw new RangeError(`there is no column "${name}"; there are ${names.join(', ')}`);
      return columns[place]!;
    },
    end: simulation.end,
    engine: simulation.engine,
    warnings: simulation.warnings,
  };
}

/**
 * A, B, modes, gain and closed loop about the scenario's steady motion, as `ripstik-lab linearize` prints them.
 * @throws ScenarioError, StartError
 */
export async function linearize(scenario: ScenarioInput): Promise<ControlReport> {
  const { checked, system } = await load(scenario);
  const [{ controlReport }, { computerReport }] = await Promise.all([
    import('../core/control/design/report.ts'),
    import('../core/control/sampled/computerReport.ts'),
  ]);
  return { ...controlReport(checked, system), ...computerReport(checked, system) };
}

/**
 * The rows of a study, one run after the other.
 *
 * @param study as its file has it
 * @param indices the runs to do; absent: all
 * @throws ScenarioError
 */
export async function* sweep(study: StudyFile, indices?: Iterable<number>): AsyncGenerator<StudyRow, void> {
  await learnSystemOf(study.scenario);
  const [{ checkStudy }, { checkMeasures, runOne }, { sharedFeedback }, { feedbackOf }] = await Promise.all([
    import('../core/sweep/study.ts'),
    import('../core/sweep/runOne.ts'),
    import('../core/sweep/sharedFeedback.ts'),
    import('../core/control/design/feedback.ts'),
    import('../core/simulation/everyMotion.ts'),
  ]);
  const checked = checkStudy({ ...study, scenario: settled(study.scenario) }, systemMetas);
  const system = await loadSystem(checked.file.scenario.system)!;
  checkMeasures(checked, system, systemMetas);
  const design = sharedFeedback(feedbackOf);
  for (const index of indices ?? Array(checked.runs).keys()) {
    yield runOne(checked, index, system, systemMetas, design);
    await new Promise((resolve) => setTimeout(resolve));
  }
}

async function load(scenario: ScenarioInput): Promise<{ checked: Scenario; system: System }> {
  await learnSystemOf(scenario);
  const checked = checkScenario(scenario, systemMetas);
  return { checked, system: await loadSystem(checked.system)! };
}

async function feedbackFor(scenario: Scenario, system: System): Promise<ReadonlyMap<string, Feedback> | null> {
  if (scenario.control?.type !== 'lqr' && scenario.control?.type !== 'ride') return null;
  const { feedbackOf } = await import('../core/control/design/feedback.ts');
  return feedbackOf(scenario, system);
}

function joined(parts: readonly Float64Array[]): Float64Array {
  const whole = new Float64Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}
