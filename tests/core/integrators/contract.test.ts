import { describe, expect, test } from 'vitest';
import type { OdeProblem, Stepper, StepperOptions } from '../../../src/core/integrators/contract.ts';
import { methods, type MethodInfo } from '../../../src/core/integrators/methods.ts';
import { createStepper } from '../../../src/core/integrators/registry.ts';
import { distance, kepler, keplerAt, problem, run } from './problems.ts';

interface Case {
  name: string;
  id: string;
  stages: number | undefined;
}

/** Every method for y' = f(t, y), with every number of stages. */
const cases: readonly Case[] = (methods as readonly MethodInfo[])
  .filter((m) => m.id !== 'ida')
  .flatMap(({ id, stages }) => (stages ?? [undefined]).map((s) => ({ name: s ? `${id} ${s}` : id, id, stages: s })));

const implicit = ({ id }: Case): boolean => ['gauss', 'radau', 'adams-moulton', 'bdf'].includes(id);
/** How near each is with the settings below. */
const near = ({ id }: Case, euler: number): number => (id === 'euler' ? euler : 1e-3);

function stepperOf(c: Pick<Case, 'id' | 'stages'>, p: OdeProblem, options: Partial<StepperOptions>): Stepper {
  return createStepper(c.id, p, { rtol: 1e-8, atol: 1e-10, ...(c.stages ? { stages: c.stages } : {}), ...options })!;
}

describe.each(cases)('contract: $name', (c) => {
  const stepOf = implicit(c) ? 0.02 : 0.01;
  const options = { rtol: 1e-7, atol: 1e-9, step: stepOf };

  test('the limit is hit to the last bit and never passed', () => {
    const stepper = stepperOf(c, kepler, options);
    stepper.reset(0, keplerAt(0));
    for (const limit of [0.1, 0.1 + 1e-9, 0.3, 0.7000000001, Math.PI / 3]) {
      expect(run(stepper, limit, () => expect(stepper.t).toBeLessThanOrEqual(limit))).toBeNull();
      expect(stepper.t).toBe(limit);
    }
  });

  test('after a reset the same input gives the same bits, whatever was before', () => {
    const stepper = stepperOf(c, kepler, options);
    const twice = [0, 1].map(() => {
      stepper.reset(0, keplerAt(0));
      expect(run(stepper, 1)).toBeNull();
      const between = new Float64Array(4);
      stepper.interpolate((stepper.previousT + stepper.t) / 2, between);
      const found = { y: [...stepper.y], between: [...between], counters: { ...stepper.counters } };
      stepper.reset(0.2, Float64Array.of(1, 2, -1, 0.5));
      expect(run(stepper, 1.3)).toBeNull();
      return found;
    });
    expect(twice[1]).toEqual(twice[0]);
  });

  test('counters move', () => {
    const stepper = stepperOf(c, kepler, options);
    let calls = 0;
    const counted = stepperOf(
      c,
      { ...kepler, derivative: (t, y, out) => (calls++, kepler.derivative(t, y, out)) },
      options,
    );
    for (const s of [stepper, counted]) {
      s.reset(0, keplerAt(0));
      expect(run(s, 1)).toBeNull();
    }
    expect(counted.counters.evaluations).toBe(calls);
    expect(counted.counters).toEqual(stepper.counters);
    expect(stepper.counters.steps).toBeGreaterThan(0);
    if (implicit(c)) {
      expect(stepper.counters.jacobians).toBeGreaterThan(0);
      expect(stepper.counters.factorizations).toBeGreaterThan(0);
    }
  });

  test('what lies between the ends of a step does not depend on what happens to y afterwards', () => {
    const [plain, moved] = [0, 1].map(() => {
      const stepper = stepperOf(c, kepler, options);
      stepper.reset(0, keplerAt(0));
      expect(run(stepper, 0.3)).toBeNull();
      return stepper;
    }) as [Stepper, Stepper];
    moved.y.fill(7);
    moved.stateChanged();
    const [a, b] = [new Float64Array(4), new Float64Array(4)];
    for (const s of [0, 0.3, 1]) {
      const t = plain.previousT + s * (plain.t - plain.previousT);
      plain.interpolate(t, a);
      moved.interpolate(t, b);
      expect([...b]).toEqual([...a]);
      expect(distance(a, keplerAt(t))).toBeLessThan(near(c, 0.1));
    }
  });

  test('a state that was moved is where the next step starts from', () => {
    const stepper = stepperOf(c, kepler, options);
    stepper.reset(0, keplerAt(0));
    expect(run(stepper, 0.3)).toBeNull();
    stepper.y.set(keplerAt(2));
    stepper.stateChanged();
    expect(run(stepper, 0.8)).toBeNull();
    expect(distance(stepper.y, keplerAt(2.5))).toBeLessThan(near(c, 0.02));
  });

  test.each([
    { what: 'has no value', value: false, failure: 'constraint-singular' },
    { what: 'is not a number', value: true, failure: null },
  ])('where f $what the step fails by name and moves nothing', ({ value, failure }) => {
    const wall = 0.5;
    const stepper = stepperOf(
      c,
      {
        dimension: 4,
        failure,
        derivative: (t, y, out) => {
          if (t <= wall) return kepler.derivative(t, y, out);
          out.fill(NaN);
          return value;
        },
      },
      options,
    );
    stepper.reset(0, keplerAt(0));
    let last = { t: 0, previousT: 0, y: [...stepper.y] };
    const found = run(stepper, 1, () => (last = { t: stepper.t, previousT: stepper.previousT, y: [...stepper.y] }));
    expect(found).toBe(failure ?? 'non-finite');
    expect({ t: stepper.t, previousT: stepper.previousT, y: [...stepper.y] }).toEqual(last);
    expect(stepper.t).toBeLessThanOrEqual(wall + stepOf);
    expect(stepper.t).toBeGreaterThan(wall - 2 * stepOf);
    const state = new Float64Array(4);
    const middle = (stepper.previousT + stepper.t) / 2;
    stepper.interpolate(middle, state);
    expect(distance(state, keplerAt(middle))).toBeLessThan(near(c, 0.1));
  });
});

