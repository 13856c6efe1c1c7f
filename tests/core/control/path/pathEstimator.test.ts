// A path followed by what sensors read: the filter of its turns.
import { describe, expect, test } from 'vitest';
import { feedbackOf } from '../../../../src/core/control/design/feedback.ts';
import { plantOf } from '../../../../src/core/control/design/scenarioControl.ts';
import { steadyTurn } from '../../../../src/core/control/path/steadyTurn.ts';
import { inputsOf } from '../../../../src/core/model/inputs.ts';
import { direction } from '../../../../src/core/elementary/trigonometry.ts';
import type { Estimate } from '../../../../src/core/mechanics/forcing.ts';
import { ripstikCases } from '../../../../src/core/systems/ripstik/cases.ts';
import { systems } from '../../../../src/core/systems/all.ts';
import { runOf, scenarioOf, seeded } from '../../../helpers.ts';

const system = systems['ripstik']!;
const authors = ripstikCases.find(({ id }) => id === 'authors-tests')!.scenario as unknown as {
  control: Record<string, unknown> & { sensors: Record<string, object> };
};
const Q = { Y: 1, theta: 1, alpha_fp: 1, alpha_bp: 1 };
const sensed = (control: object, more: object = {}) => ({
  ...authors,
  initial: { X_dot: 1 },
  ...more,
  control: { ...authors.control, Q, ...control },
});
const estimateOf = (control: object): Estimate =>
  [...feedbackOf(scenarioOf(sensed(control)), system)!.values()][0]!.estimator!.begin();

test('directions are those of Math.atan2, to rounding, and the same bits on every machine', () => {
  const random = seeded(7);
  for (let i = 0; i < 3000; i++) {
    const [y, x] = [random() - 0.5, (random() - 0.5) * 10 ** (6 * random() - 3)];
    expect(Math.abs(direction(y, x) - Math.atan2(y, x))).toBeLessThanOrEqual(4.5e-16);
  }
  for (const [y, x] of [
    [0, 1],
    [0, -1],
    [1, 0],
    [-1, 0],
    [0, 0],
    [1, 1],
    [-1, -1],
  ] as const)
    expect(direction(y, x)).toBeCloseTo(Math.atan2(y, x), 15);
});

describe('the filter', () => {
  test('along a line it estimates as the filter of straight motion does, once its covariance has settled', () => {
    const [along, straight] = [estimateOf({ path: { line: {} } }), estimateOf({})];
    const names = Object.keys(authors.control.sensors);
    const random = seeded(3);
    for (let k = 0; k < 1200; k++) {
      const read = names.map(() => 0.002 * (random() - 0.5));
      const asked = [0.1 * (random() - 0.5), 0.1 * (random() - 0.5)];
      for (const estimate of [along, straight]) {
        estimate.correct(k * 0.005, read);
        if (k < 1199) estimate.predict(asked);
      }
    }
    const at = (name: string): number => system.meta.coordinates.findIndex((c) => c.name === name);
    for (const name of ['Y', 'theta', 'theta_fc', 'theta_bc'])
      expect(along.q[at(name)]! - straight.q[at(name)]!, name).toBeCloseTo(0, 4);
    for (const name of ['Y', 'theta', 'alpha_fp', 'theta_fc'])
      expect(along.v[at(name)]! - straight.v[at(name)]!, `${name}_dot`).toBeCloseTo(0, 2);
  });

  test('in a steady turn with the inputs that hold it, it goes round as the turn does, whichever way it heads', () => {
    const inputs = ['tau_fc', 'tau_bc'].map((name) => inputsOf(system.meta).find((input) => input.name === name)!);
    const plant = plantOf(scenarioOf(sensed({})), system);
    const { motion, u0 } = steadyTurn(plant, { X_dot: 1 }, 0.5, inputs);
    const estimate = estimateOf({ path: { circle: { radius: 2 } } });
    const at = (name: string): number => system.meta.coordinates.findIndex((c) => c.name === name);
    const [q, v] = [motion.q.slice(), motion.v.slice()];
    // A third of the circle on.
    const angle = 2;
    [q[at('X')], q[at('Y')]] = [2 * Math.sin(angle), 2 - 2 * Math.cos(angle)];
    q[at('theta')]! += angle;
    [v[at('X')], v[at('Y')]] = [Math.cos(angle), Math.sin(angle)];
    estimate.know(0, q, v);
    estimate.fill(u0);
    for (let k = 0; k < 200; k++) estimate.predict(u0);
    const later = angle + 0.5;
    expect(estimate.q[at('X')]).toBeCloseTo(2 * Math.sin(later), 6);
    expect(estimate.q[at('Y')]).toBeCloseTo(2 - 2 * Math.cos(later), 6);
    expect(estimate.q[at('theta')]! - q[at('theta')]!).toBeCloseTo(0.5, 6);
    expect(estimate.v[at('X')]).toBeCloseTo(Math.cos(later), 6);
    expect(estimate.q[at('theta_fc')]).toBeCloseTo(motion.q[at('theta_fc')]!, 6);
  });

  test('what no sensor tells of an unstable mode is refused where the sensors are named', () => {
    const control = { sensors: { X: { noise: 0.01 } }, process: undefined, path: { line: {} } };
    expect(() => feedbackOf(scenarioOf(sensed(control)), system)).toThrow(
      expect.objectContaining({ path: 'control.sensors', message: expect.stringContaining('no sensor sees') }) as Error,
    );
  });
});

test.each([1, -1])('a circle of %f m is ridden through the sensors, within 0.3 m', (radius) => {
  const file = sensed({ path: { circle: { radius } } }, { duration: 7.5 });
  const run = runOf(file);
  const [X, Y] = [run.columns.get('X')!, run.columns.get('Y')!];
  expect(run.end.reason).toBe('end');
  expect(Math.max(...[...X].map((x, i) => Math.abs(Math.hypot(x, Y[i]! - radius) - 1)))).toBeLessThan(0.3);
  expect(Math.sign(radius) * run.columns.get('theta')!.at(-1)!).toBeGreaterThan(2 * Math.PI);
});
