// A scalar equation is shown as its curve being drawn: the marker goes along x with time, on the straight lines of its path.
import { expect, test } from 'vitest';
import { MotionSampler } from '../../../src/core/motion/motionSampler.ts';
import { stiffDecayView } from '../../../src/core/systems/stiff-decay/view.ts';
import { Trajectory } from '../../../src/core/motion/trajectory.ts';

function euler(step: number, rows: number): Trajectory {
  const t = Float64Array.from({ length: rows }, (_, k) => k * step);
  const y = t.map((_, k) => (1 - 15 * step) ** k);
  const trajectory = new Trajectory(['t', 'y', 'y_dot'], rows);
  trajectory.straight = true;
  trajectory.append([t, y, y.map((value) => -15 * value)], rows);
  return trajectory;
}

test('the marker is at 2 m a second, and between two steps on the line that joins them', () => {
  const sampler = new MotionSampler(stiffDecayView, { rate: 15 }, euler(0.25, 5), null);
  for (const time of [0, 0.1, 0.25, 0.4, 0.9]) {
    expect(sampler.sample(time)).toBe(true);
    const [k, share] = [Math.floor(time / 0.25), (time / 0.25) % 1];
    const y = (-2.75) ** k + share * ((-2.75) ** (k + 1) - (-2.75) ** k);
    expect(sampler.poses[0]).toBeCloseTo(2 * time, 12);
    expect(sampler.poses[2]).toBeCloseTo(y, 10);
    expect(sampler.interpolated('y', time)).toBeCloseTo(y, 10);
  }
  const [track] = sampler.tracks();
  expect(track!.count).toBe(5);
  expect([...track!.points.subarray(6, 9)]).toEqual([1, 0, 7.5625]);
});
