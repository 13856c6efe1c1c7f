/** A sweep's results as Parquet, read from the file itself. Loaded when one is opened. */
import { gunzipSync } from 'fflate';
import {
  parquetMetadataAsync,
  parquetRead,
  parquetSchema,
  type AsyncBuffer,
  type Compressors,
  type FileMetaData,
} from 'hyparquet';
import type { SystemMeta } from '../../core/model/system.ts';
import { studyResults, type StudyColumn, type StudyResults } from '../../core/sweep/studyResults.ts';
import { learnSystemIn } from '../../core/systems/registry.ts';

/** Numbers that fit into the page's memory beside all else: a million rows of twenty columns. */
const MOST_NUMBERS = 20e6;

/**
 * @param metas of the systems, by id; what a study brings of its own is learnt
 * @param reading hears how far it is, and ends it
 * @throws Error with words for a person; the signal's reason where it was ended
 */
export async function readStudyFile(
  name: string,
  file: Blob,
  metas: Readonly<Record<string, SystemMeta>>,
  reading: Reading,
): Promise<StudyResults> {
  const buffer: AsyncBuffer = {
    byteLength: file.size,
    slice: (start, end) => file.slice(start, end).arrayBuffer(),
  };
  const metadata = await parquetMetadataAsync(buffer).catch((error: unknown) => {
    throw new Error(`this Parquet file is damaged or was cut off: ${messageOf(error)}`);
  });
  const columns = await columnsOf(buffer, metadata, reading);
  const said = (key: string): string | undefined =>
    metadata.key_value_metadata?.find((entry) => entry.key === key)?.value;
  const own = said('ripstik-study');
  const facts = own === undefined ? {} : (JSON.parse(own) as { study?: { scenario?: unknown }; shard?: unknown });
  if (facts.study) await learnSystemIn(JSON.stringify(facts.study.scenario ?? null));
  try {
    return studyResults(
      name.replace(/\.parquet$/i, ''),
      columns,
      { ...facts, engine: said('ripstik-engine') ?? '' },
      metas,
    );
  } catch (error) {
    if (own !== undefined) throw error;
    throw new Error(
      `this Parquet file holds no results of a sweep: ${messageOf(error)}. To play a table of numbers, write it as CSV: in Python pandas.read_parquet("file").to_csv("file.csv", index=False)`,
    );
  }
}

/** While a large file is read. */
export interface Reading {
  signal: AbortSignal;
  onProgress(share: number, rows: number): void;
}

/** Column by column, so that no more than one is there twice, and the page stays awake between two parts of one. */
async function columnsOf(
  file: AsyncBuffer,
  metadata: FileMetaData,
  { signal, onProgress }: Reading,
): Promise<Map<string, StudyColumn>> {
  const rows = Number(metadata.num_rows);
  const names = parquetSchema(metadata).children.flatMap(({ element, children }) =>
    children.length === 0 && element.repetition_type !== 'REPEATED' ? [element.name] : [],
  );
  if (rows * names.length > MOST_NUMBERS)
    throw new Error(
      `${rows} rows of ${names.length} columns are more than the page opens, ${MOST_NUMBERS / 1e6} million numbers; open one shard, or fewer rows`,
    );
  if (rows === 0) throw new Error('it has no rows');
  refuseCodecs(metadata);
  const columns = new Map<string, StudyColumn>();
  const groups = metadata.row_groups.map(({ num_rows }) => Number(num_rows));
  for (const [k, name] of names.entries()) {
    const values = new Array<unknown>(rows);
    let rowStart = 0;
    for (const count of groups) {
      const rowEnd = rowStart + count;
      await readPart({ file, metadata, compressors, columns: [name], rowStart, rowEnd }, values);
      rowStart = rowEnd;
      const share = (k + rowStart / rows) / names.length;
      onProgress(share, Math.round(share * rows));
      await new Promise((resolve) => setTimeout(resolve));
      signal.throwIfAborted();
    }
    columns.set(name, columnOf(values));
  }
  return columns;
}

interface Part {
  file: AsyncBuffer;
  metadata: FileMetaData;
  compressors: Compressors;
  columns: string[];
  rowStart: number;
  rowEnd: number;
}

async function readPart(what: Part, values: unknown[]): Promise<void> {
  try {
    await parquetRead({
      ...what,
      onChunk({ columnData, rowStart }) {
        for (let i = 0; i < columnData.length; i++) values[rowStart + i] = columnData[i];
      },
    });
  } catch (error) {
    throw new Error(`this Parquet file can't be read, it may be damaged: ${messageOf(error)}`);
  }
}

/** Besides Snappy, which comes with the reader. */
const compressors: Compressors = { GZIP: (packed) => gunzipSync(packed) };
const READ = ['UNCOMPRESSED', 'SNAPPY', ...Object.keys(compressors)];

function refuseCodecs({ row_groups }: FileMetaData): void {
  const codecs = row_groups.flatMap(({ columns }) => columns.map(({ meta_data }) => meta_data?.codec));
  const unread = codecs.find((codec) => codec !== undefined && !READ.includes(codec));
  if (unread !== undefined)
    throw new Error(
      `it is compressed with ${unread}, which this page does not read; right would be none, Snappy or gzip: in Python pandas.read_parquet("file").to_parquet("file.parquet", compression="snappy")`,
    );
}

/** Numbers, where every value is one or is missing. */
function columnOf(values: readonly unknown[]): StudyColumn {
  const numbers = values.every((v) => v === null || v === undefined || typeof v === 'number' || typeof v === 'bigint');
  return numbers
    ? Float64Array.from(values, (v) => (v === null || v === undefined ? NaN : Number(v)))
    : values.map((v) => (v === null || v === undefined ? '' : String(v)));
}

const messageOf = (error: unknown): string => (error instanceof Error ? error.message : String(error));
