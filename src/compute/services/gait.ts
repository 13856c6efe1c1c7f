import '../../core/simulation/everyMotion.ts';
import { holdSpeed, type GaitReport } from '../../core/gait/measureGait.ts';
import { optimiseGait, type SearchState } from '../../core/gait/optimiseGait.ts';
import type { Caller, Handlers } from '../remote/serve.ts';
import type { GaitCalls, GaitRequest } from './gaitTypes.ts';
import { systemOf } from './load.ts';
import { nextTurn } from './nextTurn.ts';

export const calls: Handlers<GaitCalls> = { 'gait.find': find };

/** One run at a time, with a look at the mailbox between two. */
async function find(
  { system: id, gait, search, ...run }: GaitRequest,
  { signal, emit }: Caller<SearchState, never>,
): Promise<GaitReport | null> {
  const system = await systemOf({ system: id });
  let best: GaitReport | null = null;
  const running = search ? optimiseGait(system, gait, run, search) : holdSpeed(system, gait, run);
  for (let next = running.next(); ; next = running.next()) {
    if (next.done) return next.value;
    const state = 'tried' in next.value ? next.value : { tried: 1, best: next.value };
    best = state.best;
    emit({ ...state });
    await nextTurn();
    if (signal.aborted) return search ? best : null;
  }
}
