// Tables of a sweep's results as other tools write them: what is read, and what is refused by name.
import { readFileSync } from 'node:fs';
import { gzipSync } from 'fflate';
import { parquetMetadata, parquetReadObjects } from 'hyparquet';
import { parquetWriteBuffer } from 'hyparquet-writer';
import { expect, test } from 'vitest';
import { readStudyFile } from '../../../src/app/files/studyFile.ts';
import { systemMetas } from '../../../src/core/systems/registry.ts';

const basin = readFileSync('public/studies/basin.parquet');
const bytes = basin.buffer.slice(basin.byteOffset, basin.byteOffset + basin.byteLength);
const open = (
  file: ArrayBuffer | Uint8Array<ArrayBuffer>,
  signal = new AbortController().signal,
  shares: number[] = [],
) => readStudyFile('b.parquet', new Blob([file]), systemMetas, { signal, onProgress: (share) => shares.push(share) });

/** The first rows of the basin, written anew. */
async function written(codec: string, change: (column: unknown[], name: string) => unknown[] = (column) => column) {
  const rows = await parquetReadObjects({ file: bytes, rowEnd: 300 });
  const names = Object.keys(rows[0]!);
  return parquetWriteBuffer({
    columnData: names.map((name) => ({
      name,
      data: change(
        rows.map((row) => row[name] as unknown),
        name,
      ) as number[],
    })),
    codec: codec as 'GZIP',
    compressors: { [codec]: (plain: Uint8Array) => gzipSync(plain) } as never,
    rowGroupSize: 100,
    kvMetadata: parquetMetadata(bytes).key_value_metadata ?? [],
  });
}

test('gzip is read as Snappy is, group by group, with its progress', async () => {
  const shares: number[] = [];
  const packed = await open(await written('GZIP'), undefined, shares);
  const whole = await open(bytes);
  expect(packed.rows).toBe(300);
  for (const [name, column] of whole.columns)
    expect([...packed.columns.get(name)!], name).toEqual([...column.slice(0, 300)]);
  expect(packed.study!.file).toEqual(whole.study!.file);
  expect(shares.length).toBe(3 * whole.columns.size);
  expect(shares.at(-1)).toBe(1);
  expect([...shares].sort((a, b) => a - b)).toEqual(shares);
});

test('another codec is refused by its name', () =>
  expect(written('ZSTD').then((file) => open(file))).rejects.toThrow(
    /compressed with ZSTD, which this page does not read; right would be none, Snappy or gzip: in Python /,
  ));

test('runs that are there twice, and broken indices, are refused', async () => {
  const twice = await written('GZIP', (column) => [...column.slice(0, 299), column[0]]);
  await expect(open(twice)).rejects.toThrow('run 0 is there twice');
  const broken = await written('GZIP', (column, name) =>
    name === 'index' ? [0.5, ...column.slice(1)].map(Number) : column,
  );
  await expect(open(broken)).rejects.toThrow('"index" holds 0.5 in row 1');
});

test('it can be ended', async () => {
  const ending = new AbortController();
  ending.abort('enough');
  await expect(open(bytes, ending.signal)).rejects.toBe('enough');
});
