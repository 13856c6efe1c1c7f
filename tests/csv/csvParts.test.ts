import { expect, test } from 'vitest';
import { CsvClient } from '../../src/compute/csvClient.ts';
import { Trajectory } from '../../src/core/motion/trajectory.ts';
import { csvHeader, csvRows, writeCsv } from '../../src/csv/csv.ts';
import type { CsvReply, CsvRequest } from '../../src/compute/csv.worker.ts';

/** What the worker does with rows, here and now; `before` each part something may happen to the run. */
function writer(before: (part: number) => void): Worker {
  const port = new EventTarget();
  let part = 0;
  const postMessage = (request: CsvRequest): void => {
    if (request.type !== 'write') throw new Error(`a writer is not asked to ${request.type}`);
    const { id, heading, data } = request;
    before(part++);
    const reply: CsvReply = {
      type: 'written',
      id,
      part: new Blob([heading ? csvHeader(heading.columns, heading.comments) : '', ...csvRows(data)]),
    };
    queueMicrotask(() => port.dispatchEvent(new MessageEvent('message', { data: reply })));
  };
  return Object.assign(port, { postMessage, terminate() {} }) as unknown as Worker;
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
