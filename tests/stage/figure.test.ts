import { expect, test } from 'vitest';
import { cases, systemViews } from '../../src/core/systems/registry.ts';
import { drawnAs, movedByFeet } from '../../src/stage/figure.ts';
import type { Motion } from '../../src/app/runs/motion.ts';

const motionOf = (id: string): Motion => {
  const { scenario } = cases.find((one) => one.id === id)!;
  return { system: systemViews[scenario.system]!, written: scenario } as Motion;
};
const boards = cases.filter(({ scenario }) => scenario.system === 'ripstik').map(({ id }) => id);

test('somebody stands on the boards that feet move, and on no other', () => {
  expect(boards.filter((id) => movedByFeet(motionOf(id)))).toEqual(['ridden', 'turning', 'balanced-feet', 'circle']);
});

test('who wants somebody always or never gets it', () => {
  for (const id of ['ridden', 'falling-ground']) {
    expect(drawnAs(motionOf(id), 'always').id).toBe('ripstik-rider');
    expect(drawnAs(motionOf(id), 'never').id).toBe('ripstik');
  }
  expect(drawnAs(motionOf('ridden'), 'auto').id).toBe('ripstik-rider');
  expect(drawnAs(motionOf('falling-ground'), 'auto').id).toBe('ripstik');
});
