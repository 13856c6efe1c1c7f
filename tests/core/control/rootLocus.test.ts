import { Matrix } from 'ml-matrix';
import { describe, expect, test } from 'vitest';
import {
  closedLoopFamily,
  designFamily,
  openLoopFamily,
  type OneOpen,
} from '../../../src/core/control/locus/families.ts';
import { GainSchedule } from '../../../src/core/control/design/gainSchedule.ts';
import { assign, rootLocus } from '../../../src/core/control/locus/rootLocus.ts';
import { scenarioLocus } from '../../../src/core/control/locus/scenarioLocus.ts';
import type { Complex } from '../../../src/core/control/linearization/spectrum.ts';
import { systems } from '../../../src/core/systems/all.ts';
import { scenarioOf, seeded } from '../../helpers.ts';

const grid = (from: number, to: number, count: number) =>
  Array.from({ length: count }, (_, i) => from + ((to - from) * i) / (count - 1));

/** Weave of a pair at `pair`, divergence at `single`, both in the presence of a double structural zero. */
const family = (pair: number, single: number) => (p: number) =>
  new Matrix([
    [pair - p, 7, 0, 0, 0, 0],
    [-7, pair - p, 0, 0, 0, 0],
    [0, 0, 0.3 * (p - single), 0, 0, 0],
    [0, 0, 2, 0, 1, 0],
    [1, 0, 0, 0, 0, 0],
    [0, 3, 0, 0, 0, -9 - p * p],
  ]);

describe('critical values', () => {
  test('are found to the last digits, with what crosses', () => {
    const { critical } = rootLocus(family(4.292382536, 6.024262015), grid(0, 10, 21));
    expect(critical).toHaveLength(2);
    expect(critical[0]!.value).toBeCloseTo(4.292382536, 12);
    expect(critical[0]!.eigenvalue[1]).toBeCloseTo(7, 12);
    expect(critical[0]).toMatchObject({ unstableBelow: 2, unstableAbove: 0 });
    expect(Math.abs(critical[1]!.value - 6.024262015)).toBeLessThan(1e-8);
    expect(critical[1]).toMatchObject({ eigenvalue: [0, 0], unstableBelow: 0, unstableAbove: 1 });
  });

  test('two in one interval, and one at zero', () => {
    const { critical } = rootLocus(family(0.1, 0.15), grid(-1, 1, 3));
    expect(critical.map((c) => Number(c.value.toFixed(9)))).toEqual([0.1, 0.15]);
    const atZero = rootLocus(family(0, 50), grid(-1, 1, 4)).critical;
    expect(Math.abs(atZero[0]!.value)).toBeLessThan(1e-12);
  });

  test('an undamped oscillation is no crossing', () => {
    const swing = (p: number) =>
      new Matrix([
        [0, 1],
        [-1 - p * p, 0],
      ]);
    expect(rootLocus(swing, grid(-2, 2, 41)).critical).toEqual([]);
  });
});

describe('branches', () => {
  test('follow a mode through another one', () => {
    // Two real eigenvalues that pass each other: p and 1 - p.
    const { values, branches } = rootLocus(
      (p) =>
        new Matrix([
          [p, 0],
          [0, 1 - p],
        ]),
      grid(0, 1, 12),
    );
    for (const branch of branches) {
      const rising = branch.at(-1)![0] > branch[0]![0];
      branch.forEach(([re], i) => expect(re).toBeCloseTo(rising ? values[i]! : 1 - values[i]!, 12));
    }
  });

  test('hold every eigenvalue once at every value', () => {
    const { values, branches } = rootLocus(family(4, 6), grid(0, 10, 21));
    values.forEach((p, i) => {
      const sum = branches.reduce((total, branch) => total + branch[i]![0], 0);
      expect(sum).toBeCloseTo(2 * (4 - p) + 0.3 * (p - 6) - 9 - p * p, 10);
    });
  });

  test('values without a steady motion are left out', () => {
    const { values } = rootLocus((p) => (p < 0.5 ? null : new Matrix([[-p]])), grid(0, 1, 11));
    expect(Math.min(...values)).toBeCloseTo(0.5, 12);
  });
});

test('the assignment is the one of least total distance', () => {
  const random = seeded(61);
  for (let k = 0; k < 20; k++) {
    const points = (): Complex[] => Array.from({ length: 5 }, () => [random(), random()]);
    const [from, to] = [points(), points()];
    const cost = (order: readonly number[]) =>
      order.reduce((sum, j, i) => sum + Math.hypot(from[i]![0] - to[j]![0], from[i]![1] - to[j]![1]), 0);
    const found = assign(from, to);
    expect(new Set(found).size).toBe(5);
    expect(cost(found)).toBeCloseTo(Math.min(...permutations([0, 1, 2, 3, 4]).map(cost)), 12);
  }
});

const system = systems['ripstik']!;
const plant = {
  system,
  parameters: Float64Array.from(system.meta.parameters, (p) => p.default),
  constraints: 'rolling',
  hold: [],
};
const bySpeed: OneOpen = { plant, at: {}, varied: { kind: 'at', name: 'X_dot' } };
const motors = system.meta.inputs.filter((i) => ['tau_fc', 'tau_bc'].includes(i.name));
const weights = { Q: Array<number>(20).fill(1), R: [1, 1] };

