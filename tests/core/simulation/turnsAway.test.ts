import { expect, test } from 'vitest';
import { runOf } from '../../helpers.ts';

const warnings = (theta: string): readonly string[] =>
  runOf({
    version: 1,
    system: 'ripstik',
    initial: { X_dot: 1, theta },
    control: { type: 'lqr', inputs: ['tau_fc', 'tau_bc'], at: { X_dot: 1 }, Q: { alpha: 1, theta: 1 } },
    duration: 0.01,
  }).simulation.warnings;

test('a regulated run that starts full turns from its point says so, and how to have the same attitude', () => {
  expect(warnings('360 deg')).toEqual([
    "theta starts a full turn above the regulator's point, which drives it all the way round: " +
      'for the same attitude take 360° from it',
  ]);
  expect(warnings('-725 deg').join()).toMatch(/2 full turns below .* add 720° to it/);
  expect(warnings('354 deg').join()).toMatch(/starts about a full turn above .* take 360° from it/);
  expect(warnings('-290 deg').join()).toMatch(/starts about a full turn below .* add 360° to it/);
  for (const near of ['175 deg', '-260 deg']) expect(warnings(near)).toEqual([]);
});
