// Runs over a message channel, by the real service: rows as they come, a cancel, another run in its place, a push.
import { expect, test, vi } from 'vitest';
import { RunClient, type RunHandlers } from '../../src/compute/client/runClient.ts';
import { calls } from '../../src/compute/services/run.ts';
import type { RunEvent, RunResult } from '../../src/compute/services/runTypes.ts';
import type { Scenario } from '../../src/core/scenario/types.ts';
import { checkScenario } from '../../src/core/scenario/schema.ts';
import { learnSystem, systemMetas } from '../../src/core/systems/registry.ts';
import { runOf, scenarioOf } from '../helpers.ts';
import { NearWorker, starts, turn } from './nearWorker.ts';

/** What a run said, and when it was over. */
function heard() {
  const said: string[] = [];
  const columns = new Map<string, number[]>();
  let names: string[] = [];
  let end: (reason: string) => void;
  const over = new Promise<string>((resolve) => (end = resolve));
  const handlers: RunHandlers = {
    started(all) {
      said.push('started');
      names = all;
      for (const name of names) columns.set(name, []);
    },
    rows(data, rows) {
      said.push('rows');
      for (const [c, name] of names.entries()) columns.get(name)!.push(...data[c]!.subarray(0, rows));
    },
    pushed: () => void said.push('pushed'),
    ended({ reason }) {
      said.push('ended');
      end(reason);
    },
    refused(path, message) {
      said.push('refused');
      end(`${path}|${message}`);
    },
  };
  const time = (): number => columns.get('t')?.at(-1) ?? 0;
  return { handlers, said, columns, over, time };
}

const SHORT = { version: 1, system: 'rolling-wheel', initial: { phi_dot: 3, theta_dot: 1 }, duration: 2 };
const endless = (): Scenario => scenarioOf({ ...SHORT, duration: 1e5 });
const until = async (what: () => boolean): Promise<void> => {
  while (!what()) await turn();
};

test('a run sends its rows, the very ones that the simulation computes, then its end', async () => {
  const run = heard();
  new RunClient(starts()).start(scenarioOf(SHORT), run.handlers);
  expect(await run.over).toBe('end');
  const whole = runOf(SHORT);
  for (const [name, values] of whole.columns) expect(run.columns.get(name), name).toEqual([...values]);
  expect(run.said[0]).toBe('started');
  expect(run.said.slice(-2)).toEqual(['rows', 'ended']);
});

test('a run comes in pieces; cancelled, it keeps what came and ends by that name, and the worker stays', async () => {
  const near = new NearWorker();
  const client = new RunClient(starts(near));
  const run = heard();
  client.start(endless(), run.handlers);
  await until(() => run.said.filter((s) => s === 'rows').length > 3);
  const before = run.time();
  client.cancel();
  expect(await run.over).toBe('cancelled');
  expect(run.time()).toBeGreaterThanOrEqual(before);
  const next = heard();
  client.start(scenarioOf(SHORT), next.handlers);
  expect(await next.over).toBe('end');
  expect(near.terminated).toBe(false);
});

test('cancelled before it has begun, a run still says where it would have started', async () => {
  const events: RunEvent[] = [];
  const caller = { signal: AbortSignal.abort(), emit: (event: RunEvent) => events.push(event), onUpdate: () => {} };
  const { end } = (await calls['run.compute']({ scenario: endless() }, caller)) as RunResult;
  expect(end.reason).toBe('cancelled');
  expect(events.map(({ type }) => type)).toEqual(['started', 'rows']);
  expect(events[1]).toMatchObject({ rows: 1, time: 0 });
});

const FINE = { outputStep: 0.01, method: { name: 'rk4', step: 0.004 } };

