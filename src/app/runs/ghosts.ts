import type { ReadonlySignal } from '@preact/signals';
import { CURVES } from './curveStyles.ts';
import type { Stage } from './stage.ts';
import type { PinnedRun } from './pinnedRuns.ts';
import type { StageState } from './stageState.ts';

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
  state: Pick<StageState, 'motion'> & { pinned: ReadonlySignal<readonly PinnedRun[]> },
  stage: Pick<Stage, 'samplerOf'>,
  time: number,
): GhostPoses[] {
  const motion = state.motion.value;
  if (!motion) return [];
  const shown = state.pinned.value.filter(
    (run) => run.ghost && run.motion.system === motion.system && run.motion.id !== motion.id,
  );
  return shown.flatMap(({ id, name, style, motion: own }) => {
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
}
