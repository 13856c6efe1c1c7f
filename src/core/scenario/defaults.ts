import { methods } from '../integrators/methods.ts';

/** What a scenario means where it is silent, and the names it may use (spec, section 6). */
export const DEFAULTS = {
  duration: 10,
  outputStep: 0.01,
  rtol: 1e-8,
  atol: 1e-10,
  method: 'dopri5',
  formulation: 'multipliers',
  scheduled: 8,
} as const;

export const METHOD_NAMES = methods.map((m) => m.id);
export const FORMULATION_NAMES = ['multipliers', 'nullspace-qr', 'blt'] as const;
export const EVENT_NAMES = ['touchdown', 'constraint-singular'] as const;
export const COLUMN_NAMES = ['lambda', 'energy', 'residual', 'inputs'] as const;

/** Speeds that a schedule may design gains at. */
export const MOST_SCHEDULED = 20;
export const LONGEST_DURATION = 1e5;
export const MOST_ROWS = 1e7;
/** Characters of a scenario file; the largest sensible one has a few thousand. */
export const LONGEST_FILE = 200_000;
