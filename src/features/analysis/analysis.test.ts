import { describe, expect, test } from 'vitest';
import { analyse } from '../../core/control/analysis.ts';
import { scenarioLocus } from '../../core/control/locus/scenarioLocus.ts';
import type { Complex, Mode } from '../../core/control/linearization/spectrum.ts';
import { ScenarioError, type ScenarioFile } from '../../core/scenario/types.ts';
import { systems } from '../../core/systems/all.ts';
import { clustersOf, eigenvalueText, modeRows, qualitiesOf, reachRows } from './modes.ts';
import { analysedPart, pointOf, pointPath, statesOf, withPoint } from './names.ts';
import { bendOf, extent, isWide } from './planeScale.ts';
import { offeredRange, subjectsOf } from './subjects.ts';
import { scenarioOf } from '../../../tests/helpers.ts';

const board = systems['ripstik']!;
const mode = (re: number, im = 0): Mode => ({ eigenvalue: [re, im], moves: ['X'], shape: [1] });

describe('modes as rows', () => {
  test('a pair is one row, the fastest growing first, rounding is zero', () => {
    const rows = modeRows([mode(-2, -3), mode(-2, 3), mode(1), mode(1e-14, 20), mode(1e-14, -20)], 'open');
    expect(rows.map((r) => r.eigenvalue)).toEqual([
      [1, 0],
      [0, 20],
      [-2, 3],
    ]);
    expect(new Set(rows.map((r) => r.key)).size).toBe(3);
  });

  test('an oscillation has its frequency, damping and time constant', () => {
    const { frequency, damping, time, kind } = qualitiesOf([-3, 4]);
    expect(frequency).toBeCloseTo(4 / (2 * Math.PI), 15);
    expect([damping, time, kind]).toEqual([0.6, 1 / 3, 'decays']);
    expect(qualitiesOf([0, 0])).toEqual({ frequency: null, damping: null, time: null, kind: 'neutral' });
    expect(qualitiesOf([0, 5])).toMatchObject({ damping: 0, time: null, kind: 'neutral' });
    expect(qualitiesOf([2, 0])).toMatchObject({ frequency: null, damping: -1, time: 0.5, kind: 'grows' });
  });

  test.each<[Complex, string]>([
    [[-7.5854, 28.1459], '−7.585 ± 28.15i'],
    [[0, 24.222], '±24.22i'],
    [[10.9943, 0], '10.99'],
    [[0, 0], '0'],
  ])('%s reads %s', (value, text) => {
    expect(eigenvalueText(value)).toBe(text);
  });

  test('equal eigenvalues stand together', () => {
    const clusters = clustersOf(modeRows([mode(0), mode(0), mode(-1), mode(0)], 'open'));
    expect(clusters.map((c) => c.rows.length)).toEqual([3, 1]);
  });

  test('what each input reaches adds up to what the analysis says', () => {
    const analysis = analyse(scenarioOf({ version: 1, system: 'ripstik', at: { X_dot: 1 } }), board);
    const rows = reachRows(analysis);
    expect(rows.reduce((sum, r) => sum + r.of * (r.eigenvalue[1] > 0 ? 2 : 1), 0)).toBe(14);
    analysis.reachability.byInput.forEach(({ dimension }, k) => {
      expect(rows.reduce((sum, r) => sum + r.reached[k]! * (r.eigenvalue[1] > 0 ? 2 : 1), 0)).toBe(dimension);
    });
    expect(rows.find((r) => r.eigenvalue[0] === 0)).toMatchObject({ of: 6, reached: [2, 2, 2, 2, 2] });
  });
});

