import { expect, test } from 'vitest';
import { ripstikView } from '../../../src/core/systems/ripstik/view.ts';
import { matrixOf, quaternionOf, slerp } from '../../../src/core/motion/attitude.ts';
import { MotionSampler } from '../../../src/core/motion/motionSampler.ts';
import { Trajectory } from '../../../src/core/motion/trajectory.ts';
import { seeded } from '../../helpers.ts';

const defaults = Object.fromEntries(ripstikView.meta.parameters.map((p) => [p.name, p.default]));
const names = ['t', ...ripstikView.meta.coordinates.map((c) => c.name)];

/** A trajectory with the given rows of [t, coordinates by name]. */
function motion(rows: readonly [number, Record<string, number>][]): Trajectory {
  const trajectory = new Trajectory(names, 1);
  for (const [t, values] of rows)
    trajectory.append(
      names.map((name) => Float64Array.of(name === 't' ? t : (values[name] ?? 0))),
      1,
    );
  return trajectory;
}

test('rows are found by time, before, between and after', () => {
  const trajectory = motion([
    [0, {}],
    [1, {}],
    [2, {}],
  ]);
  expect([-1, 0, 0.5, 1, 1.99, 2, 9].map((t) => trajectory.locate(t))).toEqual([0, 0, 0, 1, 1, 1, 1]);
});

test('a quaternion of a rotation matrix gives the matrix back, half turns included', () => {
  const random = seeded(5);
  for (let i = 0; i < 200; i++) {
    const q = Float64Array.from({ length: 4 }, () => (random() < 0.2 ? 0 : random() - 0.5));
    const size = Math.hypot(...q);
    if (size < 1e-3) continue;
    const unit = q.map((x) => x / size);
    const m = new Float64Array(9);
    matrixOf(unit, m, 0);
    const back = new Float64Array(4);
    quaternionOf(m, 0, back);
    const again = new Float64Array(9);
    matrixOf(back, again, 0);
    again.forEach((x, k) => expect(Math.abs(x - m[k]!)).toBeLessThan(1e-14));
  }
});

test('interpolation takes the shorter arc and keeps its ends', () => {
  const a = Float64Array.of(0, 0, Math.sin(0.1), Math.cos(0.1));
  const b = Float64Array.of(0, 0, -Math.sin(0.2), -Math.cos(0.2));
  const out = new Float64Array(4);
  slerp(a, b, 0.5, out);
  expect(Math.abs(2 * Math.atan2(out[2]!, out[3]!))).toBeCloseTo(0.3, 12);
});

test('a recorded angle that jumps by a full turn makes no body spin between its rows', () => {
  const trajectory = motion([
    [0, { theta: 3.1 }],
    [1, { theta: 3.2 - 2 * Math.PI }],
  ]);
  trajectory.recorded = true;
  const sampler = new MotionSampler(ripstikView, defaults, trajectory, null);
  sampler.sample(0.5);
  expect(Math.cos(Math.atan2(sampler.poses[6]!, sampler.poses[3]!) - 3.15)).toBeCloseTo(1, 12);
});

test('a computed angle goes its own way between rows, however far, in numbers as in the picture', () => {
  const trajectory = motion([
    [0, { theta: 0 }],
    [1, { theta: 8 }],
  ]);
  const sampler = new MotionSampler(ripstikView, defaults, trajectory, null);
  sampler.sample(0.5);
  expect(sampler.interpolated('theta', 0.5)).toBeCloseTo(4, 12);
  expect(Math.cos(Math.atan2(sampler.poses[6]!, sampler.poses[3]!) - 4)).toBeCloseTo(1, 12);
  trajectory.recorded = true;
  sampler.sample(0.5);
  const turned = sampler.interpolated('theta', 0.5)!;
  expect(Math.cos(Math.atan2(sampler.poses[6]!, sampler.poses[3]!) - turned)).toBeCloseTo(1, 12);
});

