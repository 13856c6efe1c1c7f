import { describe, expect, test } from 'vitest';
import { cases } from '../../src/core/cases/cases.ts';
import { ConstrainedSystem } from '../../src/core/dynamics/constrainedSystem.ts';
import { consistentStart } from '../../src/core/dynamics/consistentStart.ts';
import { actuationOf } from '../../src/core/dynamics/forcing.ts';
import { Projection } from '../../src/core/dynamics/projection.ts';
import { StabilizedDae } from '../../src/core/dynamics/stabilizedDae.ts';
import type { StepFailure, Stepper, StepperOptions } from '../../src/core/integrators/contract.ts';
import type { DaeProblem } from '../../src/core/integrators/dae.ts';
import { Ida } from '../../src/core/integrators/ida.ts';
import { systems } from '../../src/core/systems/registry.ts';
import { runOf, scenarioOf, seeded } from '../helpers.ts';

function distance(a: ArrayLike<number>, b: ArrayLike<number>): number {
  return Math.max(...Array.from(a, (x, i) => Math.abs(x - b[i]!)));
}

function run(stepper: Stepper, limit: number, afterStep: () => void = () => {}): StepFailure | null {
  for (let i = 0; i < 1e6 && stepper.t < limit; i++) {
    const failure = stepper.step(limit);
    if (failure) return failure;
    afterStep();
  }
  return null;
}

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
      yp[0]! - u - mu * x, yp[1]! - w - mu * z, yp[2]! - lambda * x, yp[3]! - lambda * z + 1,
      x * u + z * w, (x * x + z * z - 1) / 2,
    ]);
    return true;
  },
  jacobian(_t, y, _yp, cj, out) {
    const [x, z, u, w, lambda, mu] = y as unknown as [number, number, number, number, number, number];
    out.set([
      cj - mu, 0, -1, 0, 0, -x,
      0, cj - mu, 0, -1, 0, -z,
      -lambda, 0, cj, 0, -x, 0,
      0, -lambda, 0, cj, -z, 0,
      u, w, x, z, 0, 0,
      x, z, 0, 0, 0, 0,
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
      return { state: distance(stepper.y.subarray(0, 4), exact.subarray(0, 4)), lambda: Math.abs(stepper.y[4]! - exact[4]!) };
    });
    const [coarse, fine] = errors as [(typeof errors)[0], (typeof errors)[0]];
    expect(Math.abs(Math.log2(coarse.state / fine.state) - order), JSON.stringify(errors)).toBeLessThan(0.2);
    expect(Math.abs(Math.log2(coarse.lambda / fine.lambda) - order), JSON.stringify(errors)).toBeLessThan(0.2);
  });

  test('ten seconds: constraints as well as Newton solves them, energy and state to the tolerance', () => {
    const stepper = ida(pendulum, { rtol: 1e-9, atol: 1e-11 });
    stepper.reset(0, released);
    let [length, normal, energy] = [0, 0, 0];
    expect(run(stepper, 10, () => {
      const [x, z, u, w] = stepper.y as unknown as [number, number, number, number];
      length = Math.max(length, Math.abs(x * x + z * z - 1));
      normal = Math.max(normal, Math.abs(x * u + z * w));
      energy = Math.max(energy, Math.abs((u * u + w * w) / 2 + z));
    })).toBeNull();
    expect(length).toBeLessThan(1e-9);
    expect(normal).toBeLessThan(1e-9);
    expect(energy).toBeLessThan(1e-6);
    expect(distance(stepper.y.subarray(0, 4), pendulumAt(10))).toBeLessThan(1e-6);
    expect(stepper.counters.steps).toBeLessThan(5000);
  });
});

test('index 1: Robertson with the conservation of mass as an equation', () => {
  const stepper = ida({
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
  }, { rtol: 1e-9, atol: 1e-14 }, { testAll: true });
  stepper.reset(0, Float64Array.of(1, 0, 0));
  expect(run(stepper, 40)).toBeNull();
  [0.7158270688, 9.185534765e-6, 0.2841637457].forEach((value, i) => expect(Math.abs(stepper.y[i]! / value - 1)).toBeLessThan(1e-6));
});

/** A scenario's mechanics as a DAE, with its start. */
function mechanicsOf(raw: unknown) {
  const scenario = scenarioOf(raw);
  const system = systems[scenario.system]!;
  const { meta } = system;
  const parameters = Float64Array.from(meta.parameters, (p) => scenario.parameters[p.name]!);
  const hold = scenario.hold.map((name) => meta.coordinates.findIndex((c) => c.name === name));
  const { q, v } = consistentStart(system, parameters, scenario.constraints, hold, scenario.initial);
  const dynamics = new ConstrainedSystem(system, parameters, scenario.constraints, hold, actuationOf(scenario, meta).forcing);
  const dae = new StabilizedDae(dynamics);
  const y = new Float64Array(dae.dimension);
  dae.fromState(q, v, y);
  return { scenario, dynamics, dae, q, v, y, n: dynamics.n };
}

