import type { FeedbackDesign } from '../core/dynamics/forcing.ts';
import { ScenarioError, type Scenario } from '../core/scenario/types.ts';
import { EXTRA_COLUMNS, Simulation } from '../core/simulation/simulation.ts';
import { ripstik } from '../core/systems/ripstik/system.ts';
import type { System } from '../core/systems/types.ts';
import type { FromWorker, ToWorker } from './protocol.ts';

/** Computing time between looks at the mailbox: a cancel is answered well within 100 ms. */
const SLICE_MS = 12;
/** Rows are sent at least this often, and no oftener, so that neither page nor plot waits or drowns. */
const SEND_MS = 30;

const post = (message: FromWorker, transfer: Transferable[] = []): void => self.postMessage(message, { transfer });

let current: { run: number; simulation: Simulation } | null = null;
/** The run that was asked for last; what it needs may still be on its way when it is cancelled. */
let asked = { run: 0, cancelled: false };
/** Time spent in `advance` by the current run, s. */
let seconds = 0;

self.addEventListener('message', ({ data }: MessageEvent<ToWorker>) => {
  if (data.type === 'cancel') {
    if (asked.run === data.run) asked.cancelled = true;
    if (current?.run === data.run) finish(current.simulation, data.run, 'cancelled', 'cancelled; what was computed is kept');
    return;
  }
  void start(data);
});

async function start({ run, scenario, from }: Extract<ToWorker, { type: 'start' }>): Promise<void> {
  const request = (asked = { run, cancelled: false });
  current = null;
  try {
    const system = scenario.system === 'ripstik' ? ripstik : await systemOf(scenario);
    const design = scenario.control?.type === 'lqr' ? await designOf() : undefined;
    if (asked !== request) return;
    const simulation = new Simulation(scenario, system, EXTRA_COLUMNS, from, design);
    seconds = 0;
    current = { run, simulation };
    post({ type: 'started', run, columns: [...simulation.columns], adjustments: [...simulation.adjustments], notes: [...simulation.notes] });
    if (request.cancelled) finish(simulation, run, 'cancelled', 'cancelled; what was computed is kept');
    else compute(run, simulation, performance.now());
  } catch (error) {
    if (asked !== request) return;
    current = null;
    const path = error instanceof ScenarioError ? error.path : '';
    post({ type: 'refused', run, path, message: error instanceof Error ? error.message : String(error) });
  }
}

/** The first view pays for the board alone; other systems, and what designs controllers, come when they are asked for. */
async function systemOf(scenario: Scenario): Promise<System> {
  const { systems } = await import('../core/systems/registry.ts');
  const system = systems[scenario.system];
  if (!system) throw new ScenarioError('system', `unknown system "${scenario.system}"`);
  return system;
}

async function designOf(): Promise<FeedbackDesign> {
  return (await import('../core/control/feedback.ts')).feedbackOf;
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
  if (performance.now() - lastSent >= SEND_MS) {
    send(simulation, run);
    lastSent = performance.now();
  }
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
  post({ type: 'rows', run, columns, rows, time: simulation.time, counts: simulation.counts, seconds }, columns.map((c) => c.buffer as ArrayBuffer));
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
