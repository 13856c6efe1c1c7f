import { parentPort, workerData } from 'node:worker_threads';
import { feedbackOf } from '../core/control/design/feedback.ts';
import '../core/simulation/everyMotion.ts';
import { runOne, type StudyRow } from '../core/sweep/runOne.ts';
import { sharedFeedback } from '../core/sweep/sharedFeedback.ts';
import { systemMetas } from '../core/systems/registry.ts';
import { loadStudy } from './study.ts';

/** What a worker is asked for. */
export type Ask = readonly number[];
/** What it says: a row, or that it has none to do. */
export type Say = StudyRow | 'idle';

/** Computes the runs that the main thread names, one after the other. */
export async function workOnSweep(): Promise<void> {
  const { study, system } = await loadStudy(workerData as string);
  const design = sharedFeedback(feedbackOf);
  parentPort!.on('message', (indices: Ask) => {
    for (const index of indices)
      parentPort!.postMessage(runOne(study, index, system, systemMetas, design) satisfies Say);
    parentPort!.postMessage('idle' satisfies Say);
  });
  parentPort!.postMessage('idle' satisfies Say);
}