const leaning = { version: 1, system: 'ripstik', initial: { X_dot: 1, alpha: '0.5 deg' }, duration: 0.5 };
const hanging = { ...(cases.find((c) => c.id === 'hanging')!.scenario as object), duration: 2 };
const driven = {
  ...leaning, initial: { X_dot: 1 },
  control: { type: 'track', reference: { tau_fp: '10 deg * sin(2*pi*1.5*t)', tau_bp: '-10 deg * sin(2*pi*1.5*t)' }, kp: 60, kd: 3 },
};

describe('mechanics as a stabilized DAE', () => {
  test.each([
    { name: 'leaning', raw: leaning }, { name: 'hanging', raw: hanging }, { name: 'driven', raw: driven },
  ])('$name: the start is consistent, and the Jacobian is that of the residual', ({ raw }) => {
    const { dae, y } = mechanicsOf(raw);
    const size = dae.dimension;
    const yp = new Float64Array(size);
    const residual = new Float64Array(size);
    expect(dae.start(0, y, yp)).toBe(true);
    dae.residual(0, y, yp, residual);
    expect(Math.max(...residual.map(Math.abs))).toBeLessThan(1e-11);

    const { held } = mechanicsOf(raw).dynamics;
    const random = seeded(7);
    const fixed = (i: number): boolean => held.some((h) => i === h || i === 10 + h);
    for (let i = 0; i < size; i++) {
      if (fixed(i)) continue;
      y[i]! += 0.1 * (random() - 0.5);
      if (dae.differential[i]) yp[i]! += random() - 0.5;
    }
    const cj = 3;
    const exact = new Float64Array(size * size);
    expect(dae.jacobian(0.1, y, yp, cj, exact)).toBe(true);
    const [up, down] = [new Float64Array(size), new Float64Array(size)];
    for (let j = 0; j < size; j++) {
      if (fixed(j)) continue;
      const moved = (sign: number, out: Float64Array): void => {
        const [z, zp] = [y.slice(), yp.slice()];
        z[j]! += sign * 1e-5;
        if (dae.differential[j]) zp[j]! += sign * cj * 1e-5;
        dae.residual(0.1, z, zp, out);
      };
      moved(1, up);
      moved(-1, down);
      for (let i = 0; i < size; i++) {
        const difference = (up[i]! - down[i]!) / 2e-5;
        expect(Math.abs(exact[i * size + j]! - difference), `row ${i}, column ${j}`).toBeLessThan(1e-6 * Math.max(1, Math.abs(difference)));
      }
    }
  });

  test.each([
    { name: 'leaning', raw: leaning }, { name: 'hanging', raw: hanging }, { name: 'driven', raw: driven },
  ])('$name: agrees with dopri5 at rtol 1e-11 within 1e-6, with and without projection', ({ raw }) => {
    const { columns, end } = runOf({ ...raw, method: { name: 'dopri5', rtol: 1e-11, atol: 1e-13 } });
    expect(end.reason).toBe('end');
    for (const projected of [false, true]) {
      const { scenario, dynamics, dae, y, q, v, n } = mechanicsOf(raw);
      const projection = new Projection(dynamics);
      const stepper = ida(dae, { rtol: 1e-9, atol: 1e-11 });
      stepper.reset(0, y);
      let residual = 0;
      expect(run(stepper, scenario.duration, () => {
        dae.toState(stepper.y, q, v);
        residual = Math.max(residual, projection.residual(q, v));
        if (!projected) return;
        projection.project(stepper.t, q, v);
        dae.fromState(q, v, stepper.y);
        stepper.stateChanged();
      })).toBeNull();
      const last = [...columns.values()].slice(1, 1 + 2 * n).map((c) => c.at(-1)!);
      const off = distance(stepper.y.subarray(0, 2 * n), last);
      expect(off).toBeLessThan(1e-6);
      expect(residual).toBeLessThan(1e-10);
      for (const i of dynamics.held) expect([stepper.y[i], stepper.y[n + i]]).toEqual([mechanicsOf(raw).q[i], 0]);
    }
  });
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
    expect(run(stepper, 2, () => {
      const t = stepper.previousT + 0.3 * (stepper.t - stepper.previousT);
      stepper.interpolate(t, state);
      expect(Math.abs(Math.hypot(state[0]!, state[1]!) - 1)).toBeLessThan(1e-6);
    })).toBeNull();
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
