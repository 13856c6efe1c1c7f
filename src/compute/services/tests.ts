import { measureRun, type Measured } from '../../core/manoeuvres/run.ts';
import { groundCoordinates } from '../../core/motion/columns.ts';
import { checkScenario } from '../../core/scenario/schema.ts';
import '../../core/simulation/everyMotion.ts';
import type { Handlers } from '../remote/serve.ts';
import { feedbackFor, systemOf } from './load.ts';
import { metas } from './metas.ts';
import type { TestAnswer, TestRequest, TestsCalls } from './testsTypes.ts';

/** Points of a picture. */
const POINTS = 240;

export const calls: Handlers<TestsCalls> = { 'tests.measure': measure };

let last: { asked: string; feedback: ReturnType<typeof feedbackFor> } | null = null;

async function measure({ test, file, designedFor }: TestRequest): Promise<TestAnswer> {
  const from = performance.now();
  let picture: TestAnswer['picture'] = null;
  let measured: Measured | string;
  try {
    const scenario = checkScenario(file, metas);
    const system = await systemOf(scenario);
    // The runs of a spread share their design.
    const asked = JSON.stringify(designedFor);
    if (last?.asked !== asked) last = { asked, feedback: feedbackFor(checkScenario(designedFor, metas), system) };
    const feedback = await last.feedback;
    const ground = groundCoordinates(system.meta);
    measured = measureRun(test, scenario, system, feedback, (columns) => {
      const [x, y] = ground.map((name) => columns.get(name)!);
      if (x && y) picture = { x: thinned(x), y: thinned(y) };
    });
  } catch (error) {
    last = null;
    measured = error instanceof Error ? error.message : String(error);
  }
  return { measured, seconds: (performance.now() - from) / 1000, picture };
}

function thinned(values: Float64Array): number[] {
  const step = Math.max(1, Math.ceil(values.length / POINTS));
  return Array.from({ length: Math.ceil(values.length / step) }, (_, i) => values[i * step]!);
}
