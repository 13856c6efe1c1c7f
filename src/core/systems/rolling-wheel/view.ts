import type { SystemView } from '../../model/system.ts';
import { rollingWheelMeta } from './meta.ts';
import { poses } from './poses.generated.ts';

/** The wheel's origin is its hub at height rho, its axle is its y, forward is Rz(theta) x. */
export const rollingWheelView: SystemView = {
  meta: rollingWheelMeta,
  poses,
  contacts: [],
  tracks: [{ body: 0, role: 'neutral', rim: 'rho' }],
};
