import type { ParameterMeta } from '../model/system.ts';

/** The parameter of every system that stands on the earth. */
export const gravity = {
  name: 'gravity',
  symbol: 'g',
  label: 'gravity',
  unit: 'm/s²',
  default: 9.81,
  group: 'World',
  source: 'the earth’s, rounded',
} as const satisfies ParameterMeta;

/** The same for what stays on level ground. */
export const gravityAcross = {
  ...gravity,
  note: 'acts across the level ground: it does not change the motion',
  source: 'the earth’s, rounded; without effect here',
} as const satisfies ParameterMeta;
