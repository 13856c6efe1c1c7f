// From one typed system to the next: what of the experiment still has a meaning stays, the rest is left out.
import { expect, test } from 'vitest';
import { readSystem } from '../../core/description/index.ts';
import { carriedOver } from './adopt.ts';

const pendulum = (more = '') =>
  readSystem(
    `system "P"\ncoordinate theta [rad] = 1 "angle"\nparameter m [kg] = 1 positive\nkinetic 1/2 m theta'^2\npotential -m cos(theta)\ninput push [N·m] on theta "torque"\n${more}`,
  ).view!.meta;

test('names that are still there keep their values; time and method stay', () => {
  const meta = pendulum("coordinate x [m]\nkinetic 1/2 m x'^2");
  const draft = {
    version: 1 as const,
    system: 'before',
    initial: { theta: '20 deg', phi: 1 },
    parameters: { m: 3, L: 2 },
    inputs: { push: 'sin(t)', f: 1 },
    hold: ['x', 'y'],
    duration: 4,
  };
  expect(carriedOver(draft, meta)).toEqual({
    version: 1,
    system: meta.id,
    initial: { theta: '20 deg' },
    parameters: { m: 3 },
    inputs: { push: 'sin(t)' },
    hold: ['x'],
    duration: 4,
  });
});

test('a controller that the new system refuses is left out, and nothing else', () => {
  const meta = pendulum();
  const lqr = (input: string) => ({
    version: 1 as const,
    system: 'before',
    initial: { theta: 0.1 },
    control: { type: 'lqr' as const, inputs: [input], at: {} },
  });
  expect(carriedOver(lqr('push'), meta).control).toBeDefined();
  expect(carriedOver(lqr('gone'), meta)).toEqual({ version: 1, system: meta.id, initial: { theta: 0.1 } });
});
