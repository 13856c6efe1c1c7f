// Remote calls over a message channel: what is promised of every service, with services of the test.
import { expect, test } from 'vitest';
import type { Call } from '../../src/compute/remote/protocol.ts';
import { RemoteError, RemoteWorker, WorkerLost } from '../../src/compute/remote/remoteWorker.ts';
import { Transferred, type Handlers } from '../../src/compute/remote/serve.ts';
import { ScenarioError } from '../../src/core/scenario/types.ts';
import { NearWorker, starts, turn } from './nearWorker.ts';

interface TestCalls {
  'test.add': Call<readonly number[], number>;
  'test.count': Call<number, string, number, string>;
  'test.fail': Call<string, never>;
  'test.double': Call<Float64Array, Float64Array>;
  'test.silent': Call<null, null>;
  'test.uncloneable': Call<null, unknown>;
}

const calls: Handlers<TestCalls> = {
  'test.add': (numbers) => numbers.reduce((sum, x) => sum + x, 0),
  /** Counts up, a number a turn, and says what was said to it. */
  async 'test.count'(to, { signal, emit, onUpdate }) {
    const said: string[] = [];
    onUpdate((update) => said.push(update));
    let reached = 0;
    while (reached < to && !signal.aborted) {
      emit(reached++);
      await turn();
    }
    return [signal.aborted ? 'aborted' : 'whole', ...said].join(' ');
  },
  'test.fail'(kind) {
    if (kind === 'scenario') throw new ScenarioError('initial.alpha', 'not a number');
    if (kind === 'range') throw new RangeError('too far');
    throw 'just words';
  },
  'test.double': (values) => {
    const doubled = values.map((x) => 2 * x);
    return new Transferred(doubled, [doubled.buffer]);
  },
  'test.silent': () => new Promise<never>(() => {}),
  'test.uncloneable': () => () => 0,
};

let loads = 0;
const worker = (): NearWorker =>
  new NearWorker({
    test: () => {
      loads++;
      return Promise.resolve(calls);
    },
    broken: () => Promise.reject(new TypeError('the module could not be fetched')),
  });

const remote = (...workers: NearWorker[]): RemoteWorker<TestCalls> => {
  const start = starts(...workers);
  return new RemoteWorker<TestCalls>(workers.length > 0 ? start : worker, 30);
};
const failure = (result: Promise<unknown>): Promise<Error> =>
  result.then(
    (value) => Promise.reject(new Error(`answered ${JSON.stringify(value)}`)),
    (error: Error) => error,
  );

test('a call is answered with its result; several run side by side, in one worker started by the first', async () => {
  let started = 0;
  const client = new RemoteWorker<TestCalls>(() => (started++, worker()));
  expect(started).toBe(0);
  const slow = client.call('test.count', 5).result;
  expect(await client.call('test.add', [1, 2, 3]).result).toBe(6);
  expect(await slow).toBe('whole');
  expect(started).toBe(1);
});

test('a prompt call is heard whole and in order through a channel of its own, whatever else the worker says', async () => {
  const client = remote();
  const heard: number[] = [];
  const prompt = client.call('test.count', 20, { prompt: true, onEvent: (n) => heard.push(n) });
  prompt.update('faster');
  const other = client.call('test.count', 3).result;
  expect(await prompt.result).toBe('whole faster');
  expect(heard).toEqual(Array.from({ length: 20 }, (_, i) => i));
  expect(await other).toBe('whole');
  const error = await failure(client.call('test.fail', 'scenario', { prompt: true }).result);
  expect(error).toMatchObject({ name: 'ScenarioError', path: 'initial.alpha' });
});

test('a service is loaded when it is first called; one that there is not, or that cannot be had, is an error', async () => {
  loads = 0;
  const client = remote();
  const near = worker();
  expect(loads).toBe(0);
  await client.call('test.add', []).result;
  expect(loads).toBe(1);
  const any = new RemoteWorker<Record<string, Call<null, null>>>(() => near);
  expect((await failure(any.call('none.such', null).result)).message).toBe('there is no call "none.such"');
  expect((await failure(any.call('test.such', null).result)).message).toBe('there is no call "test.such"');
  expect((await failure(any.call('test.toString', null).result)).message).toBe('there is no call "test.toString"');
  expect((await failure(any.call('broken.x', null).result)).message).toContain('could not be fetched');
});

test('events arrive in order and before the answer; updates are heard, also those sent before the service listens', async () => {
  const events: number[] = [];
  const call = remote().call('test.count', 4, { onEvent: (event) => events.push(event) });
  call.update('early');
  while (events.length < 2) await turn();
  call.update('late');
  expect(await call.result).toBe('whole early late');
  expect(events).toEqual([0, 1, 2, 3]);
  call.update('too late');
});

