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
    expect(message).toMatch(/take rtol and atol a hundred times larger, or dop853/);
    expect(falling('10 deg', { name: 'ida', rtol: 1e-10, atol: 1e-12 }).reason).toBe('end');
    expect(falling('10 deg', { name: 'dop853', rtol: 1e-12, atol: 1e-14 }).reason).toMatch(/end|constraint-singular/);
  });
});
