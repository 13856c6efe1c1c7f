import type { App } from '../../app/app.ts';
import type { Motion } from '../../app/runs/motion.ts';
import { columnsOf as allColumns } from '../../core/motion/columns.ts';
import { CURVES } from '../../app/runs/curveStyles.ts';

/** One run in the plots and tables: the one on the stage, or a pinned one. */
export interface ShownRun {
  /** Permanent as long as it is shown. */
  key: string;
  name: string;
  motion: Motion;
  /** Null for the one on the stage, which wears the ink of the page. */
  style: (typeof CURVES)[number] | null;
  visible: boolean;
}

/** Kept runs, after the one on the stage unless it is pinned itself. */
export function shownRuns({ state }: App): ShownRun[] {
  const motion = state.motion.value;
  const pinned = state.pinned.value.map((run): ShownRun => ({
    key: `pinned-${run.id}`,
    name: run.name,
    motion: run.motion,
    style: CURVES[run.style % CURVES.length]!,
    visible: run.visible,
  }));
  if (!motion || pinned.some((run) => run.motion.id === motion.id)) return pinned;
  return [{ key: 'stage', name: motion.title, motion, style: null, visible: true }, ...pinned];
}

/** Columns of any of the runs, recorded and computed, in the order they are first met. */
export function columnsOf(runs: readonly ShownRun[]): string[] {
  return [
    ...new Set(
      runs.flatMap(({ motion: { system, trajectory, constraints } }) =>
        allColumns(system, trajectory.columns, constraints !== null).map((c) => c.name),
      ),
    ),
  ];
}
