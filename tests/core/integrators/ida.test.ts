import { describe, expect, test } from 'vitest';
import type { StepperOptions } from '../../../src/core/integrators/contract.ts';
import type { DaeProblem } from '../../../src/core/integrators/shared/dae.ts';
import { Ida } from '../../../src/core/integrators/multistep/ida.ts';
import { ROBERTSON_40, distance, run } from './problems.ts';

/** Pendulum of length and mass 1 in Cartesian coordinates, gravity 1, index 2 stabilized: y = [x, z, x', z', lambda, mu]. */
const pendulum: DaeProblem = {
  dimension: 6,
  differential: Uint8Array.of(1, 1, 1, 1, 0, 0),
  failure: null,
  start(_t, y, yp) {
    const [x, z, u, w] = y as unknown as [number, number, number, number];
    const lambda = z - u * u - w * w;
    y[4] = lambda;
    y[5] = 0;
    yp.set([u, w, lambda * x, lambda * z - 1, 0, 0]);
    return true;
  },
  residual(_t, y, yp, out) {
    const [x, z, u, w, lambda, mu] = y as unknown as [number, number, number, number, number, number];
    out.set([
      yp[0]! - u - mu * x,
      yp[1]! - w - mu * z,
      yp[2]! - lambda * x,
      yp[3]! - lambda * z + 1,
      x * u + z * w,
      (x * x + z * z - 1) / 2,
    ]);
    return true;
  },
  jacobian(_t, y, _yp, cj, out) {
    const [x, z, u, w, lambda, mu] = y as unknown as [number, number, number, number, number, number];
    out.set([
      cj - mu,
      0,
      -1,
      0,
      0,
      -x,
      0,
      cj - mu,
      0,
      -1,
      0,
      -z,
      -lambda,
      0,
      cj,
      0,
      -x,
      0,
      0,
      -lambda,
      0,
      cj,
      -z,
      0,
      u,
      w,
      x,
      z,
      0,
      0,
      x,
      z,
      0,
      0,
      0,
      0,
    ]);
    return true;
  },
};
const released = Float64Array.of(1, 0, 0, 0, 0, 0);

/** The same by its angle from the lowest point, with classical steps so small that only rounding is left. */
function pendulumAt(t: number): [number, number, number, number] {
  let [angle, rate] = [Math.PI / 2, 0];
  const steps = Math.max(1, Math.ceil(Math.abs(t) * 2000));
  const h = t / steps;
  for (let i = 0; i < steps; i++) {
    const [k1, l1] = [rate, -Math.sin(angle)];
    const [k2, l2] = [rate + (h / 2) * l1, -Math.sin(angle + (h / 2) * k1)];
    const [k3, l3] = [rate + (h / 2) * l2, -Math.sin(angle + (h / 2) * k2)];
    const [k4, l4] = [rate + h * l3, -Math.sin(angle + h * k3)];
    angle += (h / 6) * (k1 + 2 * k2 + 2 * k3 + k4);
    rate += (h / 6) * (l1 + 2 * l2 + 2 * l3 + l4);
  }
  return [Math.sin(angle), -Math.cos(angle), rate * Math.cos(angle), rate * Math.sin(angle)];
}

function ida(problem: DaeProblem, options: Partial<StepperOptions> = {}, tuning = {}): Ida {
  return new Ida(problem, { rtol: 1e-8, atol: 1e-10, ...options }, tuning);
}

describe('pendulum in Cartesian coordinates', () => {
  test.each([1, 2, 3, 4, 5])('order %i of the state in equal steps, multiplier included', (order) => {
    const counts = order === 1 ? [4000, 8000] : order === 2 ? [1600, 3200] : [200, 400];
    const past = (t: number, y: Float64Array): void => {
      const [x, z, u, w] = pendulumAt(t);
      y.set([x, z, u, w, z - u * u - w * w, 0]);
    };
    const exact = new Float64Array(6);
    past(2, exact);
    const errors = counts.map((count) => {
      const stepper = ida(pendulum, { rtol: Infinity, step: 2 / count, maxStep: 2 / count }, { maxOrder: order, past });
      stepper.reset(0, released);
      expect(run(stepper, 2)).toBeNull();
      expect(stepper.counters.steps).toBe(count);
      return {
        state: distance(stepper.y.subarray(0, 4), exact.subarray(0, 4)),
        lambda: Math.abs(stepper.y[4]! - exact[4]!),
      };
    });
    const [coarse, fine] = errors as [(typeof errors)[0], (typeof errors)[0]];
    expect(Math.abs(Math.log2(coarse.state / fine.state) - order), JSON.stringify(errors)).toBeLessThan(0.2);
    expect(Math.abs(Math.log2(coarse.lambda / fine.lambda) - order), JSON.stringify(errors)).toBeLessThan(0.2);
  });

  test('ten seconds: constraints as well as Newton solves them, energy and state to the tolerance', () => {
    const stepper = ida(pendulum, { rtol: 1e-9, atol: 1e-11 });
    stepper.reset(0, released);
    let [length, normal, energy] = [0, 0, 0];
    expect(
      run(stepper, 10, () => {
        const [x, z, u, w] = stepper.y as unknown as [number, number, number, number];
        length = Math.max(length, Math.abs(x * x + z * z - 1));
        normal = Math.max(normal, Math.abs(x * u + z * w));
        energy = Math.max(energy, Math.abs((u * u + w * w) / 2 + z));
      }),
    ).toBeNull();
    expect(length).toBeLessThan(1e-9);
    expect(normal).toBeLessThan(1e-9);
    expect(energy).toBeLessThan(1e-6);
    expect(distance(stepper.y.subarray(0, 4), pendulumAt(10))).toBeLessThan(1e-6);
    expect(stepper.counters.steps).toBeLessThan(5000);
  });
});

