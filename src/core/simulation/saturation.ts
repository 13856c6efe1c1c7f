import type { Feedback } from '../mechanics/forcing.ts';

/** Beyond its limit, or back within it, only by this part of the limit: rounding alone switches nothing. */
const MARGIN = 1e-9;

/**
 * What a controller asks of an input, within the input's limit. Where it reaches the limit depends on the state, so a run
 * finds it as it goes: `side` holds for a step (0 free, 1 and -1 at that limit), whatever is asked within it, so that the
 * step is smooth; afterwards `room` tells whether it should have been another. Undecided (NaN) the limit acts at every moment.
 */
export class Saturation {
  side = NaN;
  private readonly feedback: Feedback;

  constructor(feedback: Feedback) {
    this.feedback = feedback;
  }

  get limited(): boolean {
    return this.feedback.limit < Infinity;
  }

  value(t: number, q: Float64Array, v: Float64Array): number {
    const { feedback, side } = this;
    const { limit } = feedback;
    if (side === 1 || side === -1) return side * limit;
    const asked = feedback.asked(t, q, v);
    return side === 0 ? asked : Math.max(-limit, Math.min(limit, asked));
  }

  /** Adds du/dq and du/dv times `weight` onto a row of each; at its limit the controller does not react. */
  addSlopes(
    t: number,
    q: Float64Array,
    v: Float64Array,
    weight: number,
    row: number,
    forceQ: Float64Array,
    forceV: Float64Array,
  ): void {
    if (this.side === 1 || this.side === -1) return;
    if (this.side !== 0 && !(Math.abs(this.feedback.asked(t, q, v)) < this.feedback.limit)) return;
    this.feedback.addSlopes(t, q, v, weight, row, forceQ, forceV);
  }

  /** The sides on which what is asked can leave `side`. */
  get ways(): readonly number[] {
    const { side } = this;
    return side === 0 ? [1, -1] : side === side ? [side] : [];
  }

  /** How far what is asked at a state is from leaving `side` on one of its ways: it has left where that is below zero. */
  room(t: number, q: Float64Array, v: Float64Array, way: number): number {
    const { feedback, side } = this;
    const asked = way * feedback.asked(t, q, v);
    return side === 0 ? feedback.limit * (1 + MARGIN) - asked : asked - feedback.limit * (1 - MARGIN);
  }

  /** Takes the side that a state asks for. */
  decide(t: number, q: Float64Array, v: Float64Array): void {
    const asked = this.feedback.asked(t, q, v);
    this.side = Math.abs(asked) > this.feedback.limit ? Math.sign(asked) : 0;
  }

  /** Reaches the limit, or leaves it. */
  turn(t: number, q: Float64Array, v: Float64Array): void {
    this.side = this.side === 0 ? Math.sign(this.feedback.asked(t, q, v)) : 0;
  }
}
