import { firstCrossing, firstTime } from './firstCrossing.ts';
import { REACHED } from './run.ts';
import type { LastStep } from './lastStep.ts';
import type { Saturation } from './saturation.ts';

/** Limits that are reached and left at one moment: beyond so many turns the limit acts at every moment of one step. */
const MOST_TURNS = 6;

/** A controller's limit is reached or left at a time. */
interface Turn {
  readonly saturation: Saturation;
  readonly time: number;
}

/** When controllers reach their limits and leave them, found as a run goes on: its steps end there. */
export class LimitTurns {
  private readonly saturations: readonly Saturation[];
  private readonly step: LastStep;
  /** y at the start of the step. */
  private readonly before: Float64Array;
  private next: Turn | null = null;
  /** Since a step was last kept. */
  private turns = 0;

  constructor(saturations: readonly Saturation[], step: LastStep) {
    this.saturations = saturations;
    this.step = step;
    this.before = new Float64Array(step.stepper.y.length);
  }

  /** No step may go beyond it, s. */
  get end(): number {
    return this.next?.time ?? Infinity;
  }

  /** At the start of the run. */
  begin(t: number, q: Float64Array, v: Float64Array): void {
    for (const saturation of this.saturations) saturation.decide(t, q, v);
  }

  /** Before a step, which may be taken back. */
  remember(): void {
    if (this.saturations.length > 0) this.before.set(this.step.stepper.y);
  }

  /**
   * Whether a controller reached or left its limit within the last step, which is then taken back: the next ones end
   * there (the step itself was computed with the old side, so that it and its dense output are smooth).
   */
  takeBack(): boolean {
    const { step, before } = this;
    const { t, previousT } = step;
    let first: Turn | null = null;
    for (const saturation of this.saturations) {
      for (const way of saturation.ways) {
        const time = this.leaves(saturation, way, first?.time ?? t);
        if (time !== null) first = { saturation, time };
      }
    }
    // Where the step was to end for it, it may be a last digit early or late.
    const due = this.next && t >= this.next.time ? this.next.saturation : null;
    if (!first || first.saturation === due) {
      this.turns = 0;
      return false;
    }
    const at = first.time - previousT <= REACHED * (t - previousT) ? previousT : first.time;
    step.rewind(previousT, before);
    if (at > previousT) {
      this.next = { saturation: first.saturation, time: at };
      return true;
    }
    if (++this.turns > MOST_TURNS) first.saturation.side = NaN;
    else first.saturation.turn(previousT, step.q, step.v);
    return true;
  }

  /** First time in the last step, up to one, at which what is asked leaves a controller's side; null where it stays. */
  private leaves(saturation: Saturation, way: number, until: number): number | null {
    const { step } = this;
    const { t, previousT } = step;
    const value = (time: number): number => {
      if (time === t) return saturation.room(t, step.q, step.v, way);
      step.lookAt(time);
      return saturation.room(time, step.atQ, step.atV, way);
    };
    // A switch at the start may have left it on the other side; rounding there alone leaves nothing.
    if (value(previousT) < 0 && value(previousT + REACHED * (until - previousT)) < 0) return previousT;
    const crossing = firstCrossing({ value }, previousT, until);
    return crossing && firstTime((time) => !(value(time) > 0), ...crossing);
  }

  /** A step ended: whether a controller is on another side of its limit from now on. */
  arrive(): boolean {
    const { step, next } = this;
    const { t, q, v } = step;
    let turned = false;
    if (next && t >= next.time) {
      next.saturation.turn(t, q, v);
      this.next = null;
      turned = true;
    }
    for (const saturation of this.saturations) {
      if (saturation.side === saturation.side) continue;
      saturation.decide(t, q, v);
      turned = true;
    }
    return turned;
  }
}
