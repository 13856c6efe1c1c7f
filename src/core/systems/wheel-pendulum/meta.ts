import type { SystemMeta } from '../../model/system.ts';
import { gravity } from '../gravity.ts';

const report = 'report, section 3.5';

/** A wheel that rolls in a plane with a pendulum at its hub (report 3.5, Eq. 27 to 34): upright at psi = -90°. Names are the report's. */
export const wheelPendulumMeta = {
  id: 'wheel-pendulum',
  title: 'Wheel and pendulum',
  coordinates: [
    { name: 'X', symbol: 'X', label: 'hub, forward', kind: 'length', role: 'neutral' },
    { name: 'phi', symbol: 'φ', label: 'rolled angle', kind: 'angle', role: 'second' },
    {
      name: 'psi',
      symbol: 'ψ',
      label: 'pendulum, from the horizontal',
      kind: 'angle',
      role: 'first',
      rest: -Math.PI / 2,
    },
  ],
  parameters: [
    {
      name: 'rho',
      symbol: 'ρ',
      label: 'wheel radius',
      unit: 'm',
      default: 0.5,
      positive: true,
      group: 'Wheel',
      source: report,
    },
    {
      name: 'm',
      symbol: 'm',
      label: 'wheel mass',
      unit: 'kg',
      default: 3,
      positive: true,
      group: 'Wheel',
      source: report,
    },
    {
      name: 'mP',
      symbol: 'm_P',
      label: 'pendulum mass',
      unit: 'kg',
      default: 1,
      positive: true,
      group: 'Pendulum',
      source: report,
    },
    {
      name: 'Jspin',
      symbol: 'J_spin',
      label: 'wheel inertia about the axle',
      unit: 'kg·m²',
      default: 2,
      positive: true,
      group: 'Wheel',
      source: report,
    },
    {
      name: 'L',
      symbol: 'L',
      label: 'centre of mass from hub',
      unit: 'm',
      default: 1,
      positive: true,
      group: 'Pendulum',
      note: 'a thin rod of length 2 L',
      source: report,
    },
    gravity,
  ],
  parameterSets: {},
  constraintSets: [
    { id: 'rolling', label: 'Rolling: X′ = ρ φ′', rows: 1 },
    { id: 'none', label: 'None: free to slide' },
  ],
  inputs: [
    { name: 'tau_phi', symbol: 'τ_φ', label: 'torque on the wheel', unit: 'N·m', column: { phi: 1 }, tracks: ['phi'] },
  ],
  bodies: [
    { id: 'wheel', label: 'wheel', role: 'neutral' },
    { id: 'pendulum', label: 'pendulum', role: 'first' },
  ],
} as const satisfies SystemMeta;
