import { describe, expect, test } from 'vitest';
import { runOf } from '../helpers.ts';

/** Feet twist the plates by 20° at 1.5 Hz, the back one with a phase of its own; both with a bias and a sign. */
function ridden(phase: string, { sign = 1, amplitude = 20, bias = 0 } = {}) {
  const reference = {
    tau_fp: `${sign} * (${bias} deg + ${amplitude} deg * sin(2*pi*1.5*t))`,
    tau_bp: `${sign} * (${bias} deg + ${amplitude} deg * sin(2*pi*1.5*t + ${phase}))`,
  };
  const run = runOf({
    version: 1,
    system: 'ripstik',
    initial: { X_dot: 0.5 },
    control: { type: 'track', reference, kp: 60, kd: 3 },
    duration: 10,
  });
  const last = (name: string) => run.columns.get(name)!.at(-1)!;
  expect(run.end.reason).toBe('end');
  return { run, last, speed: Math.hypot(last('X_dot'), last('Y_dot')) };
}

describe.each(['0', 'pi/2', 'pi'])('ridden with a phase of %s between back and front', (phase) => {
  test('the board ends faster than it started; the other sign gives the mirror image of the path', () => {
    const one = ridden(phase);
    expect(one.speed).toBeGreaterThan(1);
    const other = ridden(phase, { sign: -1 });
    for (const [name, sign] of [
      ['X', 1],
      ['Y', -1],
      ['theta', -1],
      ['theta_fc', -1],
    ] as const) {
      one.run.columns
        .get(name)!
        .forEach((value, k) => expect(Math.abs(value - sign * other.run.columns.get(name)![k]!)).toBeLessThan(1e-6));
    }
  });
});

test('a bias of 5° turns it', () => {
  const straight = Math.abs(ridden('pi', { amplitude: 15 }).last('theta'));
  const turning = Math.abs(ridden('pi', { amplitude: 15, bias: 5 }).last('theta'));
  expect(turning).toBeGreaterThan(1);
  expect(turning).toBeGreaterThan(5 * straight);
});
