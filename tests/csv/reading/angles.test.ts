// Turns about three axes in any order, as the contract's yaw, pitch and roll.
import fc from 'fast-check';
import { expect, test } from 'vitest';
import { anglesOf, quaternionsOf } from '../../../src/csv/reading/angles.ts';
import { base, motionOf, table } from '../circle.ts';

type Axis = 'X' | 'Y' | 'Z';
const one = (x: number): Float64Array => Float64Array.of(x);

/** Rotation matrix of a turn about one axis, row by row. */
function turn(axis: Axis, angle: number): number[] {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  if (axis === 'X') return [1, 0, 0, 0, c, -s, 0, s, c];
  return axis === 'Y' ? [c, 0, s, 0, 1, 0, -s, 0, c] : [c, -s, 0, s, c, 0, 0, 0, 1];
}

const times = (a: readonly number[], b: readonly number[]): number[] =>
  Array.from({ length: 9 }, (_, k) =>
    [0, 1, 2].reduce((sum, i) => sum + a[3 * Math.floor(k / 3) + i]! * b[3 * i + (k % 3)]!, 0),
  );

test('the same rotation, whatever the order of the turns', () => {
  const angle = fc.double({ min: -3, max: 3, noNaN: true });
  const orders = fc.constantFrom('XYZ', 'XZY', 'YXZ', 'YZX', 'ZXY', 'ZYX', 'ZXZ', 'XYX');
  fc.assert(
    fc.property(orders, angle, angle, angle, (order, x, y, z) => {
      const angles = { X: x, Y: y, Z: z };
      const axes = [...order] as Axis[];
      const expected = axes.map((axis) => turn(axis, angles[axis])).reduce(times);
      const [yaw, pitch, roll] = [one(0), one(0), one(0)];
      anglesOf(quaternionsOf(order, { X: one(x), Y: one(y), Z: one(z) }), yaw, pitch, roll);
      const made = times(times(turn('Z', yaw[0]!), turn('Y', pitch[0]!)), turn('X', roll[0]!));
      for (const [k, value] of expected.entries()) expect(made[k]!).toBeCloseTo(value, 6);
    }),
    { seed: 20261128, numRuns: 500 },
  );
});

test('rates that the file lacks are there when asked for; data has none, whatever is chosen', () => {
  const text = table('t,x,y,theta\n', base);
  expect(motionOf(text).columns).toEqual(['t', 'x', 'y', 'theta']);
  const rated = motionOf(text, { choices: { rates: 'savitzky-golay' } });
  const rate = rated.data[rated.columns.indexOf('theta_dot')]!;
  expect(rated.columns).toHaveLength(7);
  for (let i = 0; i < rated.rows; i++) expect(rate[i]!).toBeCloseTo(0.8, 3);
  const data = motionOf(text, { choices: { system: null, rates: 'savitzky-golay', run: 2, body: 'b' } });
  expect(data).toMatchObject({ systemId: null, columns: ['t', 'x', 'y', 'theta'], rows: base.length });
});
