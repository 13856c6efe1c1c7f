import { describe, expect, test } from 'vitest';
import { Bdf } from '../../src/core/integrators/bdf.ts';
import type { BdfTuning } from '../../src/core/integrators/bdfStepper.ts';
import type { OdeProblem, StepFailure, Stepper, StepperOptions } from '../../src/core/integrators/contract.ts';

type Derivative = (t: number, y: Float64Array, out: Float64Array) => boolean | void;

function problem(dimension: number, f: Derivative, more: Partial<OdeProblem> = {}): OdeProblem {
  return { dimension, failure: null, derivative: (t, y, out) => f(t, y, out) !== false, ...more };
}

/** Kepler's problem with eccentricity 0.3, from the pericentre: nonlinear, smooth, known. */
const ECCENTRICITY = 0.3;
const kepler = problem(4, (_t, y, out) => {
  const r3 = Math.hypot(y[0]!, y[1]!) ** 3;
  out.set([y[2]!, y[3]!, -y[0]! / r3, -y[1]! / r3]);
});

function keplerAt(t: number): Float64Array {
  let E = t;
  for (let i = 0; i < 60; i++) E -= (E - ECCENTRICITY * Math.sin(E) - t) / (1 - ECCENTRICITY * Math.cos(E));
  const d = 1 - ECCENTRICITY * Math.cos(E);
  const q = Math.sqrt(1 - ECCENTRICITY ** 2);
  return Float64Array.of(Math.cos(E) - ECCENTRICITY, q * Math.sin(E), -Math.sin(E) / d, (q * Math.cos(E)) / d);
}

function distance(a: Float64Array, b: Float64Array): number {
  return Math.max(...a.map((x, i) => Math.abs(x - b[i]!)));
}

function bdf(p: OdeProblem, options: Partial<StepperOptions> = {}, tuning: BdfTuning = {}): Bdf {
  return new Bdf(p, { rtol: 1e-8, atol: 1e-10, ...options }, tuning);
}

function run(stepper: Stepper, limit: number, afterStep: () => void = () => {}): StepFailure | null {
  for (let i = 0; i < 1e6 && stepper.t < limit; i++) {
    const failure = stepper.step(limit);
    if (failure) return failure;
    afterStep();
  }
  return null;
}

describe('order of convergence', () => {
  test.each([
    { order: 1, steps: 20000 }, { order: 2, steps: 1600 }, { order: 3, steps: 800 },
    { order: 4, steps: 600 }, { order: 5, steps: 400 },
  ])('order $order in equal steps, at their ends and between', ({ order, steps }) => {
    const errors = [steps, 2 * steps].map((count) => {
      const stepper = bdf(kepler, { rtol: Infinity, step: 2 / count, maxStep: 2 / count }, { maxOrder: order, past: (t, y) => y.set(keplerAt(t)) });
      stepper.reset(0, keplerAt(0));
      const state = new Float64Array(4);
      let between = 0;
      expect(run(stepper, 2, () => {
        const t = stepper.previousT + 0.4 * (stepper.t - stepper.previousT);
        stepper.interpolate(t, state);
        between = Math.max(between, distance(state, keplerAt(t)));
      })).toBeNull();
      expect(stepper.counters.steps).toBe(count);
      return { end: distance(stepper.y, keplerAt(2)), between };
    });
    const [coarse, fine] = errors as [(typeof errors)[0], (typeof errors)[0]];
    expect(Math.abs(Math.log2(coarse.end / fine.end) - order), `end ${coarse.end} ${fine.end}`).toBeLessThan(0.2);
    expect(Math.abs(Math.log2(coarse.between / fine.between) - order), `between ${coarse.between} ${fine.between}`).toBeLessThan(0.2);
  });

  test('values moved by their local error after each step keep the order', () => {
    const circle = (y: Float64Array): void => {
      const r = Math.hypot(y[0]!, y[1]!);
      for (let i = 0; i < 2; i++) y[i]! /= r;
    };
    const errors = [100, 200].map((count) => {
      const h = 2 / count;
      const exact = (t: number): Float64Array => Float64Array.of(Math.cos(t), Math.sin(t));
      const rotation = problem(2, (_t, y, out) => void out.set([-y[1]!, y[0]!]));
      const stepper = bdf(rotation, { rtol: Infinity, step: h, maxStep: h }, { maxOrder: 4, past: (t, y) => y.set(exact(t)) });
      stepper.reset(0, exact(0));
      expect(run(stepper, 2, () => {
        circle(stepper.y);
        stepper.stateChanged();
      })).toBeNull();
      return distance(stepper.y, exact(2));
    });
    expect(Math.abs(Math.log2(errors[0]! / errors[1]!) - 4), `${errors.join(' ')}`).toBeLessThan(0.2);
  });
});

