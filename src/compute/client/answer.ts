import { checkScenario } from '../../core/scenario/schema.ts';
import { ScenarioError, type Scenario, type ScenarioFile } from '../../core/scenario/types.ts';
import type { SystemMeta } from '../../core/model/system.ts';
import { RemoteError, WorkerLost } from '../remote/remoteWorker.ts';

/** A value, or why there is none: `path` is the scenario's key that it is about, empty where it is none of them. */
export type Answer<T> = { ok: true; value: T } | { ok: false; path: string; message: string };

export type Metas = Readonly<Record<string, SystemMeta>>;

/**
 * What came of a call.
 *
 * @param advice said of a worker that was lost: what stays, what to do
 * @returns null where it was given up
 */
export async function answerOf<T>(result: Promise<T>, advice = ''): Promise<Answer<T> | null> {
  try {
    return { ok: true, value: await result };
  } catch (error) {
    if (error instanceof DOMException && error.name === 'AbortError') return null;
    if (error instanceof WorkerLost)
      return { ok: false, path: '', message: stopped('the computation', error) + (advice && `; ${advice}`) };
    const path = error instanceof RemoteError ? error.path : '';
    return { ok: false, path, message: error instanceof Error ? error.message : String(error) };
  }
}

/** Says that something stopped, and why if that is known. */
export const stopped = (what: string, { message }: WorkerLost): string =>
  `${what} stopped unexpectedly${message ? ` (${message})` : ''}`;

/** A scenario as it is written, checked here: what is wrong with it is known without a worker. */
export function checked(file: ScenarioFile, metas: Metas): Answer<Scenario> {
  try {
    return { ok: true, value: checkScenario(file, metas) };
  } catch (error) {
    if (!(error instanceof ScenarioError)) throw error;
    return { ok: false, path: error.path, message: error.message };
  }
}