test.each([0.5, 0.503, 0.5099, 0.3 - 1e-12, 0.1 + 0.2])(
  'rows come as soon as there is one at the time that is waited for, %d s, and with nothing missing before it',
  async (until) => {
    // The clock stands still: what is sent is sent because it is waited for, or at the end.
    const clock = vi.spyOn(performance, 'now').mockReturnValue(0);
    const sent: number[] = [];
    const emit = (event: RunEvent): void => {
      if (event.type === 'rows' && event.rows > 0) sent.push(event.columns[0]![event.rows - 1]!);
    };
    const caller = { signal: new AbortController().signal, emit, onUpdate: () => {} };
    await calls['run.compute']({ scenario: scenarioOf({ ...SHORT, ...FINE }), until }, caller);
    clock.mockRestore();
    expect(sent[0]!).toBeGreaterThanOrEqual(until - 1e-9);
    expect(sent[0]!).toBeLessThan(SHORT.duration);
    expect(sent.at(-1)).toBe(SHORT.duration);
  },
);

test('nothing is heard of a run that another took the place of, or that was abandoned', async () => {
  const client = new RunClient(starts());
  const [first, second] = [heard(), heard()];
  client.start(endless(), first.handlers);
  await until(() => first.said.includes('rows'));
  client.start(endless(), second.handlers);
  const said = first.said.length;
  await until(() => second.said.includes('rows'));
  client.abandon();
  const saidThen = second.said.length;
  const third = heard();
  client.start(scenarioOf(SHORT), third.handlers);
  await third.over;
  expect([first.said.length, second.said.length]).toEqual([said, saidThen]);
});

test('a refusal names its key', async () => {
  const run = heard();
  new RunClient(starts()).start(
    scenarioOf({ version: 1, system: 'ripstik', control: { type: 'lqr', inputs: ['tau_fc'], at: { alpha_fp: 0.1 } } }),
    run.handlers,
  );
  expect(await run.over).toMatch(/^control\.at\|control\.at: /);
});

test('a pushed run waits at its horizon, goes on with the next, and ends when released', async () => {
  const client = new RunClient(starts());
  const run = heard();
  const scenario = scenarioOf({ ...SHORT, duration: 3 });
  client.start(scenario, run.handlers, { live: { push: null, horizon: 1 } });
  await until(() => run.time() >= 0.99);
  await turn();
  await turn();
  expect(run.time()).toBeLessThan(1.02);
  client.act({ horizon: 2 });
  await until(() => run.time() >= 1.99);
  expect(run.time()).toBeLessThan(2.02);
  client.act({ push: null, horizon: null });
  expect(await run.over).toBe('end');
  expect(run.said.filter((s) => s === 'pushed')).toHaveLength(2);
});

test('a run that waits at its horizon is cancelled too', async () => {
  const client = new RunClient(starts());
  const run = heard();
  client.start(endless(), run.handlers, { live: { horizon: 0.5 } });
  await until(() => run.time() >= 0.49);
  client.cancel();
  expect(await run.over).toBe('cancelled');
});

test('when the worker dies the rows stay, the words say so, and the next run gets a new one', async () => {
  const near = new NearWorker();
  const client = new RunClient(starts(near));
  const run = heard();
  client.start(endless(), run.handlers);
  await until(() => run.said.includes('rows'));
  near.die('out of memory');
  expect(await run.over).toBe(
    '|the computation stopped unexpectedly (out of memory); rows computed so far are kept, run again to retry',
  );
  const next = heard();
  client.start(scenarioOf(SHORT), next.handlers);
  expect(await next.over).toBe('end');
});

test('the equations of a described system are derived with their share told, once; another run has them', async () => {
  const description =
    'system "Told"\ncoordinate a, b [rad] = 0.3\nkinetic 1/2 (a\'^2 + b\'^2)\npotential -cos(a) - cos(b - a)';
  const { meta } = await learnSystem(description);
  const scenario = (): Scenario => checkScenario({ version: 1, system: { description }, duration: 0.1 }, systemMetas);
  const shares: number[] = [];
  const [first, second] = [heard(), heard()];
  const client = new RunClient(starts());
  const derived = (share: number): void => void shares.push(share);
  client.start(scenario(), { ...first.handlers, derived });
  expect(await first.over, meta.id).toBe('end');
  expect(shares.at(-1)).toBe(1);
  expect(shares).toEqual([...shares].sort((x, y) => x - y));
  const told = shares.length;
  client.start(scenario(), { ...second.handlers, derived });
  expect(await second.over).toBe('end');
  expect(shares).toHaveLength(told);
});
