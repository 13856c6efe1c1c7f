import { checkScenario } from '../../core/scenario/schema.ts';
import '../../core/simulation/everyMotion.ts';
import { sharedFeedback } from '../../core/sweep/sharedFeedback.ts';
import { reduceRun, type Reduced } from '../../core/sweep/reduceRun.ts';
import type { Caller, Handlers } from '../remote/serve.ts';
import { feedbackFor, systemOf } from './load.ts';
import { learnSystemOf } from '../../core/systems/registry.ts';
import { metas } from './metas.ts';
import type { MeasureRequest, SweepCalls } from './sweepTypes.ts';

/** Progress of a long run is told this often. */
const TELL_MS = 200;

export const calls: Handlers<SweepCalls> = { 'sweep.measure': measure };

async function measure(
  { file, measures }: MeasureRequest,
  { emit }: Pick<Caller<number, never>, 'emit'>,
): Promise<Reduced> {
  await learnSystemOf(file);
  const checked = checkScenario(file, metas);
  const system = await systemOf(checked);
  const feedback = await designed(checked, system);
  let told = performance.now();
  return reduceRun(checked, system, measures, {
    feedback,
    now: () => performance.now(),
    pause: () => performance.now() - told > TELL_MS,
    between(share) {
      told = performance.now();
      emit(share);
    },
  });
}

/** The state feedback of a run. */
const designed = sharedFeedback(feedbackFor);
