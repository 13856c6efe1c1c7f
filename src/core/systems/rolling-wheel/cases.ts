import type { Case } from '../../cases/case.ts';

const tight = { name: 'dop853', rtol: 1e-12, atol: 1e-12 };
const closedForm = 'closed form of the rolling wheel';

export const rollingWheelCases: readonly Case[] = [
  {
    id: 'rolling-wheel-line',
    title: 'Wheel rolling straight (Fig. 11 and 12)',
    source: 'Report, section 3.4.1, Fig. 11 and 12',
    figure: 'Fig. 11 and 12',
    chapter: '3.4.1',
    look: 'Without turning the wheel rolls along a straight line; its heading stays, its angle grows steadily.',
    picture: { time: 1.5 },
    scenario: {
      version: 1,
      system: 'rolling-wheel',
      initial: { theta: 1.2, phi_dot: 3, theta_dot: 0 },
      method: tight,
      duration: 5,
    },
    published: [
      {
        what: 'X at 5 s',
        measure: { kind: 'end', column: 'X' },
        value: 15 * Math.cos(1.2),
        unit: 'm',
        tolerance: 1e-9,
        source: closedForm,
      },
      {
        what: 'Y at 5 s',
        measure: { kind: 'end', column: 'Y' },
        value: 15 * Math.sin(1.2),
        unit: 'm',
        tolerance: 1e-9,
        source: `Fig. 11 and ${closedForm}`,
      },
      {
        what: 'angle rolled at 5 s',
        measure: { kind: 'end', column: 'phi' },
        value: 15,
        unit: 'rad',
        tolerance: 1e-9,
        source: `Fig. 12 and ${closedForm}`,
      },
    ],
    plots: [
      { title: 'Fig. 11: path', x: 'X', y: ['Y'], unit: 'm', equal: true },
      { title: 'Fig. 12: heading and rolled angle', x: 't', y: ['phi', 'theta'], unit: 'rad' },
    ],
  },
  {
    id: 'rolling-wheel-circle',
    title: 'Wheel rolling in a circle',
    source: 'Report, section 3.4.1',
    chapter: '3.4.1',
    look: 'A wheel that also turns draws a circle of radius ρ φ′ / θ′; the constraint forces hold it on it and do no work.',
    picture: { time: 5, distance: 1.4 },
    scenario: {
      version: 1,
      system: 'rolling-wheel',
      initial: { theta: 1.2, phi_dot: 3, theta_dot: 1 },
      method: tight,
      duration: 7,
    },
    published: [
      {
        what: 'diameter',
        measure: { kind: 'diameter', x: 'X', y: 'Y' },
        value: 6,
        unit: 'm',
        tolerance: 1e-9,
        source: closedForm,
      },
      {
        what: 'X at 5 s',
        measure: { kind: 'at', column: 'X', time: 5 },
        value: 3 * (Math.sin(6.2) - Math.sin(1.2)),
        unit: 'm',
        tolerance: 1e-9,
        source: closedForm,
      },
      {
        what: 'Y at 5 s',
        measure: { kind: 'at', column: 'Y', time: 5 },
        value: 3 * (Math.cos(1.2) - Math.cos(6.2)),
        unit: 'm',
        tolerance: 1e-9,
        source: closedForm,
      },
    ],
    plots: [
      { title: 'Path', x: 'X', y: ['Y'], unit: 'm', equal: true },
      { title: 'Heading and rolled angle', x: 't', y: ['phi', 'theta'], unit: 'rad' },
    ],
  },
];
