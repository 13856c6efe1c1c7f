import type { Estimate, Feedback, Program } from '../mechanics/forcing.ts';
import type { Actuator, Scenario } from '../scenario/types.ts';
import { exponential } from '../elementary/powers.ts';

/**
 * A controller as a computer runs it: it measures at k h, asks its inputs once, and they are held from k h + delay until
 * the next ones (zero-order hold; K. J. Åström and B. Wittenmark, Computer-Controlled Systems, 3rd ed., section 2.3).
 * A run stops at every such instant. Before the first inputs act they are zero. With sensors it measures what they read, and
 * its inputs are what its filter's estimate asks.
 */

/** Instants closer than this (s) are one: k h + delay and (k + 1) h may differ in a last digit. */
const SAME = 1e-9;

/** One input of the controller. */
interface Channel {
  readonly name: string;
  readonly feedback: Feedback;
  readonly actuator: Actuator;
  /** The least of the controller's limit and the actuator's. */
  readonly limit: number;
  /** What was asked within limit and rate, before it is rounded: so that small changes add up. */
  command: number;
  /** What was sent to the actuator last, what it gave then, and when: it goes from there to what was sent. */
  value: number;
  before: number;
  since: number;
}

/** What a channel's actuator gives at a time: what it was sent, or that approached with its lag. */
function given({ actuator: { lag }, value, before, since }: Channel, t: number): number {
  return lag ? value + (before - value) * exponential(-Math.max(0, t - since) / lag) : value;
}

export class HeldControl {
  private readonly sample: number;
  private readonly delay: number;
  private readonly channels: readonly Channel[];
  /** Past inputs that a design counts on, newest first, by channel. */
  private readonly past: Float64Array;
  /** What is known of the state, where it is estimated. */
  private readonly estimate: Estimate | null;
  /** What asks all channels at once, where they have a program. */
  private readonly program: ReturnType<Program['begin']> | null;
  /** Inputs on their way to the actuators, the next first. */
  private readonly coming: { time: number; values: Float64Array }[] = [];
  /** Number of the next sample. */
  private next = 0;

  /** @param feedbacks by input, in the order in which a design's past inputs are counted */
  constructor(
    sample: number,
    delay: number,
    feedbacks: ReadonlyMap<string, Feedback>,
    actuators: Readonly<Record<string, Actuator>> = {},
  ) {
    this.sample = sample;
    this.delay = delay;
    this.channels = [...feedbacks].map(([name, feedback]) => {
      const actuator = actuators[name] ?? {};
      return {
        name,
        feedback,
        actuator,
        limit: Math.min(feedback.limit, actuator.limit ?? Infinity),
        command: 0,
        value: 0,
        before: 0,
        since: 0,
      };
    });
    this.past = new Float64Array(Math.max(0, ...this.channels.map(({ feedback }) => feedback.past?.length ?? 0)));
    this.estimate = this.channels[0]?.feedback.estimator?.begin() ?? null;
    this.program = this.channels[0]?.feedback.program?.begin() ?? null;
  }

  /** Null for a controller that acts continuously. */
  static of(control: Scenario['control'], feedbacks: ReadonlyMap<string, Feedback>): HeldControl | null {
    return control?.sample ? new HeldControl(control.sample, control.delay ?? 0, feedbacks, control.actuators) : null;
  }

  /** The next instant at which it measures or its inputs change, s. */
  get end(): number {
    return Math.min(this.next * this.sample, this.coming[0]?.time ?? Infinity);
  }

  isDue(t: number): boolean {
    return this.end <= t + SAME;
  }

  /** What acts of an input at a time until the next instant. */
  value(index: number, t: number): number {
    return given(this.channels[index]!, t);
  }

  indexOf(name: string): number {
    return this.channels.findIndex((channel) => channel.name === name);
  }

  /**
   * Starts at a time. A run that goes on from a row knows no earlier measurements: until the next one acts, inputs are what
   * is asked of the row's state.
   */
  begin(t: number, q: Float64Array, v: Float64Array): void {
    this.next = Math.max(0, Math.ceil((t - SAME) / this.sample));
    if (t > 0) {
      this.estimate?.know(t, q, v);
      const values = this.ask(t, q, v, Infinity);
      for (let i = 0; i < this.past.length; i++) this.past[i] = values[i % values.length]!;
      this.act(t, values);
      for (const channel of this.channels) channel.before = channel.value;
      // What is known is that of the row's time: the next sample's measurement corrects what has passed since.
      this.estimate?.fill(values);
    }
    this.arrive(t, q, v);
  }

  /** A step ended at an instant: what is due there happens. Whether an input jumps. */
  arrive(t: number, q: Float64Array, v: Float64Array): boolean {
    let jumps = false;
    if (this.next * this.sample <= t + SAME) {
      const measured = this.next * this.sample;
      const values = this.measureAndAsk(t, q, v);
      this.coming.push({ time: measured + this.delay, values });
      this.next++;
    }
    while (this.coming.length > 0 && this.coming[0]!.time <= t + SAME) {
      jumps = this.act(t, this.coming.shift()!.values) || jumps;
    }
    return jumps;
  }

  private measureAndAsk(t: number, q: Float64Array, v: Float64Array): Float64Array {
    const { estimate, next, sample } = this;
    if (!estimate) return this.ask(t, q, v, sample);
    estimate.measure(next, t, q, v);
    const values = this.ask(t, estimate.q, estimate.v, sample);
    estimate.predict(values);
    return values;
  }

  /** What the state asks of the actuators, `since` seconds after they were last asked. */
  private ask(t: number, q: Float64Array, v: Float64Array, since: number): Float64Array {
    const { channels, past } = this;
    const values = new Float64Array(channels.length);
    this.program?.(t, q, v, values);
    channels.forEach((channel, i) => {
      const { feedback, actuator, limit, command } = channel;
      let asked = this.program ? values[i]! : feedback.asked(t, q, v);
      const memory = feedback.past;
      for (let k = 0; memory && k < memory.length; k++) asked -= memory[k]! * past[k]!;
      const { acting } = feedback;
      for (let k = 0; acting && k < acting.length; k++)
        if (acting[k] !== 0) asked -= acting[k]! * given(channels[k]!, t);
      const reach = (actuator.rate ?? Infinity) * since;
      channel.command = clamp(clamp(asked, -limit, limit), command - reach, command + reach);
      values[i] = rounded(channel.command, actuator.resolution, limit);
    });
    past.copyWithin(channels.length, 0);
    for (let i = 0; i < Math.min(past.length, values.length); i++) past[i] = values[i]!;
    return values;
  }

  private act(t: number, values: Float64Array): boolean {
    let jumps = false;
    this.channels.forEach((channel, i) => {
      jumps ||= channel.value !== values[i]!;
      channel.before = given(channel, t);
      channel.since = t;
      channel.value = values[i]!;
    });
    return jumps;
  }
}

const clamp = (x: number, least: number, most: number): number => Math.max(least, Math.min(most, x));

/** The nearest multiple of a quantum that is within the limit. */
function rounded(x: number, quantum: number | undefined, limit: number): number {
  if (!quantum) return x;
  const most = Math.floor(limit / quantum);
  // x + 0 makes -0 a 0.
  return clamp(Math.round(x / quantum), -most, most) * quantum + 0;
}
