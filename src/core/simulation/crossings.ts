import type { EventFunction } from '../mechanics/events.ts';
import type { CoordinateMeta } from '../model/system.ts';
import { firstCrossing, firstTime, type Crossing } from './firstCrossing.ts';
import type { LastStep } from './lastStep.ts';

/** An event is glanced at over ways of a coordinate no longer than this, m and rad, in up to so many pieces of a step. */
const LOOKED_AT = { length: 0.1, angle: 0.2 };
const MOST_PIECES = 500;

/** How far an event may be off before a projection, beside how far it is at the end of the step. */
const UNPROJECTED = 8;

/** The events of a run, and where the first of them happens in its last step. */
export class Crossings {
  private readonly events: readonly EventFunction[];
  private readonly coordinates: readonly CoordinateMeta[];
  private readonly step: LastStep;
  /** State that they were last looked at, and their values there. */
  private readonly q: Float64Array;
  private readonly v: Float64Array;
  private readonly values: Float64Array;

  constructor(events: readonly EventFunction[], coordinates: readonly CoordinateMeta[], step: LastStep) {
    this.events = events;
    this.coordinates = coordinates;
    this.step = step;
    this.q = new Float64Array(coordinates.length);
    this.v = new Float64Array(coordinates.length);
    this.values = new Float64Array(events.length);
  }

  /** At the start: an event that has happened there already and leaves nothing to be integrated. A corner below ground may rise. */
  begin(t: number, q: Float64Array, v: Float64Array): EventFunction | null {
    this.q.set(q);
    this.v.set(v);
    let happened: EventFunction | null = null;
    this.events.forEach((event, e) => {
      const value = (this.values[e] = event.value(t, q, v));
      if (event.id === 'constraint-singular' && !(value > 0)) happened ??= event;
    });
    return happened;
  }

  /** The earliest downward crossing in the last step. */
  find(): { event: EventFunction; time: number } | null {
    const { step, events } = this;
    const { previousT, t } = step;
    let first: { event: EventFunction; time: number } | null = null;
    const pieces = events.some(({ smooth }) => smooth) ? this.pieces(t - previousT) : 1;
    for (let e = 0; e < events.length; e++) {
      const event = events[e]!;
      const before = this.values[e]!;
      const value = (this.values[e] = event.value(t, step.q, step.v));
      if (!event.smooth && (value > 0 || !(before > 0))) continue;
      const within = event.smooth ? this.crossing(event, before, value, pieces) : ([previousT, t] as const);
      if (!within) continue;
      const time = firstTime((at) => !(this.valueAt(event, at) > 0), ...within);
      if (!first || time < first.time) first = { event, time };
    }
    return first;
  }

  /** By how far the state goes in a step of h: what an event is a function of. */
  private pieces(h: number): number {
    const { q, v, step } = this;
    let most = 1;
    this.coordinates.forEach(({ kind, pure }, i) => {
      const way = Math.max(Math.abs(step.q[i]! - q[i]!), h * Math.abs(v[i]!), h * Math.abs(step.v[i]!));
      if (!pure) most = Math.max(most, way / LOOKED_AT[kind]);
    });
    q.set(step.q);
    v.set(step.v);
    return Math.min(MOST_PIECES, Math.ceil(most));
  }

  /** At the ends of the step the event has these values: of the motion as its rows show it, projected. */
  private crossing(event: EventFunction, before: number, after: number, pieces: number): Crossing | null {
    const { step } = this;
    const { previousT, t } = step;
    const atEnds =
      (within: (time: number) => number) =>
      (time: number): number =>
        time === previousT ? before : time === t ? after : within(time);
    const nearly = (time: number): number => {
      step.lookAt(time);
      return event.value(time, step.atQ, step.atV);
    };
    if (!step.projections) return firstCrossing({ value: atEnds(nearly), pieces }, previousT, t);
    const off = UNPROJECTED * Math.abs(nearly(t) - after);
    const value = atEnds((time) => this.valueAt(event, time));
    return firstCrossing({ value, pieces, nearly: atEnds(nearly), off }, previousT, t);
  }

  private valueAt(event: EventFunction, time: number): number {
    const { step } = this;
    step.lookAt(time);
    step.project(time);
    return event.value(time, step.atQ, step.atV);
  }
}
