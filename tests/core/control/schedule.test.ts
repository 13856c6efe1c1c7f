// Gains scheduled over the forward speed: exact slopes, the fixed gain at its own speed, and runs that a fixed gain does not survive.
import { describe, expect, test } from 'vitest';
import { feedbackOf } from '../../../src/core/control/design/feedback.ts';
import { systems } from '../../../src/core/systems/all.ts';
import { runOf, scenarioOf, seeded } from '../../helpers.ts';

const board = (schedule: Record<string, unknown> | null, at = 1) => ({
  version: 1,
  system: 'ripstik',
  control: { type: 'lqr', inputs: ['tau_fc', 'tau_bc'], at: { X_dot: at }, ...(schedule ? { schedule } : {}) },
});
const bicycle = (schedule: Record<string, unknown> | null) => ({
  version: 1,
  system: 'bicycle',
  control: {
    type: 'lqr',
    inputs: ['tau_steer'],
    at: { speed: 5 },
    Q: { roll: 1, yaw: 1 },
    ...(schedule ? { schedule } : {}),
  },
});
const feedback = (raw: unknown) => {
  const scenario = scenarioOf(raw);
  return feedbackOf(scenario, systems[scenario.system]!)!;
};

describe.each([
  ['ripstik', board],
  ['bicycle', bicycle],
] as const)('%s', (id, make) => {
  const n = systems[id]!.meta.coordinates.length;
  const random = seeded(7);
  const draw = (size: number) => Float64Array.from({ length: n }, () => size * (2 * random() - 1));

  test('at a speed of the schedule it asks what the fixed gain there asks, apart from how far it has come', () => {
    const speed = id === 'ripstik' ? 1 : 5;
    const [fixed, scheduled] = [feedback(make(null)), feedback(make({ from: speed, to: 3 * speed, count: 4 }))];
    const { meta } = systems[id]!;
    const still = runOf({
      ...make(null),
      initial: id === 'ripstik' ? { X_dot: speed } : { speed },
      duration: 0.01,
    }).simulation;
    for (const [name, loop] of scheduled) {
      for (let trial = 0; trial < 5; trial++) {
        const [dq, dv] = [draw(0.01), draw(0.01)];
        // Forward speed stays that of the design: no change of it, of the heading, or of the wheels' turning.
        meta.coordinates.forEach((c, i) => {
          if (['X', 'x', 'Y', 'y', 'theta', 'yaw', 'rear_spin', 'front_spin'].includes(c.name)) dq[i] = dv[i] = 0;
        });
        const [q, v] = [still.q.map((x, i) => x + dq[i]!), still.v.map((x, i) => x + dv[i]!)];
        expect(loop.asked(0, q, v)).toBeCloseTo(fixed.get(name)!.asked(0, q, v), 9);
      }
    }
  });

  test('its slopes are those of what it asks', () => {
    for (const loop of feedback(make({ from: 0.5, to: 4, count: 5 })).values()) {
      for (const speed of [0.3, 0.9, 2.2, 5]) {
        const [q, v] = [draw(0.1), draw(0.1)];
        v[0]! += speed;
        const [forceQ, forceV] = [new Float64Array(n), new Float64Array(n)];
        loop.addSlopes(0, q, v, 1, 0, forceQ, forceV);
        const scale = Math.max(...forceQ.map(Math.abs), ...forceV.map(Math.abs));
        for (const [x, slopes] of [
          [q, forceQ],
          [v, forceV],
        ] as const) {
          for (let i = 0; i < n; i++) {
            const kept = x[i]!;
            x[i] = kept + 1e-6;
            const up = loop.asked(0, q, v);
            x[i] = kept - 1e-6;
            const down = loop.asked(0, q, v);
            x[i] = kept;
            expect(Math.abs((up - down) / 2e-6 - slopes[i]!)).toBeLessThan(1e-6 * scale);
          }
        }
      }
    }
  });
});

describe('a board that is braked and one that is driven on', () => {
  const lean = { alpha_fp: '2 deg', alpha_bp: '2 deg' };
  const method = { rtol: 1e-6 };
  const braked = { initial: { X_dot: 3, ...lean }, inputs: { f_X: -0.8 }, duration: 16, method };
  const driven = { initial: { X_dot: 0.5, ...lean }, inputs: { f_X: 1.5 }, duration: 12, method };
  const schedule = { from: 0.3, to: 4 };

  test.each([
    ['braked', 'fixed', 'touchdown', { ...board(null, 3), ...braked }],
    ['braked', 'scheduled', 'end', { ...board(schedule, 3), ...braked }],
    ['driven on', 'fixed', 'touchdown', { ...board(null, 3), ...driven }],
    ['driven on', 'scheduled', 'end', { ...board(schedule, 3), ...driven }],
  ])('%s, with a %s gain: %s', (_, _kind, reason, scenario) => {
    const run = runOf(scenario);
    expect(run.end.reason).toBe(reason);
    if (reason === 'end')
      for (const name of ['alpha_fp', 'alpha_bp', 'theta', 'theta_fc'])
        expect(Math.abs(run.columns.get(name)!.at(-1)!), name).toBeLessThan(1e-3);
  });

  test('an implicit method with its exact Jacobian gives the same run', () => {
    const [a, b] = ['dopri5', 'radau'].map((name) =>
      runOf({ ...board(schedule, 3), ...braked, duration: 2, method: { name, rtol: 1e-9, atol: 1e-11 } }),
    );
    for (const name of ['Y', 'theta', 'alpha_fp', 'theta_bc'])
      expect(Math.abs(a!.columns.get(name)!.at(-1)! - b!.columns.get(name)!.at(-1)!), name).toBeLessThan(1e-6);
  });
});

test.each([
  [{ ...board({ from: 2, to: 1 }) }, /control\.schedule\.to/],
  [{ ...board({ from: 0, to: 1 }) }, /control\.schedule\.from/],
  [{ ...board({ from: 1, to: 2, count: 1 }) }, /control\.schedule\.count/],
  [{ ...board({ from: 1, to: 2, over: 'X_dot' }) }, /control\.schedule\.over/],
  [
    { version: 1, system: 'cart-pendulum', control: { type: 'lqr', inputs: ['f_X'], schedule: { from: 1, to: 2 } } },
    /no forward speed/,
  ],
])('a wrong schedule is refused at its place: %j', (raw, message) => {
  expect(() => scenarioOf(raw)).toThrow(message);
});

test('a gain that would hold a place can not be scheduled', () => {
  const raw = {
    version: 1,
    system: 'bicycle',
    control: { type: 'lqr', inputs: ['tau_steer', 'tau_rear'], at: { speed: 5 }, schedule: { from: 4, to: 6 } },
  };
  expect(() => feedback(raw)).toThrow(/control\.schedule: the gain would hold (x|rear_spin|front_spin) to a place/);
});
