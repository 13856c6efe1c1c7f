import { expect, test } from 'vitest';
import { checkStudy, type StudyFile } from '../../../src/core/sweep/study.ts';
import { systemMetas } from '../../../src/core/systems/registry.ts';

const WHEEL: StudyFile = {
  version: 1,
  scenario: { version: 1, system: 'rolling-wheel', duration: 1 },
  vary: { 'parameters.rho': { grid: [0.2, 0.4, 3] }, 'initial.theta': { list: ['10 deg', 0.5] } },
  measures: ['final.X', 'drift'],
};
const check = (change: object) => checkStudy({ ...WHEEL, ...change }, systemMetas);

test('a grid is every combination, its last place the fastest', () => {
  const study = check({});
  expect(study.runs).toBe(6);
  const ten = (10 * Math.PI) / 180;
  expect([0, 1, 2, 5].map((index) => study.values(index))).toEqual([
    [0.2, ten],
    [0.2, 0.5],
    [0.3, ten],
    [0.4, 0.5],
  ]);
  expect(study.scenario(3)).toMatchObject({ parameters: { rho: 0.3 }, initial: { theta: 0.5 } });
  expect(WHEEL.scenario).not.toHaveProperty('parameters');
});

test.each(['random', 'sobol'] as const)(
  '%s samples follow from seed and index alone, and fill what they should',
  (kind) => {
    const vary = { 'initial.theta': { uniform: [-1, 3] }, 'initial.X': { normal: [2, 0.5] } };
    const of = (seed: number) => check({ vary, sample: { kind, count: 4096, seed } });
    const [one, again, other] = [of(7), of(7), of(8)];
    expect(one.values(123)).toEqual(again.values(123));
    expect(one.values(123)).not.toEqual(other.values(123));
    const samples = Array.from({ length: 4096 }, (_, i) => one.values(i) as number[]);
    const mean = (f: (s: number[]) => number): number => samples.reduce((sum, s) => sum + f(s), 0) / samples.length;
    expect(Math.min(...samples.map(([u]) => u!))).toBeGreaterThan(-1);
    expect(Math.max(...samples.map(([u]) => u!))).toBeLessThan(3);
    // Four standard errors of 4096 independent samples; a Sobol sequence stays far within.
    expect(Math.abs(mean(([u]) => u!) - 1)).toBeLessThan(0.073);
    expect(Math.abs(mean(([, x]) => x!) - 2)).toBeLessThan(0.032);
    expect(Math.abs(mean(([, x]) => (x! - 2) ** 2) - 0.25)).toBeLessThan(0.023);
  },
);

test.each<[object, string]>([
  [{ version: 2 }, 'version: must be 1, not number 2'],
  [{ measure: [] }, 'measure: unknown name "measure"; did you mean "measures"?'],
  [{ vary: {} }, 'vary: names nothing'],
  [
    { vary: { 'initial.thetta': { list: [1] } } },
    'vary.initial.thetta: initial.thetta: unknown name "thetta"; did you mean "theta"?',
  ],
  [{ vary: { 'initial.theta': { grid: [0, 1] } } }, 'vary.initial.theta.grid: needs 3 entries, not 2'],
  [{ vary: { 'initial.theta': { gird: [0, 1, 2] } } }, 'vary.initial.theta: unknown name "gird"; did you mean "grid"?'],
  [{ vary: { 'initial.theta': { uniform: [0, 1] } } }, 'vary.initial.theta: has no grid and no list'],
  [{ vary: { system: { list: ['bicycle'] } } }, 'vary.system: stays the same in one study'],
  [{ vary: { 'initial.__proto__': { list: [1] } } }, 'vary.initial.__proto__: is no place in a scenario'],
  [{ sample: { kind: 'sobol' } }, 'sample.count: must be a whole number from 1'],
  [{ sample: { kind: 'lhs' } }, 'sample.kind: must be grid, random, sobol'],
  [{ measures: ['mean.X'] }, 'measures.0: "mean.X" is not known; right would be final., max. or min. of a column'],
  [{ measures: ['final.X', 'final.X'] }, 'measures.1: there is a column "final.X" already'],
  [{ scenario: { version: 1, system: 'rolling-wheel', duration: -1 } }, 'scenario.duration: '],
])('a fault is told at its place: %j', (change, words) => {
  expect(() => check(change)).toThrow(words);
});