test.each([{}, { speed: 5 }])(
  'a bicycle over its speed, the point at %o: weave and capsize where they are known',
  (at) => {
    const scenario = scenarioOf({ version: 1, system: 'bicycle', at });
    const request = { vary: 'at', name: 'speed', from: 1, to: 9, count: 9, closed: false } as const;
    const { critical } = scenarioLocus(scenario, systems.bicycle!, request, () => {});
    expect(critical.map(({ value }) => Number(value.toFixed(6)))).toEqual([4.292383, 6.024262]);
  },
);

describe('the board', () => {
  test('two modes grow at every speed from rest to 10 m/s: it never balances by itself', () => {
    const { branches, critical } = rootLocus(openLoopFamily(bySpeed), grid(0, 10, 11));
    expect(branches).toHaveLength(14);
    expect(critical).toEqual([]);
    for (let i = 0; i < branches[0]!.length; i++) expect(branches.filter((b) => b[i]![0] > 1e-6)).toHaveLength(2);
  });

  test('trail: beyond a trail ahead of the pivot the casters turn over in a growing oscillation', () => {
    const trail: OneOpen = { plant, at: { X_dot: 1 }, varied: { kind: 'parameter', name: 'casterTrail' } };
    const { critical } = rootLocus(openLoopFamily(trail), grid(-0.08, -0.01, 15));
    expect(critical).toHaveLength(1);
    expect(critical[0]).toMatchObject({ unstableBelow: 6, unstableAbove: 4 });
  });

  test.each([
    [
      0,
      [
        [-0.06797, 2, 4],
        [0, 4, 2],
      ],
    ],
    [
      1,
      [
        [-0.06815, 6, 4],
        [0.000511, 4, 2],
      ],
    ],
  ])(
    'a caster without trail, at %d m/s: modes that stand still at one value alone are no crossing of their own',
    (X_dot, expected) => {
      const trail: OneOpen = { plant, at: X_dot ? { X_dot } : {}, varied: { kind: 'parameter', name: 'casterTrail' } };
      // With zero among the values, and between two of them.
      for (const count of [21, 20]) {
        const { critical } = rootLocus(openLoopFamily(trail), grid(-0.1, 0.1, count));
        expect(critical.map((c) => [c.unstableBelow, c.unstableAbove])).toEqual(
          expected.map(([, below, above]) => [below, above]),
        );
        critical.forEach((c, i) => expect(Math.abs(c.value - expected[i]![0]!)).toBeLessThan(1e-5));
      }
    },
  );

  test('a gain of 1 m/s stabilizes over a range of speeds whose ends are critical values', () => {
    const { gain } = designFamily(bySpeed, motors, weights)(1);
    const { critical } = rootLocus(closedLoopFamily(bySpeed, motors, gain), grid(0.2, 6, 30));
    const below = critical.filter((c) => c.value < 1).at(-1);
    expect(below?.unstableAbove).toBe(0);
  });
});

describe('scheduled gains', () => {
  const design = designFamily(bySpeed, motors, weights);
  const speeds = [0.5, 1, 1.5, 2, 3];
  const schedule = new GainSchedule(speeds, design);
  const out = new Float64Array(schedule.rows * schedule.columns);

  test('are the designs at the values, held beyond the ends, between neighbours in between', () => {
    const gains = speeds.map((v) => design(v).gain.to1DArray());
    speeds.forEach((v, i) => {
      schedule.at(v, out);
      out.forEach((k, e) => expect(k).toBeCloseTo(gains[i]![e]!, 10));
    });
    schedule.at(9, out);
    out.forEach((k, e) => expect(k).toBeCloseTo(gains.at(-1)![e]!, 10));
    schedule.at(1.2, out);
    out.forEach((k, e) => {
      const [a, b] = [gains[1]![e]!, gains[2]![e]!];
      expect(k).toBeGreaterThanOrEqual(Math.min(a, b) - 1e-12);
      expect(k).toBeLessThanOrEqual(Math.max(a, b) + 1e-12);
    });
  });

  test('stabilize between the values too', () => {
    for (const v of [0.7, 1.3, 1.8, 2.6]) {
      schedule.at(v, out);
      const gain = Matrix.from1DArray(schedule.rows, schedule.columns, [...out]);
      const { branches } = rootLocus(closedLoopFamily({ ...bySpeed }, motors, gain), [v]);
      expect(
        branches.filter((b) => b[0]![0] > 1e-4),
        `${v} m/s`,
      ).toHaveLength(0);
    }
  });

  test('unsorted values are refused', () => expect(() => new GainSchedule([1, 1], design)).toThrow(/ascending/));
});

function permutations(items: readonly number[]): number[][] {
  if (items.length === 0) return [[]];
  return items.flatMap((x) => permutations(items.filter((y) => y !== x)).map((rest) => [x, ...rest]));
}
