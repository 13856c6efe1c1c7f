import type { SystemMeta } from '../model/system.ts';
import type { Checker } from './checker.ts';
import { checkComputer } from './computer.ts';
import { ScenarioError, type RideCommand, type RideControl } from './types.ts';

/** The commands of a ride: what a rider is told to do, as data. Left is positive. */

/** `sample` (s) in which commands are taken and torques asked; full help; `speed` (m/s) that a start pushes up to. */
export const RIDE_DEFAULTS = { sample: 0.005, help: 1, speed: 1.5 } as const;

/** What each command may be worth. The first eight set one thing, the others are motion primitives made of them. */
export const RIDE_COMMANDS: Readonly<Record<string, readonly [least: number, most: number]>> = {
  lean: [-1, 1],
  twist: [-1, 1],
  pump: [0, 1],
  push: [0, 1],
  brake: [0, 1],
  help: [0, 1],
  crouch: [0, 1],
  hips: [-1, 1],
  start: [0, 1],
  coast: [0, 1],
  left: [0, 1],
  right: [0, 1],
  straight: [0, 1],
  stop: [0, 1],
};

/** Commands for a rider's own body, and the coordinate that each moves. */
export const RIDE_BODY: Readonly<Record<string, string>> = { crouch: 'crouch', hips: 'twist' };

/**
 * Whether a rider can be told a command: to crouch, or to turn the hips, where that coordinate is there and free.
 *
 * @param name of the command
 * @param meta of the system
 * @param hold names of the coordinates that are held
 */
export function canBeTold(name: string, meta: Pick<SystemMeta, 'coordinates'>, hold: readonly string[]): boolean {
  const coordinate = RIDE_BODY[name];
  if (coordinate === undefined) return name in RIDE_COMMANDS;
  return meta.coordinates.some((c) => c.name === coordinate) && !hold.includes(coordinate);
}

/** Of a sample: a time that is a multiple of it may be a last digit early. */
const ROUNDING = 1e-6;

/** A ride of an hour with a command in every second tick of a hand that is never still. */
const MOST_COMMANDS = 50_000;

/**
 * @param meta of a system
 * @returns whether it has feet that turn plates, and a forward direction
 */
export const isRidable = (meta: SystemMeta): boolean => meta.gait !== undefined && 'along' in (meta.forward ?? {});

/**
 * @param c collects the errors
 * @param control entries as written, by key
 * @param meta of the system
 * @param inputs names of all its inputs
 * @param limits `control.limits`
 * @param hold names of the coordinates that are held
 */
export function checkRide(
  c: Checker,
  control: ReadonlyMap<string, unknown>,
  meta: SystemMeta,
  inputs: readonly string[],
  limits: Record<string, number>,
  hold: readonly string[],
): RideControl | null {
  if (!isRidable(meta))
    return (
      c.add('control.type', `"ride" is for a board with feet, ripstik or ripstik-rider, not for ${meta.id}`) ?? null
    );
  const number = (key: 'help' | 'speed', rule: { above?: number; least?: number; most: number }): number =>
    (control.get(key) === undefined ? undefined : c.number(`control.${key}`, control.get(key), rule)) ??
    RIDE_DEFAULTS[key];
  const timed = new Map([['sample', RIDE_DEFAULTS.sample as unknown], ...control]);
  c.number('control.sample', timed.get('sample'), { above: 0 });
  return {
    type: 'ride',
    commands: checkCommands(c, 'control.commands', control.get('commands'), { meta, hold }),
    help: number('help', { least: 0, most: 1 }),
    speed: number('speed', { above: 0, most: 20 }),
    limits,
    ...checkComputer(c, timed, inputs, limits, null),
  };
}

/**
 * @param c collects the errors
 * @param path of the list
 * @param raw as written: `[[time, command, value], …]`, a value of 1 may be left out
 * @param ridden whose body is told, where that is known: the system and the coordinates that are held
 */
export function checkCommands(
  c: Checker,
  path: string,
  raw: unknown,
  ridden?: { meta: SystemMeta; hold: readonly string[] },
): RideCommand[] {
  if (raw === undefined) return [];
  if (!Array.isArray(raw)) {
    c.add(path, 'must be a list of [time, command, value], as [[0, "start"], [3, "twist", 0.5]]');
    return [];
  }
  if (raw.length > MOST_COMMANDS) {
    c.add(path, `${raw.length} commands are more than the ${MOST_COMMANDS} allowed`);
    return [];
  }
  const commands: RideCommand[] = [];
  let last = 0;
  for (const [i, entry] of raw.entries()) {
    const at = `${path}[${i}]`;
    if (!Array.isArray(entry) || entry.length < 2 || entry.length > 3) {
      c.add(at, 'must be [time, command, value], as [3, "twist", 0.5]');
      continue;
    }
    const [rawTime, rawName, rawValue = 1] = entry as unknown[];
    const time = c.number(`${at}[0]`, rawTime, { least: 0 });
    const name = c.oneOf(`${at}[1]`, rawName, Object.keys(RIDE_COMMANDS));
    if (time === undefined || name === undefined) continue;
    if (ridden && !canBeTold(name, ridden.meta, ridden.hold)) {
      const coordinate = RIDE_BODY[name]!;
      const held = ridden.hold.includes(coordinate);
      c.add(
        `${at}[1]`,
        held
          ? `"${name}" moves ${coordinate}, which is held: put it in "release"`
          : `"${name}" is for a rider who has ${coordinate}; ${ridden.meta.id} has none`,
      );
      continue;
    }
    const [least, most] = RIDE_COMMANDS[name]!;
    const value = c.number(`${at}[2]`, rawValue, { least, most });
    if (value === undefined) continue;
    if (time < last)
      c.add(`${at}[0]`, `${time} s is before the command above it at ${last} s: put them in order of time`);
    last = Math.max(last, time);
    commands.push([time, name, value]);
  }
  return commands;
}

/**
 * Tells the rider something while a ride is computed: it acts from the next sample that has not been asked for yet, and the
 * ride then has it as if it had been written so before.
 *
 * @param control of the scenario that is being computed; its list grows
 * @param time that the ride is computed up to, s
 * @param name of the command
 * @param value of it; 1 where it takes no share
 * @returns the command as it is in the list
 */
export function tell(control: RideControl, time: number, name: string, value: number): RideCommand {
  const [least, most] = RIDE_COMMANDS[name] ?? [NaN, NaN];
  if (!(value >= least && value <= most))
    throw new ScenarioError('control.commands', `no ride has the command ${name} ${value}`);
  const sample = control.sample!;
  const command: RideCommand = [(Math.floor(time / sample + ROUNDING) + 1) * sample, name, value];
  (control.commands as RideCommand[]).push(command);
  return command;
}

/**
 * The last sample up to a time: a ride that waits there for what comes takes the steps of one that does not.
 *
 * @param control of the ride
 * @param time s
 */
export const sampleUpTo = ({ sample }: RideControl, time: number): number =>
  Math.floor(time / sample! + ROUNDING) * sample!;