describe('step control', () => {
  test.each([1e-4, 1e-7, 1e-10])('the error over an orbit follows the tolerance %d', (rtol) => {
    const stepper = bdf(kepler, { rtol, atol: rtol });
    stepper.reset(0, keplerAt(0));
    expect(run(stepper, 2 * Math.PI)).toBeNull();
    // Local errors add up over an orbit, and in phase; SciPy's BDF has the same.
    expect(distance(stepper.y, keplerAt(0)), JSON.stringify(stepper.counters)).toBeLessThan(1000 * rtol);
  });

  test('order 5 takes far fewer steps than order 2', () => {
    const steps = [2, 5].map((maxOrder) => {
      const stepper = bdf(kepler, { rtol: 1e-7 }, { maxOrder });
      stepper.reset(0, keplerAt(0));
      expect(run(stepper, 6)).toBeNull();
      return stepper.counters.steps;
    });
    expect(steps[1]!).toBeLessThan(0.2 * steps[0]!);
  });

  test('projection onto the invariants after every step costs no restart', () => {
    const rotation = problem(2, (_t, y, out) => void out.set([-y[1]!, y[0]!]));
    const counts = [false, true].map((projected) => {
      const stepper = bdf(rotation);
      stepper.reset(0, Float64Array.of(1, 0));
      expect(run(stepper, 20, () => {
        if (!projected) return;
        const r = Math.hypot(stepper.y[0]!, stepper.y[1]!);
        for (let i = 0; i < 2; i++) stepper.y[i]! /= r;
        stepper.stateChanged();
      })).toBeNull();
      expect(distance(stepper.y, Float64Array.of(Math.cos(20), Math.sin(20)))).toBeLessThan(1e-5);
      return stepper.counters.steps;
    });
    expect(counts[1]!).toBeLessThan(1.2 * counts[0]!);
  });
});

describe('stiff problems', () => {
  test('from off the slow solution: fast decay, then long steps', () => {
    const stepper = bdf(problem(1, (t, y, out) => void (out[0] = -1000 * (y[0]! - Math.cos(t)) - Math.sin(t))), { rtol: 1e-6, atol: 1e-8 });
    stepper.reset(0, Float64Array.of(2));
    expect(run(stepper, 10)).toBeNull();
    expect(Math.abs(stepper.y[0]! - Math.cos(10))).toBeLessThan(1e-5);
    expect(stepper.counters.steps).toBeLessThan(400);
    expect(stepper.counters.jacobians).toBeLessThan(20);
  });

  const robertson = (exact: boolean): OdeProblem =>
    problem(3, (_t, y, out) => {
      const [a, b, c] = y as unknown as [number, number, number];
      out[0] = -0.04 * a + 1e4 * b * c;
      out[2] = 3e7 * b * b;
      out[1] = -out[0]! - out[2]!;
    }, exact ? {
      jacobian: (_t, y, out) => {
        const [, b, c] = y as unknown as [number, number, number];
        out.set([-0.04, 1e4 * c, 1e4 * b, 0.04, -1e4 * c - 6e7 * b, -1e4 * b, 0, 6e7 * b, 0]);
        return true;
      },
    } : {});

  /** At t = 40; SciPy 1.17.1's Radau at rtol 1e-11 gives the same digits. */
  const ROBERTSON_40 = [0.7158270688, 9.185534765e-6, 0.2841637457];

  test.each([true, false])('Robertson, exact Jacobian: %s', (exact) => {
    const stepper = bdf(robertson(exact), { rtol: 1e-9, atol: 1e-14 });
    stepper.reset(0, Float64Array.of(1, 0, 0));
    expect(run(stepper, 40)).toBeNull();
    ROBERTSON_40.forEach((value, i) => expect(Math.abs(stepper.y[i]! / value - 1)).toBeLessThan(1e-6));
    expect(stepper.counters.jacobians).toBeLessThan(0.2 * stepper.counters.steps);
    expect(stepper.counters.factorizations).toBeLessThan(stepper.counters.steps);
  });

  test('a stiff oscillator (van der Pol, 1e-6) through its jumps', () => {
    const stepper = bdf(problem(2, (_t, y, out) => {
      out[0] = y[1]!;
      out[1] = ((1 - y[0]! * y[0]!) * y[1]! - y[0]!) / 1e-6;
    }), { rtol: 1e-8, atol: 1e-8 });
    stepper.reset(0, Float64Array.of(2, -0.66));
    expect(run(stepper, 2)).toBeNull();
    // SciPy 1.17.1's Radau at rtol 1e-10.
    expect(Math.abs(stepper.y[0]! - 1.70616743754)).toBeLessThan(1e-6);
  });
});

