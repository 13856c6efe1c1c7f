/** Rides as scenarios, and the best one through the course, which this browser keeps. */
import { Trajectory } from '../../core/motion/trajectory.ts';
import type { RideCommand, RideControl, ScenarioFile } from '../../core/scenario/types.ts';

/** Against which wheels roll, N·s/m each: as the gaits take it. */
const DRAG = 0.5;
/** A ride ends by itself after this, s. */
const LONGEST = 300;
/** Between rows of what is kept, s, and how fine its numbers are. */
const APART = 0.1;
const FINE = 1e4;

/** What is ridden: the board alone, with a rider, with one whose legs and hips move too. Each has a best time of its own. */
export type Kind = 'board' | 'rider' | 'body';

export interface Best {
  /** s. */
  time: number;
  /** `t`, then every coordinate and its rate. */
  columns: string[];
  /** Of each column, a value about every tenth of a second. */
  values: number[][];
}

/**
 * @param rider whether somebody stands on the board
 * @param help share of it at the beginning
 * @param commands told before
 * @param body the rider's own parameters; the system's without
 * @param free whether the rider's legs and hips move too
 */
export function rideScenario(
  rider: boolean,
  help: number,
  commands: readonly RideCommand[] = [],
  body: Readonly<Record<string, number>> = {},
  free = false,
): ScenarioFile {
  return {
    version: 1,
    system: rider ? 'ripstik-rider' : 'ripstik',
    parameters: { wheelDrag: DRAG, ...(rider ? body : {}) },
    // Nobody stands quite upright.
    ...(rider ? { initial: { beta: '1 deg' } } : {}),
    ...(rider && free ? { release: ['crouch', 'twist'] } : {}),
    control: { type: 'ride', help, speed: 1.5, commands },
    method: { rtol: 1e-6, atol: 1e-8 },
    duration: LONGEST,
  };
}

/** The same ride, up to a time (s), as it is to go on from there; null for what is no ride. */
export function upTo(file: ScenarioFile | null | undefined, time: number): ScenarioFile | null {
  if (file?.control?.type !== 'ride') return null;
  const control: RideControl = { ...file.control, commands: (file.control.commands ?? []).filter(([t]) => t <= time) };
  return { ...file, control, duration: Math.max(LONGEST, time + LONGEST) };
}

/**
 * @param trajectory of the ride
 * @param coordinates of what is ridden
 * @param time at which it was through, s
 */
export function bestOf(trajectory: Trajectory, coordinates: readonly string[], time: number): Best {
  const columns = ['t', ...coordinates, ...coordinates.map((name) => `${name}_dot`)];
  const all = columns.map((name) => trajectory.column(name)!);
  const values: number[][] = columns.map(() => []);
  for (let i = 0, due = 0; i < trajectory.length && all[0]![i]! <= time; i++) {
    if (all[0]![i]! < due) continue;
    due += APART;
    all.forEach((column, k) => values[k]!.push(Math.round(column[i]! * FINE) / FINE));
  }
  return { time, columns, values };
}

/** The kept ride as a motion's rows. */
export const rowsOf = ({ columns, values }: Best): Trajectory =>
  Trajectory.of(
    columns,
    values.map((column) => Float64Array.from(column)),
  );

/** Where the best ride was at a time (s); it waits at its end. */
export function ghostAt({ columns, values }: Best, time: number): { x: number; y: number } {
  const t = values[0]!;
  const next = t.findIndex((row) => row > time);
  const i = next < 0 ? t.length - 1 : Math.max(next - 1, 0);
  const j = Math.min(i + 1, t.length - 1);
  const share = j > i ? Math.min(Math.max((time - t[i]!) / (t[j]! - t[i]!), 0), 1) : 0;
  const at = (name: string): number => {
    const column = values[columns.indexOf(name)]!;
    return column[i]! + share * (column[j]! - column[i]!);
  };
  return { x: at('X'), y: at('Y') };
}

/** Under the prefix of all that the page stores, so that it is forgotten with the rest. */
const key = (kind: Kind): string => `ripstik.ride.${kind}`;

export function storedBest(kind: Kind): Best | null {
  try {
    const found = JSON.parse(localStorage.getItem(key(kind)) ?? 'null') as Best | null;
    return found && isWhole(found) ? found : null;
  } catch {
    // No storage, or not what was put there: no best ride.
    return null;
  }
}

export function storeBest(kind: Kind, best: Best): void {
  try {
    localStorage.setItem(key(kind), JSON.stringify(best));
  } catch {
    // Full or not allowed: it holds for this visit.
  }
}

function isWhole({ time, columns, values }: Best): boolean {
  if (!Number.isFinite(time) || !Array.isArray(columns) || !Array.isArray(values)) return false;
  const rows = values[0]?.length ?? 0;
  return (
    ['t', 'X', 'Y'].every((name) => columns.includes(name)) &&
    columns[0] === 't' &&
    rows > 0 &&
    columns.length === values.length &&
    values.every((column) => column.length === rows && column.every((x) => Number.isFinite(x)))
  );
}
