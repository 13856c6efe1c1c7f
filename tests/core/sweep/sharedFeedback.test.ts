import { expect, test } from 'vitest';
import { sharedFeedback } from '../../../src/core/sweep/sharedFeedback.ts';
import type { System } from '../../../src/core/model/system.ts';
import type { Scenario } from '../../../src/core/scenario/types.ts';

const system = {} as System;
const asked = (more: object): Scenario => ({ parameters: { m: 1 }, constraints: 'a', hold: [], ...more }) as never;

test('another start asks for the same controller; another parameter, controller or system for a new one', () => {
  let designs = 0;
  const design = sharedFeedback(() => ++designs);
  expect(design(asked({ initial: { x: 1 } }), system)).toBe(1);
  expect(design(asked({ initial: { x: 2 }, duration: 3 }), system)).toBe(1);
  expect(design(asked({ parameters: { m: 2 } }), system)).toBe(2);
  expect(design(asked({ control: { type: 'lqr' } }), system)).toBe(3);
  // A system of one's own that was described anew has the same name and other equations.
  expect(design(asked({ control: { type: 'lqr' } }), { ...system })).toBe(4);
});

test('a design that fails is tried again', async () => {
  let tries = 0;
  const design = sharedFeedback(() => (++tries === 1 ? Promise.reject(new Error('offline')) : Promise.resolve('made')));
  await expect(design(asked({}), system)).rejects.toThrow('offline');
  expect(await design(asked({}), system)).toBe('made');
  const throwing = sharedFeedback((): string => {
    if (++tries === 3) throw new Error('no');
    return 'made';
  });
  expect(() => throwing(asked({}), system)).toThrow('no');
  expect(throwing(asked({}), system)).toBe('made');
});
