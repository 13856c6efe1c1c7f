import { afterEach, expect, test, vi } from 'vitest';
import { Comparison } from '../../../src/app/runs/comparison.ts';
import { Sweep } from '../../../src/app/runs/sweep.ts';
import { createApp, systemMetas } from '../../../src/app/store.ts';
import { Compute } from '../../../src/compute/client/compute.ts';
import type { ScenarioFile } from '../../../src/core/scenario/types.ts';
import { NearWorker } from '../../compute/nearWorker.ts';

const workers: { purpose: string; worker: NearWorker }[] = [];

function workingApp() {
  vi.stubGlobal('requestAnimationFrame', () => 0);
  vi.stubGlobal('cancelAnimationFrame', () => undefined);
  const compute = new Compute(
    (purpose) => {
      const worker = new NearWorker();
      workers.push({ purpose, worker });
      return worker;
    },
    systemMetas,
    1,
  );
  const { comparison, sweep } = { comparison: new Comparison(compute.comparison), sweep: new Sweep(compute.sweep) };
  return createApp(compute, { dark: false, reducedMotion: true, roomy: false }, comparison, sweep);
}

afterEach(() => {
  for (const { worker } of workers.splice(0)) worker.terminate();
});

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
