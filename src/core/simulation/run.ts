import type { Feedback } from '../mechanics/forcing.ts';
import type { EnergyNumbers } from './energyBalance.ts';
import type { PushRecord } from './push.ts';

/** How a run ended. `reason` is a permanent id; `message` is for people. */
export interface RunEnd {
  reason: string;
  message: string;
  time: number;
}

export interface RunCounts extends EnergyNumbers {
  steps: number;
  rejected: number;
  evaluations: number;
  jacobians: number;
  factorizations: number;
  /** Largest constraint residual of an emitted row. */
  residual: number;
}

/** What a run may be given besides its scenario. */
export interface RunOptions {
  /** Extra columns, in place of the scenario's. */
  extras?: readonly string[];
  /** Goes on from there, with the row after it, in place of a consistent start at t = 0. */
  from?: Continuation | undefined;
  /** State feedback by input: what an `lqr` in the scenario asks (see `feedbackOf`). */
  feedback?: ReadonlyMap<string, Feedback> | null;
  /**
   * What pushes by hand act, in the order of their times; those up to the start act from it. An empty list lets `push`
   * be called; without a list it must not be.
   */
  pushes?: readonly PushRecord[] | undefined;
}

/** A row of an earlier run to go on from: `time` is a multiple of the output step, q and v as in that row. */
export interface Continuation {
  time: number;
  q: readonly number[];
  v: readonly number[];
}

/** What `columns` of a scenario may ask for; state columns are always there. */
export const EXTRA_COLUMNS = ['lambda', 'energy', 'residual', 'inputs'] as const;

/** What the page asks for: kinetic and potential energy too, columns `kinetic` and `potential`. */
export const PAGE_COLUMNS = [...EXTRA_COLUMNS, 'energy-parts'] as const;

/** A time closer than this (s) to one that was to be reached is that time. */
export const REACHED = 1e-9;
