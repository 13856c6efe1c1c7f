/** A spring and a damper between a point of a body and a place of the world, which drags it there. */
export interface Push {
  /** Id of the body in the system's meta. */
  body: string;
  /** In the body's frame, m. */
  point: readonly [number, number, number];
  /** In the world, m; of a place that moves, where it is at `since`. */
  target: readonly [number, number, number];
  /** How the place moves: it is at target + velocity (t - since). Without it the place rests. */
  moving?: { /** m/s. */ velocity: readonly [number, number, number]; /** s. */ since: number };
  /** N/m. */
  stiffness: number;
  /** N s/m, of the point's velocity against the place's. */
  damping: number;
}

/** From `time` on (s) the push acts, or nothing does: what is needed to repeat a run that was pushed by hand. */
export interface PushRecord {
  time: number;
  push: Push | null;
}
