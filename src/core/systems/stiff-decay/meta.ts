import type { SystemMeta } from '../../model/system.ts';

/** The stiff example of the report's Fig. 13, of first order: y' = -rate y. */
export const stiffDecayMeta = {
  id: 'stiff-decay',
  title: 'Stiff decay (y′ = −15 y)',
  order: 1,
  coordinates: [{ name: 'y', symbol: 'y', label: 'value', kind: 'length', pure: true, role: 'neutral', rest: 1 }],
  parameters: [
    {
      name: 'rate',
      symbol: 'k',
      label: 'rate of decay',
      unit: '1/s',
      default: 15,
      group: 'Decay',
      note: 'y′ = −rate · y',
      source: 'report, Fig. 13',
    },
  ],
  parameterSets: {},
  constraintSets: [{ id: 'none', label: 'None: there are no constraints' }],
  inputs: [],
  bodies: [{ id: 'marker', label: 'value as a height', role: 'neutral' }],
} as const satisfies SystemMeta;
