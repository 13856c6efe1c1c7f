import { canBeTold, sampleUpTo, tell } from '../../core/scenario/ride.ts';
import { ScenarioError, type RideControl } from '../../core/scenario/types.ts';
import { needsEverything } from '../../core/simulation/motion.ts';
import { PAGE_COLUMNS, Simulation } from '../../core/simulation/simulation.ts';
import type { Caller, Handlers } from '../remote/serve.ts';
import { feedbackFor, partsOf, systemOf } from './load.ts';
import { nextTurn } from './nextTurn.ts';
import type { RideCalls, RideRequest, RideUpdate } from './rideTypes.ts';
import { sendRows, startedEvent } from './runEvents.ts';
import type { RunEvent, RunResult } from './runTypes.ts';

/** Computing time between looks at the mailbox, and the wait when the ride has caught up with the clock, ms. */
const SLICE_MS = 8;
const REST_MS = 3;
/** A ride further behind the clock than this (s) goes on from where it is: it does not race after it. */
const MOST_BEHIND = 0.15;

export const calls: Handlers<RideCalls> = { 'ride.compute': compute };

/**
 * The steps are those of a run of the same scenario with all commands in it: it waits at samples alone, and each command is
 * put into the list at the next sample (`core/scenario/ride.ts`).
 */
async function compute(
  { scenario, ride }: RideRequest,
  { signal, emit, onUpdate }: Caller<RunEvent, RideUpdate>,
): Promise<RunResult> {
  const control = scenario.control as RideControl | null;
  if (control?.type !== 'ride') throw new ScenarioError('control.type', 'must be "ride"');
  const [system] = await Promise.all([
    systemOf(scenario, partsOf(scenario, false, false)),
    needsEverything(scenario) ? import('../../core/simulation/everyMotion.ts') : null,
  ]);
  const feedback = await feedbackFor(scenario, system);
  const simulation = new Simulation(scenario, system, { extras: PAGE_COLUMNS, feedback });
  let seconds = 0;
  emit(startedEvent(simulation));
  let ready = true;
  /** When there is a row that shows what the last command did, s; it is sent at once, to be in the next picture. */
  let shown = Infinity;
  const send = (): void => {
    if (simulation.rows === 0 || !(ready || simulation.time >= shown || simulation.end)) return;
    ready = false;
    shown = Infinity;
    sendRows(simulation, seconds, emit);
  };
  const { outputStep } = scenario;
  let { pace } = ride;
  /** The clock's time and the ride's time that belongs to it; null until the ride has come to where it is taken over. */
  let since: { wall: number; time: number } | null = null;
  const due = (now: number): number => (since ? since.time + (pace * (now - since.wall)) / 1000 : ride.resume);
  onUpdate(({ command, pace: next, ready: drawn }) => {
    ready ||= drawn === true;
    if (command && !simulation.end && canBeTold(command[0], system.meta, scenario.hold)) {
      const [name, value, given] = command;
      const told = tell(control, simulation.time, name, value);
      // Rows stand at whole output steps.
      shown = Math.min(shown, (Math.floor(told[0] / outputStep + 1e-6) + 1) * outputStep - 1e-9);
      emit({ type: 'told', command: told, given });
    }
    if (next === undefined) return;
    if (since) since = { wall: performance.now(), time: simulation.time };
    pace = next;
  });
  while (!simulation.end) {
    if (signal.aborted) {
      // To a sample, where a run of that duration stops too: its rows are these, and one at its end.
      simulation.horizon = sampleUpTo(control, simulation.time + control.sample!);
      simulation.advance(() => false);
      simulation.stop('cancelled', `ridden to t = ${Number(simulation.time.toFixed(3))} s`);
      break;
    }
    const began = performance.now();
    const target = due(began);
    if (since && target - simulation.time > MOST_BEHIND) since = { wall: began, time: simulation.time };
    simulation.horizon = sampleUpTo(control, target);
    simulation.advance(() => performance.now() >= began + SLICE_MS);
    seconds += (performance.now() - began) / 1000;
    if (simulation.end) break;
    send();
    if (!simulation.waits) await nextTurn();
    else {
      since ??= { wall: performance.now(), time: simulation.time };
      await new Promise((resolve) => setTimeout(resolve, REST_MS));
    }
  }
  send();
  return { end: simulation.end!, counts: simulation.counts, seconds };
}
