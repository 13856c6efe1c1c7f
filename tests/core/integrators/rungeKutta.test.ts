import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { gauss, radau } from '../../../src/core/integrators/collocation/collocationCoefficients.ts';
import type { OdeProblem, Stepper, StepperOptions } from '../../../src/core/integrators/contract.ts';
import { bs23 } from '../../../src/core/integrators/runge-kutta/tableaus/bs23.ts';
import { dop853 } from '../../../src/core/integrators/runge-kutta/tableaus/dop853.ts';
import { dopri5 } from '../../../src/core/integrators/runge-kutta/tableaus/dopri5.ts';
import { tsit5 } from '../../../src/core/integrators/runge-kutta/tableaus/tsit5.ts';
import { methods, type MethodInfo } from '../../../src/core/integrators/methods.ts';
import { createStepper } from '../../../src/core/integrators/registry.ts';
import {
  ROBERTSON_40,
  VAN_DER_POL_2,
  distance,
  kepler,
  keplerAt,
  problem,
  prothero,
  robertson,
  run,
  vanDerPol,
} from './problems.ts';

interface Former {
  step: number;
  rows: { time: number; end: number[]; between: number[] }[];
}
const former = JSON.parse(readFileSync(new URL('./formerDigits.json', import.meta.url), 'utf8')) as Record<
  string,
  Former
>;

interface Case {
  name: string;
  id: string;
  stages?: number;
  order: number;
  /** Order of what is seen between the steps: that of the dense output, or that of the steps if it is less. */
  dense: number;
  /** Steps to t = 2 in the coarser of the two runs. */
  steps: number;
}

const table: readonly Omit<Case, 'name'>[] = [
  { id: 'euler', order: 1, dense: 1, steps: 800 },
  { id: 'rk4', order: 4, dense: 4, steps: 80 },
  { id: 'adams-moulton', order: 2, dense: 2, steps: 80 },
  { id: 'dopri5', order: 5, dense: 5, steps: 160 },
  { id: 'dop853', order: 8, dense: 8, steps: 16 },
  { id: 'tsit5', order: 5, dense: 5, steps: 160 },
  { id: 'bs23', order: 3, dense: 3, steps: 320 },
  { id: 'gauss', stages: 1, order: 2, dense: 2, steps: 80 },
  { id: 'gauss', stages: 2, order: 4, dense: 4, steps: 80 },
  { id: 'gauss', stages: 3, order: 6, dense: 5, steps: 40 },
  { id: 'gauss', stages: 4, order: 8, dense: 6, steps: 16 },
  { id: 'radau', stages: 2, order: 3, dense: 3, steps: 80 },
  { id: 'radau', stages: 3, order: 5, dense: 5, steps: 80 },
];

const cases: readonly Case[] = table.map((c) => ({ ...c, name: c.stages ? `${c.id} ${c.stages}` : c.id }));

function stepperOf(c: Pick<Case, 'id' | 'stages'>, p: OdeProblem, options: Partial<StepperOptions>): Stepper {
  return createStepper(c.id, p, { rtol: 1e-8, atol: 1e-10, ...(c.stages ? { stages: c.stages } : {}), ...options })!;
}

/** Equal steps: collocation without error control, explicit pairs with a tolerance that nothing exceeds. */
function equalSteps(c: Pick<Case, 'id' | 'stages'>, h: number): Partial<StepperOptions> {
  return { rtol: c.id === 'gauss' || c.id === 'radau' ? Infinity : 1e12, atol: 1e-10, step: h, maxStep: h };
}

