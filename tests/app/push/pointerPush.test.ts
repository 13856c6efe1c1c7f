// A hand on the run that is watched: the page's store and the run's worker, on one thread; the display's clock is turned by hand.
import { beforeAll, expect, test, vi } from 'vitest';
import type { Comparison } from '../../../src/app/runs/comparison.ts';
import type { Sweep } from '../../../src/app/runs/sweep.ts';
import { pushComments } from '../../../src/app/push/pushRecorder.ts';
import { createKeyHand } from '../../../src/app/push/keyboardPush.ts';
import { createApp, systemMetas } from '../../../src/app/store.ts';
import type { App } from '../../../src/app/types.ts';
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

test('a grabbed run is computed only a little ahead of what is seen, and to its end when let go', async () => {
  const app = await balanced();
  const { state } = app;
  expect(end(app)).toBe(10);
  state.time.value = 2.004;
  state.grab.value = push;
  await until(() => end(app) < 10 && end(app) >= 2.04);
  expect(state.playing.value).toBe(true);
  const y = state.motion.value!.trajectory.column('Y')!.slice();
  for (let k = 0; k < 30; k++) {
    state.time.value += 0.016;
    state.grab.value = { ...push, target: [2 + 0.016 * k, 0.3, 0.15] };
    await until(() => end(app) >= state.time.value + 0.03);
    expect(end(app)).toBeLessThanOrEqual(state.time.value + 0.05);
  }
  const trajectory = state.motion.value!.trajectory;
  // What was seen before the grab stays; what comes after it differs from the run without it.
  expect(trajectory.column('Y')!.subarray(0, 200)).toEqual(y.subarray(0, 200));
  state.grab.value = null;
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

test('grabbed at its end, a run goes on; grabbed again at an earlier moment, it goes another way from there', async () => {
  const app = await balanced();
  const { state } = app;
  state.time.value = 10;
  const X = state.motion.value!.trajectory.column('X')!.at(-1)!;
  state.grab.value = { ...push, target: [X, 0.05, 0.15] };
  await until(() => end(app) > 10);
  state.grab.value = null;
  await until(() => ended(app));
  expect(end(app)).toBe(15);
  state.time.value = 3;
  state.grab.value = push;
  await until(() => end(app) < 10);
  state.grab.value = null;
  await until(() => ended(app));
  expect(state.motion.value!.marks[0]!.time).toBe(3);
  expect(state.motion.value!.pushes!.map((r) => r.push !== null)).toEqual([true, false]);
});

test('a hand that lets go at once leaves nothing behind that acts', async () => {
  const app = await balanced();
  const { state } = app;
  state.time.value = 1;
  state.grab.value = push;
  state.grab.value = null;
  await until(() => ended(app));
  expect(end(app)).toBe(10);
  expect(state.motion.value!.pushes!.at(-1)!.push).toBeNull();
});

test('a fallen board is not grabbed, and says so', async () => {
  const app = opened();
  app.actions.loadCase('falling-ground');
  await until(() => ended(app));
  const last = end(app);
  app.state.time.value = last;
  app.state.grab.value = push;
  expect(app.state.messages.value.at(-1)!.title).toBe('This run is over');
  expect(end(app)).toBe(last);
});

test('by keys: the force goes along with the body, gives way to another hand, and is over with the run', async () => {
  const app = await balanced();
  const { state } = app;
  const hand = createKeyHand(state);
  state.time.value = 2;
  hand.press('front-plate', [0, 1, 0]);
  hand.press('front-plate', [0, 1, 0]);
  const force = hand.hold.value!.force;
  expect(force[1]).toBeGreaterThan(0);
  await until(() => end(app) < 10 && end(app) >= 2.04);
  const first = state.grab.value!;
  for (let k = 0; k < 20; k++) {
    state.time.value += 0.016;
    await until(() => end(app) >= state.time.value + 0.03);
  }
  // It rides at some speed, and the hand with it.
  expect(state.grab.value!.target[0] - first.target[0]).toBeGreaterThan(0.1);
  expect(state.grab.value!.stiffness).toBe(first.stiffness);
  state.grab.value = push;
  state.time.value += 0.016;
  expect(hand.hold.value).toBeNull();
  expect(state.grab.value).toBe(push);
  state.grab.value = null;
  await until(() => ended(app));
  state.time.value = 3;
  hand.press('rod', [1, 0, 0]);
  await until(() => end(app) < 10);
  hand.letGo();
  expect(state.grab.value).toBeNull();
  await until(() => ended(app));
  expect(state.motion.value!.pushes!.at(-1)!.push).toBeNull();
  hand.dispose();
});
