import { afterEach, describe, expect, test, vi } from 'vitest';
import { embeddingOf } from '../../../src/app/embed/options.ts';
import { speakWith } from '../../../src/app/embed/partner.ts';
import { embeddedPlots } from '../../../src/app/embed/plots.ts';
import { endWorkers, workingApp } from '../workingApp.ts';

afterEach(endWorkers);

const LMS = 'https://lms.example.org';

describe('who may speak is named in the address', () => {
  test.each([
    ['', null],
    ['?file=a.csv', null],
    ['?embed', { partner: null, wrong: null }],
    ['?embed=', { partner: null, wrong: null }],
    [`?embed=${LMS}`, { partner: LMS, wrong: null }],
    [`?embed=${LMS}/`, { partner: LMS, wrong: null }],
    ['?embed=http%3A%2F%2Flocalhost%3A8080', { partner: 'http://localhost:8080', wrong: null }],
  ])('%s', (search, right) => expect(embeddingOf(search)).toEqual(right));

  test.each([
    '*',
    'null',
    'lms.example.org',
    `${LMS}/course`,
    'https://',
    'javascript:alert(1)',
    'file:///home',
    'data:,a',
  ])('%s is no origin', (text) => {
    const { partner, wrong } = embeddingOf(`?embed=${encodeURIComponent(text)}`)!;
    expect(partner).toBe(null);
    expect(wrong).toContain('right would be https://lms.example.org');
  });
});

type Said = { type: string; id?: unknown; message?: string } & Record<string, unknown>;

function embedded(partner = LMS) {
  const app = workingApp();
  const plots = embeddedPlots(app);
  const said: Said[] = [];
  const origins = new Set<string>();
  let hear: (event: MessageEvent<unknown>) => void = () => {};
  const parent = {
    postMessage: (message: unknown, origin: unknown) => {
      said.push(structuredClone(message) as Said);
      origins.add(String(origin));
    },
  };
  speakWith(app, plots, partner, '1.2.3', {
    parent: parent as never,
    addEventListener: (_, listener) => (hear = listener),
  });
  let ids = 0;
  const event = (data: unknown, origin: string, source: unknown): MessageEvent<unknown> =>
    ({ data, origin, source }) as MessageEvent<unknown>;
  const ask = async (data: object): Promise<Said> => {
    const id = ++ids;
    hear(event({ ripstik: 1, id, ...data }, LMS, parent));
    await vi.waitFor(() => expect(said.some((one) => one.id === id)).toBe(true), 20_000);
    return said.find((one) => one.id === id)!;
  };
  const ended = (count: number) =>
    vi.waitFor(() => expect(said.filter(({ type }) => type === 'ended').length).toBeGreaterThanOrEqual(count), 30_000);
  return {
    app,
    plots,
    said,
    origins,
    ask,
    ended,
    from: (data: unknown, origin: string, source: unknown = parent) => hear(event(data, origin, source)),
  };
}

test('load, set, run, seek, state: each is answered, an end is told, to the partner alone', async () => {
  const { said, origins, ask, ended } = embedded();
  expect(said[0]).toEqual({ ripstik: 1, type: 'ready', version: '1.2.3' });
  const scenario = { version: 1, system: 'cart-pendulum', initial: { theta: 0.2 }, duration: 1 };
  expect(await ask({ type: 'load', scenario, title: 'Small swing' })).toMatchObject({
    type: 'state',
    scenario,
  });
  await ended(1);
  expect(said.at(-1)).toMatchObject({ type: 'ended', reason: 'end', time: 1 });
  expect(await ask({ type: 'seek', time: 1 })).toMatchObject({
    title: 'Small swing',
    system: 'cart-pendulum',
    time: 1,
    end: 1,
  });
  const first = (await ask({ type: 'state' }))['values'] as Record<string, number>;
  expect(Number.isFinite(first['theta'])).toBe(true);
  const set = await ask({ type: 'set', path: 'initial.theta', value: '30 deg' });
  expect(set['scenario']).toMatchObject({ initial: { theta: '30 deg' } });
  await ask({ type: 'run' });
  await ended(2);
  await ask({ type: 'seek', time: 1 });
  const second = (await ask({ type: 'state' }))['values'] as Record<string, number>;
  expect(second['theta']).not.toBe(first['theta']);
  expect([...origins]).toEqual([LMS]);
}, 60_000);

