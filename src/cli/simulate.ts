import { closeSync, openSync, writeSync } from 'node:fs';
import { feedbackOf } from '../core/control/design/feedback.ts';
import type { Scenario } from '../core/scenario/types.ts';
import { Simulation } from '../core/simulation/simulation.ts';
import type { System } from '../core/model/system.ts';
import { writeCsv } from '../csv/csv.ts';
import { UsageError, pathOf } from './usage.ts';

/** Rows between writes: the file grows while the run computes, and memory does not. */
const ROWS_PER_WRITE = 4096;

/**
 * Runs a scenario into a CSV file (or standard output).
 * @returns 0, or 3 when the run stopped before its duration (the reason goes to standard error)
 */
export function simulate(scenario: Scenario, system: System, out: string | undefined): number {
  const simulation = new Simulation(scenario, system, { feedback: feedbackOf(scenario, system) });
  for (const { name, from, to } of simulation.adjustments) process.stderr.write(`start: ${name} ${from} -> ${to}\n`);
  for (const note of simulation.notes) process.stderr.write(`start: ${note}\n`);
  for (const warning of simulation.warnings) process.stderr.write(`warning: ${warning}\n`);
  const file = open(out);
  let header = true;
  try {
    while (!simulation.end) {
      simulation.advance(() => simulation.rows >= ROWS_PER_WRITE);
      const { columns, rows } = simulation.takeChunk();
      if (rows === 0 && !header) continue;
      const text = writeCsv(simulation.columns, columns);
      writeAll(file, header ? text : text.slice(text.indexOf('\n') + 1));
      header = false;
    }
    // Behind the table, where a program that knows no comments has read all numbers.
    for (const warning of simulation.warnings) writeAll(file, `# warning: ${warning}\n`);
  } finally {
    if (out !== undefined) closeSync(file);
  }
  const { reason, message } = simulation.end;
  if (reason === 'end') return 0;
  process.stderr.write(`ripstik: stopped early: ${message}\n`);
  return 3;
}

/** A pipe takes what it has room for, and may have none just now. */
function writeAll(file: number, text: string): void {
  const bytes = Buffer.from(text);
  const pause = new Int32Array(new SharedArrayBuffer(4));
  for (let at = 0; at < bytes.length;) {
    try {
      at += writeSync(file, bytes, at);
    } catch (error) {
      if ((error as NodeJS.ErrnoException).code !== 'EAGAIN') throw error;
      Atomics.wait(pause, 0, 0, 1);
    }
  }
}

function open(out: string | undefined): number {
  if (out === undefined) return 1;
  try {
    return openSync(pathOf(out), 'w');
  } catch (error) {
    throw new UsageError(`${out} can't be written: ${(error as Error).message}`);
  }
}
