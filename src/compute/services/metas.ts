/** What scenarios are checked against. */
export { systemMetas as metas } from '../../core/systems/registry.ts';