test('what cannot be done is answered with what would be right, and changes nothing', async () => {
  const { app, ask } = embedded();
  const before = app.state.draft.peek();
  for (const [data, right] of [
    [{ type: 'jump' }, 'load, set, run, cancel, play, pause, seek, plots or state'],
    [{ type: 'plots', panes: ['alpha'] }, '[{"y": ["alpha", "beta"]}]'],
    [{ type: 'load', csv: '' }, 'there are no rows of numbers'],
    [{ type: 'load', csv: 'theta\n0.1\n0.2\n' }, 'leaves something open'],
    [{ type: 'load' }, 'a case, a scenario or a csv'],
    [{ type: 'load', case: 'nowhere' }, 'ridden'],
    [{ type: 'load', scenario: { version: 1, system: 'sledge' } }, 'sledge'],
    [{ type: 'set', path: 'initial.alpha', value: 'abc' }, 'initial.alpha'],
    [{ type: 'set', path: 'initial.alhpa', value: 1 }, 'alhpa'],
    [{ type: 'set', path: '__proto__.x', value: 1 }, ''],
    [{ type: 'set', value: 1 }, 'path'],
    [{ type: 'seek', time: 'later' }, 'seconds'],
  ] as const) {
    const said = await ask(data);
    expect(said, JSON.stringify(data)).toMatchObject({ type: 'error' });
    expect(said.message).toContain(right);
  }
  expect(app.state.draft.peek()).toBe(before);
}, 60_000);

test('another origin, another window and other words are not heard', async () => {
  const { said, from } = embedded();
  from({ ripstik: 1, id: 1, type: 'state' }, 'https://other.example.org');
  from({ ripstik: 1, id: 2, type: 'state' }, LMS, {});
  for (const data of [null, 'state', 7, [], { type: 'state', id: 3 }, { ripstik: 2, type: 'state', id: 4 }])
    from(data, LMS);
  await new Promise((resolve) => setTimeout(resolve, 50));
  expect(said.length).toBe(1);
});

test('plots that are asked for stand beside every motion that follows', async () => {
  const { app, plots, ask, ended } = embedded();
  const scenario = { version: 1, system: 'cart-pendulum', initial: { theta: 0.2 }, duration: 0.1 };
  expect(await ask({ type: 'load', scenario })).toMatchObject({ type: 'state' });
  await ended(1);
  expect(plots.shown.value).toBe(false);
  const panes = [{ y: ['theta', 'X'] }, { x: 'theta', y: ['theta_dot'], title: 'Phase' }];
  expect(await ask({ type: 'plots', panes })).toMatchObject({ type: 'state' });
  const drawn = [
    { title: 'theta, X', x: 't', y: ['theta', 'X'] },
    { title: 'Phase', x: 'theta', y: ['theta_dot'] },
  ];
  expect(app.state.plots.value.own?.panes).toEqual(drawn);
  expect(await ask({ type: 'load', case: 'released' })).toMatchObject({ type: 'state' });
  await vi.waitFor(() => expect(app.state.plots.value.own).toEqual({ key: 'ripstik/released', panes: drawn }), 20_000);
  expect((await ask({ type: 'plots', panes: [{ y: ['lambda_9'] }] })).message).toMatch(
    /no column "lambda_9"; there are t, X/,
  );
  expect(plots.shown.value).toBe(true);
  await ask({ type: 'plots', panes: [] });
  expect(plots.shown.value).toBe(false);
  await ask({ type: 'plots' });
  expect([plots.shown.value, app.state.plots.value.own]).toEqual([true, null]);
}, 60_000);

test('the page that wrote this one is heard whatever its origin, and no other window', async () => {
  const { said, origins, from } = embedded('*');
  from({ ripstik: 1, id: 1, type: 'state' }, 'null', {});
  from({ ripstik: 1, id: 2, type: 'state' }, 'null');
  await vi.waitFor(() => expect(said.map(({ id }) => id)).toEqual([undefined, 2]));
  expect([...origins]).toEqual(['*']);
});
