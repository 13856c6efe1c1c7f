import { ScenarioError } from '../core/scenario/types.ts';
import { PAGE_COLUMNS, Simulation } from '../core/simulation/simulation.ts';
import { loadSystem } from '../core/systems/registry.ts';
import type { FromWorker, Live, ToWorker } from './protocol.ts';

/** Computing time between looks at the mailbox: a cancel is answered well within 100 ms. */
const SLICE_MS = 12;
/** Rows are sent at least this often, and no oftener, so that neither page nor plot waits or drowns. */
const SEND_MS = 30;

const post = (message: FromWorker, transfer: Transferable[] = []): void => self.postMessage(message, { transfer });

let current: { run: number; simulation: Simulation } | null = null;
/** The run asked for last, and whether it was cancelled before it had begun. */
let wanted = 0;
let cancelled = false;
/** What a hand did to the run asked for last before it had begun. */
let early: Live[] = [];
/** The run is computed up to its horizon and waits for another. */
let waiting = false;
/** Time spent in `advance` by the current run, s. */
let seconds = 0;

self.addEventListener('message', ({ data }: MessageEvent<ToWorker>) => {
  if (data.type === 'cancel') {
    if (current?.run === data.run) finishCancelled(current.simulation, data.run);
    else if (wanted === data.run) cancelled = true;
    return;
  }
  if (data.type === 'push') {
    if (current?.run === data.run) act(current.simulation, data.run, data.live);
    else if (wanted === data.run) early.push(data.live);
    return;
  }
  wanted = data.run;
  cancelled = waiting = false;
  early = data.live ? [data.live] : [];
  current = null;
  void start(data);
});

async function start({ run, scenario, from, live }: Extract<ToWorker, { type: 'start' }>): Promise<void> {
  try {
    const system = await loadSystem(scenario.system);
    if (!system) throw new ScenarioError('system', `unknown system "${scenario.system}"`);
    // The design of a controller is loaded by those runs that have one.
    const feedback =
      scenario.control?.type === 'lqr'
        ? (await import('../core/control/design/feedback.ts')).feedbackOf(scenario, system)
        : null;
    if (wanted !== run) return;
    const simulation = new Simulation(scenario, system, { extras: PAGE_COLUMNS, from, feedback, pushes: live && [] });
    seconds = 0;
    current = { run, simulation };
    post({
      type: 'started',
      run,
      columns: [...simulation.columns],
      adjustments: [...simulation.adjustments],
      notes: [...simulation.notes],
    });
    for (const what of early) act(simulation, run, what);
    if (cancelled) finishCancelled(simulation, run);
    else compute(run, simulation, performance.now());
  } catch (error) {
    if (wanted === run) current = null;
    const path = error instanceof ScenarioError ? error.path : '';
    post({ type: 'refused', run, path, message: error instanceof Error ? error.message : String(error) });
  }
}

const finishCancelled = (simulation: Simulation, run: number): void =>
  finish(simulation, run, 'cancelled', 'cancelled; what was computed is kept');

/** What a hand does, from the end of what is computed on. */
function act(simulation: Simulation, run: number, { push, horizon }: Live): void {
  try {
    if (push !== undefined) post({ type: 'pushed', run, record: simulation.push(push) });
  } catch (error) {
    simulation.stop('failed', error instanceof Error ? error.message : String(error));
  }
  simulation.horizon = horizon ?? Infinity;
  if (!waiting) return;
  waiting = false;
  nextTurn(() => compute(run, simulation, 0));
}

/** One slice of computing, then a turn of the event loop, until the run ends or another takes its place. */
function compute(run: number, simulation: Simulation, lastSent: number): void {
  if (current?.simulation !== simulation) return;
  const from = performance.now();
  simulation.advance(() => performance.now() >= from + SLICE_MS);
  seconds += (performance.now() - from) / 1000;
  if (simulation.end) {
    finish(simulation, run, '', '');
    return;
  }
  waiting = simulation.waits;
  if (waiting || performance.now() - lastSent >= SEND_MS) {
    send(simulation, run);
    lastSent = performance.now();
  }
  if (waiting) return;
  nextTurn(() => compute(run, simulation, lastSent));
}

function finish(simulation: Simulation, run: number, reason: string, message: string): void {
  if (reason) simulation.stop(reason, message);
  current = null;
  send(simulation, run);
  post({ type: 'ended', run, end: simulation.end!, counts: simulation.counts, seconds });
}

function send(simulation: Simulation, run: number): void {
  const { columns, rows } = simulation.takeChunk();
  post(
    { type: 'rows', run, columns, rows, time: simulation.time, counts: simulation.counts, seconds },
    columns.map((c) => c.buffer as ArrayBuffer),
  );
}

/** A message to oneself: unlike a timer it is not throttled, and other messages get their turn first. */
const channel = new MessageChannel();
let pending: (() => void) | null = null;
channel.port1.onmessage = () => {
  const then = pending;
  pending = null;
  then?.();
};
function nextTurn(then: () => void): void {
  // One message under way, whatever replaces what it leads to: two would take two slices between looks at the mailbox.
  if (!pending) channel.port2.postMessage(null);
  pending = then;
}
