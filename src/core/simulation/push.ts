/** A spring and a damper between a point of a body and a place of the world: a hand that drags it. */
export interface Push {
  /** Id of the body in the system's meta. */
  body: string;
  /** In the body's frame, m. */
  point: readonly [number, number, number];
  /** In the world, m. */
  target: readonly [number, number, number];
  /** N/m. */
  stiffness: number;
  /** N s/m. */
  damping: number;
}

/** From `time` on (s) the push acts, or nothing does: what is needed to repeat a run that was pushed by hand. */
export interface PushRecord {
  time: number;
  push: Push | null;
}
