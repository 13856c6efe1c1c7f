import type { Measure } from '../cases/case.ts';
import { inputsOf } from '../model/inputs.ts';
import { groundCoordinates } from './columns.ts';
import { recipeOf, type Recipe } from './recipes.ts';
import type { RunCounts, RunEnd } from '../simulation/simulation.ts';
import type { System, SystemMeta } from '../model/system.ts';

/**
 * A number that a sweep keeps of each run. Of a column, over all rows: `end`, `max`, `min`. Else:
 * `time` when it ended (s), `drift` of energy (as `RunCounts`), `residual`, `steps`, `seconds` of computing,
 * `work` that the inputs put in (J; what they take out is not given back), `distance` along the path on the ground (m),
 * `costOfTransport`: without dimension, work / (mass x gravity x distance).
 */
export type SweepMeasure =
  | Extract<Measure, { kind: 'end' | 'max' | 'min' }>
  | { kind: 'time' | 'drift' | 'residual' | 'steps' | 'seconds' | 'work' | 'distance' | 'costOfTransport' };

export type FactKind = Exclude<SweepMeasure['kind'], 'end' | 'max' | 'min'>;

/** Of standard gravity, for systems that name none. */
const STANDARD_GRAVITY = 9.81;

/**
 * Extra columns that the measures need of a run.
 *
 * @param measures of the sweep
 * @param inputs of the system, which may have any name
 */
export function extrasFor(measures: readonly SweepMeasure[], inputs: readonly { name: string }[] = []): string[] {
  const columns = measures.flatMap((m) => ('column' in m ? [m.column] : []));
  const extras: string[] = [];
  if (columns.some((c) => /^lambda_/.test(c))) extras.push('lambda');
  if (columns.includes('energy')) extras.push('energy');
  if (columns.includes('residual')) extras.push('residual');
  // What is neither of these nor a state is an input.
  if (
    measures.some(({ kind }) => kind === 'work' || kind === 'costOfTransport') ||
    columns.some((c) => /^(tau|f)_/.test(c) || inputs.some(({ name }) => name === c))
  )
    extras.push('inputs');
  return extras;
}

/**
 * Whether rows between the first and the last change what is measured: the end of a coordinate or of its rate is in the
 * last row, and when a run ended or how many steps it took is in none. Each row costs a look into a step and a projection.
 *
 * @param measures of the sweep
 */
export function needsRows(measures: readonly SweepMeasure[], { coordinates }: SystemMeta): boolean {
  const states = new Set(coordinates.flatMap(({ name }) => [name, `${name}_dot`]));
  return measures.some((m) =>
    m.kind === 'end' ? !states.has(m.column) : !['time', 'steps', 'seconds'].includes(m.kind),
  );
}

/** Measures a run chunk by chunk, so that no row is kept. */
export class RunMeasurer {
  private readonly measures: readonly SweepMeasure[];
  private readonly values: Float64Array;
  private readonly places: Int32Array;
  /** Of measured columns that are not recorded. */
  private readonly made: readonly (MadeColumn | null)[];
  private readonly ground: readonly number[];
  /** Per recorded input: its column, and the rates it works on with their factors. */
  private readonly efforts: readonly { column: number; rates: readonly { column: number; factor: number }[] }[];
  private readonly lastPlace: Float64Array;
  private readonly weight: number;
  private lastTime = NaN;
  private lastPower = 0;
  private distance = 0;
  private work = 0;

  /**
   * @param columns the run's
   * @param parameters SI, by name
   * @param q start, for the mass that moves along the ground
   */
  constructor(
    system: System,
    parameters: Readonly<Record<string, number>>,
    columns: readonly string[],
    measures: readonly SweepMeasure[],
    q: Float64Array,
  ) {
    this.measures = measures;
    const at = (name: string): number => columns.indexOf(name);
    this.places = Int32Array.from(measures, (m) => ('column' in m ? at(m.column) : -1));
    this.made = measures.map((m) => {
      if (!('column' in m) || at(m.column) >= 0) return null;
      const recipe = recipeOf(system, parameters, (name) => columns.includes(name), m.column);
      return recipe && new MadeColumn(recipe, recipe.from.map(at));
    });
    this.values = Float64Array.from(measures, ({ kind }) =>
      kind === 'max' ? -Infinity : kind === 'min' ? Infinity : NaN,
    );
    const ground = groundCoordinates(system.meta);
    this.ground = ground.map(at);
    this.lastPlace = new Float64Array(ground.length);
    this.efforts = inputsOf(system.meta)
      .filter(({ name }) => at(name) >= 0)
      .map(({ name, column }) => ({
        column: at(name),
        rates: Object.entries(column).map(([coordinate, factor]) => ({ column: at(`${coordinate}_dot`), factor })),
      }));
    this.weight =
      ground.length > 0 ? movedMass(system, parameters, q) * (parameters['gravity'] ?? STANDARD_GRAVITY) : NaN;
  }

