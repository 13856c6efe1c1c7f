/** What a run, and a ride, tell the page of their simulation. */
import type { Simulation } from '../../core/simulation/simulation.ts';
import type { Caller } from '../remote/serve.ts';
import type { RunEvent } from './runTypes.ts';

/**
 * Before the first row: its columns, and what the start became.
 *
 * @param simulation just made
 */
export const startedEvent = (simulation: Simulation): RunEvent => ({
  type: 'started',
  columns: [...simulation.columns],
  adjustments: [...simulation.adjustments],
  notes: [...simulation.notes, ...simulation.warnings],
  engine: simulation.engine,
});

/**
 * The rows that have come since the last time; their buffers are handed over.
 *
 * @param simulation whose rows they are
 * @param seconds of computing so far
 * @param emit tells the page
 */
export function sendRows(simulation: Simulation, seconds: number, emit: Caller<RunEvent, never>['emit']): void {
  const { columns, rows } = simulation.takeChunk();
  emit(
    { type: 'rows', columns, rows, time: simulation.time, counts: simulation.counts, seconds },
    columns.map((c) => c.buffer as ArrayBuffer),
  );
}
