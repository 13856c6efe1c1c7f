import { describe, expect, test } from 'vitest';
import { runOf } from '../../helpers.ts';

/** Through the ground, past a place where a skate lies flat, nearly. */
const falling = (alpha: string, method: object) =>
  runOf({
    version: 1,
    system: 'ripstik',
    initial: { alpha },
    events: { touchdown: 'ignore' },
    duration: 5,
    outputStep: 1,
    method,
  }).end;

describe('tolerances near rounding', () => {
  test.each(['12 deg'])('ida goes on at 1e-12 from %s as at 1e-11', (alpha) => {
    expect(falling(alpha, { name: 'ida', rtol: 1e-12, atol: 1e-14 }).message).toBe('ran to t = 5 s');
  });

  test('where it can not, the message names nearly dependent constraints and a remedy, which helps', () => {
    const { reason, message } = falling('10 deg', { name: 'ida', rtol: 1e-12, atol: 1e-14 });
    expect(['newton', 'step-too-small']).toContain(reason);
    expect(message).toMatch(/constraints are nearly dependent: smallest eigenvalue .* \(a skate lies flat\)/);
    expect(message).toMatch(/take rtol 1e-10 and atol 1e-12, or dop853/);
    expect(falling('10 deg', { name: 'ida', rtol: 1e-10, atol: 1e-12 }).reason).toBe('end');
    expect(falling('10 deg', { name: 'dop853', rtol: 1e-12, atol: 1e-14 }).reason).toMatch(/end|constraint-singular/);
  });
});

describe('a start that cannot be', () => {
  test.each([
    [
      { system: 'bicycle', initial: { roll: '90 deg' } },
      /a motion of x, yaw and pitch together has no inertia: their axes/,
    ],
    [{ system: 'bicycle', hold: ['x', 'y', 'yaw', 'rear_spin'] }, /and the held coordinates .*: hold fewer$/],
    [{ system: 'rolling-wheel', hold: ['X', 'Y', 'theta', 'phi'] }, /: hold fewer, or choose constraints "none"$/],
    [
      { system: 'ripstik', initial: { alpha: '90 deg' } },
      /dependent at this start \(a skate lies flat\): change the start/,
    ],
  ])('%j is told in the words of its system', (raw, message) => {
    expect(() => runOf({ version: 1, duration: 0.1, ...raw })).toThrow(message);
  });
});
