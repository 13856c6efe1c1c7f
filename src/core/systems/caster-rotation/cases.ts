import type { Case } from '../../cases/case.ts';

const closedForm = 'closed form Ry(casterAngle) Rz(theta_c) (-casterTrail, 0, -casterDrop)';

export const casterRotationCases: readonly Case[] = [
  {
    id: 'caster-rotation',
    title: 'Caster turned once (Fig. 5 and 6)',
    source: 'Report, section 3.2.1, Fig. 5 and 6',
    figure: 'Fig. 5 and 6',
    chapter: '3.2.1',
    look: 'The skate point draws a circle of radius |trail| about the tilted steering axis. The report’s curves start at the same point, but are those of the drop turned about the tilted x axis: a circle of 0.095 m.',
    picture: { time: 0.85, distance: 0.8 },
    scenario: { version: 1, system: 'caster-rotation', initial: { theta_c_dot: '2*pi' }, duration: 1 },
    published: [
      {
        what: 'x at the start',
        measure: { kind: 'at', column: 'caster.x', time: 0 },
        value: 0.05 * Math.cos(Math.PI / 6) - 0.095 * 0.5,
        unit: 'm',
        tolerance: 1e-12,
        source: `Fig. 5 and ${closedForm}`,
      },
      {
        what: 'z at the start',
        measure: { kind: 'at', column: 'caster.z', time: 0 },
        value: -0.05 * 0.5 - 0.095 * Math.cos(Math.PI / 6),
        unit: 'm',
        tolerance: 1e-12,
        source: `Fig. 5 and ${closedForm}`,
      },
      {
        what: 'x half a turn later',
        measure: { kind: 'at', column: 'caster.x', time: 0.5 },
        value: -0.05 * Math.cos(Math.PI / 6) - 0.095 * 0.5,
        unit: 'm',
        tolerance: 1e-12,
        source: closedForm,
      },
      {
        what: 'furthest to the left',
        measure: { kind: 'max', column: 'caster.y' },
        value: 0.05,
        unit: 'm',
        tolerance: 1e-12,
        source: closedForm,
      },
      {
        what: 'angle turned',
        measure: { kind: 'end', column: 'theta_c' },
        value: 2 * Math.PI,
        unit: 'rad',
        tolerance: 1e-12,
        source: 'Section 3.2.1',
      },
    ],
    plots: [
      { title: 'Fig. 5: place of the skate point', x: 'theta_c', y: ['caster.x', 'caster.y', 'caster.z'], unit: 'm' },
      { title: 'Fig. 6: its path, seen from the side', x: 'caster.x', y: ['caster.z'], unit: 'm', equal: true },
    ],
  },
];
