import type { ReadonlySignal } from '@preact/signals';
import { CURVES } from './curveStyles.ts';
import type { Motion } from './motion.ts';
import type { Stage } from './stage.ts';
import type { PinnedRun } from './pinnedRuns.ts';
import type { CompanyState } from './company.ts';
import type { LiveState } from './live.ts';
import type { SettingsState } from '../state/settings.ts';
import type { StageState } from './stageState.ts';

/** The run before the one that is being changed. */
const BEFORE = 'before';
const FAINT = '#8a8f98';

/** One pinned run as it stands at a time, in the bodies of the system on the stage. */
export interface GhostPoses {
  id: string;
  label: string;
  tint: string;
  poses: Float64Array;
  wheelAngles: Float64Array;
}

/** Pinned runs that are shown as ghosts, of the system on the stage; before its start and after its end each stands still. */
export function ghostsAt(
  state: Pick<StageState, 'motion'> &
    Pick<LiveState, 'former'> &
    Pick<CompanyState, 'companion'> &
    Pick<SettingsState, 'view'> & { pinned: ReadonlySignal<readonly PinnedRun[]> },
  stage: Pick<Stage, 'samplerOf'> & Partial<Pick<Stage, 'sampler'>>,
  time: number,
): GhostPoses[] {
  const motion = state.motion.value;
  if (!motion) return [];
  const shown = state.pinned.value.filter(
    (run) => run.ghost && run.motion.system === motion.system && run.motion.id !== motion.id,
  );
  const beneath = (other: Motion | null) =>
    other?.system === motion.system && other.id !== motion.id ? stage.samplerOf(other) : undefined;
  const companion = state.companion.value;
  const beside = shown.flatMap(({ id, name, style, motion: own }) => {
    const sampler = stage.samplerOf(own);
    if (!sampler.sample(time)) return [];
    return [
      {
        id: `${id}/${style}/${name}`,
        label: name,
        tint: CURVES[style % CURVES.length]!.color,
        poses: sampler.poses,
        wheelAngles: sampler.wheelAngles,
      },
    ];
  });
  for (const [id, label, sampler] of [
    ['before', BEFORE, beneath(state.former.value)],
    ['companion', companion?.title ?? '', beneath(companion)],
  ] as const) {
    if (!sampler?.sample(time)) continue;
    if (id === 'companion' && state.view.value === 'rider' && isBehind(sampler.poses, stage.sampler?.peek()?.poses))
      continue;
    beside.push({ id, label, tint: FAINT, poses: sampler.poses, wheelAngles: sampler.wheelAngles });
  }
  return beside;
}

/** So far behind, along the heading of what is ridden, a ghost stands before the eyes of who looks over the shoulder, m. */
const BEHIND = 0.6;

const isBehind = (ghost: Float64Array, own: Float64Array | undefined): boolean =>
  own !== undefined && (ghost[0]! - own[0]!) * own[3]! + (ghost[1]! - own[1]!) * own[6]! < -BEHIND;
