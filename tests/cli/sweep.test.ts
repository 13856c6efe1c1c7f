import { spawn, spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { parquetMetadata, parquetReadObjects } from 'hyparquet';
import { expect, test } from 'vitest';

const STUDY = {
  version: 1,
  scenario: { version: 1, system: 'rolling-wheel', inputs: { tau_phi: 0.1 }, duration: 4 },
  vary: {
    'initial.theta': { uniform: ['-1 deg', '1 deg'] },
    'parameters.m': { list: [-1, 1, 2, 3, 4, 5, 6, 7] },
    'method.name': { list: ['dopri5', 'rk4'] },
  },
  sample: { kind: 'sobol', count: 48, seed: 3 },
  measures: ['final.X', 'max.Y', 'steps'],
};
const COMMAND = ['--import', 'tsx', 'src/cli/main.ts', 'sweep'];

function place(): { file: string; out: (name: string) => string; folder: string } {
  const folder = mkdtempSync(join(tmpdir(), 'sweep-'));
  const file = join(folder, 'study.json');
  writeFileSync(file, JSON.stringify(STUDY));
  return { file, out: (name) => join(folder, name), folder };
}

const sweep = (...args: string[]) => spawnSync(process.execPath, [...COMMAND, ...args], { encoding: 'utf8' });

function bytesOf(path: string): ArrayBuffer {
  return Uint8Array.from(readFileSync(path)).buffer;
}

test('all at once, in two parts, and killed and gone on with: the same rows, to the bit', async () => {
  const { file, out, folder } = place();
  const whole = sweep(file, '--out', out('whole.parquet'), '--workers', '2');
  expect([whole.status, whole.stdout], whole.stderr).toEqual([0, '']);
  expect(whole.stderr).toMatch(/sweep: 48 of 48 runs.*\n.*run \d+ was refused: parameters.m: /);
  const file0 = bytesOf(out('whole.parquet'));
  const rows = await parquetReadObjects({ file: file0 });
  expect(rows.map(({ index }) => index as number)).toEqual(Array.from({ length: 48 }, (_, i) => i));
  expect(Object.keys(rows[0]!)).toEqual(['index', ...Object.keys(STUDY.vary), ...STUDY.measures, 'reason', 'time']);
  expect(new Set(rows.map(({ reason }) => reason as string))).toEqual(new Set(['end', 'refused']));
  const facts = parquetMetadata(file0).key_value_metadata!.find(({ key }) => key === 'ripstik-study')!.value!;
  expect(JSON.parse(facts)).toEqual({ study: STUDY, shard: '1/1' });

  const parts = [];
  for (const shard of ['1/2', '2/2']) {
    expect(sweep(file, '--out', out('part.parquet'), '--shard', shard, '--workers', '1').status).toBe(0);
    parts.push(...(await parquetReadObjects({ file: bytesOf(out('part.parquet')) })));
  }
  expect(parts.sort((a, b) => (a['index'] as number) - (b['index'] as number))).toEqual(rows);

  const child = spawn(process.execPath, [...COMMAND, file, '--out', out('killed.parquet')], { stdio: 'ignore' });
  const journal = out('killed.parquet.unfinished');
  const ended = new Promise((resolve) => child.on('exit', resolve));
  while (child.exitCode === null && !(existsSync(journal) && readFileSync(journal, 'utf8').split('\n').length > 4))
    await new Promise((resolve) => setTimeout(resolve, 2));
  child.kill('SIGKILL');
  await ended;
  // It may have been too quick for us; then there is nothing to go on with, and its file is whole.
  if (existsSync(journal)) {
    writeFileSync(journal, readFileSync(journal, 'utf8').slice(0, -3)); // a line that was cut off
    const refused = sweep(file, '--out', out('killed.parquet'));
    expect([refused.status, refused.stderr]).toEqual([2, expect.stringMatching(/was interrupted: --resume goes on/)]);
  }
  expect(sweep(file, '--out', out('killed.parquet'), '--resume').status).toBe(0);
  expect(readFileSync(out('killed.parquet')).equals(readFileSync(out('whole.parquet')))).toBe(true);
  expect(readdirSync(folder).sort()).toEqual(['killed.parquet', 'part.parquet', 'study.json', 'whole.parquet']);
}, 240_000);

test('a study too large for one table is told before anything runs, with the parts that would do', () => {
  const { file, out } = place();
  writeFileSync(file, JSON.stringify({ ...STUDY, sample: { kind: 'random', count: 9_000_000 } }));
  const { status, stderr } = sweep(file, '--out', out('x.parquet'), '--shard', '1/2');
  expect([status, stderr]).toEqual([
    2,
    'ripstik: 4500000 runs are more than one table takes, 4000000; split the study: --shard 1/3, and so on\n',
  ]);
});

test('a call that cannot be carried out is one line', () => {
  const { file, out } = place();
  for (const [args, words] of [
    [[file, '--out', out('x.txt')], '--out must name a file that ends in .parquet or .csv'],
    [[file, '--out', out('x.csv'), '--shard', '3/2'], '--shard must be as 2/8'],
  ] as const) {
    const { status, stderr } = sweep(...args);
    expect([status, stderr.split('\n').length]).toEqual([2, 2]);
    expect(stderr).toContain(words);
  }
}, 60_000);
