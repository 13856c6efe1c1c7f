import { systemViews } from '../../core/systems/registry.ts';

/** What scenarios are checked against. */
export const metas = Object.fromEntries(Object.entries(systemViews).map(([id, view]) => [id, view.meta]));
