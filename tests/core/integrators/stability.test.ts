import { describe, expect, test } from 'vitest';
import { Bdf } from '../../../src/core/integrators/multistep/bdf.ts';
import type { OdeProblem, Stepper } from '../../../src/core/integrators/contract.ts';
import type { DaeProblem } from '../../../src/core/integrators/shared/dae.ts';
import { Ida } from '../../../src/core/integrators/multistep/ida.ts';
import { createStepper } from '../../../src/core/integrators/registry.ts';
import { problem, run } from './problems.ts';

/** y' = rate y, as a function and as a residual. */
const decay = (rate: number): OdeProblem =>
  problem(1, (_t, y, out) => void (out[0] = rate * y[0]!), { jacobian: (_t, _y, out) => ((out[0] = rate), true) });
const decayResidual = (rate: number): DaeProblem => ({
  dimension: 1,
  differential: Uint8Array.of(1),
  failure: null,
  start: (_t, y, yp) => ((yp[0] = rate * y[0]!), true),
  residual: (_t, y, yp, out) => ((out[0] = yp[0]! - rate * y[0]!), true),
  jacobian: (_t, _y, _yp, cj, out) => ((out[0] = cj - rate), true),
});

/** y after one step of length h from 1, without step control where there is any: R(rate h). */
function amplification(id: string, stages: number | undefined, rate: number, h: number): number {
  const collocation = id === 'gauss' || id === 'radau';
  const options = {
    rtol: collocation ? Infinity : 1e12,
    atol: 1e12,
    step: h,
    maxStep: h,
    ...(stages ? { stages } : {}),
  };
  const stepper = createStepper(id, decay(rate), options)!;
  stepper.reset(0, Float64Array.of(1));
  expect(stepper.step(h)).toBeNull();
  expect(stepper.t).toBe(h);
  return stepper.y[0]!;
}

const factorial = (n: number): number => (n < 2 ? 1 : n * factorial(n - 1));

/** Padé approximation of e^z with numerator of degree k and denominator of degree j (Hairer and Wanner, Solving ODEs II, section IV.3). */
function pade(k: number, j: number, z: number): number {
  const sum = (degree: number, x: number): number => {
    let total = 0;
    for (let i = 0; i <= degree; i++)
      total +=
        (factorial(degree) / factorial(degree - i)) *
        (factorial(k + j - i) / factorial(k + j)) *
        (x ** i / factorial(i));
    return total;
  };
  return sum(k, z) / sum(j, -z);
}

const aStable = [
  { id: 'adams-moulton', stages: undefined, numerator: 1, denominator: 1 },
  ...[1, 2, 3, 4].map((s) => ({ id: 'gauss', stages: s, numerator: s, denominator: s })),
  ...[2, 3].map((s) => ({ id: 'radau', stages: s, numerator: s - 1, denominator: s })),
].map((c) => ({ ...c, name: c.stages ? `${c.id} ${c.stages}` : c.id }));

