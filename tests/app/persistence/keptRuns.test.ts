// Pinned runs and the last sweep come back after a reload, within a stated limit; what is stored by another hand is read as far as it holds.
import fc from 'fast-check';
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { keepRuns } from '../../../src/app/persistence/keptRuns.ts';
import { LARGEST_SAVED_RUNS, runsFrom, storedRuns, sweepFrom } from '../../../src/app/persistence/savedRuns.ts';
import { systemMetas } from '../../../src/app/store.ts';
import type { Motion } from '../../../src/app/runs/motion.ts';
import { checkScenario } from '../../../src/core/scenario/schema.ts';
import { dataView } from '../../../src/core/motion/dataView.ts';
import { Trajectory } from '../../../src/core/motion/trajectory.ts';
import { systemViews } from '../../../src/core/systems/registry.ts';
import type { ScenarioFile } from '../../../src/core/scenario/types.ts';
import { appOf, storageOf } from '../appOf.ts';

const SEED = { seed: 20261202 };
const file: ScenarioFile = { version: 1, system: 'stiff-decay', duration: 2 };

beforeEach(() => void vi.useFakeTimers());
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

function motionOf(rows = 3): Omit<Motion, 'id'> {
  const scenario = checkScenario(file, systemMetas);
  const column = (f: (i: number) => number) => Float64Array.from({ length: rows }, (_, i) => f(i));
  return {
    source: 'file',
    title: 'A ride',
    system: systemViews['stiff-decay']!,
    parameters: scenario.parameters,
    trajectory: Trajectory.of(['t', 'y'], [column((i) => i / 10), column((i) => Math.exp(-i))]),
    constraints: scenario.constraints,
    scenario,
    written: file,
    adjustments: [],
    issues: [{ line: 3, column: 'y', message: 'no number' }],
    marks: [{ time: 0.1, name: 'end' }],
    judgement: { energyDrift: null, energyChange: 0, residual: 0 },
  };
}

/** What a page stored, on the next one. */
async function reloaded(storage: ReturnType<typeof storageOf>) {
  await vi.advanceTimersByTimeAsync(5000);
  const next = appOf();
  await keepRuns(next, storage.storage, systemViews);
  return next;
}

test('pinned runs come back with name, look, numbers and scenario; removed ones do not', async () => {
  const storage = storageOf();
  const app = appOf();
  await keepRuns(app, storage.storage, systemViews);
  app.actions.showMotion(motionOf());
  const pinned = app.pinned.pin()!;
  app.pinned.change(pinned.id, { name: 'The first', ghost: true });
  const view = dataView('log.csv', [{ name: 'volts', label: 'Volts', unit: 'V' }]);
  const trajectory = Trajectory.of(['t', 'volts'], [new Float64Array([0, 1]), new Float64Array([3, NaN])]);
  trajectory.recorded = true;
  app.actions.showMotion({ ...motionOf(), title: 'log.csv', system: view, trajectory, scenario: null, written: null });
  app.pinned.pin();

  const next = await reloaded(storage);
  const [first, second] = next.state.pinned.value;
  expect(first).toMatchObject({ name: 'The first', ghost: true, visible: true, style: 0 });
  expect(first!.motion).toMatchObject({ ...motionOf(), trajectory: expect.anything() as unknown });
  expect(first!.motion.trajectory.column('y')!.slice(0, 3)).toEqual(motionOf().trajectory.column('y')!.slice(0, 3));
  expect(second!.motion.system.meta).toMatchObject({ id: 'data', columns: view.meta.columns });
  expect(second!.motion.trajectory.recorded).toBe(true);
  expect(new Set([first!.id, second!.id, first!.motion.id, second!.motion.id]).size).toBe(4);

  next.pinned.remove(first!.id);
  next.pinned.remove(second!.id);
  expect((await reloaded(storage)).state.pinned.value).toEqual([]);
});

test('what is pinned before the stored ones are there stands behind them, in another colour', async () => {
  const storage = storageOf();
  const app = appOf();
  await keepRuns(app, storage.storage, systemViews);
  app.actions.showMotion(motionOf());
  app.pinned.pin();
  await vi.advanceTimersByTimeAsync(5000);
  const next = appOf();
  next.actions.showMotion({ ...motionOf(), title: 'Quick' });
  next.pinned.pin();
  await keepRuns(next, storage.storage, systemViews);
  expect(next.state.pinned.value.map(({ name }) => name)).toEqual(['A ride', 'Quick']);
  expect(new Set(next.state.pinned.value.map(({ style }) => style)).size).toBe(2);
});

