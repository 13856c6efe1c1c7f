import { expect, test } from 'vitest';
import { CsvClient } from '../../src/compute/client/csvClient.ts';
import { calls } from '../../src/compute/services/csv.ts';
import { Trajectory } from '../../src/core/motion/trajectory.ts';
import { writeCsv } from '../../src/csv/csv.ts';
import { NearWorker } from './nearWorker.ts';

/** The writer's worker; `before` each part something may happen to the run. */
function writer(before: (part: number) => void): NearWorker {
  let part = 0;
  const write: (typeof calls)['csv.write'] = (request, caller) => {
    before(part++);
    return calls['csv.write'](request, caller);
  };
  return new NearWorker({ csv: () => Promise.resolve({ 'csv.write': write }) });
}

const rowsFrom = (from: number, rows: number): Float64Array[] => [
  Float64Array.from({ length: rows }, (_, k) => from + k),
  Float64Array.from({ length: rows }, (_, k) => Math.sin(from + k)),
];

test('a long run is written in parts: together the very file, without the rows that come meanwhile', async () => {
  const trajectory = new Trajectory(['t', 'x']);
  trajectory.append(rowsFrom(0, 45_001), 45_001);
  const whole = writeCsv(['t', 'x'], rowsFrom(0, 45_001), ['scenario: {}']);
  const client = new CsvClient(() => writer((part) => trajectory.append(rowsFrom(45_001 + 10 * part, 10), 10)));
  const shares: number[] = [];
  const parts = (await client.write(trajectory, ['scenario: {}'], { onProgress: (share) => shares.push(share) }))!;
  expect(shares).toEqual([20_000 / 45_001, 40_000 / 45_001, 1]);
  expect(parts.length).toBe(3);
  expect(await new Blob(parts).text()).toBe(whole);
});

test('rows that are let go meanwhile: the file is begun anew, with those that stay', async () => {
  const trajectory = new Trajectory(['t', 'x'], 1024, 50_000);
  trajectory.append(rowsFrom(0, 45_000), 45_000);
  const client = new CsvClient(() =>
    writer((part) => part === 1 && trajectory.append(rowsFrom(45_000, 10_000), 10_000)),
  );
  const lines = (await new Blob((await client.write(trajectory, []))!).text()).trim().split('\n');
  expect(trajectory.stride).toBe(2);
  expect(lines).toHaveLength(1 + trajectory.length);
  expect(lines.slice(1, 4).map((line) => line.split(',')[0])).toEqual(['0', '2', '4']);
});

test('writing that is cancelled ends after the part under way, with nothing', async () => {
  const trajectory = new Trajectory(['t', 'x']);
  trajectory.append(rowsFrom(0, 90_000), 90_000);
  const given = new AbortController();
  let asked = 0;
  const client = new CsvClient(() =>
    writer((part) => {
      asked = part;
      if (part === 2) given.abort();
    }),
  );
  expect(await client.write(trajectory, [], { signal: given.signal })).toBeNull();
  expect(asked).toBe(2);
});

test('a file that is read is told how far, and can be given up; the columns come as they are', async () => {
  const rows = 300_000;
  const text = writeCsv(['t', 'X', 'theta'], [...rowsFrom(0, rows), new Float64Array(rows)]);
  const client = new CsvClient(() => new NearWorker());
  const shares: number[] = [];
  const whole = (await client.read(new Blob([text]), { onProgress: (share) => shares.push(share) }))!;
  expect(whole.result).toMatchObject({ kind: 'motion', rows });
  expect(shares.length).toBeGreaterThan(0);
  const giveUp = new AbortController();
  expect(await client.read(new Blob([text]), { signal: giveUp.signal, onProgress: () => giveUp.abort() })).toBeNull();
  expect(await client.read(new Blob([text]), { signal: AbortSignal.abort() })).toBeNull();
});

test('a worker that dies is told in the words of the reader', async () => {
  const near = new NearWorker();
  const reading = new CsvClient(() => near).read(new Blob(['t,X,theta']));
  near.die('out of memory');
  await expect(reading).rejects.toThrow('the file reader stopped unexpectedly (out of memory)');
});