describe('order of convergence', () => {
  test.each(cases)('$name: order $order at the ends of the steps, $dense between', (c) => {
    const errors = [c.steps, 2 * c.steps].map((steps) => {
      const stepper = stepperOf(c, kepler, equalSteps(c, 2 / steps));
      stepper.reset(0, keplerAt(0));
      const state = new Float64Array(4);
      let between = 0;
      const failure = run(stepper, 2, () => {
        for (const s of [0.15, 0.4, 0.5, 0.77]) {
          const t = stepper.previousT + s * (stepper.t - stepper.previousT);
          stepper.interpolate(t, state);
          between = Math.max(between, distance(state, keplerAt(t)));
        }
      });
      expect(failure).toBeNull();
      expect(stepper.counters.steps).toBe(steps);
      return { end: distance(stepper.y, keplerAt(2)), between };
    });
    const [coarse, fine] = errors as [(typeof errors)[0], (typeof errors)[0]];
    expect(Math.abs(Math.log2(coarse.end / fine.end) - c.order), `end ${coarse.end} ${fine.end}`).toBeLessThan(0.2);
    expect(
      Math.abs(Math.log2(coarse.between / fine.between) - c.dense),
      `between ${coarse.between} ${fine.between}`,
    ).toBeLessThan(0.2);
  });

  test('coefficients of Radau IIA follow from its nodes', () => {
    const { A, startSlope } = radau(3);
    const r = Math.sqrt(6);
    const known = [
      (88 - 7 * r) / 360,
      (296 - 169 * r) / 1800,
      (-2 + 3 * r) / 225,
      (296 + 169 * r) / 1800,
      (88 + 7 * r) / 360,
      (-2 - 3 * r) / 225,
      (16 - r) / 36,
      (16 + r) / 36,
      1 / 9,
    ];
    known.forEach((a, k) => expect(A[k]).toBeCloseTo(a, 15));
    [13 + 7 * r, 13 - 7 * r, 1].forEach((e, k) => expect(startSlope[k]).toBeCloseTo(e / 3, 13));
  });

  test.each([1, 2, 3, 4])('Gauss with %i stages integrates powers up to its stage number exactly', (s) => {
    const { A, c } = gauss(s);
    for (let k = 1; k <= s; k++) {
      c.forEach((ci, i) => {
        const sum = c.reduce((total, cj, j) => total + A[i * s + j]! * cj ** (k - 1), 0);
        expect(sum).toBeCloseTo(ci ** k / k, 14);
      });
    }
  });
});

describe.each([
  { id: 'dopri5', tableau: dopri5, estimate: 4, dense: 4 },
  { id: 'dop853', tableau: dop853, estimate: 5, dense: 7 },
  { id: 'tsit5', tableau: tsit5, estimate: 4, dense: 4 },
  { id: 'bs23', tableau: bs23, estimate: 2, dense: 3 },
])('tableau of $id', ({ id, tableau, estimate, dense }) => {
  const { A, c, stages, order } = tableau;
  const sum = (x: readonly number[]): number => x.reduce((total, a) => total + a, 0);
  /** The sum of w_i c_i^(k-1): 1/k where the weights integrate powers up to k. */
  const moment = (w: readonly number[], k: number): number => sum(w.map((wi, i) => wi * c[i]! ** (k - 1)));

  test('rows add up to their nodes, b integrates powers up to its order, estimates those up to their own', () => {
    expect(A).toHaveLength(c.length);
    A.forEach((row, s) => {
      expect(row.length).toBeLessThanOrEqual(s);
      expect(sum(row)).toBeCloseTo(c[s]!, 13);
    });
    for (let k = 1; k <= order; k++) expect(moment(A[stages]!, k)).toBeCloseTo(1 / k, 13);
    for (let k = 1; k <= estimate; k++) expect(moment(tableau.error, k)).toBeCloseTo(0, 13);
    expect(Math.abs(moment(tableau.error, estimate + 1))).toBeGreaterThan(1e-6);
    if (tableau.lowOrderError) for (let k = 1; k <= 3; k++) expect(moment(tableau.lowOrderError, k)).toBeCloseTo(0, 13);
    for (const row of tableau.dense) expect(sum(row)).toBeCloseTo(0, 10);
  });

  test(`between the ends of one step the error falls by order ${dense}`, () => {
    const lengths = id === 'dop853' ? [0.4, 0.2] : [0.1, 0.05];
    const errors = lengths.map((h) => {
      const stepper = stepperOf({ id }, kepler, { rtol: 1e12, step: h });
      const state = new Float64Array(4);
      let largest = 0;
      for (const t0 of [0.5, 1, 1.5, 2]) {
        stepper.reset(t0, keplerAt(t0));
        expect(stepper.step(t0 + h)).toBeNull();
        for (let s = 0.02; s < 1; s += 0.02) {
          stepper.interpolate(t0 + s * h, state);
          largest = Math.max(largest, distance(state, keplerAt(t0 + s * h)));
        }
      }
      return largest;
    });
    expect(Math.abs(Math.log2(errors[0]! / errors[1]!) - (dense + 1)), String(errors)).toBeLessThan(0.4);
  });

  test('each step begins with the slope that the one before ended with', () => {
    const stepper = stepperOf({ id }, kepler, { rtol: 1e12, step: 0.1, maxStep: 0.1 });
    stepper.reset(0, keplerAt(0));
    expect(run(stepper, 1)).toBeNull();
    expect(stepper.counters).toMatchObject({ steps: 10, evaluations: 10 * stages + 1 });
  });
});

