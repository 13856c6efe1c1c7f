import { extrasFor, needsRows, RunMeasurer } from '../../core/motion/sweepMeasures.ts';
import { checkScenario } from '../../core/scenario/schema.ts';
import type { Scenario } from '../../core/scenario/types.ts';
import '../../core/simulation/everyMotion.ts';
import { Simulation } from '../../core/simulation/simulation.ts';
import type { System } from '../../core/model/system.ts';
import type { Caller, Handlers } from '../remote/serve.ts';
import { feedbackFor, systemOf } from './load.ts';
import { learnSystemOf } from '../../core/systems/registry.ts';
import { metas } from './metas.ts';
import type { Measured, MeasureRequest, SweepCalls } from './sweepTypes.ts';

/** Rows after which they are measured and let go. */
const CHUNK_ROWS = 2048;
/** Progress of a long run is told this often. */
const TELL_MS = 200;

export const calls: Handlers<SweepCalls> = { 'sweep.measure': measure };

async function measure(
  { file, measures }: MeasureRequest,
  { emit }: Pick<Caller<number, never>, 'emit'>,
): Promise<Measured> {
  await learnSystemOf(file);
  const checked = checkScenario(file, metas);
  const system = await systemOf(checked);
  const scenario = needsRows(measures, system.meta) ? checked : { ...checked, outputStep: checked.duration };
  const feedback = await designed(scenario, system);
  const from = performance.now();
  const simulation = new Simulation(scenario, system, { extras: extrasFor(measures), feedback });
  const measurer = new RunMeasurer(system, scenario.parameters, simulation.columns, measures, simulation.q);
  let told = from;
  while (!simulation.end) {
    simulation.advance(() => simulation.rows >= CHUNK_ROWS || performance.now() - told > TELL_MS);
    const { columns, rows } = simulation.takeChunk();
    measurer.take(columns, rows);
    if (performance.now() - told <= TELL_MS) continue;
    told = performance.now();
    emit(simulation.time / scenario.duration);
  }
  // A run that ended at its very start still has that row.
  const { columns, rows } = simulation.takeChunk();
  measurer.take(columns, rows);
  const seconds = (performance.now() - from) / 1000;
  const { end, counts } = simulation;
  return { values: measurer.result(end, counts, seconds), end, counts, seconds };
}

let last: { asked: string; feedback: ReturnType<typeof feedbackFor> } | null = null;

/** The state feedback of a run. Runs that ask for the same design one after another, as most of a sweep do, share it. */
function designed(scenario: Scenario, system: System): ReturnType<typeof feedbackFor> {
  const { system: id, parameters, constraints, hold, control } = scenario;
  const asked = JSON.stringify([id, parameters, constraints, hold, control]);
  if (last?.asked !== asked) last = { asked, feedback: feedbackFor(scenario, system) };
  return last.feedback;
}
