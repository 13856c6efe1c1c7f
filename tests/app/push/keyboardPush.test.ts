import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { bodyVelocity, firmness, posesNear } from '../../../src/app/push/pointerPush.ts';
import { pushOf, stepOf } from '../../../src/app/push/keyboardPush.ts';
import type { Motion } from '../../../src/app/runs/motion.ts';
import { systemViews } from '../../../src/core/systems/registry.ts';
import { Trajectory } from '../../../src/core/motion/trajectory.ts';

/** A motion of two rows, both in this state. */
function still(id: string, state: Record<string, number>): Motion {
  const system = systemViews[id]!;
  const trajectory = new Trajectory(['t', ...system.meta.coordinates.flatMap(({ name }) => [name, `${name}_dot`])], 2);
  trajectory.append(
    trajectory.columns.map((name) =>
      name === 't' ? Float64Array.of(1, 2) : new Float64Array(2).fill(state[name] ?? 0),
    ),
    2,
  );
  return { system, parameters: {}, trajectory } as unknown as Motion;
}

const newton = fc.double({ min: -50, max: 50, noNaN: true });

describe('the force chosen by keys', () => {
  test('is what the spring pulls with, turned as the board heads; the damper goes along', () => {
    fc.assert(
      fc.property(newton, newton, newton, fc.double({ min: -7, max: 7, noNaN: true }), (ahead, left, up, theta) => {
        const motion = still('ripstik', {
          X: 3,
          Y: -2,
          Z: 0.09,
          theta,
          X_dot: Math.cos(theta),
          Y_dot: Math.sin(theta),
        });
        const push = pushOf(motion, 1.5, { body: 'rod', force: [ahead, left, up] })!;
        const { stiffness } = firmness(motion);
        const pulled = push.target.map((x, i) => stiffness * (x - posesNear(motion, 0)[i]!));
        expect(pulled[0]).toBeCloseTo(Math.cos(theta) * ahead - Math.sin(theta) * left, 6);
        expect(pulled[1]).toBeCloseTo(Math.sin(theta) * ahead + Math.cos(theta) * left, 6);
        expect(pulled[2]).toBeCloseTo(up, 6);
        expect(push.moving!.velocity).toEqual(bodyVelocity(motion, 1, 0));
        expect(push.moving!.since).toBe(1);
      }),
      { seed: 11 },
    );
  });

  test.each(Object.keys(systemViews))('%s: every body can be held, and no other', (id) => {
    const motion = still(id, {});
    for (const { id: body } of motion.system.meta.bodies)
      expect(pushOf(motion, 1, { body, force: [1, 0, 0] })!.target.every(Number.isFinite)).toBe(true);
    expect(pushOf(motion, 1, { body: 'nothing', force: [1, 0, 0] })).toBeNull();
  });

  test('comes in round steps that stretch the spring by 2 cm, nearly', () => {
    fc.assert(
      fc.property(fc.double({ min: 1e-3, max: 1e6, noNaN: true }), (stiffness) => {
        const step = stepOf(stiffness);
        expect(['1', '2', '5']).toContain(step.toExponential()[0]);
        expect(Math.abs(Math.log(step / stiffness / 0.02))).toBeLessThan(Math.log(2.5) / 2 + 1e-9);
      }),
      { seed: 11 },
    );
  });
});