test('dopri5 and dop853 give the digits that they gave before they were tableaus of one kernel', () => {
  // Equal steps of a problem without any function but the square root, so that every engine gives the same bits.
  const orbit = problem(4, (_t, y, out) => {
    const r2 = y[0]! * y[0]! + y[1]! * y[1]!;
    const r3 = r2 * Math.sqrt(r2);
    out.set([y[2]!, y[3]!, -y[0]! / r3, -y[1]! / r3]);
  });
  for (const [id, { step, rows }] of Object.entries(former)) {
    const stepper = stepperOf({ id }, orbit, { rtol: 1e12, atol: 1e12, step, maxStep: step });
    stepper.reset(0, Float64Array.of(0.7, 0, 0, 1.3));
    const between = new Float64Array(4);
    const found = [];
    for (let k = 1; k <= 40; k++) {
      expect(stepper.step(k * step)).toBeNull();
      if (k % 10 !== 0) continue;
      stepper.interpolate(stepper.previousT + 0.3 * (stepper.t - stepper.previousT), between);
      found.push({ time: stepper.t, end: [...stepper.y], between: [...between] });
    }
    expect(found, id).toEqual(rows);
  }
});

describe('step control', () => {
  const controlled = cases.filter(
    (c) => (methods as readonly MethodInfo[]).find((m) => m.id === c.id)!.adaptive && c.stages !== 1,
  );

  test.each(controlled)('$name: the error over an orbit follows the tolerance', (c) => {
    const period = 2 * Math.PI;
    for (const rtol of [1e-4, 1e-7, 1e-10]) {
      const stepper = stepperOf(c, kepler, { rtol, atol: rtol });
      stepper.reset(0, keplerAt(0));
      expect(run(stepper, period)).toBeNull();
      const error = distance(stepper.y, keplerAt(0));
      expect(error, `rtol ${rtol}, ${JSON.stringify(stepper.counters)}`).toBeLessThan(100 * rtol);
    }
  });

  test('order 8 needs far fewer evaluations than order 5 at a sharp tolerance', () => {
    const evaluations = ['dopri5', 'dop853'].map((id) => {
      const stepper = stepperOf({ id }, kepler, { rtol: 1e-12, atol: 1e-12 });
      stepper.reset(0, keplerAt(0));
      expect(run(stepper, 20)).toBeNull();
      return stepper.counters.evaluations;
    });
    expect(evaluations[1]!).toBeLessThan(0.5 * evaluations[0]!);
  });

  test('the continuous output of order 8 costs three evaluations a step, and only where it is asked for', () => {
    const stepper = stepperOf({ id: 'dop853' }, kepler, {});
    stepper.reset(0, keplerAt(0));
    stepper.step(10);
    const { evaluations } = stepper.counters;
    const state = new Float64Array(4);
    for (const s of [0.2, 0.5, 0.9]) stepper.interpolate(s * stepper.t, state);
    expect(stepper.counters.evaluations).toBe(evaluations + 3);
  });

  test('stage numbers that do not exist are refused', () => {
    expect(() => stepperOf({ id: 'gauss', stages: 5 }, kepler, {})).toThrow(RangeError);
    expect(() => stepperOf({ id: 'radau', stages: 1 }, kepler, {})).toThrow(RangeError);
  });
});

