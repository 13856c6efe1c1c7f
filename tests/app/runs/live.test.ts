// The run on the stage follows the draft: the start at once, the motion at the time where it is played, and never the run of
// anything else than what stands there.
import { afterEach, expect, test, vi } from 'vitest';
import type { App } from '../../../src/app/app.ts';
import type { ScenarioFile } from '../../../src/core/scenario/types.ts';
import { withEntry, withKey } from '../../../src/app/state/draft.ts';
import { endWorkers, workingApp } from '../workingApp.ts';

afterEach(() => {
  endWorkers();
  vi.useRealTimers();
});

const HANGING: ScenarioFile = {
  version: 1,
  system: 'ripstik',
  constraints: 'none',
  hold: ['X', 'Y', 'Z', 'theta', 'psi', 'alpha'],
  initial: { alpha_fp: '10 deg' },
  duration: 2,
};

const over = ({ state }: App) => vi.waitFor(() => expect(state.run.value?.kind).toBe('ended'), 20_000);
/** The stage shows a run of the draft, to its end. */
async function followed(app: App): Promise<void> {
  await vi.waitFor(() => expect(app.state.motion.value?.written).toBe(app.state.draft.value), 20_000);
  await over(app);
  expect(app.state.stale.value).toBeNull();
}
const startOf = ({ state }: App, name: string) => state.motion.value!.trajectory.column(name)![0]!;

async function hanging(): Promise<App> {
  const app = workingApp();
  app.actions.loadScenario(HANGING, 'Hanging');
  await over(app);
  app.actions.pause();
  return app;
}

test('a changed parameter is computed anew and shown at the time where the motion stands', async () => {
  const app = await hanging();
  app.actions.seek(1.25);
  const before = app.state.motion.value!;
  app.actions.edit('gravity', (draft) => withEntry(draft, 'parameters', 'gravity', 1.6));
  expect(app.state.former.value).toBe(before);
  await followed(app);
  expect(app.state.time.value).toBe(1.25);
  expect(app.state.playing.value).toBe(false);
  expect(app.state.motion.value!.parameters['gravity']).toBe(1.6);
});

test('of the start the stage shows the start itself while it is changed, then goes on from where it was', async () => {
  const app = await hanging();
  app.actions.seek(1.25);
  app.actions.play();
  app.actions.edit('roll', (draft) => withEntry(draft, 'initial', 'alpha_fp', '25 deg'));
  expect([app.state.time.value, app.state.playing.value]).toEqual([0, false]);
  await followed(app);
  expect(startOf(app, 'alpha_fp')).toBeCloseTo((25 * Math.PI) / 180, 12);
  await vi.waitFor(() => expect(app.state.time.value).toBe(1.25), 5000);
  expect(app.state.playing.value).toBe(true);
});

test('who plays, pauses or goes elsewhere while the start is shown stays there', async () => {
  const app = await hanging();
  app.actions.seek(1.25);
  app.actions.edit('roll', (draft) => withEntry(draft, 'initial', 'alpha_fp', '25 deg'));
  app.actions.seek(0);
  await followed(app);
  await new Promise((done) => setTimeout(done, 1100));
  expect([app.state.time.value, app.state.playing.value]).toEqual([0, false]);
});

test('changes come faster than runs: the last one is what is shown at the end', async () => {
  const app = await hanging();
  for (let k = 1; k <= 40; k++) {
    app.actions.edit('roll', (draft) => withEntry(draft, 'initial', 'alpha_fp', `${k} deg`));
    if (k % 8 === 0) await new Promise((done) => setTimeout(done));
  }
  await followed(app);
  expect(startOf(app, 'alpha_fp')).toBeCloseTo((40 * Math.PI) / 180, 12);
});

test('undo and redo are shown as any change is', async () => {
  const app = await hanging();
  app.actions.edit('gravity', (draft) => withEntry(draft, 'parameters', 'gravity', 1.6));
  await followed(app);
  app.actions.undo();
  await followed(app);
  expect(app.state.draft.value).toBe(HANGING);
  expect(app.state.motion.value!.parameters['gravity']).toBe(9.81);
  app.actions.redo();
  await followed(app);
  expect(app.state.motion.value!.parameters['gravity']).toBe(1.6);
});

test('Run after a change plays the run that follows it from its start, and computes none twice', async () => {
  const app = await hanging();
  app.actions.seek(1);
  app.actions.edit('gravity', (draft) => withEntry(draft, 'parameters', 'gravity', 1.6));
  await followed(app);
  const { id } = app.state.motion.value!;
  app.actions.run();
  expect([app.state.time.value, app.state.playing.value, app.state.motion.value!.id]).toEqual([0, true, id]);
  app.actions.run();
  await vi.waitFor(() => expect(app.state.motion.value!.id).not.toBe(id), 20_000);
});

test('a long run is marked as stale, and waits for Run', async () => {
  const app = await hanging();
  const { id } = app.state.motion.value!;
  app.actions.edit('duration', (draft) => withKey(draft, 'duration', 100_000));
  expect(app.state.stale.value).toBe('costly');
  expect(app.state.motion.value!.id).toBe(id);
  app.actions.undo();
  expect(app.state.stale.value).toBeNull();
});

test('switched off, nothing follows', async () => {
  const app = await hanging();
  app.actions.set('live', false);
  app.actions.edit('gravity', (draft) => withEntry(draft, 'parameters', 'gravity', 1.6));
  expect(app.state.stale.value).toBe('off');
  expect(app.state.run.value?.kind).toBe('ended');
});

test('a draft that can’t run, or text that is refused, is never run: Run leads to it', async () => {
  const app = await hanging();
  const { id } = app.state.motion.value!;
  app.actions.refuseField('initial.alpha_fp', 'abc is no number');
  app.actions.run();
  expect(app.state.wantedField.value).toEqual({ path: 'initial.alpha_fp' });
  app.actions.refuseField('initial.alpha_fp', null);
  app.actions.edit('duration', (draft) => withKey(draft, 'duration', -1));
  expect(app.state.stale.value).toBe('refused');
  app.actions.run();
  expect(app.state.wantedField.value).toEqual({ path: 'duration' });
  expect([app.state.motion.value!.id, app.state.run.value?.kind]).toEqual([id, 'ended']);
});

test('a change of the controller goes on from where the motion stands', async () => {
  const app = workingApp();
  app.actions.loadCase('balanced');
  await over(app);
  app.actions.pause();
  app.actions.seek(1);
  app.actions.edit('control', (draft) =>
    draft.control?.type === 'lqr' ? withKey(draft, 'control', { ...draft.control, Q: { alpha: 50 } }) : draft,
  );
  await followed(app);
  expect(app.state.motion.value!.marks.map(({ name }) => name)).toContain('retuned');
  expect(app.state.time.value).toBeCloseTo(1, 9);
});
