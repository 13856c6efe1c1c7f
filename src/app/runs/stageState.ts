/** What is on the stage: the motion being watched, and where the run behind it stands. */
import { batch, signal, type ReadonlySignal } from '@preact/signals';
import { readonly } from '../state/signals.ts';
import type { Motion, RunState, RunStatistics } from './motion.ts';

export interface StageState {
  motion: ReadonlySignal<Motion | null>;
  /** Bumped whenever the motion's trajectory grows. */
  rowsVersion: ReadonlySignal<number>;
  run: ReadonlySignal<RunState | null>;
  statistics: ReadonlySignal<RunStatistics | null>;
}

/** All of it at one moment. */
export interface StageContent {
  motion: Motion | null;
  run: RunState | null;
  statistics: RunStatistics | null;
}

export interface StageActions {
  /** Another motion takes the stage, with what is known of its run. */
  put(content: StageContent): void;
  setMotion(motion: Motion): void;
  setRun(run: RunState | null): void;
  setStatistics(statistics: RunStatistics | null): void;
  /** The motion's trajectory has more rows. */
  grew(): void;
}

export interface StageSlice {
  state: StageState;
  actions: StageActions;
}

export function createStage(): StageSlice {
  const motion = signal<Motion | null>(null);
  const rowsVersion = signal(0);
  const run = signal<RunState | null>(null);
  const statistics = signal<RunStatistics | null>(null);
  return {
    state: {
      motion: readonly(motion),
      rowsVersion: readonly(rowsVersion),
      run: readonly(run),
      statistics: readonly(statistics),
    },
    actions: {
      put: (content) =>
        batch(() => {
          run.value = content.run;
          statistics.value = content.statistics;
          motion.value = content.motion;
          rowsVersion.value++;
        }),
      setMotion: (next) => void (motion.value = next),
      setRun: (next) => void (run.value = next),
      setStatistics: (next) => void (statistics.value = next),
      grew: () => void rowsVersion.value++,
    },
  };
}
