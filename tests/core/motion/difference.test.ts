import { describe, expect, test } from 'vitest';
import { commonTimes, differenceOf } from '../../../src/core/motion/difference.ts';
import { resample } from '../../../src/core/motion/resample.ts';
import { Trajectory } from '../../../src/core/motion/trajectory.ts';
import { seeded } from '../../helpers.ts';

type Curve = (t: number) => number;

/** Rows of y, and of its rate where one is given. */
function record(times: readonly number[], y: Curve, rate?: Curve): Trajectory {
  const trajectory = new Trajectory(rate ? ['t', 'y', 'y_dot'] : ['t', 'y'], 1);
  const columns = [times, times.map(y), ...(rate ? [times.map(rate)] : [])];
  trajectory.append(
    columns.map((c) => Float64Array.from(c)),
    times.length,
  );
  return trajectory;
}

const grid = (from: number, to: number, n: number): number[] =>
  Array.from({ length: n + 1 }, (_, i) => from + ((to - from) * i) / n);
const turn = 2 * Math.PI;

describe('between rows', () => {
  test('a cubic with its rate is met exactly, a line without one', () => {
    const times = Float64Array.from(grid(-1, 3, 97));
    const cubic: Curve = (t) => 2 * t ** 3 - t ** 2 + 4 * t - 7;
    const found = resample(
      record([-1, 0.2, 0.5, 2, 3], cubic, (t) => 6 * t ** 2 - 2 * t + 4),
      'y',
      times,
    )!;
    times.forEach((t, k) => expect(found[k]).toBeCloseTo(cubic(t), 11));
    const line = resample(
      record([-1, 0.2, 0.5, 2, 3], (t) => 3 - 2 * t),
      'y',
      times,
    )!;
    times.forEach((t, k) => expect(line[k]).toBeCloseTo(3 - 2 * t, 12));
  });

  test('rows give themselves to the last bit, times outside give the ends', () => {
    const random = seeded(11);
    const times = grid(0, 1, 20).map((t) => t + 0.01 * random());
    const run = record(times, Math.sin, Math.cos);
    expect([...resample(run, 'y', Float64Array.from(times))!]).toEqual([...run.column('y')!]);
    expect([...resample(run, 'y', Float64Array.of(-5, 9))!]).toEqual([run.column('y')![0], run.column('y')![20]]);
  });

  test('of fourth order with rates, of second without', () => {
    const at = Float64Array.from(grid(0, 4, 1009));
    const error = (n: number, rate?: Curve): number =>
      Math.max(
        ...resample(record(grid(0, 4, n), Math.sin, rate), 'y', at)!.map((y, k) => Math.abs(y - Math.sin(at[k]!))),
      );
    expect(Math.log2(error(40, Math.cos) / error(80, Math.cos))).toBeCloseTo(4, 0);
    expect(Math.log2(error(40) / error(80))).toBeCloseTo(2, 0);
  });

  test('a recorded angle that jumps by a turn goes the short way', () => {
    const wrapped: Curve = (t) => Math.atan2(Math.sin(3 * t), Math.cos(3 * t));
    const times = Float64Array.from(grid(0, 4, 333));
    const found = resample(
      record(grid(0, 4, 100), wrapped, () => 3),
      'y',
      times,
      turn,
    )!;
    times.forEach((t, k) => expect(Math.cos(found[k]! - 3 * t)).toBeCloseTo(1, 12));
  });
});

describe('difference of two runs', () => {
  test('a sine and a shifted sine: root mean square, largest and final value in closed form', () => {
    const shift = 0.37;
    const a = record(grid(0, turn, 700), Math.sin, Math.cos);
    const b = record(
      grid(0, turn, 451),
      (t) => Math.sin(t + shift),
      (t) => Math.cos(t + shift),
    );
    // sin t - sin(t + d) = -2 sin(d / 2) cos(t + d / 2)
    const { rms, max, maxTime, final } = differenceOf(a, b, 'y')!;
    expect(rms).toBeCloseTo(Math.SQRT2 * Math.sin(shift / 2), 4);
    expect(max).toBeCloseTo(2 * Math.sin(shift / 2), 5);
    expect(Math.abs(Math.cos(maxTime + shift / 2))).toBeCloseTo(1, 4);
    expect(final).toBeCloseTo(-Math.sin(shift), 10);
  });

  test('zero for itself, whatever the grid', () => {
    const coarse = record(
      grid(0, 5, 40),
      (t) => t ** 2,
      (t) => 2 * t,
    );
    const fine = record(
      grid(0, 5, 77),
      (t) => t ** 2,
      (t) => 2 * t,
    );
    expect(differenceOf(coarse, coarse, 'y')).toMatchObject({ rms: 0, max: 0, final: 0 });
    const apart = differenceOf(coarse, fine, 'y')!;
    expect(apart.max).toBeLessThan(1e-13);
  });

  test('symmetric, and with the sign turned', () => {
    const random = seeded(23);
    for (let i = 0; i < 20; i++) {
      const [a, b] = [1, 2].map(() => {
        const times = grid(random(), 3 + random(), 5 + Math.floor(40 * random())).map((t) => t + 1e-3 * random());
        return record(times, () => random() - 0.5, random() < 0.5 ? () => random() : undefined);
      }) as [Trajectory, Trajectory];
      const [one, other] = [differenceOf(a, b, 'y')!, differenceOf(b, a, 'y')!];
      expect([...other.times]).toEqual([...one.times]);
      expect([...other.values.map((x) => -x)]).toEqual([...one.values]);
      expect(other.rms).toBe(one.rms);
      expect(other.max).toBe(one.max);
      expect(one.rms).toBeLessThanOrEqual(one.max * (1 + 1e-12));
    }
  });

  test('over the time both have, at the rows of both', () => {
    const a = record([0, 1, 2, 3], (t) => t);
    const b = record([0.5, 1 + 1e-12, 1.5, 2.5, 9], (t) => t + 1);
    const { times, rms } = differenceOf(a, b, 'y')!;
    expect([...times]).toEqual([0.5, 1, 1.5, 2, 2.5, 3]);
    expect(rms).toBeCloseTo(1, 12);
    expect(
      commonTimes(
        a,
        record([4, 5], (t) => t),
      ),
    ).toBeNull();
    expect(
      differenceOf(
        a,
        record([4, 5], (t) => t),
        'y',
      ),
    ).toBeNull();
    expect(differenceOf(a, b, 'z')).toBeNull();
    expect(
      differenceOf(
        a,
        record([3, 7], () => 1),
        'y',
      ),
    ).toMatchObject({ rms: 2, max: 2, final: 2, maxTime: 3 });
  });

  test('whole turns count only when asked', () => {
    const a = record(grid(0, 10, 100), (t) => t + 3 * turn);
    const b = record(grid(0, 10, 60), (t) => t + 0.1);
    expect(differenceOf(a, b, 'y')!.rms).toBeCloseTo(3 * turn - 0.1, 10);
    expect(differenceOf(a, b, 'y', turn)!.rms).toBeCloseTo(0.1, 10);
  });

  test('a gap in a record is left out of the mean', () => {
    const a = record(grid(0, 4, 8), (t) => (t === 2 ? NaN : 1));
    const b = record(grid(0, 4, 8), () => 0);
    expect(differenceOf(a, b, 'y')).toMatchObject({ rms: 1, max: 1 });
  });
});
