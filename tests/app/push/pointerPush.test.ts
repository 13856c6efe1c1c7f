// A push on the run that is watched: the page's store and the run's worker, on one thread; the display's clock is turned by pusher.
import { beforeAll, expect, test, vi } from 'vitest';
import type { Comparison } from '../../../src/app/runs/comparison.ts';
import type { Sweep } from '../../../src/app/runs/sweep.ts';
import { pushComments } from '../../../src/app/push/pushRecorder.ts';
import { createKeyboardPusher } from '../../../src/app/push/keyboardPush.ts';
import { createApp, systemMetas } from '../../../src/app/store.ts';
import type { App } from '../../../src/app/app.ts';
import type { Push } from '../../../src/core/simulation/push.ts';
import { Simulation } from '../../../src/core/simulation/simulation.ts';
import { systems } from '../../../src/core/systems/all.ts';
import { feedbackOf } from '../../../src/core/control/design/feedback.ts';
import { Compute } from '../../../src/compute/client/compute.ts';
import { NearWorker } from '../../compute/nearWorker.ts';
import { scenarioOf } from '../../helpers.ts';

beforeAll(() => {
  vi.stubGlobal('requestAnimationFrame', () => 0);
  vi.stubGlobal('cancelAnimationFrame', () => undefined);
});

const push: Push = { body: 'rod', point: [0, 0, 0], target: [2, 0.3, 0.15], stiffness: 20, damping: 2 };

function opened(): App {
  return createApp(
    new Compute(() => new NearWorker(), systemMetas, 2),
    { dark: false, reducedMotion: true, roomy: false },
    {} as Comparison,
    {} as Sweep,
  );
}

const until = (what: () => boolean): Promise<void> =>
  vi.waitUntil(what, { timeout: 60_000, interval: 2 }).then(() => undefined);
const end = ({ state }: App): number => state.motion.value!.trajectory.end;
const ended = ({ state }: App): boolean => state.run.value?.kind === 'ended';

async function balanced(): Promise<App> {
  const app = opened();
  app.actions.loadCase('balanced');
  await until(() => ended(app));
  return app;
}

test('a pushed run is computed only a little ahead of what is seen, and to its end when released', async () => {
  const app = await balanced();
  const { state, actions } = app;
  expect(end(app)).toBe(10);
  actions.seek(2.004);
  actions.setPush(push);
  await until(() => end(app) < 10 && end(app) >= 2.04);
  expect(state.playing.value).toBe(true);
  const y = state.motion.value!.trajectory.column('Y')!.slice();
  for (let k = 0; k < 30; k++) {
    actions.seek(state.time.value + 0.016);
    actions.setPush({ ...push, target: [2 + 0.016 * k, 0.3, 0.15] });
    await until(() => end(app) >= state.time.value + 0.03);
    expect(end(app)).toBeLessThanOrEqual(state.time.value + 0.05);
  }
  const trajectory = state.motion.value!.trajectory;
  // What was seen before the push stays; what comes after it differs from the run without it.
  expect(trajectory.column('Y')!.subarray(0, 200)).toEqual(y.subarray(0, 200));
  actions.setPush(null);
  await until(() => ended(app));
  expect(end(app)).toBe(10);
  expect(state.motion.value!.marks.map((m) => m.name)).toEqual(['pushed', 'released']);
  expect(state.motion.value!.marks[0]!.time).toBeCloseTo(2, 1);
  await repeats(app);
});

/** The exported pushes give the same rows again. */
async function repeats({ state }: App): Promise<void> {
  const { trajectory, pushes, written } = state.motion.value!;
  expect(pushes!.length).toBeGreaterThan(10);
  const comments = pushComments(state.motion.value!);
  expect(comments[0]).toContain('does not repeat');
  const recorded = JSON.parse(comments[1]!.replace('pushes: ', '')) as typeof pushes;
  const scenario = scenarioOf(written);
  const system = systems['ripstik']!;
  const again = new Simulation(scenario, system, { feedback: feedbackOf(scenario, system), pushes: recorded! });
  again.advance(() => false);
  const { columns, rows } = again.takeChunk();
  expect(rows).toBe(trajectory.length);
  for (const name of ['X', 'Y', 'alpha', 'theta']) {
    const [a, b] = [columns[again.columns.indexOf(name)]!, trajectory.column(name)!];
    for (let row = 0; row < rows; row++) expect(Math.abs(a[row]! - b[row]!)).toBeLessThan(1e-5);
  }
}

test('pushed at its end, a run goes on; pushed again at an earlier moment, it goes another way from there', async () => {
  const app = await balanced();
  const { state, actions } = app;
  actions.seek(10);
  const X = state.motion.value!.trajectory.column('X')!.at(-1)!;
  actions.setPush({ ...push, target: [X, 0.05, 0.15] });
  await until(() => end(app) > 10);
  actions.setPush(null);
  await until(() => ended(app));
  expect(end(app)).toBe(15);
  actions.seek(3);
  actions.setPush(push);
  await until(() => end(app) < 10);
  actions.setPush(null);
  await until(() => ended(app));
  expect(state.motion.value!.marks[0]!.time).toBe(3);
  expect(state.motion.value!.pushes!.map((r) => r.push !== null)).toEqual([true, false]);
});

test('a push released at once leaves nothing behind that acts', async () => {
  const app = await balanced();
  const { state, actions } = app;
  actions.seek(1);
  actions.setPush(push);
  actions.setPush(null);
  await until(() => ended(app));
  expect(end(app)).toBe(10);
  expect(state.motion.value!.pushes!.at(-1)!.push).toBeNull();
});

test('a fallen board is not pushed, and says so', async () => {
  const app = opened();
  app.actions.loadCase('falling-ground');
  await until(() => ended(app));
  const last = end(app);
  app.actions.seek(last);
  app.actions.setPush(push);
  expect(app.state.messages.value.at(-1)!.title).toBe('This run is over');
  expect(end(app)).toBe(last);
});

test('by keys: the force goes along with the body, gives way to another push, and is over with the run', async () => {
  const app = await balanced();
  const { state, actions } = app;
  const pusher = createKeyboardPusher(state, app.actions);
  actions.seek(2);
  pusher.press('front-plate', [0, 1, 0]);
  pusher.press('front-plate', [0, 1, 0]);
  const force = pusher.current.value!.force;
  expect(force[1]).toBeGreaterThan(0);
  await until(() => end(app) < 10 && end(app) >= 2.04);
  const first = state.push.value!;
  for (let k = 0; k < 20; k++) {
    actions.seek(state.time.value + 0.016);
    await until(() => end(app) >= state.time.value + 0.03);
  }
  // It rides at some speed, and the push with it.
  expect(state.push.value!.target[0] - first.target[0]).toBeGreaterThan(0.1);
  expect(state.push.value!.stiffness).toBe(first.stiffness);
  actions.setPush(push);
  actions.seek(state.time.value + 0.016);
  expect(pusher.current.value).toBeNull();
  expect(state.push.value).toBe(push);
  actions.setPush(null);
  await until(() => ended(app));
  actions.seek(3);
  pusher.press('rod', [1, 0, 0]);
  await until(() => end(app) < 10);
  pusher.release();
  expect(state.push.value).toBeNull();
  await until(() => ended(app));
  expect(state.motion.value!.pushes!.at(-1)!.push).toBeNull();
  pusher.dispose();
});
