import { extrasFor, RunMeasurer } from '../core/motion/sweepMeasures.ts';
import { checkScenario } from '../core/scenario/schema.ts';
import { ScenarioError } from '../core/scenario/types.ts';
import { Simulation } from '../core/simulation/simulation.ts';
import { loadSystem, systemViews } from '../core/systems/registry.ts';
import type { SweepReply, SweepRequest } from './sweepProtocol.ts';

/** Rows after which they are measured and let go. */
const CHUNK_ROWS = 2048;
/** Progress of a long run is told this often. */
const TELL_MS = 200;

const metas = Object.fromEntries(Object.entries(systemViews).map(([id, view]) => [id, view.meta]));

const post = (message: SweepReply): void => self.postMessage(message);

self.addEventListener('message', ({ data }: MessageEvent<SweepRequest>) => void answer(data));

async function answer({ job, file, measures }: SweepRequest): Promise<void> {
  try {
    const scenario = checkScenario(file, metas);
    const system = await loadSystem(scenario.system);
    if (!system) throw new ScenarioError('system', `unknown system "${scenario.system}"`);
    const feedback =
      scenario.control?.type === 'lqr'
        ? (await import('../core/control/design/feedback.ts')).feedbackOf(scenario, system)
        : null;
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
      post({ type: 'progress', job, share: simulation.time / scenario.duration });
    }
    // A run that ended at its very start still has that row.
    const { columns, rows } = simulation.takeChunk();
    measurer.take(columns, rows);
    const seconds = (performance.now() - from) / 1000;
    post({
      type: 'measured',
      job,
      values: measurer.result(simulation.end, simulation.counts, seconds),
      end: simulation.end,
      counts: simulation.counts,
      seconds,
    });
  } catch (error) {
    const path = error instanceof ScenarioError ? error.path : '';
    post({ type: 'refused', job, path, message: error instanceof Error ? error.message : String(error) });
  }
}
