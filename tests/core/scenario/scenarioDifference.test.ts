import { expect, test } from 'vitest';
import { scenarioDifferences } from '../../../src/core/scenario/scenarioDifference.ts';
import type { ScenarioFile } from '../../../src/core/scenario/types.ts';
import { scenarioOf } from '../../helpers.ts';

const of = (written: ScenarioFile) => ({ checked: scenarioOf(written), written });
const base: ScenarioFile = {
  version: 1,
  system: 'ripstik',
  initial: { X_dot: 1, alpha_fp: '10 deg' },
  hold: ['alpha'],
};

test('a scenario does not differ from itself, however it is written', () => {
  expect(scenarioDifferences(of(base), of(base))).toEqual([]);
  const spelled = {
    ...base,
    duration: 10,
    method: { name: 'dopri5', rtol: 1e-8 },
    initial: { alpha_fp: Math.PI / 18, X_dot: '2/2' },
    parameters: { gravity: 9.81 },
  };
  expect(scenarioDifferences(of(base), of(spelled))).toEqual([]);
});

test('what differs is told as it was written, a default where nothing was', () => {
  const other: ScenarioFile = {
    ...base,
    initial: { X_dot: 1, alpha_fp: '12 deg', psi_dot: 0 },
    parameters: { casterTrail: 0.05 },
    hold: [],
    method: { name: 'ida' },
  };
  expect(scenarioDifferences(of(base), of(other))).toEqual([
    { path: 'parameters.casterTrail', first: '0.04', second: '0.05' },
    { path: 'hold', first: 'alpha', second: '' },
    { path: 'initial.alpha_fp', first: '10 deg', second: '12 deg' },
    { path: 'method.name', first: 'dopri5', second: 'ida' },
    { path: 'method.formulation', first: 'multipliers', second: null },
    { path: 'initial.psi_dot', first: null, second: '0' },
  ]);
});
