import { readFileSync } from 'node:fs';
import { parquetMetadata } from 'hyparquet';
import { parquetWriteBuffer, type ColumnSource } from 'hyparquet-writer';
import type { StudyRow } from '../core/sweep/runOne.ts';
import type { Study } from '../core/sweep/study.ts';

/** What a table of results says of itself. */
export interface TableFacts {
  /** The study's JSON as it was written. */
  study: unknown;
  /** `1/1` for all. */
  shard: string;
}

/** Its key in the Parquet file's metadata, and in front of a comment of the CSV file. */
const KEY = 'ripstik-study';

/** @param rows by index */
export function parquetTable(study: Study, rows: readonly StudyRow[], facts: TableFacts): Uint8Array {
  const doubles = (name: string, value: (row: StudyRow) => number): ColumnSource => ({
    name,
    type: 'DOUBLE',
    nullable: false,
    data: Float64Array.from(rows, value),
  });
  const texts = (name: string, value: (row: StudyRow) => string): ColumnSource => ({
    name,
    type: 'STRING',
    nullable: false,
    data: rows.map(value),
  });
  const columnData: ColumnSource[] = [
    { name: 'index', type: 'INT32', nullable: false, data: Int32Array.from(rows, ({ index }) => index) },
    ...study.paths.map((path, k) =>
      rows.some(({ values }) => typeof values[k] === 'string')
        ? texts(path, ({ values }) => String(values[k]))
        : doubles(path, ({ values }) => values[k] as number),
    ),
    ...study.measureNames.map((name, k) => doubles(name, ({ measures }) => measures[k]!)),
    texts('reason', ({ reason }) => reason),
    doubles('time', ({ time }) => time),
  ];
  const kvMetadata = [
    { key: KEY, value: JSON.stringify(facts) },
    { key: 'ripstik-engine', value: enginesOf(rows) },
  ];
  return new Uint8Array(parquetWriteBuffer({ columnData, kvMetadata, createdBy: 'ripstik-lab' }));
}

/** @param rows by index */
export function csvTable(study: Study, rows: readonly StudyRow[], facts: TableFacts): string {
  const header = ['index', ...study.paths, ...study.measureNames, 'reason', 'time'];
  const lines = rows.map(({ index, values, measures, reason, time }) =>
    [index, ...values, ...measures, reason, time].map(cell).join(','),
  );
  return `${header.map(cell).join(',')}\n${lines.join('\n')}\n# ${KEY}: ${JSON.stringify(facts)}\n# ripstik-engine: ${enginesOf(rows)}\n`;
}

/** What a finished table says of itself; null where it is none of a study. */
export function factsOf(path: string): TableFacts | null {
  try {
    const file = readFileSync(path);
    const text = path.endsWith('.csv')
      ? new RegExp(`^# ${KEY}: (.*)$`, 'm').exec(file.toString('utf8'))?.[1]
      : parquetMetadata(
          file.buffer.slice(file.byteOffset, file.byteOffset + file.byteLength) as ArrayBuffer,
        ).key_value_metadata?.find(({ key }) => key === KEY)?.value;
    return text === undefined ? null : (JSON.parse(text) as TableFacts);
  } catch {
    return null;
  }
}

function cell(value: number | string): string {
  if (typeof value === 'number') return Number.isNaN(value) ? '' : Object.is(value, -0) ? '-0' : String(value);
  return /[",\n\r]/.test(value) ? `"${value.replaceAll('"', '""')}"` : value;
}

const enginesOf = (rows: readonly StudyRow[]): string =>
  [...new Set(rows.map(({ engine }) => engine))].filter(Boolean).sort().join(', ');
