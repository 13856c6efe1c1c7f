import type { RideCommand } from '../../scenario/types.ts';

/**
 * What a rider is told at a time: the last value of each command, with primitives taken apart, and how fast a body follows.
 */
export interface Wish {
  /** Share of the most lean into a turn, to the left positive. */
  lean: number;
  /** Share of the tightest turn, to the left positive. */
  twist: number;
  /** Share of the pump's stroke. */
  pump: number;
  /** A foot that pushes the ground back, 0 to 1. */
  push: number;
  /** A foot that drags, 0 to 1. */
  brake: number;
  /** How much of the stabilizing layer acts, 0 to 1. */
  help: number;
  /** How deep the body crouches, 0 to 1. */
  crouch: number;
  /** How far the hips turn, to the left positive, -1 to 1. */
  hips: number;
}

/** What every command and primitive sets. */
const SETS: Readonly<Record<string, (value: number) => Partial<Wish>>> = {
  lean: (lean) => ({ lean }),
  twist: (twist) => ({ twist }),
  pump: (pump) => ({ pump, push: 0, brake: 0 }),
  push: (push) => ({ push, brake: 0 }),
  brake: (brake) => ({ brake, push: 0 }),
  help: (help) => ({ help }),
  crouch: (crouch) => ({ crouch }),
  hips: (hips) => ({ hips }),
  start: (push) => ({ push, pump: 0, brake: 0 }),
  coast: () => ({ push: 0, pump: 0, brake: 0 }),
  left: (twist) => ({ twist }),
  right: (value) => ({ twist: -value }),
  straight: () => ({ lean: 0, twist: 0, hips: 0 }),
  stop: (brake) => ({ brake, push: 0, pump: 0, lean: 0, twist: 0, hips: 0 }),
};

/** How fast a body takes a wish up, 1/s: from nothing to all of it. */
const RATES: Readonly<Wish> = { lean: 2.5, twist: 2.5, pump: 1, push: 4, brake: 3, help: 2, crouch: 3, hips: 4 };

const KEYS = Object.keys(RATES) as (keyof Wish)[];

/** A command counts from the sample at or after it; closer than this (s) they are one. */
const SAME = 1e-9;

/** Follows a list of commands as time goes on; the list may grow at its end meanwhile. */
export class Follower {
  /** As far as the body has taken it up. */
  readonly now: Wish;
  private readonly wished: Wish;
  private readonly first: Wish;
  private readonly commands: readonly RideCommand[];
  private next = 0;
  private time = -1;

  /** @param help at the beginning */
  constructor(commands: readonly RideCommand[], help: number) {
    this.commands = commands;
    this.first = { lean: 0, twist: 0, pump: 0, push: 0, brake: 0, help, crouch: 0, hips: 0 };
    this.now = { ...this.first };
    this.wished = { ...this.first };
  }

  /** Goes on to time t, s; an earlier time than the last begins anew. */
  at(t: number): Readonly<Wish> {
    const { now, wished, commands } = this;
    const began = this.time < 0 || t < this.time;
    if (began) {
      Object.assign(wished, this.first);
      this.next = 0;
    }
    while (this.next < commands.length && commands[this.next]![0] <= t + SAME) {
      const [, name, value] = commands[this.next++]!;
      Object.assign(wished, SETS[name]!(value));
    }
    // A run that goes on from the middle finds the body as it was told to be; one from the start finds it at rest.
    if (began) Object.assign(now, t > 0 ? wished : this.first);
    const dt = began ? 0 : t - this.time;
    for (const key of KEYS) {
      const reach = RATES[key] * dt;
      now[key] += Math.max(-reach, Math.min(reach, wished[key] - now[key]));
    }
    this.time = t;
    return now;
  }
}
