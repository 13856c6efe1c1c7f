import { afterEach, expect, test, vi } from 'vitest';
import type { ScenarioFile } from '../../../src/core/scenario/types.ts';
import { endWorkers, workingApp } from '../workingApp.ts';

afterEach(endWorkers);

const FALLING: ScenarioFile = {
  version: 1,
  system: 'ripstik',
  parameterSet: 'authors',
  constraints: 'report',
  initial: { alpha: '10 deg' },
  duration: 5.8,
  events: { touchdown: 'ignore' },
};

test('a run that has ended is compared beside the page; an edit stops it and it begins anew', async () => {
  const { state, actions } = workingApp();
  // Else the run follows the edit.
  actions.set('live', false);
  actions.loadScenario(FALLING, 'Falling');
  await vi.waitFor(() => expect(state.trust.value?.kind).toBe('comparing'), 20_000);
  actions.edit('alpha', (draft) => ({ ...draft, duration: 4 }));
  expect(state.trust.value?.kind).toBe('comparing');
  await vi.waitFor(() => expect(state.trust.value?.kind).toBe('compared'), 20_000);
  const known = state.trust.value!;
  if (known.kind !== 'compared') throw new Error('not compared');
  expect(known.trust.compared).toBe(5.8);
  expect(known.trust.until[4]).toBeGreaterThan(1.5);
  expect(known.trust.until[1]).toBeLessThan(4);
  // What stands is of the run on the stage, whatever the panel says meanwhile.
  actions.edit('alpha', (draft) => ({ ...draft, duration: 3 }));
  expect(state.trust.value).toBe(known);
  actions.run();
  expect(state.trust.value).toBe(null);
}, 60_000);

test('a run that fell is compared to its touchdown', async () => {
  const { state, actions } = workingApp();
  actions.loadScenario({ version: 1, system: 'ripstik', initial: { alpha: '10 deg' }, duration: 5 }, 'Falling');
  await vi.waitFor(() => expect(state.trust.value?.kind).toBe('compared'), 20_000);
  const known = state.trust.value!;
  if (known.kind !== 'compared') throw new Error('not compared');
  expect(known.trust.compared).toBe(state.motion.value!.trajectory.end);
}, 60_000);

test('a long run is compared when asked to', async () => {
  const { state, actions } = workingApp();
  const method = { name: 'rk4', step: 1e-5 };
  actions.loadScenario({ version: 1, system: 'rolling-wheel', initial: { phi_dot: 1 }, duration: 1, method }, 'Long');
  await vi.waitFor(() => expect(state.trust.value).toEqual({ kind: 'asks' }), 30_000);
  actions.compareRun();
  await vi.waitFor(() => expect(state.trust.value?.kind).toBe('compared'), 20_000);
}, 60_000);
