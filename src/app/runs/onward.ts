/** How a run goes on from a row of another: what is taken over, and what is marked. */
import { Trajectory } from '../../core/motion/trajectory.ts';
import type { Scenario } from '../../core/scenario/types.ts';
import type { Push } from '../../core/simulation/push.ts';
import type { Continuation } from '../../core/simulation/simulation.ts';
import { PUSHED } from '../push/pushRecorder.ts';
import type { Motion } from './motion.ts';

/** A mark where the controller was changed under way; one that follows sooner than this (s) takes the place of the last. */
export const RETUNED = 'retuned';
const MARKS_APART = 0.25;

/** The row of a motion from which another run goes on. */
export interface Onward {
  before: Motion;
  row: number;
  time: number;
  /** Name of what happens there. */
  mark: string;
  push?: Push;
}

/** The same equations of motion, rows and times: only what acts on them may differ. */
export function samePlant(a: Scenario, b: Scenario): boolean {
  const plant = ({ system, parameters, constraints, hold, outputStep }: Scenario): string =>
    JSON.stringify([system, parameters, constraints, hold, outputStep]);
  return plant(a) === plant(b);
}

export function continuationOf(
  { before: { system, trajectory }, row, time }: Onward,
  scenario: Scenario,
): Continuation {
  const names = system.meta.coordinates.map((c) => c.name);
  const at = (name: string): number => trajectory.column(name)![row]!;
  return {
    time: Math.round(time / scenario.outputStep) * scenario.outputStep,
    q: names.map(at),
    v: names.map((name) => at(`${name}_dot`)),
  };
}

/** Rows to be expected of a run: room is made for them at once, for copying a long run into larger columns would stop the page. */
export const rowsOf = ({ duration, outputStep }: Scenario): number => Math.ceil(duration / outputStep) + 2;

/** The rows up to and with the one to go on from, in the new run's columns; what the old run did not have is not a number. */
export function firstRows(
  { before: { trajectory }, row }: Onward,
  columns: readonly string[],
  expected: number,
): Trajectory {
  const rows = row + 1;
  const taken = new Trajectory(columns, Math.max(2 * rows, expected));
  taken.recorded = trajectory.recorded;
  taken.append(
    columns.map((name) => trajectory.column(name)?.subarray(0, rows) ?? new Float64Array(rows).fill(NaN)),
    rows,
  );
  return taken;
}

/** The marks before, one where the controller was changed; a push marks itself when it acts. */
export function marksOf({ before, time, mark }: Onward): Motion['marks'] {
  const earlier = before.marks.filter((m) => m.time <= time && !(m.name === mark && time - m.time < MARKS_APART));
  return mark === PUSHED ? earlier : [...earlier, { time, name: mark }];
}
