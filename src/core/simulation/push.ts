/** A spring and a damper between a point of a body and a place of the world: a hand that drags it. */
export interface Push {
  /** Id of the body in the system's meta. */
  body: string;
  /** In the body's frame, m. */
  point: readonly [number, number, number];
  /** In the world, m; of a hand that moves, where it is at `since`. */
  target: readonly [number, number, number];
  /** How the hand moves: it is at target + velocity (t - since). Without it the hand rests. */
  moving?: { /** m/s. */ velocity: readonly [number, number, number]; /** s. */ since: number };
  /** N/m. */
  stiffness: number;
  /** N s/m, of the point's velocity against the hand's. */
  damping: number;
}

/** From `time` on (s) the push acts, or nothing does: what is needed to repeat a run that was pushed by hand. */
export interface PushRecord {
  time: number;
  push: Push | null;
}
