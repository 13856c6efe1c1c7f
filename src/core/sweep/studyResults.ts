/** A sweep's results as a table that was read: its columns, what is varied in it, and the scenario of each run. */
import type { SystemMeta } from '../model/system.ts';
import { withValue } from '../scenario/sweepAxes.ts';
import type { ScenarioFile } from '../scenario/types.ts';
import { checkStudy, type Study } from './study.ts';

/** Numbers in SI, NaN where there is none; or words. */
export type StudyColumn = Float64Array | readonly string[];

export interface StudyResults {
  /** Of the file. */
  title: string;
  /** The study that the file carries; null where it carries none. */
  study: Study | null;
  /** `1/1` for all of a study. */
  shard: string;
  /** What computed it; empty where the file does not say. */
  engine: string;
  rows: number;
  /** By name, in the order of the file. */
  columns: ReadonlyMap<string, StudyColumn>;
}

/** What every table of results has, beside what is varied and measured. */
const ALWAYS = ['index', 'reason', 'time'] as const;

/**
 * @param title of the file
 * @param columns by name, all of one length
 * @param facts what the file says of itself
 * @param metas of the systems, by id
 * @throws Error that says what the table lacks; ScenarioError with the place of what is wrong in the study
 */
export function studyResults(
  title: string,
  columns: ReadonlyMap<string, StudyColumn>,
  facts: { study?: unknown; shard?: unknown; engine?: string },
  metas: Readonly<Record<string, SystemMeta>>,
): StudyResults {
  const missing = ALWAYS.filter((name) => !columns.has(name));
  const study = facts.study === undefined ? null : checkStudy(facts.study, metas);
  if (study)
    missing.push(...([...study.paths, ...study.measureNames] as typeof missing).filter((n) => !columns.has(n)));
  if (missing.length > 0) throw new Error(`it has no column "${missing[0]!}", which the results of a sweep have`);
  const index = columns.get('index')!;
  if (!(index instanceof Float64Array)) throw new Error('its column "index" holds words, not numbers');
  const odd = oddIndex(index);
  if (odd !== null) throw new Error(odd);
  if (columns.get('reason') instanceof Float64Array) throw new Error('its column "reason" holds numbers, not words');
  const shard = typeof facts.shard === 'string' ? facts.shard : '1/1';
  return { title, study, shard, engine: facts.engine ?? '', rows: index.length, columns };
}

/** Results of several shards are joined by their indices: none is there twice, none is broken. */
function oddIndex(index: Float64Array): string | null {
  const bad = index.findIndex((i) => !Number.isSafeInteger(i) || i < 0);
  if (bad >= 0)
    return `its column "index" holds ${index[bad]} in row ${bad + 1}, where a whole number is right; the file may be damaged`;
  const sorted = Float64Array.from(index).sort();
  const twice = sorted.findIndex((i, k) => k > 0 && i === sorted[k - 1]);
  return twice < 0 ? null : `run ${sorted[twice]} is there twice: shards were joined twice, or the file is damaged`;
}

/**
 * The columns that are varied: those of the study, or those with a place's name where the file carries none.
 *
 * @param results of a sweep
 */
export function variedOf({ study, columns }: StudyResults): readonly string[] {
  return study?.paths ?? [...columns.keys()].filter((name) => /^(initial|parameters|control|method)\./.test(name));
}

/**
 * The scenario of a row, with the row's own values; null where the file carries no study.
 *
 * @param results of a sweep
 * @param row from 0
 */
export function scenarioOfRow({ study, columns }: StudyResults, row: number): ScenarioFile | null {
  if (!study) return null;
  return study.paths.reduce<ScenarioFile>(
    (file, path) => withValue(file, path, columns.get(path)![row]!),
    study.file.scenario,
  );
}

/**
 * Different values, rising; null where there are more.
 *
 * @param values NaN is left out
 * @param most that are listed
 */
export function differentValues(values: ArrayLike<number>, most: number): number[] | null {
  const found = new Set<number>();
  for (let i = 0; i < values.length; i++) {
    const value = values[i]!;
    if (Number.isNaN(value)) continue;
    found.add(value);
    if (found.size > most) return null;
  }
  return [...found].sort((a, b) => a - b);
}

/** A table of rows over two columns whose values come again and again. */
export interface Grid {
  /** Rising. */
  x: readonly number[];
  y: readonly number[];
  /** The row in each cell, from the lowest y, x fastest; -1 where there is none. */
  cells: Int32Array;
  /** Rows that found their cell taken. */
  hidden: number;
}

/** A picture has no more cells in a line than it has pixels. */
const MOST_STEPS = 1000;
/** A grid of which less is there is a cloud of points, a share. */
const LEAST_FILLED = 0.2;

/**
 * The rows as a grid; null where they are none.
 *
 * @param x of each row
 * @param y of each row
 * @param rows those that count
 */
export function gridOf(x: Float64Array, y: Float64Array, rows: ArrayLike<number>): Grid | null {
  const at = (column: Float64Array): number[] | null =>
    differentValues(
      Float64Array.from(rows, (row) => column[row]!),
      MOST_STEPS,
    );
  const [across, up] = [at(x), at(y)];
  if (!across || !up || across.length < 2 || up.length < 2) return null;
  const places = [across, up].map((values) => new Map(values.map((value, i) => [value, i])));
  const cells = new Int32Array(across.length * up.length).fill(-1);
  let taken = 0;
  let hidden = 0;
  for (let i = 0; i < rows.length; i++) {
    const row = rows[i]!;
    const [c, r] = [places[0]!.get(x[row]!), places[1]!.get(y[row]!)];
    if (c === undefined || r === undefined) continue;
    const cell = r * across.length + c;
    if (cells[cell]! >= 0) hidden++;
    else {
      cells[cell] = row;
      taken++;
    }
  }
  return taken >= LEAST_FILLED * cells.length ? { x: across, y: up, cells, hidden } : null;
}
