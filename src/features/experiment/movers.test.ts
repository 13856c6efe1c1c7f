import { expect, test } from 'vitest';
import { ripstikMeta } from '../../core/systems/ripstik/meta.ts';
import { movers } from './movers.ts';

test('modes are named by symbols, a rate with its dot, each once', () => {
  const modes = [
    { moves: ['psi', 'Z'] },
    { moves: ['alpha_fp'] },
    { moves: ['psi'] },
    { moves: ['psi_dot'] },
    { moves: [] },
  ];
  expect(movers(ripstikMeta, modes)).toBe('ψ, α_fp, ψ\u0307');
});
