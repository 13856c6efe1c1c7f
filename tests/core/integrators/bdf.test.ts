import { describe, expect, test } from 'vitest';
import { Bdf } from '../../../src/core/integrators/multistep/bdf.ts';
import type { BdfTuning } from '../../../src/core/integrators/multistep/bdfStepper.ts';
import type { OdeProblem, StepperOptions } from '../../../src/core/integrators/contract.ts';
import {
  ROBERTSON_40,
  VAN_DER_POL_2,
  distance,
  kepler,
  keplerAt,
  problem,
  robertson,
  run,
  vanDerPol,
} from './problems.ts';

function bdf(p: OdeProblem, options: Partial<StepperOptions> = {}, tuning: BdfTuning = {}): Bdf {
  return new Bdf(p, { rtol: 1e-8, atol: 1e-10, ...options }, tuning);
}

describe('order of convergence', () => {
  test.each([
    { order: 1, steps: 20000 },
    { order: 2, steps: 1600 },
    { order: 3, steps: 800 },
    { order: 4, steps: 600 },
    { order: 5, steps: 400 },
  ])('order $order in equal steps, at their ends and between', ({ order, steps }) => {
    const errors = [steps, 2 * steps].map((count) => {
      const stepper = bdf(
        kepler,
        { rtol: Infinity, step: 2 / count, maxStep: 2 / count },
        { maxOrder: order, past: (t, y) => y.set(keplerAt(t)) },
      );
      stepper.reset(0, keplerAt(0));
      const state = new Float64Array(4);
      let between = 0;
      expect(
        run(stepper, 2, () => {
          const t = stepper.previousT + 0.4 * (stepper.t - stepper.previousT);
          stepper.interpolate(t, state);
          between = Math.max(between, distance(state, keplerAt(t)));
        }),
      ).toBeNull();
      expect(stepper.counters.steps).toBe(count);
      return { end: distance(stepper.y, keplerAt(2)), between };
    });
    const [coarse, fine] = errors as [(typeof errors)[0], (typeof errors)[0]];
    expect(Math.abs(Math.log2(coarse.end / fine.end) - order), `end ${coarse.end} ${fine.end}`).toBeLessThan(0.2);
    expect(
      Math.abs(Math.log2(coarse.between / fine.between) - order),
      `between ${coarse.between} ${fine.between}`,
    ).toBeLessThan(0.2);
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
      const stepper = bdf(
        rotation,
        { rtol: Infinity, step: h, maxStep: h },
        { maxOrder: 4, past: (t, y) => y.set(exact(t)) },
      );
      stepper.reset(0, exact(0));
      expect(
        run(stepper, 2, () => {
          circle(stepper.y);
          stepper.stateChanged();
        }),
      ).toBeNull();
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
      expect(
        run(stepper, 20, () => {
          if (!projected) return;
          const r = Math.hypot(stepper.y[0]!, stepper.y[1]!);
          for (let i = 0; i < 2; i++) stepper.y[i]! /= r;
          stepper.stateChanged();
        }),
      ).toBeNull();
      expect(distance(stepper.y, Float64Array.of(Math.cos(20), Math.sin(20)))).toBeLessThan(1e-5);
      return stepper.counters.steps;
    });
    expect(counts[1]!).toBeLessThan(1.2 * counts[0]!);
  });
});

describe('stiff problems', () => {
  test('from off the slow solution: fast decay, then long steps', () => {
    const stepper = bdf(
      problem(1, (t, y, out) => void (out[0] = -1000 * (y[0]! - Math.cos(t)) - Math.sin(t))),
      { rtol: 1e-6, atol: 1e-8 },
    );
    stepper.reset(0, Float64Array.of(2));
    expect(run(stepper, 10)).toBeNull();
    expect(Math.abs(stepper.y[0]! - Math.cos(10))).toBeLessThan(1e-5);
    expect(stepper.counters.steps).toBeLessThan(400);
    expect(stepper.counters.jacobians).toBeLessThan(20);
  });

  test.each([true, false])('Robertson, exact Jacobian: %s', (exact) => {
    const stepper = bdf(robertson(exact), { rtol: 1e-9, atol: 1e-14 });
    stepper.reset(0, Float64Array.of(1, 0, 0));
    expect(run(stepper, 40)).toBeNull();
    ROBERTSON_40.forEach((value, i) => expect(Math.abs(stepper.y[i]! / value - 1)).toBeLessThan(1e-6));
    expect(stepper.counters.jacobians).toBeLessThan(0.2 * stepper.counters.steps);
    expect(stepper.counters.factorizations).toBeLessThan(stepper.counters.steps);
  });

  test('a stiff oscillator (van der Pol, 1e-6) through its jumps', () => {
    const stepper = bdf(vanDerPol, { rtol: 1e-8, atol: 1e-8 });
    stepper.reset(0, Float64Array.of(2, -0.66));
    expect(run(stepper, 2)).toBeNull();
    expect(Math.abs(stepper.y[0]! - VAN_DER_POL_2)).toBeLessThan(1e-6);
  });
});
