import { effect, untracked } from '@preact/signals';
import type { Push, PushRecord } from '../../core/simulation/push.ts';
import type { Live } from '../../compute/services/runTypes.ts';
import type { Motion } from '../runs/motion.ts';
import type { StageState } from '../runs/stageState.ts';
import type { PlaybackState } from '../state/playback.ts';
import type { SettingsState } from '../state/settings.ts';
import type { PushState } from './pushState.ts';

/** How far a run is computed ahead of what is seen while something is pushed, in seconds of the clock on the wall. */
const AHEAD_S = 0.05;
/** Rows that must be there to go on playing. */
const AHEAD_ROWS = 2;

export const PUSHED = 'pushed';
export const RELEASED = 'released';

type Timed = Pick<StageState, 'motion' | 'run'> & Pick<PlaybackState, 'time'> & Pick<SettingsState, 'speed'>;

/** What a push needs of the runs. */
export interface Pushable {
  /** Begins a run that goes on from the playback time and can be pushed; false where it can't be. */
  takeOver(push: Push): boolean;
  act(live: Live): void;
}

/** Follows `state.push`: while something is pushed, the run is computed only a little ahead of what is seen. */
export function followPush(state: Timed & PushState, runs: Pushable): void {
  let live = false;
  const horizon = (): number => horizonOf(state);
  const follow = (push: Push | null): void => {
    if (push === null) {
      if (live) runs.act({ push, horizon: null });
      live = false;
    } else if (live && state.run.peek()?.kind === 'computing') runs.act({ push, horizon: horizon() });
    else live = runs.takeOver(push);
  };
  effect(() => {
    const push = state.push.value;
    untracked(() => follow(push));
  });
  effect(() => {
    void state.time.value;
    if (live && state.push.peek()) runs.act({ horizon: horizon() });
  });
}

/** Up to where a pushed run is computed now, s. */
export function horizonOf(state: Pick<Timed, 'motion' | 'time' | 'speed'>): number {
  const rows = AHEAD_ROWS * (state.motion.peek()?.scenario?.outputStep ?? 0);
  return state.time.peek() + Math.max(rows, AHEAD_S * state.speed.peek());
}

/** What a motion's pushes were up to a time at which another run goes on from it, without a push until one acts. */
export function pushesUpTo(before: Motion, time: number): PushRecord[] {
  const earlier = (before.pushes ?? []).filter((r) => r.time < time);
  return earlier.at(-1)?.push ? [...earlier, { time, push: null }] : earlier;
}

/** A mark where a push begins and where it is released, none where it only moves. */
export function withMark(
  marks: Motion['marks'],
  before: readonly PushRecord[] | undefined,
  { time, push }: PushRecord,
): Motion['marks'] {
  const held = before?.at(-1)?.push ?? null;
  if ((held === null) === (push === null)) return marks;
  return [...marks, { time, name: push ? PUSHED : RELEASED }];
}

/** What an export says of a motion that the scenario alone does not give. */
export function pushComments({ pushes }: Motion): string[] {
  if (!pushes || pushes.length === 0) return [];
  return [
    'pushed by hand: the scenario alone does not repeat this run; from each time on this push acts',
    `pushes: ${JSON.stringify(pushes)}`,
  ];
}