  /** Takes the next rows, column by column. */
  take(chunk: readonly Float64Array[], rows: number): void {
    for (let m = 0; m < this.places.length; m++) {
      const place = this.places[m]!;
      if (place >= 0) this.extend(m, chunk[place]!, rows);
      const made = this.made[m];
      if (made) this.extend(m, made.next(chunk, rows), rows);
    }
    for (let row = 0; row < rows; row++) this.move(chunk, row);
  }

  /** One number a measure; NaN where the run has none. */
  result(end: RunEnd, counts: RunCounts, seconds: number): number[] {
    const facts: Record<FactKind, number> = {
      time: end.time,
      drift: counts.energyDrift ?? NaN,
      residual: counts.residual,
      steps: counts.steps,
      seconds,
      work: this.efforts.length > 0 ? this.work : NaN,
      distance: this.ground.length > 0 ? this.distance : NaN,
      costOfTransport: this.efforts.length > 0 && this.distance > 0 ? this.work / (this.weight * this.distance) : NaN,
    };
    return this.measures.map((m, i) => {
      const value = 'column' in m ? (this.places[i]! < 0 && !this.made[i] ? NaN : this.values[i]!) : facts[m.kind];
      return Number.isFinite(value) ? value : NaN;
    });
  }

  private extend(m: number, values: Float64Array, rows: number): void {
    const { kind } = this.measures[m]!;
    if (rows === 0) return;
    if (kind === 'end') this.values[m] = values[rows - 1]!;
    for (let row = 0; row < rows && kind !== 'end'; row++) {
      const value = values[row]!;
      if (kind === 'max' ? value > this.values[m]! : value < this.values[m]!) this.values[m] = value;
    }
  }

  private move(chunk: readonly Float64Array[], row: number): void {
    const time = chunk[0]![row]!;
    const first = Number.isNaN(this.lastTime);
    let square = 0;
    for (let k = 0; k < this.ground.length; k++) {
      const place = chunk[this.ground[k]!]![row]!;
      const step = first ? 0 : place - this.lastPlace[k]!;
      square += step * step;
      this.lastPlace[k] = place;
    }
    this.distance += Math.sqrt(square);
    const power = this.powerAt(chunk, row);
    if (!first) this.work += 0.5 * (this.lastPower + power) * (time - this.lastTime);
    this.lastPower = power;
    this.lastTime = time;
  }

  /** Power of the inputs that put energy in, W. */
  private powerAt(chunk: readonly Float64Array[], row: number): number {
    let sum = 0;
    for (const { column, rates } of this.efforts) {
      let rate = 0;
      for (const r of rates) rate += r.factor * chunk[r.column]![row]!;
      sum += Math.max(0, chunk[column]![row]! * rate);
    }
    return sum;
  }
}

/** The mass that a push along the ground meets when nothing turns: the mass matrix's entry of that coordinate, kg. */
function movedMass({ meta, mechanics }: System, parameters: Readonly<Record<string, number>>, q: Float64Array): number {
  const n = meta.coordinates.length;
  const p = Float64Array.from(meta.parameters, (m) => parameters[m.name] ?? m.default);
  const massMatrix = new Float64Array(n * n);
  mechanics(q, new Float64Array(n), p, massMatrix, new Float64Array(n));
  const i = meta.coordinates.findIndex(({ name }) => name === groundCoordinates(meta)[0]);
  return massMatrix[i * n + i]!;
}

/** A column computed from recorded ones, chunk by chunk: what is summed up over rows goes on where the last chunk ended. */
class MadeColumn {
  private readonly recipe: Recipe;
  private readonly from: readonly number[];
  private before = 0;
  /** The last row of the chunk before, in the columns of `from`. */
  private lastRow: readonly number[] | null = null;

  /** @param from places of the recipe's columns in a chunk */
  constructor(recipe: Recipe, from: readonly number[]) {
    this.recipe = recipe;
    this.from = from;
  }

  next(chunk: readonly Float64Array[], rows: number): Float64Array {
    const values = new Float64Array(rows);
    if (rows === 0) return values;
    const { lastRow } = this;
    const ahead = lastRow ? 1 : 0;
    const columns = this.from.map((place, k) => {
      const column = new Float64Array(rows + ahead);
      if (lastRow) column[0] = lastRow[k]!;
      column.set(chunk[place]!.subarray(0, rows), ahead);
      return column;
    });
    for (let row = 0; row < rows; row++)
      values[row] = this.before = this.recipe.value(columns, row + ahead, this.before);
    this.lastRow = columns.map((column) => column[rows + ahead - 1]!);
    return values;
  }
}