test('index 1: Robertson with the conservation of mass as an equation', () => {
  const stepper = ida(
    {
      dimension: 3,
      differential: Uint8Array.of(1, 1, 0),
      failure: null,
      start(_t, y, yp) {
        y[2] = 1 - y[0]! - y[1]!;
        yp[0] = -0.04 * y[0]! + 1e4 * y[1]! * y[2]!;
        yp[1] = -yp[0]! - 3e7 * y[1]! * y[1]!;
        yp[2] = 0;
        return true;
      },
      residual(_t, y, yp, out) {
        const made = -0.04 * y[0]! + 1e4 * y[1]! * y[2]!;
        out.set([yp[0]! - made, yp[1]! + made + 3e7 * y[1]! * y[1]!, y[0]! + y[1]! + y[2]! - 1]);
        return true;
      },
      jacobian(_t, y, _yp, cj, out) {
        const [, b, c] = y as unknown as [number, number, number];
        out.set([cj + 0.04, -1e4 * c, -1e4 * b, -0.04, cj + 1e4 * c + 6e7 * b, 1e4 * b, 1, 1, 1]);
        return true;
      },
    },
    { rtol: 1e-9, atol: 1e-14 },
    { testAll: true },
  );
  stepper.reset(0, Float64Array.of(1, 0, 0));
  expect(run(stepper, 40)).toBeNull();
  ROBERTSON_40.forEach((value, i) => expect(Math.abs(stepper.y[i]! / value - 1)).toBeLessThan(1e-6));
});

describe('contract', () => {
  test('the limit is hit to the last bit and never passed', () => {
    const stepper = ida(pendulum);
    stepper.reset(0, released);
    for (const limit of [0.1, 0.1 + 1e-9, 0.3, 0.7000000001, Math.PI / 3]) {
      expect(run(stepper, limit, () => expect(stepper.t).toBeLessThanOrEqual(limit))).toBeNull();
      expect(stepper.t).toBe(limit);
      expect(distance(stepper.y.subarray(0, 4), pendulumAt(limit))).toBeLessThan(1e-6);
    }
  });

  test('after a reset the same input gives the same bits, and the counters move', () => {
    const stepper = ida(pendulum);
    const [a, b] = [0, 1].map(() => {
      stepper.reset(0, released);
      expect(run(stepper, 1)).toBeNull();
      const between = new Float64Array(6);
      stepper.interpolate((stepper.previousT + stepper.t) / 2, between);
      const found = { y: [...stepper.y], between: [...between], counters: { ...stepper.counters } };
      stepper.reset(0.2, Float64Array.of(0.6, -0.8, 0.8, 0.6, 0, 0));
      expect(run(stepper, 1.3)).toBeNull();
      return found;
    });
    expect(b).toEqual(a);
    const { steps, evaluations, jacobians, factorizations } = a!.counters;
    expect(Math.min(steps, jacobians, factorizations)).toBeGreaterThan(0);
    expect(evaluations).toBeGreaterThanOrEqual(steps);
    expect(jacobians).toBeLessThan(steps);
  });

  test('between the steps it is as exact as at their ends, whatever happens to y', () => {
    const stepper = ida(pendulum);
    stepper.reset(0, released);
    const state = new Float64Array(6);
    expect(
      run(stepper, 2, () => {
        const t = stepper.previousT + 0.3 * (stepper.t - stepper.previousT);
        stepper.interpolate(t, state);
        expect(Math.abs(Math.hypot(state[0]!, state[1]!) - 1)).toBeLessThan(1e-6);
      }),
    ).toBeNull();
    const t = 0.5 * (stepper.previousT + stepper.t);
    stepper.interpolate(t, state);
    const before = [...state];
    expect(distance(state.subarray(0, 4), pendulumAt(t))).toBeLessThan(1e-6);
    stepper.y.fill(7);
    stepper.stateChanged();
    stepper.interpolate(t, state);
    expect([...state]).toEqual(before);
  });

  test.each([
    { what: 'has no value', value: false, failure: 'constraint-singular', name: 'constraint-singular' },
    { what: 'is not a number', value: true, failure: null, name: 'non-finite' },
  ])('where F $what the step fails by name and moves nothing', ({ value, failure, name }) => {
    const stepper = ida({
      ...pendulum,
      failure,
      residual: (t, y, yp, out) => {
        if (t <= 0.5) return pendulum.residual(t, y, yp, out);
        out.fill(NaN);
        return value;
      },
    });
    stepper.reset(0, released);
    let last = { t: 0, y: [...stepper.y] };
    expect(run(stepper, 1, () => (last = { t: stepper.t, y: [...stepper.y] }))).toBe(name);
    expect({ t: stepper.t, y: [...stepper.y] }).toEqual(last);
    expect(Math.abs(stepper.t - 0.5)).toBeLessThan(0.01);
  });

  test('equations without a solution are a failure called newton', () => {
    // x' = 1 and x + z^2 = 0: z is real only for x <= 0.
    const stepper = ida({
      dimension: 2,
      differential: Uint8Array.of(1, 0),
      failure: null,
      start: (_t, y, yp) => (yp.set([1, 0]), (y[1] = Math.sqrt(-y[0]!)) >= 0),
      residual: (_t, y, yp, out) => (out.set([yp[0]! - 1, y[0]! + y[1]! * y[1]!]), true),
      jacobian: (_t, y, _yp, cj, out) => (out.set([cj, 0, 1, 2 * y[1]!]), true),
    });
    stepper.reset(0, Float64Array.of(-0.3, 0));
    expect(run(stepper, 1)).toBe('newton');
    expect(stepper.t).toBeLessThan(0.31);
  });
});