test('wheels turn with the distance rolled, and backwards when it goes backwards', () => {
  const rows = Array.from(
    { length: 11 },
    (_, i) => [i * 0.1, { X: 0.1 * i, Z: 0.08196 }] as [number, Record<string, number>],
  );
  const trajectory = motion([...rows, [1.1, { X: 0.9, Z: 0.08196 }]]);
  const sampler = new MotionSampler(ripstikView, defaults, trajectory, null);
  sampler.sample(1);
  for (const angle of sampler.wheelAngles) expect(angle).toBeCloseTo(1 / defaults['wheelRadius']!, 4);
  sampler.sample(1.1);
  for (const angle of sampler.wheelAngles) expect(angle).toBeCloseTo(0.9 / defaults['wheelRadius']!, 4);
});

test('tracks follow a trajectory that grows', () => {
  const trajectory = motion([[0, { X: 0 }]]);
  const sampler = new MotionSampler(ripstikView, defaults, trajectory, null);
  expect(sampler.tracks().map((t) => t.count)).toEqual([1, 1]);
  for (let i = 1; i < 3000; i++)
    trajectory.append(
      names.map((name) => Float64Array.of(name === 't' ? i : name === 'X' ? i : 0)),
      1,
    );
  let [front] = sampler.tracks();
  while (sampler.behind) [front] = sampler.tracks();
  expect(front!.count).toBe(3000);
  expect(front!.points[3 * 2999]! - front!.points[0]!).toBeCloseTo(2999, 2);
});

test('a motion that outgrows its room keeps every second row, the newest always, and says so', () => {
  const trajectory = new Trajectory(['t', 'x'], 4, 64);
  const random = seeded(3);
  let sent = 0;
  while (sent < 5000) {
    const rows = Math.ceil(90 * random() ** 3);
    const t = Float64Array.from({ length: rows }, (_, i) => sent + i);
    trajectory.append([t, t.map((v) => v * v)], rows);
    sent += rows;
    expect(trajectory.length).toBeLessThanOrEqual(65);
    expect(trajectory.end).toBe(sent - 1);
    const kept = [...trajectory.column('t')!];
    kept.slice(0, trajectory.settled).forEach((value, k) => expect(value).toBe(k * trajectory.stride));
    expect(trajectory.settled).toBe(Math.floor((sent - 1) / trajectory.stride) + 1);
    expect([...trajectory.column('x')!]).toEqual(kept.map((v) => v * v));
  }
  expect(trajectory.generation).toBeGreaterThan(4);
  expect(trajectory.stride).toBe(2 ** trajectory.generation);
});

test('paths and wheel angles of a long motion come in shares, and are the same in the end', () => {
  const rows = 9001;
  const columns = names.map((name) =>
    Float64Array.from({ length: rows }, (_, i) =>
      name === 't' ? i / 1000 : name === 'X' ? i / 2000 : name === 'theta' ? i / 9000 : 0,
    ),
  );
  const whole = new MotionSampler(ripstikView, defaults, Trajectory.of(names, columns), null);
  for (let k = 0; k < 10 && whole.sample(0) && whole.behind; k++);
  expect(whole.behind).toBe(false);
  const grown = new Trajectory(names);
  const pieces = new MotionSampler(ripstikView, defaults, grown, null);
  for (let at = 0; at < rows; at += 500) {
    grown.append(
      columns.map((c) => c.subarray(at, at + 500)),
      Math.min(500, rows - at),
    );
    pieces.sample(9);
  }
  for (const time of [0, 4.5, 9]) {
    whole.sample(time);
    pieces.sample(time);
    expect([...whole.wheelAngles]).toEqual([...pieces.wheelAngles]);
  }
  expect(whole.tracks()[0]!.count).toBe(rows);
  expect(whole.tracks()[0]!.points.subarray(0, 3 * rows)).toEqual(pieces.tracks()[0]!.points.subarray(0, 3 * rows));
});
