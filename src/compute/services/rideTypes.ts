import type { Scenario } from '../../core/scenario/types.ts';
import type { Call } from '../remote/protocol.ts';
import type { RunEvent, RunResult } from './runTypes.ts';

export interface RideCalls {
  /** Computes a ride in step with the clock, told where to go meanwhile. Aborted, it answers with the end `cancelled`. */
  'ride.compute': Call<RideRequest, RunResult, RunEvent, RideUpdate>;
}

export interface RideRequest {
  /** With a control of type `ride`: its list holds what was told before. */
  scenario: Scenario;
  ride: RideStart;
}

export interface RideStart {
  /** Up to where it is computed at once, before the clock counts, s. */
  resume: number;
  /** Seconds of the ride in a second of the clock; 0: it waits. */
  pace: number;
}

export interface RideUpdate {
  /** Name and value of a command, and when it was given, for who wants to know how long it takes to be seen (ms). */
  command?: readonly [name: string, value: number, given: number];
  pace?: number;
  /** The page has drawn: rows are sent once for that, so that a slow page never falls behind with them. */
  ready?: true;
}
