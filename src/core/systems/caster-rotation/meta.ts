import type { SystemMeta } from '../../model/system.ts';

const report = 'report, section 3.2.1';
const board = 'the board’s caster';

/**
 * One caster of the board, its pivot at the world's origin, turned through a full circle (report 3.2.1).
 *
 * Gravity is off unless asked for: the steering axis is tilted, so weight would swing the caster, and the report turns it
 * by hand at a constant rate.
 */
export const casterRotationMeta = {
  id: 'caster-rotation',
  title: 'Caster rotation',
  coordinates: [{ name: 'theta_c', symbol: 'θ_c', label: 'caster steer', kind: 'angle', role: 'first' }],
  parameters: [
    {
      name: 'casterAngle',
      symbol: 'φ',
      label: 'caster angle',
      unit: 'rad',
      kind: 'angle',
      default: Math.PI / 6,
      group: 'Caster',
      note: 'tilt of the steering axis about y; its lower end points backwards',
      source: report,
    },
    {
      name: 'casterTrail',
      symbol: 'c',
      label: 'caster trail',
      unit: 'm',
      default: -0.05,
      group: 'Caster',
      note: 'positive: the wheel is behind its pivot',
      source: report,
    },
    {
      name: 'casterDrop',
      symbol: 'd_c',
      label: 'skate point below pivot',
      unit: 'm',
      default: 0.095,
      group: 'Caster',
      source: report,
    },
    {
      name: 'casterMass',
      symbol: 'm_c',
      label: 'caster mass',
      unit: 'kg',
      default: 0.5,
      positive: true,
      group: 'Caster',
      source: board,
    },
    {
      name: 'wheelRadius',
      symbol: 'R_w',
      label: 'wheel radius',
      unit: 'm',
      default: 0.04,
      positive: true,
      group: 'Caster',
      source: board,
    },
    {
      name: 'gravity',
      symbol: 'g',
      label: 'gravity',
      unit: 'm/s²',
      default: 0,
      group: 'World',
      note: 'off: the caster is turned by hand at a constant rate',
      source: 'none: the report turns the caster by hand',
    },
  ],
  parameterSets: {},
  constraintSets: [{ id: 'none', label: 'None: there are no constraints' }],
  inputs: [
    {
      name: 'tau_c',
      symbol: 'τ_c',
      label: 'torque about the steering axis',
      unit: 'N·m',
      column: { theta_c: 1 },
      tracks: ['theta_c'],
    },
  ],
  bodies: [{ id: 'caster', label: 'caster', role: 'first' }],
} as const satisfies SystemMeta;
