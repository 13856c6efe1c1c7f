import type { ImportPlan } from '../plan.ts';
import type { Source } from '../source.ts';
import { formOf } from './cells.ts';
import { unitInRow, type Layout } from './layout.ts';
import { isUnit } from '../units/units.ts';

/** More names would be no columns of a motion. */
const MOST_NAMES = 200;

/**
 * A long table, one row a value: a column of few names that come again and again, beside a time and one column of
 * numbers. Null for any other.
 */
export function longOf(layout: Layout, sources: readonly Source[], time: number | undefined): ImportPlan['long'] {
  if (time === undefined || sources.length < 3 || layout.rows.length < 4) return null;
  const comma = layout.decimal === ',';
  const forms = sources.map((source) => {
    const cells = layout.rows.map((row) => (row[source.index] ?? '').trim());
    const filled = cells.filter((cell) => formOf(cell, comma) !== 'missing');
    const share = (form: string): number =>
      filled.filter((cell) => formOf(cell, comma) === form).length / (filled.length || 1);
    return {
      index: source.index,
      name: source.name,
      texts: share('text'),
      numbers: share('number'),
      distinct: new Set(filled),
    };
  });
  const names = forms.filter(
    (f) =>
      f.index !== time &&
      f.texts > 0.9 &&
      ![...f.distinct].every(isUnit) &&
      f.distinct.size >= 2 &&
      f.distinct.size <= Math.min(MOST_NAMES, layout.rows.length / 2),
  );
  const values = forms.filter((f) => f.index !== time && f.numbers > 0.9 && !/^(?:index|id|row|)$/i.test(f.name));
  const value =
    values.find((f) => /^(?:value|values|val|wert|valeur|valor|valore|data|reading|y)$/i.test(f.name)) ?? values.at(-1);
  const name = names.sort((a, b) => b.distinct.size - a.distinct.size)[0];
  if (!name || !value || values.length > 2) return null;
  return { time, name: name.index, value: value.index, names: [...name.distinct] };
}

/** The unit beside the values of each name, where a column holds it; '' for none. */
export function longUnits(layout: Layout, long: NonNullable<ImportPlan['long']>): string[] {
  for (let column = 0; column < layout.width; column++) {
    if (column === long.time || column === long.name || column === long.value) continue;
    const units = new Map<string, Set<string>>();
    for (const row of layout.rows) {
      const name = (row[long.name] ?? '').trim();
      const known = units.get(name) ?? new Set<string>();
      units.set(name, known.add((row[column] ?? '').trim()));
    }
    const one = [...units.values()].every((known) => known.size === 1);
    const all = [...units.values()].flatMap((known) => [...known]).filter((unit) => unitInRow(unit) !== '');
    if (one && all.length > 0 && all.every(isUnit))
      return long.names.map((name) => unitInRow([...(units.get(name) ?? [''])][0]!));
  }
  return long.names.map(() => '');
}

/** Turns rows of a long table into rows with a cell for each name: those of one time are one row. */
export class Pivot {
  private readonly long: NonNullable<ImportPlan['long']>;
  private readonly place: ReadonlyMap<string, number>;
  /** By time as written, in the order of the file. */
  private readonly rows = new Map<string, { cells: string[]; line: number }>();
  private again = 0;
  /** Names that were not among the first rows. */
  readonly unknown = new Set<string>();

  constructor(long: NonNullable<ImportPlan['long']>) {
    this.long = long;
    this.place = new Map(long.names.map((name, i) => [name, i + 1]));
  }

  push(cells: readonly string[], line: number): void {
    const time = (cells[this.long.time] ?? '').trim();
    const name = (cells[this.long.name] ?? '').trim();
    const at = this.place.get(name);
    if (at === undefined) {
      if (this.unknown.size < 20) this.unknown.add(name.slice(0, 40));
      return;
    }
    let row = this.rows.get(time);
    if (row && row.cells[at] !== '') {
      // A name that comes again at one time begins another row: the old one keeps its place.
      this.rows.delete(time);
      this.rows.set(`${time}\0${this.again++}`, row);
      row = undefined;
    }
    if (!row) this.rows.set(time, (row = { cells: [time, ...this.long.names.map(() => '')], line }));
    row.cells[at] = (cells[this.long.value] ?? '').trim();
  }

  finish(sink: (cells: string[], line: number) => void): void {
    for (const { cells, line } of this.rows.values()) sink(cells, line);
    this.rows.clear();
  }
}
