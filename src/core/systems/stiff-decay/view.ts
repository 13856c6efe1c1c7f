import type { SystemView } from '../../model/system.ts';
import { stiffDecayMeta } from './meta.ts';
import { poses } from './poses.generated.ts';

/** The marker stands at height y above the origin. */
export const stiffDecayView: SystemView = {
  meta: stiffDecayMeta,
  poses,
  contacts: [],
};
