import type { Case } from '../../cases/case.ts';

export const cartPendulumCases: readonly Case[] = [
  {
    id: 'cart-pendulum',
    title: 'Inverted pendulum let go (Fig. 7)',
    source: 'Report, section 3.3.1, Fig. 7',
    figure: 'Fig. 7',
    chapter: '3.3.1',
    look: 'Nothing holds the rod: it falls, swings through, and drives the cart to and fro. The common centre of mass never moves sideways.',
    picture: { time: 1.6 },
    scenario: {
      version: 1,
      system: 'cart-pendulum',
      initial: { theta: 'pi/2 - 0.1' },
      method: { rtol: 1e-10 },
      duration: 10,
    },
    plots: [
      { title: 'Cart', x: 't', y: ['X'], unit: 'm' },
      { title: 'Pendulum', x: 't', y: ['theta'], unit: 'rad' },
    ],
  },
  {
    id: 'cart-pendulum-lqr',
    title: 'Inverted pendulum balanced',
    source: 'Report, section 3.3.1, with the regulator of section 3.5',
    chapter: '3.5',
    look: 'A force on the cart brings the rod upright from 0.1 rad, and the cart back to where it stood.',
    picture: { time: 0.6 },
    scenario: {
      version: 1,
      system: 'cart-pendulum',
      initial: { theta: 'pi/2 - 0.1' },
      control: { type: 'lqr', inputs: ['f_X'], Q: { X: 1, X_dot: 10, theta: 10, theta_dot: 100 } },
      duration: 30,
    },
    plots: [
      { title: 'Cart', x: 't', y: ['X'], unit: 'm' },
      { title: 'Pendulum', x: 't', y: ['theta'], unit: 'rad' },
    ],
  },
];
