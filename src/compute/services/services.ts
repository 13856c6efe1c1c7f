import type { Loaders } from '../remote/serve.ts';

/** The services, each loaded by the first call for it, so that a worker holds what it needs and no more. */
export const services = {
  run: async () => (await import('./run.ts')).calls,
  ride: async () => (await import('./ride.ts')).calls,
  sweep: async () => (await import('./sweep.ts')).calls,
  tests: async () => (await import('./tests.ts')).calls,
  control: async () => (await import('./control.ts')).calls,
  mechanics: async () => (await import('./mechanics.ts')).calls,
  gait: async () => (await import('./gait.ts')).calls,
  csv: async () => (await import('./csv.ts')).calls,
} satisfies Loaders;
