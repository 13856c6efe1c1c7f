// Analyses and root loci: newest wins, faults are values, a worker that dies is replaced.
import { expect, test } from 'vitest';
import { ControlClient } from '../../src/compute/client/controlClient.ts';
import { LocusClient } from '../../src/compute/client/locusClient.ts';
import type { ScenarioFile } from '../../src/core/scenario/types.ts';
import { metas } from '../helpers.ts';
import { NearWorker, starts } from './nearWorker.ts';

const board = (speed: number | string): ScenarioFile => ({ version: 1, system: 'ripstik', at: { X_dot: speed } });
test('of questions that wait, each asker’s newest is answered, and only that is computed', async () => {
  const worker = new NearWorker();
  const client = new ControlClient(starts(worker), metas);
  const questions = [1, 2, 3, 4].map((v) => client.analyse(board(v), 'view'));
  const other = client.analyse(board(5), 'panel');
  expect((await Promise.all(questions.slice(0, 3))).every((a) => a === null)).toBe(true);
  const [last, panel] = [await questions[3]!, await other];
  expect(last?.ok && last.value.point.v[0]).toBe(4);
  expect(panel?.ok && panel.value.point.v[0]).toBe(5);
  // The first was under way; of the others one for each asker.
  expect(worker.sent).toHaveLength(3);
});

test('a wrong scenario and a point that is no steady motion are answers with the place', async () => {
  const client = new ControlClient(starts(new NearWorker()), metas);
  expect(await client.analyse(board('fast'), 'view')).toMatchObject({ ok: false, path: 'at.X_dot' });
  expect(await client.analyse({ version: 1, system: 'ripstik', at: { alpha_fp: '5 deg' } }, 'view')).toMatchObject({
    ok: false,
    path: 'at',
  });
});

test('after a worker has died the next question gets a new one', async () => {
  const near = new NearWorker();
  const client = new ControlClient(starts(near), metas);
  const question = client.analyse(board(1), 'view');
  near.die('out of memory');
  expect(await question).toEqual({
    ok: false,
    path: '',
    message: 'the computation stopped unexpectedly (out of memory); change something to try again',
  });
  expect(await client.analyse(board(1), 'view')).toMatchObject({ ok: true });
});

test('what is forgotten or closed is void', async () => {
  const client = new ControlClient(starts(new NearWorker(), new NearWorker()), metas);
  const forgotten = client.analyse(board(1), 'view');
  client.forget('view');
  expect(await forgotten).toBeNull();
  const closed = client.analyse(board(1), 'view');
  client.close();
  expect(await closed).toBeNull();
});

test('a locus tells its progress; another takes its place; cancelling ends the worker', async () => {
  const made = [new NearWorker(), new NearWorker(), new NearWorker()];
  const client = new LocusClient(starts(...made), metas);
  const ask = { vary: 'at', name: 'X_dot', from: 0, to: 2, count: 60, closed: false } as const;
  const first = client.start(board(1), ask, () => {});
  const shares: number[] = [];
  const second = client.start(board(1), ask, (share) => shares.push(share));
  expect(await first).toBeNull();
  expect(await second).toMatchObject({ ok: true, value: { request: ask } });
  expect(shares.every((share, k) => share >= (shares[k - 1] ?? 0) && share <= 1)).toBe(true);
  const third = client.start(board(1), ask, () => {});
  client.cancel();
  expect(await third).toBeNull();
  expect(made.map((worker) => worker.terminated)).toEqual([true, true, true]);
  expect(await client.start(board('fast'), ask, () => {})).toMatchObject({ ok: false, path: 'at.X_dot' });
});

test('a locus whose worker dies says so, and can be asked again', async () => {
  const near = new NearWorker();
  const client = new LocusClient(starts(near), metas);
  const ask = { vary: 'at', name: 'X_dot', from: 0, to: 2, count: 5, closed: false } as const;
  const question = client.start(board(1), ask, () => {});
  near.die('out of memory');
  expect(await question).toMatchObject({ ok: false, message: expect.stringContaining('out of memory); try again') });
  expect(await client.start(board(1), ask, () => {})).toMatchObject({ ok: true });
});