describe('contract', () => {
  test('the limit is hit to the last bit and never passed', () => {
    const stepper = bdf(kepler);
    stepper.reset(0, keplerAt(0));
    for (const limit of [0.1, 0.1 + 1e-9, 0.3, 0.7000000001, Math.PI / 3]) {
      expect(run(stepper, limit, () => expect(stepper.t).toBeLessThanOrEqual(limit))).toBeNull();
      expect(stepper.t).toBe(limit);
      expect(distance(stepper.y, keplerAt(limit))).toBeLessThan(1e-6);
    }
  });

  test('after a reset the same input gives the same bits', () => {
    const stepper = bdf(kepler);
    const [a, b] = [0, 1].map(() => {
      stepper.reset(0, keplerAt(0));
      expect(run(stepper, 1)).toBeNull();
      const between = new Float64Array(4);
      stepper.interpolate((stepper.previousT + stepper.t) / 2, between);
      const found = { y: [...stepper.y], between: [...between], counters: { ...stepper.counters } };
      stepper.reset(0.2, Float64Array.of(1, 2, -1, 0.5));
      expect(run(stepper, 1.3)).toBeNull();
      return found;
    });
    expect(b).toEqual(a);
  });

  test('every call of f is counted', () => {
    let calls = 0;
    const stepper = bdf({ ...kepler, derivative: (t, y, out) => (calls++, kepler.derivative(t, y, out)) });
    stepper.reset(0, keplerAt(0));
    expect(run(stepper, 1)).toBeNull();
    expect(stepper.counters.evaluations).toBe(calls);
    expect(Math.min(...Object.entries(stepper.counters).map(([name, count]) => (name === 'rejected' ? 1 : count)))).toBeGreaterThan(0);
  });

  test('what lies in the last step stays when y is moved, and a long way begins anew from there', () => {
    const stepper = bdf(kepler);
    stepper.reset(0, keplerAt(0));
    expect(run(stepper, 0.3)).toBeNull();
    const [before, after] = [new Float64Array(4), new Float64Array(4)];
    const t = 0.3 * stepper.previousT + 0.7 * stepper.t;
    stepper.interpolate(t, before);
    expect(distance(before, keplerAt(t))).toBeLessThan(1e-6);
    stepper.y.set(keplerAt(2));
    stepper.stateChanged();
    stepper.interpolate(t, after);
    expect([...after]).toEqual([...before]);
    expect(run(stepper, 0.8)).toBeNull();
    expect(distance(stepper.y, keplerAt(2.5))).toBeLessThan(1e-5);
  });

  test.each([
    { what: 'has no value', value: false, failure: 'constraint-singular' },
    { what: 'is not a number', value: true, failure: null },
  ])('where f $what the step fails by name and moves nothing', ({ value, failure }) => {
    const stepper = bdf({
      dimension: 4,
      failure,
      derivative: (t, y, out) => {
        if (t <= 0.5) return kepler.derivative(t, y, out);
        out.fill(NaN);
        return value;
      },
    });
    stepper.reset(0, keplerAt(0));
    let last = { t: 0, previousT: 0, y: [...stepper.y] };
    expect(run(stepper, 1, () => (last = { t: stepper.t, previousT: stepper.previousT, y: [...stepper.y] }))).toBe(failure ?? 'non-finite');
    expect({ t: stepper.t, previousT: stepper.previousT, y: [...stepper.y] }).toEqual(last);
    expect(Math.abs(stepper.t - 0.5)).toBeLessThan(0.01);
  });
});