describe('the operating point in a draft', () => {
  const draft: ScenarioFile = { version: 1, system: 'ripstik', duration: -1 };
  const lqr: ScenarioFile = { ...draft, at: { Y: 1 }, control: { type: 'lqr', inputs: ['tau_fc'], at: { X_dot: 1 } } };

  test('is the controller’s where there is one', () => {
    expect([pointOf(draft), pointOf(lqr)]).toEqual([{}, { X_dot: 1 }]);
    expect([pointPath(draft), pointPath(lqr)]).toEqual(['at', 'control.at']);
  });

  test('is changed without a trace of what was taken out', () => {
    expect(withPoint(draft, 'X_dot', 2)).toEqual({ ...draft, at: { X_dot: 2 } });
    expect(withPoint({ ...draft, at: { X_dot: 2 } }, 'X_dot', undefined)).toEqual(draft);
    expect(withPoint(lqr, 'X_dot', 3).control).toEqual({ type: 'lqr', inputs: ['tau_fc'], at: { X_dot: 3 } });
  });

  test('only what an analysis depends on is asked about', () => {
    expect(analysedPart(lqr)).toEqual({ version: 1, system: 'ripstik', control: lqr.control });
    const track: ScenarioFile = {
      ...draft,
      at: { X_dot: 1 },
      inputs: { tau_fp: 't' },
      control: { type: 'track', reference: {}, kp: 1, kd: 1 },
    };
    expect(analysedPart(track)).toEqual({ version: 1, system: 'ripstik', at: { X_dot: 1 } });
  });
});

describe('scales', () => {
  test('small things', () => {
    expect([isWide([1, 2, 0]), isWide([1, 1000]), isWide([0])]).toEqual([false, true, false]);
    expect([bendOf([]), bendOf([0, 3, 40]), bendOf([1e-8, 500])]).toEqual([1, 1, 0.1]);
    const [low, high] = extent([-10, -5]);
    expect(low).toBeLessThan(-10);
    expect(high).toBeGreaterThan(0);
  });
});

describe('what a locus is drawn against', () => {
  const subjects = subjectsOf(board, statesOf(board.meta), 'speed');

  test('is the forward rate first, and every parameter, with a range inside its bounds', () => {
    expect(subjects[0]).toMatchObject({ id: 'at.X_dot', unit: 'm/s', factor: 1 });
    expect(subjects.filter((s) => s.vary === 'parameter').map((s) => s.name)).toEqual(
      board.meta.parameters.map((p) => p.name),
    );
    expect(subjects.find((s) => s.name === 'casterAngle')).toMatchObject({ unit: '°', angle: true });
    for (const subject of subjects) {
      const p = board.meta.parameters.find(({ name }) => name === subject.name);
      const { from, to } = offeredRange(subject, p?.default ?? 0);
      expect(from, subject.id).toBeLessThan(to);
      expect(from, subject.id).toBeGreaterThanOrEqual(p?.min ?? -Infinity);
    }
  });
});

describe('the locus of a scenario', () => {
  const scenario = scenarioOf({ version: 1, system: 'ripstik', at: { X_dot: 1 } });
  const ask = { vary: 'at', name: 'X_dot', from: -1, to: 1, count: 9, closed: false } as const;

  test('passes through the analysis at its own point, tells its progress, and finds the board at rest', () => {
    const shares: number[] = [];
    const locus = scenarioLocus(scenario, board, ask, (share) => shares.push(share));
    expect(shares).toEqual([0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1]);
    const end = locus.branches.map((branch) => branch.at(-1)!);
    for (const [re, im] of analyse(scenario, board).eigenvalues) {
      expect(Math.min(...end.map((e) => Math.hypot(e[0] - re, e[1] - im)))).toBeLessThan(1e-9);
    }
    // Backwards two oscillations grow that decay forwards.
    expect(locus.critical).toHaveLength(1);
    expect(locus.critical[0]).toMatchObject({ unstableBelow: 6, unstableAbove: 2 });
    expect(Math.abs(locus.critical[0]!.value)).toBeLessThan(1e-6);
  });

  test('a caster without trail is one place, not many', () => {
    const { critical } = scenarioLocus(
      scenario,
      board,
      { vary: 'parameter', name: 'casterTrail', from: -0.06, to: 0.06, count: 13, closed: false },
      () => {},
    );
    expect(critical.length).toBeLessThan(3);
  });

  test.each([
    ['a falling range', { from: 1, to: 0 }],
    ['no number', { from: NaN }],
    ['one value', { count: 1 }],
    ['an unknown parameter', { vary: 'parameter', name: 'wings' }],
    ['no gain to keep', { closed: true }],
    ['no steady motion', { name: 'theta_dot', from: 1, to: 2 }],
  ] as const)('refuses %s', (_, change) => {
    expect(() => scenarioLocus(scenario, board, { ...ask, ...change }, () => {})).toThrow(ScenarioError);
  });
});