test('aborted before: nothing is sent; aborted after: the worker ends the call with its answer', async () => {
  const near = worker();
  const client = remote(near);
  const before = client.call('test.add', [1], { signal: AbortSignal.abort() });
  expect((await failure(before.result)).name).toBe('AbortError');
  expect(near.sent).toEqual([]);
  const abort = new AbortController();
  const call = client.call('test.count', 1e6, {
    signal: abort.signal,
    onEvent: (event) => event === 2 && abort.abort(),
  });
  expect(await call.result).toBe('aborted');
  expect(near.terminated).toBe(false);
  // The watchdog of that abort is at rest.
  await new Promise((done) => setTimeout(done, 60));
  expect(near.terminated).toBe(false);
  abort.abort();
  expect(await client.call('test.add', [1, 1]).result).toBe(2);
});

test('a dropped call is over at once, and nothing more is heard of it', async () => {
  const near = worker();
  const client = remote(near);
  const events: number[] = [];
  const call = client.call('test.count', 1e6, { onEvent: (event) => events.push(event) });
  while (events.length === 0) await turn();
  call.drop();
  call.drop();
  const heard = events.length;
  expect((await failure(call.result)).name).toBe('AbortError');
  expect(await client.call('test.count', 3).result).toBe('whole');
  expect(events).toHaveLength(heard);
  expect(near.terminated).toBe(false);
});

test('errors keep their name and message, a ScenarioError its path', async () => {
  const client = remote();
  const error = await failure(client.call('test.fail', 'scenario').result);
  expect(error).toBeInstanceOf(RemoteError);
  expect(error).toMatchObject({
    name: 'ScenarioError',
    path: 'initial.alpha',
    message: 'initial.alpha: not a number',
  });
  expect(await failure(client.call('test.fail', 'range').result)).toMatchObject({
    name: 'RangeError',
    path: '',
    message: 'too far',
  });
  expect(await failure(client.call('test.fail', '').result)).toMatchObject({ name: 'Error', message: 'just words' });
});

test('buffers are transferred both ways', async () => {
  const values = Float64Array.of(1, 2, 3);
  const call = remote().call('test.double', values, { transfer: [values.buffer] });
  expect(values.length).toBe(0);
  expect(await call.result).toEqual(Float64Array.of(2, 4, 6));
});

test('what cannot be sent is an error of that call alone', async () => {
  const near = worker();
  const client = remote(near);
  const request = (() => 0) as unknown as number[];
  expect((await failure(client.call('test.add', request).result)).name).toBe('DataCloneError');
  expect((await failure(client.call('test.uncloneable', null).result)).name).toBe('DataCloneError');
  expect(await client.call('test.add', [4]).result).toBe(4);
  expect(near.terminated).toBe(false);
});

test('a worker that cannot be started is an error of the call', async () => {
  const client = new RemoteWorker<TestCalls>(() => {
    throw new Error('no more workers');
  });
  expect((await failure(client.call('test.add', []).result)).message).toBe('no more workers');
});

test.each(['page', 'worker'] as const)(
  'a message that cannot be read on the %s’s side fails every call under way, by name; the next gets a new worker',
  async (side) => {
    const near = worker();
    const client = remote(near, worker());
    const both = [client.call('test.silent', null).result, client.call('test.silent', null).result].map(failure);
    await turn();
    near.garble(side);
    for (const error of await Promise.all(both)) {
      expect(error).toBeInstanceOf(WorkerLost);
      expect(error.message).toBe('a message could not be read');
    }
    expect(near.terminated).toBe(true);
    expect(await client.call('test.add', [1]).result).toBe(1);
  },
);

test('a worker that dies fails every call under way with the reason; the next gets a new worker', async () => {
  const near = worker();
  const client = remote(near, worker());
  const events: number[] = [];
  const call = client.call('test.count', 1e6, { onEvent: (event) => events.push(event) });
  while (events.length === 0) await turn();
  near.die('out of memory');
  const heard = events.length;
  expect(await failure(call.result)).toMatchObject({ name: 'WorkerLost', message: 'out of memory' });
  expect(near.terminated).toBe(true);
  expect(await client.call('test.add', [1]).result).toBe(1);
  expect(events).toHaveLength(heard);
  // What the dead worker still reports is no concern of the new one.
  near.die('again');
  expect(await client.call('test.add', [2]).result).toBe(2);
});

test('a worker that does not answer an abort is ended; calls beside it fail with it', async () => {
  const near = worker();
  const client = remote(near, worker());
  const abort = new AbortController();
  const silent = failure(client.call('test.silent', null, { signal: abort.signal }).result);
  const beside = failure(client.call('test.silent', null).result);
  await turn();
  abort.abort();
  expect(await silent).toMatchObject({ name: 'WorkerLost', message: 'it did not answer' });
  expect(await beside).toMatchObject({ name: 'WorkerLost' });
  expect(near.terminated).toBe(true);
  expect(await client.call('test.add', [1]).result).toBe(1);
});

test('closed, the worker is ended and its calls are dropped', async () => {
  const near = worker();
  const client = remote(near, worker());
  const call = failure(client.call('test.silent', null).result);
  client.close();
  expect((await call).name).toBe('AbortError');
  expect(near.terminated).toBe(true);
  expect(await client.call('test.add', [1]).result).toBe(1);
});
