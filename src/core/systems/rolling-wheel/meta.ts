import type { SystemMeta } from '../../model/system.ts';
import { gravityAcross } from '../gravity.ts';

const report = 'report, section 3.4.1';

/** A wheel that rolls upright without slipping (report 3.4.1, Eq. 21 to 25, Fig. 11 and 12). Names are the report's. */
export const rollingWheelMeta = {
  id: 'rolling-wheel',
  title: 'Rolling wheel',
  coordinates: [
    { name: 'X', symbol: 'X', label: 'hub, forward', kind: 'length', role: 'neutral' },
    { name: 'Y', symbol: 'Y', label: 'hub, to the left', kind: 'length', role: 'neutral' },
    { name: 'theta', symbol: 'θ', label: 'heading', kind: 'angle', role: 'first' },
    { name: 'phi', symbol: 'φ', label: 'rolled angle', kind: 'angle', role: 'second' },
  ],
  parameters: [
    {
      name: 'm',
      symbol: 'm',
      label: 'wheel mass',
      unit: 'kg',
      default: 1,
      positive: true,
      group: 'Wheel',
      source: report,
    },
    {
      name: 'rho',
      symbol: 'ρ',
      label: 'wheel radius',
      unit: 'm',
      default: 1,
      positive: true,
      group: 'Wheel',
      source: report,
    },
    {
      name: 'Jroll',
      symbol: 'J_roll',
      label: 'inertia about the vertical',
      unit: 'kg·m²',
      default: 1,
      positive: true,
      group: 'Wheel',
      source: report,
    },
    {
      name: 'Jspin',
      symbol: 'J_spin',
      label: 'inertia about the axle',
      unit: 'kg·m²',
      default: 1,
      positive: true,
      group: 'Wheel',
      source: report,
    },
    gravityAcross,
  ],
  parameterSets: {},
  constraintSets: [
    { id: 'rolling', label: 'Rolling: X′ = ρ φ′ cos θ, Y′ = ρ φ′ sin θ', rows: 2 },
    { id: 'none', label: 'None: free to slide' },
  ],
  inputs: [
    {
      name: 'tau_theta',
      symbol: 'τ_θ',
      label: 'steering torque',
      unit: 'N·m',
      column: { theta: 1 },
      tracks: ['theta'],
    },
    { name: 'tau_phi', symbol: 'τ_φ', label: 'driving torque', unit: 'N·m', column: { phi: 1 }, tracks: ['phi'] },
  ],
  bodies: [{ id: 'wheel', label: 'wheel', role: 'neutral' }],
  views: { ridden: true },
} as const satisfies SystemMeta;
