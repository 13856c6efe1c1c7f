/** From where to where the time line runs, and how much of it is there. */
import type { Motion, RunState } from '../../app/runs/motion.ts';

export interface Timeline {
  start: number;
  /** Planned end while a run streams, else the last row. */
  end: number;
  /** Last row there is. */
  available: number;
}

export function timelineOf(motion: Motion | null, run: RunState | null): Timeline {
  if (!motion) return { start: 0, end: 0, available: 0 };
  const { start, end } = motion.trajectory;
  const planned = motion.source === 'run' && run?.kind === 'computing' ? (motion.scenario?.duration ?? end) : end;
  return { start, end: Math.max(planned, end), available: end };
}

/** Position on the line, 0 to 1. */
export function fraction(time: number, line: Timeline): number {
  const length = line.end - line.start;
  return length > 0 ? Math.min(1, Math.max(0, (time - line.start) / length)) : 0;
}
