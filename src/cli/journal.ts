import { closeSync, existsSync, ftruncateSync, openSync, readFileSync, rmSync, writeSync } from 'node:fs';
import type { StudyRow } from '../core/sweep/runOne.ts';
import { cannotWrite } from './output.ts';
import type { TableFacts } from './studyTable.ts';
import { UsageError } from './usage.ts';

/**
 * The rows of a sweep that is not finished, one JSON text a line, beside the file that they will be: a sweep that is
 * killed goes on where it was. Lines are only ever appended, so that two processes that were given the same sweep, as
 * by a scheduler that thinks the first one dead, do not write into each other's. A line that was cut off is not
 * counted: its run is computed again.
 */
export class Journal {
  readonly rows = new Map<number, StudyRow>();
  private readonly path: string;
  private readonly name: string;
  private readonly file: number;

  /**
   * @param out of the finished table
   * @param resume go on with what is there
   * @throws UsageError where there is another study's, or one is there and `resume` was not asked for
   */
  constructor(out: string, name: string, facts: TableFacts, resume: boolean) {
    this.path = `${out}.unfinished`;
    this.name = `${name}.unfinished`;
    const first = JSON.stringify(facts);
    const there = existsSync(this.path);
    if (there && !resume)
      throw new UsageError(`${this.name} holds a sweep that was interrupted: --resume goes on with it, or delete it`);
    try {
      this.file = openSync(this.path, there ? 'a' : 'ax');
    } catch (error) {
      throw cannotWrite(this.name, error);
    }
    const text = there ? readFileSync(this.path, 'utf8') : '';
    const [header, ...lines] = text.split('\n').slice(0, -1);
    if (header !== undefined && header !== first)
      throw new UsageError(`${this.name} is of another study or shard: name another --out, or delete it`);
    for (const line of lines) {
      const row = parsed(line);
      if (row) this.rows.set(row.index, row);
    }
    if (header === undefined) {
      ftruncateSync(this.file, 0);
      this.append(`${first}\n`);
    } else if (!text.endsWith('\n')) this.append('\n');
  }

  add(row: StudyRow): void {
    this.append(`${lineOf(row)}\n`);
    this.rows.set(row.index, row);
  }

  close(): void {
    closeSync(this.file);
  }

  /** The table is written. */
  remove(): void {
    this.close();
    rmSync(this.path, { force: true });
  }

  private append(text: string): void {
    const bytes = Buffer.from(text);
    try {
      for (let done = 0; done < bytes.length;) done += writeSync(this.file, bytes, done);
    } catch (error) {
      throw cannotWrite(this.name, error);
    }
  }
}

/** Minus zero and NaN have no JSON text of their own. */
const numbers = (values: readonly (number | string)[]): string =>
  `[${values.map((v) => (Object.is(v, -0) ? '-0' : JSON.stringify(v))).join(',')}]`;

function lineOf({ index, values, measures, reason, time, engine, message }: StudyRow): string {
  const texts = [reason, engine, message].map((text) => JSON.stringify(text)).join(',');
  return `[${index},${numbers(values)},${numbers(measures)},${numbers([time])},${texts}]`;
}

type Line = [number, (number | string)[], (number | null)[], [number | null], string, string, string];

/** @returns null for a line that was cut off */
function parsed(line: string): StudyRow | null {
  let values: Line;
  try {
    values = JSON.parse(line) as Line;
  } catch {
    return null;
  }
  const [index, varied, measures, [time], reason, engine, message] = values;
  return { index, values: varied, measures: measures.map((m) => m ?? NaN), time: time ?? NaN, reason, engine, message };
}
