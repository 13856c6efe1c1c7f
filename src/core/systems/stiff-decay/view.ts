import type { SystemView } from '../../model/system.ts';
import { stiffDecayMeta } from './meta.ts';
import { poses } from './poses.generated.ts';

/** The marker stands at height y, and goes along a time line of 2 m a second: its path is the curve of Fig. 13. */
export const stiffDecayView: SystemView = {
  meta: stiffDecayMeta,
  poses,
  contacts: [],
  tracks: [{ body: 0, role: 'first' }],
  drawnAlong: 2,
};
