import type { SystemView } from '../model/system.ts';
import { columnOf } from './columns.ts';
import { Envelope } from './envelope.ts';
import { interpolate, TURN } from './interpolation.ts';
import { recipeOf, type Recipe } from './recipes.ts';
import { rowAt } from './resample.ts';
import type { Trajectory } from './trajectory.ts';

/** A motion as columns are computed of it. */
export interface ColumnSource {
  system: SystemView;
  parameters: Readonly<Record<string, number>>;
  trajectory: Trajectory;
}

/** Rows computed in one go, so that a long motion never stops the page. */
const AT_ONCE = 20_000;

/** Values of one column of a growing motion, recorded or computed as they are asked for, with their envelope. */
export class ColumnValues {
  readonly envelope = new Envelope();
  readonly name: string;
  private readonly trajectory: Trajectory;
  private readonly recipe: Recipe | null;
  private readonly period: number;
  private made = new Float64Array(0);
  private count = 0;
  private generation = 0;

  /** @param wrapped angles within half a turn of zero */
  constructor({ system, parameters, trajectory }: ColumnSource, name: string, wrapped = false) {
    this.trajectory = trajectory;
    this.name = name;
    const has = (column: string): boolean => trajectory.has(column);
    const { turns } = columnOf(system.meta, name);
    const plain: Recipe | null = has(name) ? null : (recipeOf(system, parameters, has, name) ?? NOTHING);
    this.recipe = wrapped && turns ? wrappedOf(plain ?? recorded(name)) : plain;
    this.period = turns && (wrapped || trajectory.recorded) ? TURN : 0;
  }

  /** Values so far; fewer than there are rows while they are still computed. */
  get(): Float64Array {
    const { trajectory, recipe } = this;
    if (trajectory.generation !== this.generation) {
      this.generation = trajectory.generation;
      this.envelope.clear();
      this.count = 0;
    }
    if (!recipe) return trajectory.column(this.name)!;
    // The newest row of a thinned motion may still be replaced: it is not kept.
    const rows = Math.min(trajectory.settled, this.count + AT_ONCE);
    if (this.made.length < rows) {
      const grown = new Float64Array(Math.max(rows, 2 * this.made.length, 1024));
      grown.set(this.made.subarray(0, this.count));
      this.made = grown;
    }
    const columns = recipe.from.map((name) => trajectory.column(name)!);
    let before = this.count > 0 ? this.made[this.count - 1]! : 0;
    for (; this.count < rows; this.count++) this.made[this.count] = before = recipe.value(columns, this.count, before);
    return this.made.subarray(0, rows);
  }

  /** Its rate at the rows, where that is recorded and no whole turns lie between them: for what draws between rows. */
  get rate(): Float64Array | undefined {
    return this.recipe || this.period > 0 ? undefined : this.trajectory.rateOf(this.name);
  }

  /** Rows are missing: ask again. */
  get behind(): boolean {
    return this.recipe !== null && this.count < this.trajectory.settled;
  }

  /** At a time, clamped to the rows there are; NaN where there is none. */
  at(time: number): number {
    const values = this.get();
    if (values.length === 0) return NaN;
    const { trajectory } = this;
    const rate = this.recipe ? undefined : trajectory.rateOf(this.name);
    const row = rowAt(trajectory, time, values.length);
    const value = interpolate(trajectory.column('t')!, values, rate, row, time, this.period);
    return this.recipe && this.period > 0 ? halfTurn(value) : value;
  }
}

const NOTHING: Recipe = { from: [], value: () => NaN };
const recorded = (name: string): Recipe => ({ from: [name], value: (columns, row) => columns[0]![row]! });
const halfTurn = (angle: number): number => Math.atan2(Math.sin(angle), Math.cos(angle));
const wrappedOf = (of: Recipe): Recipe => ({ ...of, value: (columns, row) => halfTurn(of.value(columns, row, 0)) });

/**
 * Every row of a finished motion.
 *
 * @param source the motion
 * @param name of the column
 */
export function everyRow(source: ColumnSource, name: string): Float64Array {
  const values = new ColumnValues(source, name);
  let found = values.get();
  while (values.behind) found = values.get();
  return found;
}

const made = new WeakMap<Trajectory, Map<string, ColumnValues>>();

/**
 * The values of a column, made once a motion.
 *
 * @param source the motion
 * @param name of the column
 * @param wrapped angles are brought to within half a turn of zero
 */
export function valuesOf(source: ColumnSource, name: string, wrapped = false): ColumnValues {
  const key = wrapped ? `${name} wrapped` : name;
  let columns = made.get(source.trajectory);
  if (!columns) made.set(source.trajectory, (columns = new Map()));
  let found = columns.get(key);
  if (!found) columns.set(key, (found = new ColumnValues(source, name, wrapped)));
  return found;
}
