import type { Case } from '../../cases/case.ts';

const closedForm = 'closed form, from rest of the limit cases forward and backward';
/** Of the default sleigh. */
const [mass, a, inertia] = [1, 0.2, 0.05];

export const chaplyginSleighCases: readonly Case[] = [
  {
    id: 'chaplygin-sleigh',
    title: 'Chaplygin sleigh turning round',
    source: 'The classical example of a nonholonomic system',
    look: 'Pushed backwards with a slight spin, the sleigh turns about and runs on with its centre of mass ahead. No loss, no force that does work, and yet only one direction is stable.',
    picture: { time: 3.4, distance: 1.8 },
    scenario: {
      version: 1,
      system: 'chaplygin-sleigh',
      initial: { x_dot: -1, theta_dot: 0.01 },
      method: { name: 'dop853', rtol: 1e-12, atol: 1e-12 },
      duration: 8,
    },
    published: [
      {
        what: 'heading at the end, all but π sqrt((I + m a²) / (m a²))',
        measure: { kind: 'end', column: 'theta' },
        value:
          Math.sqrt((inertia + mass * a * a) / (mass * a * a)) *
          (Math.PI - Math.atan(0.01 * Math.sqrt((inertia + mass * a * a) / mass))),
        unit: 'rad',
        tolerance: 1e-4,
        source: closedForm,
      },
    ],
    plots: [
      { title: 'Path of the blade', x: 'x', y: ['y'], unit: 'm', equal: true },
      { title: 'Heading', x: 't', y: ['theta'], unit: 'deg' },
      { title: 'Turning', x: 't', y: ['theta_dot'], unit: 'rad/s' },
    ],
  },
];
