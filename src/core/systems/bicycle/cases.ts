import type { Case } from '../../cases/case.ts';

const source = 'Meijaard, Papadopoulos, Ruina and Schwab 2007: the benchmark bicycle';

const plots: Case['plots'] = [
  { title: 'Lean and steer', x: 't', y: ['roll', 'steer'], unit: 'deg' },
  { title: 'Path of the rear contact', x: 'x', y: ['y'], unit: 'm', equal: true },
];

const pushed = (
  id: string,
  title: string,
  look: string,
  speed: number,
  roll_dot: number,
  duration: number,
  picture: NonNullable<Case['picture']>,
): Case => ({
  id: `bicycle-${id}`,
  title,
  among: { id: 'bicycle', value: `${speed}\u202fm/s` },
  source,
  look,
  picture,
  scenario: { version: 1, system: 'bicycle', initial: { speed, roll_dot }, method: { rtol: 1e-10 }, duration },
  plots,
});

export const bicycleCases: readonly Case[] = [
  pushed(
    'stable',
    'Bicycle that rights itself',
    'At 4.6 m/s, between weave and capsize speed, nobody need hold it: it steers into the push and comes upright.',
    4.6,
    0.5,
    8,
    { time: 0.35, view: 'front' },
  ),
  pushed(
    'weave',
    'Bicycle that weaves',
    'At 3.5 m/s, below the weave speed of 4.292 m/s, it swings from side to side, further each time.',
    3.5,
    0.05,
    4,
    { time: 3.9 },
  ),
  pushed(
    'capsize',
    'Bicycle that capsizes',
    'At 8 m/s, above the capsize speed of 6.024 m/s, the weave dies away at once, and it leans into its turn slowly and steadily.',
    8,
    0.05,
    16,
    { time: 15 },
  ),
];