test('an implicit equation without a solution is a failure called newton', () => {
  // y1 = y0 + h/2 (1 + y0^2 + 1 + y1^2) has no real solution for h = 3.
  const stepper = stepperOf(
    { id: 'adams-moulton', stages: undefined },
    problem(1, (_t, y, out) => void (out[0] = 1 + y[0]! ** 2)),
    { step: 3 },
  );
  stepper.reset(0, Float64Array.of(1));
  expect(stepper.step(10)).toBe('newton');
  expect([stepper.t, stepper.y[0]]).toEqual([0, 1]);
});

describe.each(cases)('projection within the step: $name', (c) => {
  /** The unit circle at speed 1, and a projection that counts. */
  const circle = (): OdeProblem & { projected: number } => {
    const p = {
      ...problem(2, (_t, y, out) => {
        out[0] = -y[1]!;
        out[1] = y[0]!;
      }),
      projected: 0,
      project(_t: number, y: Float64Array): boolean {
        p.projected++;
        const r = Math.hypot(y[0]!, y[1]!);
        y[0]! /= r;
        y[1]! /= r;
        return true;
      },
    };
    return p;
  };

  test('a stepper that projects does so at every step, keeps the slope made there, and reads between projected ends', () => {
    const p = circle();
    const stepper = stepperOf(c, p, { rtol: 1e-4, atol: 1e-4 });
    stepper.reset(0, Float64Array.of(1, 0));
    const at = new Float64Array(2);
    const off: number[] = [];
    expect(
      run(stepper, 6, () => {
        off.push(Math.abs(Math.hypot(stepper.y[0]!, stepper.y[1]!) - 1));
        stepper.interpolate(stepper.t, at);
        expect(distance(at, stepper.y)).toBeLessThan(1e-14);
      }),
    ).toBeNull();
    const { steps, rejected, evaluations } = stepper.counters;
    if (!stepper.projects) return expect(p.projected).toBe(0);
    expect(Math.max(...off)).toBeLessThan(1e-15);
    expect(p.projected).toBeGreaterThanOrEqual(steps);
    // New stages with the slope at the end; the first step adds its own slope and the guess of its length.
    const most = { bs23: 3, dop853: 12 }[c.id] ?? 6;
    expect(evaluations).toBeLessThanOrEqual(most * (steps + rejected) + 2 + 3 * steps * Number(c.id === 'dop853'));
    expect(distance(stepper.y, [Math.cos(6), Math.sin(6)])).toBeLessThan(1e-2);
  });

  test('a projection that fails refuses the step', () => {
    const p = circle();
    p.project = () => false;
    const stepper = stepperOf(c, p, { rtol: 1e-4, atol: 1e-4, step: 0.1 });
    stepper.reset(0, Float64Array.of(1, 0));
    const failure = stepper.step(6);
    if (stepper.projects) {
      expect(failure).not.toBeNull();
      expect([stepper.t, ...stepper.y]).toEqual([0, 1, 0]);
    } else expect(failure).toBeNull();
  });
});
