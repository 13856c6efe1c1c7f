// The rider on the board against an independent model (tests/reference/ripstik-rider.json).
import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { lqrOf, operatingPoint } from '../../src/core/control/design/scenarioControl.ts';
import { controlReport } from '../../src/core/control/design/report.ts';
import type { Complex } from '../../src/core/control/linearization/spectrum.ts';
import { marginsOf } from '../../src/core/control/margins.ts';
import { systems } from '../../src/core/systems/all.ts';
import { cases } from '../../src/core/systems/registry.ts';
import { spectralDistance } from '../core/control/helpers.ts';
import { runOf, scenarioOf } from '../helpers.ts';

interface Reference {
  cases: {
    ankleStiffness: number;
    ankleDamping: number;
    speed: number;
    multipliers: number[];
    eigenvalues: Complex[];
  }[];
}
const reference = JSON.parse(readFileSync('tests/reference/ripstik-rider.json', 'utf8')) as Reference;
const system = systems['ripstik-rider']!;
const { scenario: balanced } = cases.find((c) => c.id === 'rider-balanced')!;

/** The reference's own rounding of a zero. */
const NEUTRAL = 1e-4;
const size = ([re, im]: Complex) => Math.hypot(re, im);

test.each(reference.cases)(
  'multipliers and eigenvalues with ankles of $ankleStiffness N·m/rad at $speed m/s',
  ({ ankleStiffness, ankleDamping, speed, multipliers, eigenvalues }) => {
    const scenario = scenarioOf({
      version: 1,
      system: 'ripstik-rider',
      parameters: { ankleStiffness, ankleDamping },
      at: { X_dot: speed },
    });
    const { lambda } = operatingPoint(scenario, system);
    multipliers.forEach((known, i) => expect(Math.abs(lambda[i]! - known)).toBeLessThan(1e-6));
    const found = controlReport(scenario, system).eigenvalues;
    const moving = eigenvalues.filter((value) => size(value) >= NEUTRAL);
    expect(found).toHaveLength(eigenvalues.length);
    expect(found.filter(([re, im]) => re === 0 && im === 0)).toHaveLength(eigenvalues.length - moving.length);
    expect(
      spectralDistance(
        moving,
        found.filter((value) => size(value) > 0),
      ),
    ).toBeLessThan(1e-6);
  },
);

describe('balanced by the feet', () => {
  test.each([
    { speed: 0, largest: 58_226, delay: 0.205, growth: 2.998 },
    { speed: 1, largest: 1_684, delay: 0.21, growth: 2.889 },
    { speed: 5, largest: 144, delay: 0.236, growth: 2.564 },
  ])('at $speed m/s: largest gain $largest, delay margin $delay s', ({ speed, largest, delay, growth }) => {
    const design = lqrOf(
      scenarioOf({ ...balanced, control: { ...balanced.control, at: speed > 0 ? { X_dot: speed } : {} } }),
      system,
    );
    const gains = design.gain.to2DArray().flat().map(Math.abs);
    expect(Math.abs(Math.max(...gains) / largest - 1)).toBeLessThan(0.01);
    const growing = design.openLoop.filter(([re]) => re > 0);
    expect(growing).toHaveLength(1);
    expect(Math.abs(growing[0]![0] - growth)).toBeLessThan(1e-3);
    const { A, B } = design.quotient;
    const margins = marginsOf({ A, B, K: design.riccati.gain }, design.linearization.inputs);
    expect(Math.abs(margins.delay / delay - 1)).toBeLessThan(0.01);
  });

  test.each([0.001, 0.01, 0.03, 0.1, 0.3, 0.5, 0.7, 3, 10])(
    'at %d m/s, however weakly the casters move the board: solved, heading and place left alone',
    (speed) => {
      const design = lqrOf(scenarioOf({ ...balanced, control: { ...balanced.control, at: { X_dot: speed } } }), system);
      expect(design.split.reachable.columns).toBe(12);
      expect(design.placed).toHaveLength(10);
      expect(design.unseen).toHaveLength(2);
      expect(design.riccati.residual).toBeLessThan(1e-11);
      for (const [re] of design.placed) expect(re).toBeLessThan(-1);
    },
  );

  test('from three degrees of the rider’s own lean at 1 m/s, the board upright: at most 88.2 N·m per ankle', () => {
    const run = runOf({ ...balanced, outputStep: 0.001 });
    expect(run.end.reason).toBe('end');
    const largest = (name: string) => run.columns.get(name)!.reduce((most, x) => Math.max(most, Math.abs(x)), 0);
    expect(Math.abs(Math.max(largest('tau_af'), largest('tau_ab')) - 88.2)).toBeLessThan(0.1);
    expect(Math.abs(run.columns.get('beta')!.at(-1)!)).toBeLessThan(1e-3);
  });
});
