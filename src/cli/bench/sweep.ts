import '../../core/simulation/everyMotion.ts';
import { RunMeasurer, type SweepMeasure } from '../../core/motion/sweepMeasures.ts';
import type { EngineId, ScenarioFile } from '../../core/scenario/types.ts';
import { RepeatedRuns } from '../../core/simulation/repeatedRuns.ts';
import { systems } from '../../core/systems/all.ts';
import type { Caller, Job } from './apart.ts';
import { Checksum, processorTime, settle } from './measure.ts';
import { scenarioOf } from './states.ts';
import { caseNamed } from './stepping.ts';

/** Leans at the start, rad: 5 to 15 degrees. */
const [FROM, TO] = [Math.PI / 36, Math.PI / 12];
const MEASURE: SweepMeasure = { kind: 'end', column: 'alpha_fp' };
/** The same sweep again; the least time counts. */
const REPEATS = 5;
export const TOLERANCES = { rtol: 1e-6, atol: 1e-8 } as const;

export interface SweepReport {
  runs: number;
  /** Processor time of one run on one core, from its file to what is measured, ms; by engine. */
  perRun: Record<EngineId, number>;
  /** Steps of a run, on average. */
  steps: number;
  /** Of what was measured. */
  checksum: string;
}

/** The file of one run of a sweep: the falling board for a second, with projection and the event of dependent constraints. */
export function fileOf(run: number, runs: number, engine: EngineId): ScenarioFile {
  return {
    ...caseNamed('falling-report'),
    initial: { alpha: FROM + ((TO - FROM) * run) / (runs - 1) },
    duration: 1,
    method: { name: 'dopri5', ...TOLERANCES, engine },
  };
}

/** Many runs that differ in their start, as the page's sweep makes them. */
export function sweep(runs: number, call: Caller): SweepReport {
  const [wasm, typescript] = (['wasm', 'typescript'] as const).map((engine) => call(sweepJob, runs, engine));
  if (wasm!.checksum !== typescript!.checksum) throw new Error('the engines do not agree');
  return {
    runs,
    perRun: { wasm: wasm!.perRun, typescript: typescript!.perRun },
    steps: wasm!.steps,
    checksum: wasm!.checksum,
  };
}

export const sweepJob: Job<[number, EngineId], { perRun: number; steps: number; checksum: string }> = {
  module: import.meta.url,
  name: 'sweepJob',
  run: (runs, engine) => {
    let [least, steps, checksum] = [Infinity, 0, ''];
    for (let repeat = 0; repeat < REPEATS; repeat++) {
      const sum = new Checksum();
      steps = 0;
      settle();
      const from = processorTime();
      for (let run = 0; run < runs; run++) {
        const { value, counts } = measured(fileOf(run, runs, engine));
        sum.add(value);
        steps += counts.steps;
      }
      least = Math.min(least, (1000 * (processorTime() - from)) / runs);
      checksum = sum.text;
    }
    return { perRun: least, steps: steps / runs, checksum };
  },
};

const repeated = new RepeatedRuns();

function measured(file: ScenarioFile) {
  const checked = scenarioOf(file);
  // The measure is in the last row alone.
  const scenario = { ...checked, outputStep: checked.duration };
  const system = systems[scenario.system]!;
  const simulation = repeated.next(scenario, system, { extras: [] });
  const measurer = new RunMeasurer(system, scenario.parameters, simulation.columns, [MEASURE], simulation.q);
  simulation.advance(() => false);
  const { columns, rows } = simulation.takeChunk();
  measurer.take(columns, rows);
  const { counts } = simulation;
  return { value: measurer.result(simulation.end!, counts, 0)[0]!, counts };
}
