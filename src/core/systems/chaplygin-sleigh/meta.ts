import type { SystemMeta } from '../../model/system.ts';
import { gravityAcross } from '../gravity.ts';

const own = 'chosen for this program, not published';

/** A body on a blade that does not slip sideways, its centre of mass ahead of the blade (or behind, with a < 0). */
export const chaplyginSleighMeta = {
  id: 'chaplygin-sleigh',
  title: 'Chaplygin sleigh',
  coordinates: [
    { name: 'x', symbol: 'x', label: 'blade, forward', kind: 'length', role: 'neutral' },
    { name: 'y', symbol: 'y', label: 'blade, to the left', kind: 'length', role: 'neutral' },
    { name: 'theta', symbol: 'θ', label: 'heading', kind: 'angle', role: 'first' },
  ],
  parameters: [
    { name: 'mass', symbol: 'm', label: 'mass', unit: 'kg', default: 1, positive: true, group: 'Sleigh', source: own },
    {
      name: 'a',
      symbol: 'a',
      label: 'centre of mass ahead of the blade',
      unit: 'm',
      default: 0.2,
      group: 'Sleigh',
      source: own,
    },
    {
      name: 'inertia',
      symbol: 'I',
      label: 'inertia about the centre of mass',
      unit: 'kg·m²',
      default: 0.05,
      positive: true,
      group: 'Sleigh',
      source: own,
    },
    gravityAcross,
  ],
  parameterSets: {},
  constraintSets: [
    { id: 'rolling', label: 'Blade: no motion across its heading', rows: 1 },
    { id: 'none', label: 'None: free to slide' },
  ],
  inputs: [
    { name: 'tau_theta', symbol: 'τ_θ', label: 'turning torque', unit: 'N·m', column: { theta: 1 }, tracks: ['theta'] },
  ],
  bodies: [{ id: 'sleigh', label: 'sleigh', role: 'neutral' }],
  views: { ridden: true },
} as const satisfies SystemMeta;
