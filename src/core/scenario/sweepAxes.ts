import type { MethodOptions, ScenarioFile } from './types.ts';

/** More runs than this are refused: a table of them is no longer read. */
export const MOST_SWEEP_RUNS = 2000;

/** One value of an axis: a number, or a method of its own. */
export interface SweepValue {
  /** SI; for a method its place in the list. */
  value: number;
  label: string;
  method?: Partial<MethodOptions>;
}

export interface SweepAxis {
  /** As in `SweepPath` of sweepPaths.ts, or `method`. */
  path: string;
  label: string;
  unit: string;
  angle: boolean;
  values: readonly SweepValue[];
}

/**
 * `count` numbers from `from` to `to`, both included.
 *
 * @param from the first
 * @param to the last
 * @param count whole, 2 or more
 * @param scale how they are spaced
 * @throws Error with words for a field
 */
export function spaced(from: number, to: number, count: number, scale: 'linear' | 'logarithmic'): number[] {
  if (!Number.isFinite(from) || !Number.isFinite(to)) throw new Error('from and to must be numbers');
  if (!Number.isInteger(count) || count < 2 || count > MOST_SWEEP_RUNS)
    throw new Error(`the number of values must be a whole number from 2 to ${MOST_SWEEP_RUNS}`);
  if (from === to) throw new Error('from and to must differ');
  if (scale === 'logarithmic' && !(from * to > 0)) throw new Error('a logarithmic range must not reach zero');
  const at = (share: number): number => (scale === 'linear' ? from + share * (to - from) : from * (to / from) ** share);
  return Array.from({ length: count }, (_, i) =>
    i === 0 ? from : i === count - 1 ? to : Number(at(i / (count - 1)).toPrecision(13)),
  );
}

/**
 * The scenario with this value of the axis.
 *
 * @param file as written
 */
export function withAxisValue(file: ScenarioFile, { path }: SweepAxis, { value, method }: SweepValue): ScenarioFile {
  return method ? { ...file, method } : withValue(file, path, value);
}

/**
 * The scenario with another value at a place.
 *
 * @param file as written
 * @param path `initial.alpha`; several joined by `+` take the same value
 * @param value number in SI, or text as a scenario has it
 */
export function withValue<T extends object>(file: T, path: string, value: number | string): T {
  return path.split('+').reduce((next, part) => withLeaf(next, part.split('.'), value), file);
}

function withLeaf<T extends object>(node: T, [key, ...rest]: readonly string[], value: number | string): T {
  const inner = (node as Record<string, unknown>)[key!];
  return { ...node, [key!]: rest.length === 0 ? value : withLeaf((inner ?? {}) as object, rest, value) };
}
