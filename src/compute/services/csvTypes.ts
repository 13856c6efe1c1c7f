import type { Scenario } from '../../core/scenario/types.ts';
import type { Judgement } from '../../core/simulation/judge.ts';
import type { CsvResult } from '../../csv/csv.ts';
import type { ImportChoices, Understanding } from '../../csv/plan.ts';
import type { Call } from '../remote/protocol.ts';

export interface CsvCalls {
  /** What a file is understood as, from its beginning. */
  'csv.understand': Call<{ file: Blob; choices?: ImportChoices | undefined }, Understanding>;
  /** Reads a file and judges its numbers. Aborted, it answers null after the piece under way. Columns are transferred. */
  'csv.read': Call<ReadRequest, FileReading | null, ReadProgress>;
  /** Some rows as text. */
  'csv.write': Call<WriteRequest, Blob>;
}

export interface ReadRequest {
  file: Blob;
  /** Of a file without times, s. */
  timeStep?: number | undefined;
  /** What a person decided of the file; with them (`{}` at least), what names no system opens as data. */
  choices?: ImportChoices | undefined;
}

export interface ReadProgress {
  /** Of the file read, 0 to 1. */
  share: number;
  rows: number;
}

/** What a file holds; with the scenario it came from, if it says so, its numbers can be judged. */
export interface FileReading {
  result: CsvResult;
  scenario: Scenario | null;
  judgement: Judgement | null;
}

export interface WriteRequest {
  /** Of those rows that begin a file. */
  columns: string[] | null;
  data: Float64Array[];
  /** Of those rows that end it. */
  comments: string[] | null;
}
