// The Whipple bicycle against the benchmark: linear, from the nonlinear model's own Jacobians, and nonlinear near upright.
import { readFileSync } from 'node:fs';
import { Matrix, solve } from 'ml-matrix';
import { describe, expect, test } from 'vitest';
import { controlReport } from '../../src/core/control/design/report.ts';
import { scenarioLocus } from '../../src/core/control/locus/scenarioLocus.ts';
import type { Complex } from '../../src/core/control/linearization/spectrum.ts';
import { systems } from '../../src/core/systems/all.ts';
import { runOf, scenarioOf } from '../helpers.ts';

interface Benchmark {
  eigenvalues_v0: number[];
  eigenvalues_by_speed: Record<string, { capsize: number; castering: number; weave_re: number; weave_im: number }>;
  critical_speeds: { weave: { v: number }; capsize: { v: number } };
}
const benchmark = JSON.parse(
  readFileSync(new URL('../reference/whipple-benchmark.json', import.meta.url), 'utf8'),
) as Benchmark;
const bicycle = systems['bicycle']!;
const at = (speed: number) => scenarioOf({ version: 1, system: 'bicycle', at: { speed } });

/** The four eigenvalues of lean and steer: what is left without the zeros of place, heading and speed. */
const moving = (speed: number): Complex[] =>
  controlReport(at(speed), bicycle).eigenvalues.filter(([re, im]) => Math.hypot(re, im) > 0);

function nearest(values: readonly Complex[], [re, im]: Complex): number {
  return Math.min(...values.map(([a, b]) => Math.hypot(a - re, b - im)));
}

test('at rest: two pairs of opposite eigenvalues', () => {
  const found = moving(0);
  expect(found).toHaveLength(4);
  for (const value of benchmark.eigenvalues_v0) expect(nearest(found, [value, 0])).toBeLessThan(1e-9);
});

test.each(Object.entries(benchmark.eigenvalues_by_speed))(
  'eigenvalues at %s m/s',
  (speed, { capsize, castering, weave_re, weave_im }) => {
    const found = moving(Number(speed));
    expect(found).toHaveLength(4);
    const expected: Complex[] = [
      [capsize, 0],
      [castering, 0],
      [weave_re, weave_im],
      [weave_re, -weave_im],
    ];
    for (const value of expected) expect(nearest(found, value)).toBeLessThan(1e-9);
  },
);

test('weave and capsize speeds are where modes cease and begin to grow', () => {
  const locus = scenarioLocus(
    at(5),
    bicycle,
    { vary: 'at', name: 'x_dot', from: 3.05, to: 8, count: 40, closed: false },
    () => {},
  );
  const critical = locus.critical.map((c) => c.value);
  expect(critical).toHaveLength(2);
  const { weave, capsize } = benchmark.critical_speeds;
  expect(Math.abs(critical[0]! - weave.v)).toBeLessThan(1e-8);
  expect(Math.abs(critical[1]! - capsize.v)).toBeLessThan(1e-8);
});

describe('the nonlinear bicycle near upright', () => {
  const run = (speed: number, initial: object, duration: number) =>
    runOf({
      version: 1,
      system: 'bicycle',
      initial: { speed, ...initial },
      duration,
      method: { name: 'dop853', rtol: 1e-12, atol: 1e-14 },
    });

  test('speed alone is straight ahead with rolling wheels', () => {
    const { columns, end } = run(4.6, {}, 2);
    expect(end.reason).toBe('end');
    expect(columns.get('x')!.at(-1)!).toBeCloseTo(9.2, 9);
    expect(columns.get('rear_spin')!.at(-1)!).toBeCloseTo(9.2 / 0.3, 8);
    expect(columns.get('front_spin')!.at(-1)!).toBeCloseTo(9.2 / 0.35, 8);
    for (const name of ['y', 'yaw', 'roll', 'steer']) expect(Math.abs(columns.get(name)!.at(-1)!)).toBeLessThan(1e-10);
  });

  test.each([
    ['weave grows', 4],
    ['weave decays', 5],
  ] as const)('%s at %d m/s at the rate of its eigenvalue, and energy is kept', (_, speed) => {
    const { weave_re, weave_im, capsize } = benchmark.eigenvalues_by_speed[String(speed)]!;
    const { columns, counts } = run(speed, { roll: 1e-4 }, 5);
    expect(Math.abs(counts.energyDrift!)).toBeLessThan(1e-9);
    // After 1.5 s castering has died away: rows of lean obey a recurrence of three terms, of which e^(lambda d) are the roots.
    const rows = 15;
    const terms = recurrence(columns.get('roll')!.subarray(150), rows);
    for (const value of [
      [weave_re, weave_im],
      [capsize, 0],
    ] as const)
      expect(rootError(terms, value, 0.01 * rows)).toBeLessThan(1e-4);
  });

  test('capsize grows at 8 m/s at the rate of its eigenvalue', () => {
    const roll = run(8, { roll: 1e-6 }, 40).columns.get('roll')!;
    const rate = Math.log(roll[3500]! / roll[3000]!) / 5;
    expect(Math.abs(rate - benchmark.eigenvalues_by_speed['8']!.capsize)).toBeLessThan(1e-4);
  });
});

/** Prony: a, b, c of x[k + 3] = a x[k + 2] + b x[k + 1] + c x[k] for rows `apart`, by least squares. */
function recurrence(x: Float64Array, apart: number): number[] {
  const rows: number[][] = [];
  const right: number[][] = [];
  for (let k = 0; k + 3 * apart < x.length; k++) {
    rows.push([x[k + 2 * apart]!, x[k + apart]!, x[k]!]);
    right.push([x[k + 3 * apart]!]);
  }
  return solve(new Matrix(rows), new Matrix(right)).to1DArray();
}

/** How far (1/s, to first order) a root e^(lambda d) of z^3 - a z^2 - b z - c is from a given lambda. */
function rootError([a, b, c]: readonly number[], [re, im]: readonly [number, number], d: number): number {
  const z: Complex = [Math.exp(re * d) * Math.cos(im * d), Math.exp(re * d) * Math.sin(im * d)];
  const times = ([x, y]: Complex, [u, v]: Complex): Complex => [x * u - y * v, x * v + y * u];
  const [z2, z3] = [times(z, z), times(z, times(z, z))];
  const p = Math.hypot(z3[0] - a! * z2[0] - b! * z[0] - c!, z3[1] - a! * z2[1] - b! * z[1]);
  const slope = Math.hypot(3 * z2[0] - 2 * a! * z[0] - b!, 3 * z2[1] - 2 * a! * z[1]);
  return p / (slope * Math.hypot(...z) * d);
}
