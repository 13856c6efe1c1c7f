import type { SystemView } from '../../model/system.ts';
import { chaplyginSleighMeta } from './meta.ts';
import { poses } from './poses.generated.ts';

/** The sleigh's origin is where the blade touches the ground; the blade lies along its x, z is up. */
export const chaplyginSleighView: SystemView = {
  meta: chaplyginSleighMeta,
  poses,
  contacts: [],
  tracks: [{ body: 0, role: 'neutral' }],
};
