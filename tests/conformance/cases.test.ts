// Every built-in case runs, ends as it should, and meets the numbers that are known about it.
import { describe, expect, test } from 'vitest';
import { cases } from '../../src/core/systems/registry.ts';
import { caseColumns, measured } from '../../src/core/motion/caseMeasures.ts';
import { methodSets } from '../../src/core/cases/methodSets.ts';
import { compileExpression } from '../../src/core/scenario/expressions.ts';
import { systems } from '../../src/core/systems/all.ts';
import { runOf, scenarioOf } from '../helpers.ts';

/** Where runs stop that do not reach their duration. */
const stops: Readonly<Record<string, readonly [reason: string, time: number]>> = {
  released: ['touchdown', 0.52425],
  'coasting-2': ['touchdown', 0.56965],
  'coasting-3': ['touchdown', 0.61435],
  'falling-ground': ['touchdown', 0.17442],
};

/** Last values of what nobody has published: they are this program's own, stored so that a change is seen. */
const ends: Readonly<Record<string, Readonly<Record<string, readonly [value: number, tolerance: number]>>>> = {
  ridden: { X: [19.7443, 1e-3], Y: [-3.1316, 1e-3] },
  balanced: { X: [9.9455, 1e-3], alpha_bp: [-0.17454, 1e-4] },
  'balanced-computer': { X: [9.9657, 1e-3], alpha_bp: [-0.17457, 1e-4] },
  'authors-tests': { X: [8.02577, 1e-3], Y: [0.02665, 1e-3] },
  released: { X: [0.52337, 1e-4], theta: [-0.033238, 1e-5] },
  'coasting-2': { X: [1.13824, 1e-4], theta: [-0.045132, 1e-5] },
  'coasting-3': { X: [1.84175, 1e-4], theta: [-0.059369, 1e-5] },
  'falling-ground': { Y: [-0.02497, 1e-4], alpha_fp: [0.28249, 1e-4] },
  'balanced-feet': { X: [0.079496, 1e-5], alpha_fp: [0, 1e-4], alpha_bp: [0, 1e-4], theta_fc: [0, 1e-4] },
  'balanced-pushed': { X: [11.838803, 1e-4], alpha_bp: [-0.002133, 1e-5], theta_fc: [0.001526, 1e-5] },
  scheduled: { X_dot: [4.101, 1e-3], alpha_fp: [0, 1e-4], theta_fc: [0, 1e-4] },
  circle: { X: [1.43666, 1e-3], Y: [-3.45009, 1e-3], theta: [-14.95352, 1e-3] },
  turning: { X: [15.0041, 1e-3], Y: [3.7102, 1e-3] },
  'rider-balanced': { X: [9.68468, 1e-3], Y: [-2.59213, 1e-3], beta: [0.000196, 1e-5] },
  'rider-fast': { X: [49.44315, 1e-3], Y: [-7.1852, 1e-3], beta: [0.000902, 1e-5] },
  'rider-standing': { X: [0.027507, 1e-5], beta: [0, 1e-7], alpha_fp: [0, 1e-6] },
  'rider-late': { X: [5.00185, 1e-3], Y: [-0.21018, 1e-3], beta: [0.000826, 1e-5] },
  'cart-pendulum': { X: [0.252355, 1e-5], theta: [-3.570098, 1e-5] },
  'cart-pendulum-lqr': { X: [0, 1e-3], theta: [Math.PI / 2, 1e-4] },
  'bicycle-stable': { roll: [-0.000523, 1e-5], y: [-8.08767, 1e-3] },
  'bicycle-weave': { roll: [-0.354201, 1e-5], steer: [-0.354737, 1e-5] },
  'bicycle-capsize': { roll: [0.030087, 1e-6], y: [-10.2092, 1e-3] },
  'rider-hips': { X: [21.73225, 1e-3], Y: [0.0197, 1e-3], twist: [-0.23449, 1e-4] },
  'rider-landing': { X: [2.96736, 1e-4], Y: [-0.45741, 1e-4], beta: [0.000065, 1e-6] },
  'bicycle-rider-no-hands': { x: [39.87972, 1e-3], y: [-2.93608, 1e-3], roll: [0, 1e-5] },
  'bicycle-rider-firm': { x: [46.5965, 1e-3], y: [-17.8087, 1e-3], lean: [-0.000155, 1e-5] },
  'bicycle-rider-limp': { roll: [-0.178166, 1e-4], lean: [1.027304, 1e-4] },
  'wheel-pendulum': { X: [-0.033276, 1e-5], psi: [-7.554747, 1e-5] },
};

const finished = new Map<string, ReturnType<typeof runOf>>();
/** One run per case, whatever asks for it. */
const runOfCase = (id: string) => {
  const { scenario } = cases.find((c) => c.id === id)!;
  const run = finished.get(id) ?? runOf(scenario);
  finished.set(id, run);
  return {
    run,
    column: caseColumns(systems[scenario.system]!, scenarioOf(scenario).parameters, (name) => run.columns.get(name)),
  };
};