describe('stiff problems', () => {
  /** Distances from cos t after each of 20 steps of 0.1, from distance 1: h lambda = -100. */
  function distances(c: Pick<Case, 'id' | 'stages'>): number[] {
    const stepper = stepperOf(c, prothero, equalSteps(c, 0.1));
    stepper.reset(0, Float64Array.of(2));
    const found: number[] = [];
    expect(run(stepper, 2, () => found.push(stepper.y[0]! - Math.cos(stepper.t)))).toBeNull();
    expect(found).toHaveLength(20);
    return found;
  }

  test.each(['euler', 'rk4'])('%s is beyond its limit of stability and grows', (id) => {
    expect(Math.abs(distances({ id })[9]!)).toBeGreaterThan(1e10);
  });

  test('Adams-Moulton rings: each deviation is -49/51 of the one before', () => {
    const found = distances({ id: 'adams-moulton' });
    [1, ...found].slice(0, -1).forEach((before, i) => expect(found[i]! / before).toBeCloseTo(-49 / 51, 3));
  });

  test.each([1, 2, 3, 4])('Gauss with %i stages stays bounded', (stages) => {
    distances({ id: 'gauss', stages }).forEach((d) => expect(Math.abs(d)).toBeLessThan(1));
  });

  test.each([2, 3])('Radau with %i stages forgets', (stages) => {
    expect(Math.abs(distances({ id: 'radau', stages })[4]!)).toBeLessThan(1e-4);
  });

  test.each([
    { id: 'radau', stages: 3, exact: true },
    { id: 'radau', stages: 3, exact: false },
    { id: 'radau', stages: 2, exact: true },
    { id: 'gauss', stages: 3, exact: false },
  ])('Robertson by $id $stages, exact Jacobian: $exact', ({ exact, ...c }) => {
    const stepper = stepperOf(c, robertson(exact), { rtol: 1e-8, atol: 1e-13 });
    stepper.reset(0, Float64Array.of(1, 0, 0));
    expect(run(stepper, 40)).toBeNull();
    ROBERTSON_40.forEach((value, i) => expect(Math.abs(stepper.y[i]! / value - 1)).toBeLessThan(1e-6));
    const { steps, jacobians, factorizations } = stepper.counters;
    expect(jacobians).toBeLessThan(steps);
    expect(factorizations).toBeGreaterThanOrEqual(jacobians);
  });

  test('Radau takes a stiff oscillator (van der Pol, 1e-6) through its jumps in few steps', () => {
    const stepper = stepperOf({ id: 'radau' }, vanDerPol, { rtol: 1e-8, atol: 1e-8 });
    stepper.reset(0, Float64Array.of(2, -0.66));
    expect(run(stepper, 2)).toBeNull();
    expect(Math.abs(stepper.y[0]! - VAN_DER_POL_2)).toBeLessThan(1e-8);
    expect(stepper.counters.steps).toBeLessThan(1200);
  });
});

test('Gauss in equal steps keeps a quadratic invariant as well as its equations are solved', () => {
  const stepper = stepperOf({ id: 'gauss', stages: 2 }, kepler, equalSteps({ id: 'gauss' }, 0.05));
  stepper.reset(0, keplerAt(0));
  const momentum = (y: Float64Array): number => y[0]! * y[3]! - y[1]! * y[2]!;
  const start = momentum(stepper.y);
  let drift = 0;
  expect(run(stepper, 100, () => (drift = Math.max(drift, Math.abs(momentum(stepper.y) - start))))).toBeNull();
  expect(drift).toBeLessThan(1e-10);
});