describe("amplification of y' = rate y in one step", () => {
  test('Euler and Runge-Kutta 4: the polynomial of their order; beyond their limit they grow', () => {
    expect(amplification('euler', undefined, -15, 1 / 4)).toBe(-2.75);
    expect(amplification('euler', undefined, -15, 1 / 8)).toBe(-0.875);
    for (const z of [-0.5, -2, -15 / 4, -15]) {
      expect(amplification('euler', undefined, z, 1)).toBeCloseTo(1 + z, 12);
      expect(amplification('rk4', undefined, z, 1) / (1 + z + z ** 2 / 2 + z ** 3 / 6 + z ** 4 / 24)).toBeCloseTo(
        1,
        12,
      );
    }
    for (const id of ['euler', 'rk4', 'dopri5', 'dop853'])
      expect(Math.abs(amplification(id, undefined, -15, 1))).toBeGreaterThan(10);
  });

  test.each(aStable)('$name: its Padé approximation, never above 1', ({ id, stages, numerator, denominator }) => {
    expect(amplification(id, stages, -15, 1 / 8)).toBeCloseTo(pade(numerator, denominator, -15 / 8), 11);
    for (let z = -0.01; z > -2e6; z *= 10) {
      const R = amplification(id, stages, z, 1);
      expect(Math.abs(R - pade(numerator, denominator, z)), `z = ${z}`).toBeLessThan(1e-9);
      expect(Math.abs(R), `z = ${z}`).toBeLessThanOrEqual(1);
    }
  });

  test.each(aStable)('$name at rate -1e6: forgets if it is L-stable, else keeps the size', ({ id, stages }) => {
    const R = amplification(id, stages, -1e6, 1);
    if (id === 'radau') expect(Math.abs(R)).toBeLessThan(1e-5);
    else expect(Math.abs(Math.abs(R) - 1)).toBeLessThan(1e-4);
  });

  test.each([1, 2, 3, 4, 5])('BDF of order %i forgets, as a function and as a residual', (maxOrder) => {
    const rate = -1e6;
    const tuning = { maxOrder, past: (_t: number, y: Float64Array) => void (y[0] = 1) };
    const options = { rtol: Infinity, atol: 1, step: 1, maxStep: 1 };
    const steppers: Stepper[] = [new Bdf(decay(rate), options, tuning), new Ida(decayResidual(rate), options, tuning)];
    for (const stepper of steppers) {
      stepper.reset(0, Float64Array.of(1));
      // The values before the start are still remembered for `maxOrder` steps.
      expect(run(stepper, 2 * maxOrder)).toBeNull();
      expect(stepper.counters.steps).toBe(2 * maxOrder);
      expect(Math.abs(stepper.y[0]!)).toBeLessThan(1e-5);
    }
  });
});

describe("a stiff nonlinear problem with a known answer: Kaps' problem, y1 = exp(-2t), y2 = exp(-t)", () => {
  const epsilon = 1e-6;
  const kaps = problem(
    2,
    (_t, y, out) => {
      const [a, b] = y as unknown as [number, number];
      out[0] = -(2 + 1 / epsilon) * a + (b * b) / epsilon;
      out[1] = a - b - b * b;
    },
    {
      jacobian: (_t, y, out) => {
        out.set([-(2 + 1 / epsilon), (2 * y[1]!) / epsilon, 1, -1 - 2 * y[1]!]);
        return true;
      },
    },
  );
  const error = (stepper: Stepper): number =>
    Math.max(Math.abs(stepper.y[0]! - Math.exp(-2)), Math.abs(stepper.y[1]! - Math.exp(-1)));

  test.each([
    { id: 'radau', stages: 2, steps: 200 },
    { id: 'radau', stages: 3, steps: 60 },
    { id: 'bdf', stages: undefined, steps: 120 },
    { id: 'gauss', stages: 2, steps: 2000 },
    { id: 'gauss', stages: 3, steps: 2000 },
  ])('$id $stages: to the tolerance in few steps', ({ id, stages, steps }) => {
    const stepper = createStepper(id, kaps, { rtol: 1e-6, atol: 1e-9, ...(stages ? { stages } : {}) })!;
    stepper.reset(0, Float64Array.of(1, 1));
    expect(run(stepper, 1)).toBeNull();
    expect(error(stepper)).toBeLessThan(1e-5);
    expect(stepper.counters.steps).toBeLessThan(steps);
  });

  test('Adams-Moulton: order 2 in steps a hundred thousand times the fast time', () => {
    const errors = [0.1, 0.05].map((step) => {
      const stepper = createStepper('adams-moulton', kaps, { rtol: 1e-6, atol: 1e-9, step })!;
      stepper.reset(0, Float64Array.of(1, 1));
      expect(run(stepper, 1)).toBeNull();
      return error(stepper);
    });
    expect(Math.abs(Math.log2(errors[0]! / errors[1]!) - 2), String(errors)).toBeLessThan(0.2);
  });

  test.each(['dopri5', 'dop853'])('%s needs steps as short as the fast time', (id) => {
    const stepper = createStepper(id, kaps, { rtol: 1e-6, atol: 1e-9 })!;
    stepper.reset(0, Float64Array.of(1, 1));
    expect(run(stepper, 0.01)).toBeNull();
    expect(stepper.counters.steps).toBeGreaterThan(1000);
  });
});
