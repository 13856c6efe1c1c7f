import type { ReadonlySignal } from '@preact/signals';
import { CURVES } from './curveStyles.ts';
import type { Stage } from './stage.ts';
import type { PinnedRun } from './pinnedRuns.ts';
import type { LiveState } from './live.ts';
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
  state: Pick<StageState, 'motion'> & Pick<LiveState, 'former'> & { pinned: ReadonlySignal<readonly PinnedRun[]> },
  stage: Pick<Stage, 'samplerOf'>,
  time: number,
): GhostPoses[] {
  const motion = state.motion.value;
  if (!motion) return [];
  const shown = state.pinned.value.filter(
    (run) => run.ghost && run.motion.system === motion.system && run.motion.id !== motion.id,
  );
  const former = state.former.value;
  const before = former?.system === motion.system && former.id !== motion.id ? stage.samplerOf(former) : undefined;
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
  if (!before?.sample(time)) return beside;
  const { poses, wheelAngles } = before;
  return [...beside, { id: 'before', label: BEFORE, tint: FAINT, poses, wheelAngles }];
}
