/** Rides as scenarios, and the best one through the course, which this browser keeps. */
import type { Trajectory } from '../../core/motion/trajectory.ts';
import type { RideCommand, RideControl, ScenarioFile } from '../../core/scenario/types.ts';

/** Against which wheels roll, N·s/m each: as the gaits take it. */
const DRAG = 0.5;
/** A ride ends by itself after this, s. */
const LONGEST = 300;
/** Of the kept path, s. */
const APART = 0.1;

export interface Best {
  /** s. */
  time: number;
  /** X and Y in turn, one pair every tenth of a second, m. */
  path: number[];
}

export function rideScenario(rider: boolean, help: number, commands: readonly RideCommand[] = []): ScenarioFile {
  return {
    version: 1,
    system: rider ? 'ripstik-rider' : 'ripstik',
    parameters: { wheelDrag: DRAG },
    // Nobody stands quite upright.
    ...(rider ? { initial: { beta: '1 deg' } } : {}),
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

export function pathOf(trajectory: Trajectory, until: number): number[] {
  const [t, x, y] = ['t', 'X', 'Y'].map((name) => trajectory.column(name)!);
  const path: number[] = [];
  for (let i = 0, due = 0; i < trajectory.length && t![i]! <= until; i++) {
    if (t![i]! < due) continue;
    due += APART;
    path.push(Math.round(x![i]! * 1000) / 1000, Math.round(y![i]! * 1000) / 1000);
  }
  return path;
}

/** Where the best ride was at a time (s); it waits at its end. */
export function ghostAt({ path }: Best, time: number): { x: number; y: number } {
  const last = path.length / 2 - 1;
  const place = Math.min(time / APART, last);
  const i = Math.min(Math.floor(place), Math.max(last - 1, 0));
  const share = Math.min(place - i, 1);
  const at = (k: number): number => path[Math.min(2 * i + k, path.length - 1)]!;
  return { x: at(0) + share * (at(2) - at(0)), y: at(1) + share * (at(3) - at(1)) };
}

/** Under the prefix of all that the page stores, so that it is forgotten with the rest. */
const key = (rider: boolean): string => `ripstik.ride.${rider ? 'rider' : 'board'}`;

export function storedBest(rider: boolean): Best | null {
  try {
    const found = JSON.parse(localStorage.getItem(key(rider)) ?? 'null') as Best | null;
    const whole = found && Number.isFinite(found.time) && Array.isArray(found.path) && found.path.length >= 2;
    return whole && found.path.every((x) => Number.isFinite(x)) ? found : null;
  } catch {
    // No storage, or not what was put there: no best ride.
    return null;
  }
}

export function storeBest(rider: boolean, best: Best): void {
  try {
    localStorage.setItem(key(rider), JSON.stringify(best));
  } catch {
    // Full or not allowed: it holds for this visit.
  }
}