test('ids are unique, every system has a case, every figure with a result has one', () => {
  expect(new Set(cases.map((c) => c.id)).size).toBe(cases.length);
  expect(Object.keys(systems).filter((id) => !cases.some((c) => c.scenario.system === id))).toEqual([]);
  const figures = new Set(
    cases.flatMap(({ figure }) => {
      const [first, last] = (figure?.match(/\d+/g) ?? []).map(Number);
      return first === undefined ? [] : Array.from({ length: (last ?? first) - first + 1 }, (_, k) => first + k);
    }),
  );
  expect([5, 6, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17].filter((n) => !figures.has(n))).toEqual([]);
});

describe.each(cases.map((c) => [c.id, c] as const))('%s', (id, { scenario, published = [], plots = [] }) => {
  test('runs, with finite rows on its constraints, and ends where it should', () => {
    const { run } = runOfCase(id);
    for (const [name, column] of run.columns) expect(column.every(Number.isFinite), name).toBe(true);
    expect(Math.max(...run.columns.get('residual')!)).toBeLessThan(1e-12);
    const [reason, time] = stops[id] ?? ['end', scenario.duration ?? 10];
    expect(run.end.reason).toBe(reason);
    expect(Math.abs(run.end.time - time)).toBeLessThan(1e-4);
    const stored = Object.entries(ends[id] ?? {});
    expect(
      stored.length + published.length,
      'a case needs a published number, or a stored end state in this file',
    ).toBeGreaterThan(0);
    for (const [name, [value, tolerance]] of stored)
      expect(Math.abs(run.columns.get(name)!.at(-1)! - value), `${name} at the end`).toBeLessThan(tolerance);
  });

  test.each(published)('meets what is known about it: $what', ({ what, measure, value, tolerance, source }) => {
    const { column } = runOfCase(id);
    expect(
      Math.abs(measured(measure, column) - value),
      `${what}: ${measured(measure, column)} for ${value} (${source})`,
    ).toBeLessThanOrEqual(tolerance);
  });

  test('its plots name columns that there are', () => {
    const { run, column } = runOfCase(id);
    expect(plots.length).toBeGreaterThan(0);
    for (const { x, y, exact } of plots) {
      for (const name of [x, ...y]) expect(column(name).length).toBe(run.rows);
      if (exact)
        expect(compileExpression(exact.expression, { variables: ['t'] }).evaluate(0)).toBeCloseTo(
          run.columns.get(y[0]!)![0]!,
          12,
        );
    }
  });
});

test.each([0.5, 2])('the gait on the circle holds its speed whatever it starts with: %f m/s', (X_dot) => {
  const { scenario } = cases.find((c) => c.id === 'circle')!;
  const { columns } = runOf({ ...scenario, initial: { X_dot } });
  const over = { x: 'X', y: 'Y', from: 20 } as const;
  const column = (name: string) => columns.get(name)!;
  expect(Math.abs(measured({ kind: 'speed', ...over }, column) - 1)).toBeLessThan(0.002);
  expect(Math.abs(measured({ kind: 'diameter', ...over }, column) - 4)).toBeLessThan(0.02);
});

test.each(['balanced-feet', 'balanced', 'cart-pendulum-lqr'])(
  'without losses the inputs of %s spend what the energy gains',
  (id) => {
    const { scenario } = cases.find((c) => c.id === id)!;
    const { columns } = runOf({ ...scenario, duration: 1, outputStep: 2e-4 });
    const column = caseColumns(systems[scenario.system]!, scenarioOf(scenario).parameters, (name) => columns.get(name));
    const energy = column('energy');
    const [net, gross] = (['net', 'gross'] as const).map((spent) => measured({ kind: 'energy', spent }, column));
    expect(Math.abs(energy.at(-1)! - energy[0]! - net!)).toBeLessThan(1e-3 * gross!);
    expect(gross).toBeGreaterThan(Math.abs(net!));
  },
);

test('a name that is no column is refused', () => {
  const { column } = runOfCase('caster-rotation');
  for (const name of ['caster', 'caster.w', 'caster.xy', 'wheel.x', 'speed'])
    expect(() => column(name)).toThrow(/no column/);
});

describe.each(methodSets.filter((set) => set.scenario))(
  'the set of methods $id',
  ({ scenario, choices, chosen, column }) => {
    test('runs every choice, and draws a column that there is', () => {
      expect(chosen.filter((id) => !choices.some((c) => c.id === id))).toEqual([]);
      for (const { method, outputStep } of choices) {
        const run = runOf({ ...scenario, method, ...(outputStep ? { outputStep } : {}) });
        expect(run.end.reason).toBe('end');
        expect(run.columns.get(column)!.length).toBe(run.rows);
      }
    });
  },
);
