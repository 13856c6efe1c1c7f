import type { SystemMeta } from '../../model/system.ts';
import { ripstikMeta } from '../ripstik/meta.ts';

const body = 'a grown person with bent knees, rounded';
const ankle = 'stiff ankles of a standing person, rounded';

// Lean is measured in the pitched frame, not from the rod, so the charts that carry a free board past pitch ±90° do not
// apply; and files without a header row are the board's.
const { attitude: _attitude, headerless: _headerless, rider: _rider, ...board } = ripstikMeta;

/** The board and a rider who leans by `beta` on it: six bodies, eleven coordinates, four multipliers. */
export const ripstikRiderMeta = {
  ...board,
  id: 'ripstik-rider',
  title: 'RipStik with a rider',
  person: 'Rider',
  coordinates: [
    ...board.coordinates,
    { name: 'beta', symbol: 'β', label: 'rider’s lean', kind: 'angle', role: 'neutral' },
  ],
  parameters: [
    ...board.parameters,
    {
      name: 'riderMass',
      symbol: 'm_b',
      label: 'rider’s mass',
      unit: 'kg',
      default: 70,
      min: 0,
      group: 'Rider',
      source: body,
    },
    {
      name: 'riderHeight',
      symbol: 'h_b',
      label: 'rider’s centre of mass above the rod’s centre',
      unit: 'm',
      default: 0.9,
      group: 'Rider',
      source: body,
    },
    {
      name: 'riderIxx',
      symbol: 'I_x',
      label: 'rider’s inertia in roll',
      unit: 'kg·m²',
      default: 8,
      min: 0,
      group: 'Rider',
      note: 'about the centre of mass, as the other two',
      source: body,
    },
    {
      name: 'riderIyy',
      symbol: 'I_y',
      label: 'rider’s inertia in pitch',
      unit: 'kg·m²',
      default: 8.5,
      min: 0,
      group: 'Rider',
      source: body,
    },
    {
      name: 'riderIzz',
      symbol: 'I_z',
      label: 'rider’s inertia in yaw',
      unit: 'kg·m²',
      default: 1.2,
      min: 0,
      group: 'Rider',
      source: body,
    },
    {
      name: 'ankleStiffness',
      symbol: 'k_a',
      label: 'stiffness of each ankle',
      unit: 'N·m/rad',
      default: 600,
      min: 0,
      group: 'Ankles',
      source: ankle,
    },
    {
      name: 'ankleDamping',
      symbol: 'c_a',
      label: 'damping of each ankle',
      unit: 'N·m·s/rad',
      default: 20,
      min: 0,
      group: 'Ankles',
      source: ankle,
    },
  ],
  inputs: [
    {
      name: 'tau_af',
      symbol: 'τ_af',
      label: 'front ankle torque',
      unit: 'N·m',
      column: { alpha: 1, alpha_fp: 1, beta: -1 },
      tracks: ['alpha', 'alpha_fp'],
    },
    {
      name: 'tau_ab',
      symbol: 'τ_ab',
      label: 'back ankle torque',
      unit: 'N·m',
      column: { alpha: 1, alpha_bp: 1, beta: -1 },
      tracks: ['alpha', 'alpha_bp'],
    },
    ...board.inputs,
  ],
  gait: { feet: ['tau_af', 'tau_ab'], drag: 'wheelDrag', hold: ['beta'] },
  regulators: ['tau_af', 'tau_ab'],
  bodies: [...board.bodies, { id: 'rider', label: 'rider', role: 'neutral' }],
  spoken: [...board.spoken, { label: 'rider’s lean', values: [['beta']] }],
} as const satisfies SystemMeta;
