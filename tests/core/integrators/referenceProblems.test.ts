import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { Ida } from '../../../src/core/integrators/multistep/ida.ts';
import { methods, type MethodInfo } from '../../../src/core/integrators/methods.ts';
import { createStepper } from '../../../src/core/integrators/registry.ts';
import { distance, problem, run } from './problems.ts';
import { sliderCrankDae, sliderCrankOde, type SliderCrank } from './sliderCrank.ts';

interface References {
  pleiades: { start: number[]; time: number; end: number[] };
  sliderCrank: { parameters: SliderCrank; start: number[]; rows: { time: number; state: number[] }[] };
}

/** Made by another tool; see the README there. */
const references = JSON.parse(
  readFileSync(new URL('../../reference/test-problems.json', import.meta.url), 'utf8'),
) as References;

/** Adaptive methods for y' = f(t, y); those of order 2 and 3 would take very long at these tolerances. */
const sharp = (methods as readonly MethodInfo[])
  .filter((m) => m.adaptive && m.id !== 'ida')
  .flatMap(({ id, stages }) =>
    (stages ?? [undefined])
      .filter((s) => id !== 'bs23' && !(id === 'gauss' && s === 1) && !(id === 'radau' && s === 2))
      .map((s) => ({ name: s ? `${id} ${s}` : id, id, stages: s })),
  );

const pleiades = problem(28, (_t, y, out) => {
  for (let i = 0; i < 14; i++) {
    out[i] = y[14 + i]!;
    out[14 + i] = 0;
  }
  for (let i = 0; i < 7; i++) {
    for (let j = 0; j < 7; j++) {
      if (i === j) continue;
      const [dx, dy] = [y[j]! - y[i]!, y[7 + j]! - y[7 + i]!];
      const r3 = Math.hypot(dx, dy) ** 3;
      out[14 + i]! += ((j + 1) * dx) / r3;
      out[21 + i]! += ((j + 1) * dy) / r3;
    }
  }
});

describe('Pleiades: seven stars with close encounters', () => {
  test.each(sharp)('$name follows the tolerance', ({ id, stages }) => {
    const { start, time, end } = references.pleiades;
    const errors = [1e-7, 1e-9].map((rtol) => {
      const stepper = createStepper(id, pleiades, { rtol, atol: rtol, ...(stages ? { stages } : {}) })!;
      stepper.reset(0, Float64Array.from(start));
      expect(run(stepper, time)).toBeNull();
      return distance(stepper.y, end);
    });
    // What is off by the tolerance before an encounter is off by thousands of it after.
    expect(errors[0]!, String(errors)).toBeLessThan(5e-3);
    expect(errors[1]!, String(errors)).toBeLessThan(1e-4);
    expect(errors[1]!, String(errors)).toBeLessThan(0.2 * errors[0]!);
  });
});

describe('slider-crank', () => {
  const { parameters, start, rows } = references.sliderCrank;
  const tolerance = { rtol: 1e-9, atol: 1e-10 };

  test.each(sharp)('$name on the index-reduced equations', ({ id, stages }) => {
    const stepper = createStepper(id, sliderCrankOde(parameters), { ...tolerance, ...(stages ? { stages } : {}) })!;
    stepper.reset(0, Float64Array.from(start));
    for (const { time, state } of rows) {
      expect(run(stepper, time)).toBeNull();
      expect(distance(stepper.y, state), `t = ${time}`).toBeLessThan(1e-6);
    }
  });

  test('ida on the residual of index 2, from the positions and velocities alone', () => {
    const stepper = new Ida(sliderCrankDae(parameters), tolerance);
    stepper.reset(0, Float64Array.of(...start, 0, 0, 0, 0));
    for (const { time, state } of rows) {
      expect(run(stepper, time)).toBeNull();
      expect(distance(stepper.y.subarray(0, 6), state), `t = ${time}`).toBeLessThan(1e-6);
    }
    expect(stepper.counters.steps).toBeLessThan(3000);
  });
});
