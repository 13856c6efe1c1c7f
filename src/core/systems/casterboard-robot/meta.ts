import type { SystemMeta } from '../../model/system.ts';
import { gravityAcross } from '../gravity.ts';

const paper = 'Kinugasa et al. 2013';

/**
 * The casterboard robot of Kinugasa, Ishikawa, Sugimoto and Osuka, "Modeling and Control of Casterboard Robot" (IFAC
 * NOLCOS 2013; the report's reference [19]): flat, its casters steered by the roll of its plates.
 *
 * The paper's Table 1 prints J = 0.039 kg m², ten times what its text has, J = m1 l1² / 3. The text's value is the
 * default, because it gives the paper's figures; the table's is the parameter set `table`.
 */
export const casterboardRobotMeta = {
  id: 'casterboard-robot',
  title: 'Casterboard robot',
  coordinates: [
    { name: 'x', symbol: 'x', label: 'centre, forward', kind: 'length', role: 'neutral' },
    { name: 'y', symbol: 'y', label: 'centre, to the left', kind: 'length', role: 'neutral' },
    { name: 'theta', symbol: 'θ', label: 'heading', kind: 'angle', role: 'neutral' },
    { name: 'phi_f', symbol: 'φ_f', label: 'front plate, to the left', kind: 'angle', role: 'first' },
    { name: 'phi_r', symbol: 'φ_r', label: 'rear plate, to the left', kind: 'angle', role: 'second' },
  ],
  parameters: [
    {
      name: 'l1',
      symbol: 'l_1',
      label: 'caster from centre',
      unit: 'm',
      default: 0.095,
      positive: true,
      group: 'Board',
      source: paper,
    },
    {
      name: 'l2',
      symbol: 'l_2',
      label: 'weight from roll axis',
      unit: 'm',
      default: 0.115,
      positive: true,
      group: 'Weights',
      source: paper,
    },
    {
      name: 'm1',
      symbol: 'm_1',
      label: 'board mass',
      unit: 'kg',
      default: 1.29,
      positive: true,
      group: 'Board',
      source: paper,
    },
    {
      name: 'm2',
      symbol: 'm_2',
      label: 'mass of each weight',
      unit: 'kg',
      default: 0.29,
      positive: true,
      group: 'Weights',
      source: paper,
    },
    {
      name: 'J',
      symbol: 'J',
      label: 'board inertia about the vertical',
      unit: 'kg·m²',
      default: (1.29 * 0.095 ** 2) / 3,
      positive: true,
      group: 'Board',
      note: 'm₁ l₁² / 3 of the defaults; it does not follow l₁ and m₁',
      source:
        'Kinugasa et al. 2013, from J = m₁ l₁² / 3 in its text; its Table 1 prints ten times that, see the set “table”',
    },
    {
      name: 'a',
      symbol: 'a',
      label: 'caster angle',
      unit: 'rad',
      kind: 'angle',
      default: (7 * Math.PI) / 18,
      min: 0,
      max: 1.5,
      group: 'Board',
      note: 'ψ = atan(tan(a) sin(φ))',
      source: paper,
    },
    { name: 'c', symbol: 'c', label: 'drag', unit: 'N·s/m', default: 0.8, min: 0, group: 'Losses', source: paper },
    gravityAcross,
  ],
  parameterSets: { text: {}, table: { J: 0.039 } },
  constraintSets: [
    { id: 'rolling', label: 'Rolling: each caster moves along its heading', rows: 2 },
    { id: 'none', label: 'None: free to slide' },
  ],
  inputs: [
    {
      name: 'tau_f',
      symbol: 'τ_f',
      label: 'torque on the front weight',
      unit: 'N·m',
      column: { phi_f: 1 },
      tracks: ['phi_f'],
    },
    {
      name: 'tau_r',
      symbol: 'τ_r',
      label: 'torque on the rear weight',
      unit: 'N·m',
      column: { phi_r: 1 },
      tracks: ['phi_r'],
    },
  ],
  bodies: [
    { id: 'body', label: 'board', role: 'neutral' },
    { id: 'front-arm', label: 'front arm', role: 'first' },
    { id: 'rear-arm', label: 'rear arm', role: 'second' },
    { id: 'front-wheel', label: 'front wheel', role: 'first' },
    { id: 'rear-wheel', label: 'rear wheel', role: 'second' },
  ],
  views: { ridden: true },
} as const satisfies SystemMeta;
