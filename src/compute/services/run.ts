import { needsEverything } from '../../core/simulation/motion.ts';
import { PAGE_COLUMNS, Simulation } from '../../core/simulation/simulation.ts';
import { sharedFeedback } from '../../core/sweep/sharedFeedback.ts';
import type { Caller, Handlers } from '../remote/serve.ts';
import { feedbackFor, partsOf, systemOf } from './load.ts';
import { nextTurn } from './nextTurn.ts';
import { sendRows, startedEvent } from './runEvents.ts';
import type { Live, RunCalls, RunEvent, RunRequest, RunResult } from './runTypes.ts';

/** Computing time between looks at the mailbox: the run that follows a drag waits so long for the one before to stop. */
const SLICE_MS = 4;
/** Rows are sent at least this often, and no oftener, so that neither page nor plot waits or drowns. */
const SEND_MS = 30;

/**
 * The time (s) by which the rows up to one that is waited for have been given out: a step gives out those before its end.
 * 0: nothing is waited for.
 */
const rowsUpTo = (time: number, outputStep: number): number =>
  time > 0 ? (Math.ceil(time / outputStep - 1e-6) + 1e-6) * outputStep : 0;

/** While the start is dragged, the controller stays. */
const designed = sharedFeedback(feedbackFor);

export const calls: Handlers<RunCalls> = { 'run.compute': compute };

async function compute(
  { scenario, from, live, until = 0, soonest = false }: RunRequest,
  { signal, emit, onUpdate }: Caller<RunEvent, Live>,
): Promise<RunResult> {
  const [system] = await Promise.all([
    systemOf(scenario, {
      ...partsOf(scenario, live !== undefined, soonest),
      derived: (done, of) => emit({ type: 'derived', share: done / of }),
    }),
    soonest && !needsEverything(scenario) ? null : import('../../core/simulation/everyMotion.ts'),
  ]);
  const feedback = await designed(scenario, system);
  const simulation = new Simulation(scenario, system, { extras: PAGE_COLUMNS, from, feedback, pushes: live && [] });
  let seconds = 0;
  emit(startedEvent(simulation));
  const send = (): void => sendRows(simulation, seconds, emit);
  /** Lets a run go on that was computed up to its horizon. */
  let wake = (): void => {};
  signal.addEventListener('abort', () => wake());
  const act = ({ push, horizon }: Live): void => {
    try {
      if (push !== undefined) emit({ type: 'pushed', record: simulation.push(push) });
    } catch (error) {
      simulation.stop('failed', error instanceof Error ? error.message : String(error));
    }
    simulation.horizon = horizon ?? Infinity;
    wake();
  };
  if (live) act(live);
  onUpdate(act);

  let awaited = true;
  const waitedFor = rowsUpTo(until, scenario.outputStep);
  for (let lastSent = performance.now(); !simulation.end;) {
    if (signal.aborted) {
      simulation.stop('cancelled', 'cancelled; what was computed is kept');
      break;
    }
    const began = performance.now();
    simulation.advance(() => performance.now() >= began + SLICE_MS || (awaited && simulation.time >= waitedFor));
    seconds += (performance.now() - began) / 1000;
    if (simulation.end) break;
    if (simulation.waits) {
      send();
      lastSent = 0;
      await new Promise<void>((resolve) => (wake = resolve));
    } else if ((awaited && simulation.time >= waitedFor) || performance.now() - lastSent >= SEND_MS) {
      awaited &&= simulation.time < waitedFor;
      send();
      lastSent = performance.now();
    }
    await nextTurn();
  }
  send();
  return { end: simulation.end!, counts: simulation.counts, seconds };
}
