import type { Purpose } from './compute.ts';

/** The page's workers: one program, loaded once and started as often as it is needed. */
export const startWorker = (purpose: Purpose): Worker =>
  new Worker(new URL('../worker.ts', import.meta.url), { type: 'module', name: purpose });
