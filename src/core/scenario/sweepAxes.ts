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
