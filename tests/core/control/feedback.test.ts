import { describe, expect, test } from 'vitest';
import { feedbackOf, StateFeedback } from '../../../src/core/control/design/feedback.ts';
import { actuationOf } from '../../../src/core/simulation/actuation.ts';
import { Saturation } from '../../../src/core/simulation/saturation.ts';
import { systems } from '../../../src/core/systems/all.ts';
import { scenarioOf, seeded } from '../../helpers.ts';

const q0 = Float64Array.of(1, 2);
const v0 = Float64Array.of(3, 0);
const gain = [0.5, -1, 2, 0.25];

test('the reference goes along with the steady motion', () => {
  const feedback = new StateFeedback(gain, q0, v0, Infinity);
  expect(feedback.asked(4, Float64Array.of(13, 2), v0)).toBeCloseTo(0, 14);
  expect(feedback.asked(4, Float64Array.of(13.2, 2.1), Float64Array.of(3.1, 0.4))).toBeCloseTo(
    -(0.5 * 0.2 - 0.1 + 2 * 0.1 + 0.25 * 0.4),
    13,
  );
});

test('at its limit it neither asks for more nor reacts', () => {
  const feedback = new Saturation(new StateFeedback(gain, q0, v0, 0.3));
  const far = Float64Array.of(5, 2);
  expect(feedback.value(0, far, v0)).toBe(-0.3);
  const [Q, V] = [new Float64Array(4), new Float64Array(4)];
  feedback.addSlopes(0, far, v0, 1, 2, Q, V);
  expect([...Q, ...V]).toEqual(Array(8).fill(0));
  feedback.addSlopes(0, q0, v0, 2, 2, Q, V);
  expect([...Q, ...V]).toEqual([0, 0, -1, 2, 0, 0, -4, -0.5]);
});

describe.each([
  ['lqr', { type: 'lqr', inputs: ['tau_fp', 'f_theta', 'tau_bc'], at: { X_dot: 1 } }],
  [
    'lqr with limits',
    { type: 'lqr', inputs: ['tau_fc', 'tau_bc'], at: { X_dot: 1 }, limits: { tau_fc: 0.5, tau_bc: 50 } },
  ],
  ['track', { type: 'track', reference: { tau_fp: '0.1*sin(t)', tau_twist: 0 }, kp: 6, kd: 0.3 }],
])('%s', (_, control) => {
  test('the derivatives of the forces are exact', () => {
    const scenario = scenarioOf({ version: 1, system: 'ripstik', control, inputs: { tau_fp: 'sin(t)' } });
    const { forcing } = actuationOf(scenario, systems['ripstik']!.meta, feedbackOf(scenario, systems['ripstik']!));
    const random = seeded(41);
    const t = 0.7;
    const q = Float64Array.from({ length: 10 }, () => 0.05 * (random() - 0.5));
    const v = Float64Array.from({ length: 10 }, () => 0.05 * (random() - 0.5));
    q[0]! += t;
    v[0]! += 1;
    const [forceQ, forceV] = [new Float64Array(100), new Float64Array(100)];
    forcing!.jacobians!(t, q, v, forceQ, forceV);
    for (const [x, exact] of [
      [q, forceQ],
      [v, forceV],
    ] as const) {
      for (let k = 0; k < 10; k++) {
        const [kept, h] = [x[k]!, 1e-5];
        const side = (sign: number) => {
          x[k] = kept + sign * h;
          const force = new Float64Array(10);
          forcing!(t, q, v, force);
          x[k] = kept;
          return force;
        };
        const [plus, minus] = [side(1), side(-1)];
        for (let i = 0; i < 10; i++)
          expect(Math.abs((plus[i]! - minus[i]!) / (2 * h) - exact[10 * i + k]!)).toBeLessThan(1e-7);
      }
    }
  });
});
