import type { Case } from './case.ts';

const paper = 'Meijaard, Papadopoulos, Ruina and Schwab, Proc. R. Soc. A 463 (2007)';

export const bicycleCases: readonly Case[] = [
  {
    id: 'bicycle-stable',
    title: 'Bicycle that balances itself',
    source: `${paper}; reference [18] of the report treats the same vehicle`,
    chapter: '3.4',
    look: 'Pushed sideways at 5 m/s, between weave (4.29 m/s) and capsize (6.02 m/s), it steers into the fall and rights itself without a rider.',
    scenario: { version: 1, system: 'bicycle', initial: { speed: 5, roll_dot: 0.3 }, duration: 8 },
    published: [],
    plots: [
      { title: 'Lean and steer', x: 't', y: ['roll', 'steer'], unit: 'deg' },
      { title: 'Path of the rear wheel', x: 'x', y: ['y'], unit: 'm' },
    ],
  },
  {
    id: 'bicycle-weave',
    title: 'Bicycle that weaves',
    source: paper,
    chapter: '3.4',
    look: 'At 4 m/s, below the weave speed, each swing of lean and steer is larger than the one before.',
    scenario: { version: 1, system: 'bicycle', initial: { speed: 4, roll_dot: 0.1 }, duration: 6 },
    published: [],
    plots: [{ title: 'Lean and steer', x: 't', y: ['roll', 'steer'], unit: 'deg' }],
  },
  {
    id: 'bicycle-capsize',
    title: 'Bicycle that capsizes slowly',
    source: paper,
    chapter: '3.4',
    look: 'At 8 m/s, above the capsize speed, it leans over ever further in a tightening turn, without swinging.',
    scenario: { version: 1, system: 'bicycle', initial: { speed: 8, roll_dot: 0.1 }, duration: 20 },
    published: [],
    plots: [
      { title: 'Lean and steer', x: 't', y: ['roll', 'steer'], unit: 'deg' },
      { title: 'Path of the rear wheel', x: 'x', y: ['y'], unit: 'm' },
    ],
  },
];
