import { describe, expect, test, vi } from 'vitest';
import { methods } from '../../../src/core/integrators/methods.ts';
import { InputPlan } from '../../../src/core/simulation/inputPlan.ts';
import { runOf } from '../../helpers.ts';

const adaptive = methods.filter((m) => m.adaptive).map((m) => m.id);

const pendulum = {
  version: 1,
  system: 'wheel-pendulum',
  initial: { psi: '-94 deg' },
  control: { type: 'lqr', inputs: ['tau_phi'], limits: { tau_phi: 8 } },
  duration: 4,
};
const robot = {
  version: 1,
  system: 'casterboard-robot',
  control: {
    type: 'track',
    kp: 2,
    kd: 0.2,
    reference: { tau_f: 'pi/9*sin(6.4*t)', tau_r: 'pi/9*sin(6.4*t)' },
    limits: { tau_f: 0.05, tau_r: 0.05 },
  },
  duration: 2,
};

describe("a controller's limit", () => {
  for (const [what, file, input] of [
    ['a regulator', pendulum, 'tau_phi'],
    ['a follower of a reference', robot, 'tau_f'],
  ] as const) {
    const limit = file.control.limits[input as never] as number;
    const run = (method: object) => runOf({ ...file, method });
    const exact = run({ name: 'dop853', rtol: 1e-12, atol: 1e-14, maxStep: 1e-3 });

    test(`${what} reaches it and leaves it`, () => {
      const u = exact.columns.get(input)!;
      expect(exact.end.reason).toBe('end');
      expect(Math.max(...u.map(Math.abs))).toBe(limit);
      expect(u.filter((x) => Math.abs(x) < limit).length).toBeGreaterThan(20);
    });

    test.each(adaptive)(`${what}: %s agrees with short steps`, (name) => {
      const { end, columns, rows, counts } = run({ name, rtol: 1e-9, atol: 1e-11 });
      expect(end.reason).toBe('end');
      expect(rows).toBe(exact.rows);
      for (const [column, values] of columns) {
        const other = exact.columns.get(column)!;
        const size = Math.max(...other.map(Math.abs), 1e-3);
        if (column === 't' || column === 'residual' || column.startsWith('lambda') || column === 'energy') continue;
        let most = 0;
        values.forEach((x, i) => (most = Math.max(most, Math.abs(x - other[i]!))));
        expect(most / size, column).toBeLessThan(name === 'bdf' || name === 'ida' ? 2e-5 : 2e-6);
      }
      expect(counts.steps).toBeLessThan(name === 'bs23' ? 20000 : 6000);
    });
  }
});

describe('what planning costs', () => {
  const slow: [string, Record<string, unknown>][] = [
    [
      'a wheel driven slowly',
      {
        system: 'rolling-wheel',
        initial: { phi_dot: 1, theta_dot: 1 },
        inputs: { tau_phi: '0.5*sin(0.5*t)', tau_theta: '0.2*cos(t)' },
        duration: 10,
      },
    ],
    [
      'a wheel driven at 1 Hz',
      { system: 'rolling-wheel', initial: { phi_dot: 1 }, inputs: { tau_phi: '0.1*sin(2*pi*t)' }, duration: 5 },
    ],
    [
      'a cart',
      {
        system: 'cart-pendulum',
        initial: { theta: '-80 deg' },
        inputs: { f_X: '0.3*sin(t)+0.1*exp(-t/3)' },
        duration: 5,
      },
    ],
    ['a bicycle', { system: 'bicycle', initial: { speed: 5 }, inputs: { tau_steer: '0.2*sin(t)' }, duration: 5 }],
    ['nothing that acts', { system: 'rolling-wheel', initial: { phi_dot: 1, theta_dot: 1 }, duration: 5 }],
    [
      'a constant',
      { system: 'rolling-wheel', initial: { phi_dot: 1, theta_dot: 1 }, inputs: { tau_phi: '0.1' }, duration: 5 },
    ],
  ];
  test.each(slow)('%s takes no more than a tenth more evaluations', (what, file) => {
    for (const name of adaptive) {
      const count = (): number => runOf({ version: 1, ...file, method: { name } }).counts.evaluations;
      const planned = count();
      const spy = vi.spyOn(InputPlan.prototype, 'bound').mockReturnValue(Infinity);
      const free = count();
      spy.mockRestore();
      expect(planned, name).toBeLessThanOrEqual((file['inputs'] && what !== 'a constant' ? 1.1 : 1) * free);
    }
  });
});

describe('energy', () => {
  test('of a system at rest does not drift: it changes by so many joules', () => {
    for (const name of adaptive) {
      const { counts } = runOf({ version: 1, system: 'ripstik', duration: 0.2, method: { name } });
      expect(counts.energyDrift, name).toBe(null);
      expect(Math.abs(counts.energyChange)).toBeLessThan(1e-12);
      expect(counts.work).toBe(null);
    }
  });

  test('that moves drifts beside its largest kinetic energy', () => {
    const { counts } = runOf({ version: 1, system: 'cart-pendulum', initial: { theta: 0 }, duration: 3 });
    expect(Math.abs(counts.energyDrift!)).toBeLessThan(1e-6);
    expect(counts.energyDrift).not.toBe(0);
  });

  test.each(adaptive)('is what inputs put in, by %s', (name) => {
    const { counts } = runOf({
      version: 1,
      system: 'cart-pendulum',
      initial: { theta: '-90 deg' },
      inputs: { f_X: '5*exp(-((t-1)/0.05)^2) + 3*(t > 2.5)' },
      method: { name, rtol: 1e-10 },
      duration: 3,
    });
    expect(counts.work).toBeGreaterThan(0.1);
    expect(Math.abs(counts.energyChange - counts.work!)).toBeLessThan(1e-5 * counts.work!);
  });
});