test('a run that is too large is left out, and said once; a run still computing waits for its end', () => {
  const run = (motion: Omit<Motion, 'id'>, name: string) => ({
    id: 1,
    name,
    style: 0,
    motion: { ...motion, id: 1 },
    statistics: null,
    ending: null,
    visible: true,
    ghost: false,
  });
  const large = run(motionOf(LARGEST_SAVED_RUNS / 16), 'large');
  const { stored, left } = storedRuns([
    run(motionOf(), 'small'),
    large,
    run({ ...motionOf(), source: 'run' }, 'computing'),
  ]);
  expect(stored.map(({ name }) => name)).toEqual(['small']);
  expect(left).toEqual(['large']);
});

test('what another hand stored is read as far as it holds', () => {
  const good = storedRuns([
    {
      id: 1,
      name: 'x',
      style: 0,
      motion: { ...motionOf(), id: 1 },
      statistics: null,
      ending: null,
      visible: true,
      ghost: false,
    },
  ]).stored[0]!;
  const paths = Object.keys(good);
  fc.assert(
    fc.property(
      fc.constantFrom(...paths),
      fc.constantFrom(...Object.keys(good.motion)),
      fc.anything(),
      (a, b, value) => {
        runsFrom([{ ...good, [a]: value }], systemViews);
        runsFrom([{ ...good, motion: { ...good.motion, [b]: value } }], systemViews);
        runsFrom(value, systemViews);
      },
    ),
    SEED,
  );
  expect(runsFrom([{ ...good, system: 'none' }, good], systemViews)).toHaveLength(1);
  expect(
    runsFrom([{ ...good, motion: { ...good.motion, written: { version: 9 } } }], systemViews)[0]!.motion,
  ).toMatchObject({
    scenario: null,
    written: null,
  });
});

const plan = {
  title: 'Steps',
  file,
  axes: [
    {
      path: 'initial.y',
      label: 'y',
      unit: 'm',
      angle: false,
      values: [1, 2, 3].map((value) => ({ value, label: `${value}` })),
    },
  ],
  measures: [{ kind: 'time' as const }],
  form: [{ path: 'initial.y' }, { path: '' }],
};

test('a sweep comes back with its results; one that was cut off is a cancelled one', async () => {
  const storage = storageOf();
  const results = [
    { values: [2], reason: 'end', message: '' },
    { values: [NaN], reason: 'refused', message: 'no' },
    undefined,
  ];
  storage.large.set('sweep', structuredClone({ plan, results }));
  const app = appOf();
  await keepRuns(app, storage.storage, systemViews);
  expect(app.sweep.state.value).toBe('cancelled');
  expect(app.sweep.plan.value).toEqual(plan);
  expect([...app.sweep.results]).toEqual(results);
  expect([app.sweep.done, app.sweep.total]).toEqual([2, 3]);

  app.sweep.restore({ plan, results: [...results.slice(0, 2), results[0]] });
  expect(app.sweep.state.value).toBe('ended');
  const next = await reloaded(storage);
  expect(next.sweep.state.value).toBe('ended');
});

test('a sweep of another hand is refused or read, and never breaks the page', async () => {
  for (const wrong of [
    { plan: { ...plan, file: { version: 1, system: 'none' } }, results: [] },
    { plan: { ...plan, axes: [] }, results: [] },
    { plan: { ...plan, measures: [] }, results: [] },
    {},
    'text',
  ])
    expect(() => sweepFrom(wrong, systemMetas)).toThrow();
  fc.assert(
    fc.property(fc.constantFrom(...Object.keys(plan)), fc.anything(), (key, value) => {
      try {
        sweepFrom({ plan: { ...plan, [key]: value }, results: value }, systemMetas);
      } catch (error) {
        expect(error).toBeInstanceOf(Error);
      }
    }),
    SEED,
  );
  const storage = storageOf();
  storage.large.set('sweep', { plan: 3 });
  const app = appOf();
  await keepRuns(app, storage.storage, systemViews);
  expect(app.sweep.state.value).toBe('empty');
});
