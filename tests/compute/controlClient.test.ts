// The page's end of the control worker: newest wins, faults are values, a worker that dies is replaced.
import { expect, test } from 'vitest';
import { ControlClient } from '../../src/compute/controlClient.ts';
import { LocusClient } from '../../src/compute/locusClient.ts';
import { analyse } from '../../src/core/control/analysis.ts';
import { scenarioLocus } from '../../src/core/control/locus/scenarioLocus.ts';
import type { ScenarioFile } from '../../src/core/scenario/types.ts';
import { systems } from '../../src/core/systems/all.ts';
import type { ControlReply, ControlRequest } from '../../src/compute/controlProtocol.ts';
import { metas } from '../helpers.ts';

/** A worker on this thread: it computes in a later turn, as a thread of its own would. */
class NearWorker extends EventTarget {
  asked: ControlRequest[] = [];
  ended = false;
  readonly dies: boolean;
  constructor(dies = false) {
    super();
    this.dies = dies;
  }
  postMessage(request: ControlRequest): void {
    this.asked.push(request);
    setTimeout(() => {
      if (this.ended) return;
      if (this.dies) this.dispatchEvent(Object.assign(new Event('error'), { message: 'out of memory' }));
      else
        this.dispatchEvent(
          new MessageEvent('message', { data: answer(request, (share) => this.tell(request.id, share)) }),
        );
    });
  }
  tell(id: number, share: number): void {
    this.dispatchEvent(new MessageEvent<ControlReply>('message', { data: { type: 'progress', id, share } }));
  }
  terminate(): void {
    this.ended = true;
  }
}

function answer(request: ControlRequest, progress: (share: number) => void): ControlReply {
  const system = systems[request.scenario.system]!;
  try {
    return request.type === 'analyse'
      ? { type: 'analysed', id: request.id, analysis: analyse(request.scenario, system), seconds: 0 }
      : {
          type: 'locus',
          id: request.id,
          locus: scenarioLocus(request.scenario, system, request.request, progress),
          seconds: 0,
        };
  } catch (error) {
    return {
      type: 'refused',
      id: request.id,
      path: (error as { path?: string }).path ?? '',
      message: (error as Error).message,
    };
  }
}

const board = (speed: number | string): ScenarioFile => ({ version: 1, system: 'ripstik', at: { X_dot: speed } });
const workers =
  (...made: NearWorker[]) =>
  () =>
    made.shift() as unknown as Worker;

test('of questions that wait, each asker’s newest is answered, and only that is computed', async () => {
  const worker = new NearWorker();
  const client = new ControlClient(workers(worker), metas);
  const questions = [1, 2, 3, 4].map((v) => client.analyse(board(v), 'view'));
  const other = client.analyse(board(5), 'panel');
  expect((await Promise.all(questions.slice(0, 3))).every((a) => a === null)).toBe(true);
  const [last, panel] = [await questions[3]!, await other];
  expect(last?.ok && last.value.point.v[0]).toBe(4);
  expect(panel?.ok && panel.value.point.v[0]).toBe(5);
  // The first was under way; of the others one for each asker.
  expect(worker.asked).toHaveLength(3);
});

test('a wrong scenario and a point that is no steady motion are answers with the place', async () => {
  const client = new ControlClient(workers(new NearWorker()), metas);
  expect(await client.analyse(board('fast'), 'view')).toMatchObject({ ok: false, path: 'at.X_dot' });
  expect(await client.analyse({ version: 1, system: 'ripstik', at: { alpha_fp: '5 deg' } }, 'view')).toMatchObject({
    ok: false,
    path: 'at',
  });
});

test('after a worker has died the next question gets a new one', async () => {
  const client = new ControlClient(workers(new NearWorker(true), new NearWorker()), metas);
  expect(await client.analyse(board(1), 'view')).toMatchObject({ ok: false });
  expect(await client.analyse(board(1), 'view')).toMatchObject({ ok: true });
});

test('what is forgotten or closed is void', async () => {
  const client = new ControlClient(workers(new NearWorker(), new NearWorker()), metas);
  const forgotten = client.analyse(board(1), 'view');
  client.forget('view');
  expect(await forgotten).toBeNull();
  const closed = client.analyse(board(1), 'view');
  client.close();
  expect(await closed).toBeNull();
});

test('a locus tells its progress; another takes its place; cancelling ends the worker', async () => {
  const made = [new NearWorker(), new NearWorker(), new NearWorker()];
  const client = new LocusClient(workers(...made), metas);
  const ask = { vary: 'at', name: 'X_dot', from: 0, to: 2, count: 5, closed: false } as const;
  const first = client.start(board(1), ask, () => {});
  const shares: number[] = [];
  const second = client.start(board(1), ask, (share) => shares.push(share));
  expect(await first).toBeNull();
  expect(await second).toMatchObject({ ok: true, value: { request: ask } });
  expect(shares).toEqual([0, 0.25, 0.5, 0.75, 1]);
  const third = client.start(board(1), ask, () => {});
  client.cancel();
  expect(await third).toBeNull();
  expect(made.map((worker) => worker.ended)).toEqual([true, true, true]);
  expect(await client.start(board('fast'), ask, () => {})).toMatchObject({ ok: false, path: 'at.X_dot' });
});
