import type { Case } from '../../cases/case.ts';

/** Weights on what can be felt: roll of the plates on the rod, steer, lean, and their rates. */
const felt = ['alpha_fp', 'alpha_bp', 'theta_fc', 'theta_bc', 'beta'];

export const ripstikRiderCases: readonly Case[] = [
  {
    id: 'rider-balanced',
    title: 'Rider, balanced by the feet',
    source: '',
    look: 'Three degrees of lean at 1 m/s. The rider’s ankles turn the plates, the casters follow, and the board is steered back under the body.',
    picture: { time: 0.3 },
    scenario: {
      version: 1,
      system: 'ripstik-rider',
      initial: { X_dot: 1, beta: '3 deg' },
      control: {
        type: 'lqr',
        inputs: ['tau_af', 'tau_ab'],
        at: { X_dot: 1 },
        Q: Object.fromEntries(felt.flatMap((name) => [name, `${name}_dot`].map((state) => [state, 1]))),
      },
      duration: 10,
    },
    plots: [
      { title: 'Lean of the rider, roll of the plates', x: 't', y: ['beta', 'alpha_fp', 'alpha_bp'], unit: 'deg' },
      { title: 'Ankle torques', x: 't', y: ['tau_af', 'tau_ab'], unit: 'N·m' },
      { title: 'Path', x: 'X', y: ['Y'], unit: 'm', equal: true },
    ],
  },
];
