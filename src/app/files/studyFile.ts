/** A sweep's results as Parquet, read from the file itself. Loaded when one is opened. */
import { parquetMetadataAsync, parquetRead, type AsyncBuffer, type FileMetaData } from 'hyparquet';
import type { SystemMeta } from '../../core/model/system.ts';
import { studyResults, type StudyColumn, type StudyResults } from '../../core/sweep/studyResults.ts';
import { learnSystemIn } from '../../core/systems/registry.ts';

/** Numbers that fit into the page's memory beside all else: a million rows of twenty columns. */
const MOST_NUMBERS = 20e6;

/**
 * @param metas of the systems, by id; what a study brings of its own is learnt
 * @throws Error with words for a person
 */
export async function readStudyFile(
  name: string,
  file: Blob,
  metas: Readonly<Record<string, SystemMeta>>,
): Promise<StudyResults> {
  const buffer: AsyncBuffer = {
    byteLength: file.size,
    slice: (start, end) => file.slice(start, end).arrayBuffer(),
  };
  const metadata = await parquetMetadataAsync(buffer).catch((error: unknown) => {
    throw new Error(`this Parquet file is damaged or was cut off: ${messageOf(error)}`);
  });
  const columns = await columnsOf(buffer, metadata);
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

async function columnsOf(file: AsyncBuffer, metadata: FileMetaData): Promise<Map<string, StudyColumn>> {
  const rows = Number(metadata.num_rows);
  const names = metadata.schema.slice(1).flatMap((element) => (element.num_children ? [] : [element.name]));
  if (rows * names.length > MOST_NUMBERS)
    throw new Error(
      `${rows} rows of ${names.length} columns are more than the page opens, ${MOST_NUMBERS / 1e6} million numbers; open one shard, or fewer rows`,
    );
  if (rows === 0) throw new Error('it has no rows');
  const cells = new Map<string, unknown[]>(names.map((name) => [name, new Array<unknown>(rows)]));
  try {
    await parquetRead({
      file,
      metadata,
      onChunk({ columnName, columnData, rowStart }) {
        const column = cells.get(columnName);
        if (column) for (let i = 0; i < columnData.length; i++) column[rowStart + i] = columnData[i];
      },
    });
  } catch (error) {
    throw new Error(
      `this Parquet file can't be read: ${messageOf(error)}; a sweep writes it uncompressed or with Snappy`,
    );
  }
  return new Map([...cells].map(([name, values]) => [name, columnOf(values)]));
}

/** Numbers, where every value is one or is missing. */
function columnOf(values: readonly unknown[]): StudyColumn {
  const numbers = values.every((v) => v === null || v === undefined || typeof v === 'number' || typeof v === 'bigint');
  return numbers
    ? Float64Array.from(values, (v) => (v === null || v === undefined ? NaN : Number(v)))
    : values.map((v) => (v === null || v === undefined ? '' : String(v)));
}

const messageOf = (error: unknown): string => (error instanceof Error ? error.message : String(error));
