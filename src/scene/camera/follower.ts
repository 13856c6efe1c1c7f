/** Following without jerks: goes after a moving place as a critically damped spring does, without lagging behind steady motion. */

/** A step of time longer than this (s), or backwards, is a jump: the place is taken as it is. */
const LONGEST = 0.5;

export class Follower {
  /** Where it is now. */
  readonly at: Float64Array;
  private readonly rate: number;
  private readonly goal: Float64Array;
  /** How fast it goes there, per second. */
  readonly speed: Float64Array;
  private time = Number.NaN;
  /** Since a jump nothing is known of how fast the goal is. */
  private fresh = true;

  /** @param rate 1/s: what is slower than this is followed, what is faster is smoothed away */
  constructor(size: number, rate: number) {
    this.rate = rate;
    this.at = new Float64Array(size);
    this.goal = new Float64Array(size);
    this.speed = new Float64Array(size);
  }

  /** The place at a time (s). Error e from a goal that moves steadily between two times: e'' + 2 rate e' + rate² e = 0, solved exactly. */
  take(goal: ArrayLike<number>, time: number): void {
    const dt = time - this.time;
    this.time = time;
    if (!(dt >= 0 && dt <= LONGEST)) return this.jump(goal);
    const { rate, at, speed } = this;
    if (this.fresh && dt > 0) {
      for (let i = 0; i < at.length; i++) speed[i] = (goal[i]! - this.goal[i]!) / dt;
      this.fresh = false;
    }
    const decay = Math.exp(-rate * dt);
    for (let i = 0; i < at.length; i++) {
      const step = goal[i]! - this.goal[i]!;
      const pace = dt > 0 ? step / dt : speed[i]!;
      const error = at[i]! - this.goal[i]!;
      const drift = speed[i]! - pace + rate * error;
      at[i] = goal[i]! + (error + drift * dt) * decay;
      speed[i] = pace + (drift - rate * (error + drift * dt)) * decay;
      this.goal[i] = goal[i]!;
    }
  }

  /** Goes on from another place, as fast as before. */
  put(goal: ArrayLike<number>): void {
    this.at.set(goal);
    this.goal.set(goal);
  }

  private jump(goal: ArrayLike<number>): void {
    this.put(goal);
    this.speed.fill(0);
    this.fresh = true;
  }
}
