import { describe, expect, test } from 'vitest';
import { compareOrders } from '../../src/core/control/linearization/linearize.ts';
import { lqrOf, linearizedInputs, operatingPoint } from '../../src/core/control/design/scenarioControl.ts';
import { controlReport } from '../../src/core/control/design/report.ts';
import { eigenvalues } from '../../src/core/control/linearization/spectrum.ts';
import { systems } from '../../src/core/systems/all.ts';
import { runOf, scenarioOf } from '../helpers.ts';

/** Steady motions of every system: at rest by default, and where the system rolls, on its way. */
const points: Record<string, Record<string, number | string>[]> = {
  ripstik: [{}, { X_dot: 1 }, { X_dot: -4 }],
  'caster-rotation': [{}, { theta_c: 0.4 }],
  'cart-pendulum': [{}, { theta: '-90 deg' }, { X_dot: 2 }],
  'rolling-wheel': [{}, { phi_dot: 3 }, { theta: 1.2 }],
  'stiff-decay': [{ y: 0 }],
  'wheel-pendulum': [{}, { psi: '90 deg' }, { phi_dot: 2, X_dot: 1 }],
  'casterboard-robot': [{}, { theta: 0.7 }],
  bicycle: [{ speed: 0 }, { speed: 3 }, { speed: 5 }],
  'bicycle-rider': [{ speed: 0 }, { speed: 5 }],
  'ripstik-rider': [{}, { X_dot: 1 }, { X_dot: 5 }],
  'chaplygin-sleigh': [{}, { x_dot: 1 }],
};

describe.each(Object.keys(systems))('%s', (id) => {
  const system = systems[id]!;
  const scenarioAt = (at: Record<string, number | string>) => scenarioOf({ version: 1, system: id, at });

  test('has a point to linearize at', () => expect(points[id]?.length).toBeGreaterThan(0));

  test.each((points[id] ?? []).map((at) => [JSON.stringify(at), at] as const))(
    'at %s both orders agree, and the report is whole',
    (_, at) => {
      const scenario = scenarioAt(at);
      const motion = operatingPoint(scenario, system);
      const orders = compareOrders(motion, linearizedInputs(scenario, system.meta));
      const largest = orders.eliminateFirst.tangentA.clone().abs().max();
      // Stiff ankles make entries of 1e5, with rounding in proportion.
      expect(orders.difference).toBeLessThan(largest > 1e4 ? 2e-12 * largest : 1e-10);
      if (motion.lambda.every((x) => Math.abs(x) < 1e-12) && motion.moving.length === 0)
        expect(orders.frozenDifference).toBeLessThan(1e-10);
      const report = controlReport(scenario, system);
      expect(report.eigenvalues).toHaveLength(orders.eliminateFirst.basis.columns);
      expect(report.uncontrollable.length + report.reachability.dimension).toBe(report.eigenvalues.length);
      expect(report.A.flat().every(Number.isFinite)).toBe(true);
    },
  );
});

test('a system of first order has its coordinates as states', () => {
  const report = controlReport(
    scenarioOf({ version: 1, system: 'stiff-decay', at: { y: 0 } }),
    systems['stiff-decay']!,
  );
  expect(report).toMatchObject({ states: ['y'], inputs: [], A: [[-15]], eigenvalues: [[-15, 0]] });
  expect(() => controlReport(scenarioOf({ version: 1, system: 'stiff-decay' }), systems['stiff-decay']!)).toThrow(
    /y by -15 per second/,
  );
});

test('the cart with its pendulum: the matrix by hand, and balanced from pi/2 - 0.1', () => {
  const raw = {
    version: 1,
    system: 'cart-pendulum',
    initial: { theta: Math.PI / 2 - 0.1 },
    control: { type: 'lqr', inputs: ['f_X'], Q: { X: 1, X_dot: 10, theta: 10, theta_dot: 100 } },
    duration: 60,
    outputStep: 0.1,
  };
  const design = lqrOf(scenarioOf(raw), systems['cart-pendulum']!);
  expect(design.riccati.residual).toBeLessThan(1e-13);
  // L = 1/2 m1 X'^2 + 1/2 m2 (-2 g L sin th + 2 L^2 th'^2 - 2 L sin th th' X' + X'^2), at theta = pi/2.
  const [m1, m2, L, g] = [0.3, 0.1, 1, 9.81];
  const inverse = 1 / ((m1 + m2) * 2 * m2 * L * L - m2 * m2 * L * L);
  const { A, B } = design.linearization;
  expect(A.get(2, 1)).toBeCloseTo(m2 * L * m2 * g * L * inverse, 12);
  expect(A.get(3, 1)).toBeCloseTo((m1 + m2) * m2 * g * L * inverse, 12);
  expect(B.get(2, 0)).toBeCloseTo(2 * m2 * L * L * inverse, 12);
  expect(B.get(3, 0)).toBeCloseTo(m2 * L * inverse, 12);
  const run = runOf(raw);
  expect(run.end.reason).toBe('end');
  expect(Math.abs(run.columns.get('theta')![run.rows - 1]! - Math.PI / 2)).toBeLessThan(1e-3);
});

test('the rolling wheel on its way: what moves does not matter, and it is neutral in every way', () => {
  const scenario = scenarioOf({ version: 1, system: 'rolling-wheel', at: { phi_dot: 3 } });
  const motion = operatingPoint(scenario, systems['rolling-wheel']!);
  expect(motion.moving).toEqual(['X', 'phi']);
  const { eliminateFirst } = compareOrders(motion, []);
  expect(eliminateFirst.basis.columns).toBe(6);
  expect(eigenvalues(eliminateFirst.tangentA).every(([re, im]) => re === 0 && im === 0)).toBe(true);
});
