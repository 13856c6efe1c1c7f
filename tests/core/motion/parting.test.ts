// Where runs of one scenario part.
import { expect, test } from 'vitest';
import { partingOf } from '../../../src/core/motion/parting.ts';
import { Trajectory } from '../../../src/core/motion/trajectory.ts';
import { systems } from '../../../src/core/systems/all.ts';
import { runOf } from '../../helpers.ts';

const { meta } = systems['rolling-wheel']!;

/** Every coordinate sin t, one of them wrong by `error(t)`. */
function run(error: (t: number) => number, end = 10, step = 0.1): Trajectory {
  const rows = Math.round(end / step) + 1;
  const t = Float64Array.from({ length: rows }, (_, i) => i * step);
  const names = meta.coordinates.map(({ name }) => name);
  const made = new Trajectory(['t', ...names], rows);
  made.append([t, ...names.map((_, k) => t.map((x) => Math.sin(x) + (k === 1 ? error(x) : 0)))], rows);
  return made;
}

test('an error that grows tenfold a second is told by its digits', () => {
  const parted = partingOf(meta, [run(() => 0), run((t) => 1e-6 * 10 ** t), run((t) => 1e-9 * 10 ** t)])!;
  expect(parted.compared).toBe(10);
  // The last row before.
  for (const [digits, lost] of [
    [4, 2],
    [2, 4],
    [1, 5],
  ] as const) {
    expect(parted.until[digits]).toBeGreaterThan(lost - 0.11);
    expect(parted.until[digits]).toBeLessThan(lost + 0.01);
  }
});

test('no more is said than all of them came to; one alone says nothing; a number that is none ends agreement', () => {
  expect(partingOf(meta, [run(() => 0), run(() => 0, 3)])).toEqual({ until: { 4: 3, 2: 3, 1: 3 }, compared: 3 });
  expect(partingOf(meta, [run(() => 0)])).toBeNull();
  expect(partingOf(meta, [run(() => 0), run((t) => (t > 1 ? NaN : 0))])!.until[1]).toBeCloseTo(1, 6);
});

test('methods on the board agree for a while, and to more digits for a shorter one', () => {
  const of = (name: string, rtol: number): Trajectory => {
    const { columns, rows } = runOf({
      version: 1,
      system: 'rolling-wheel',
      initial: { phi_dot: 3, theta_dot: 1 },
      duration: 2,
      method: { name, rtol },
    });
    const names = [...columns.keys()];
    const made = new Trajectory(names, rows);
    made.append(
      names.map((name) => columns.get(name)!),
      rows,
    );
    return made;
  };
  const parted = partingOf(meta, [of('dopri5', 1e-3), of('bs23', 1e-3), of('radau', 1e-8)])!;
  expect(parted.until[4]).toBeLessThanOrEqual(parted.until[2]);
  expect(parted.until[1]).toBe(2);
});
