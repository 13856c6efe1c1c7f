import { loadSystem, systemIds } from './registry.ts';
import type { System } from '../model/system.ts';

/** Every system with its dynamics at once: for the command line and tests. The page's workers load what they need. */
export const systems: Readonly<Record<string, System>> = Object.fromEntries(
  await Promise.all(systemIds.map(async (id): Promise<[string, System]> => [id, await loadSystem(id)!])),
);
