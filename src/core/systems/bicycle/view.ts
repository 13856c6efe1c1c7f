import type { SystemView } from '../../model/system.ts';
import { bicycleMeta } from './meta.ts';
import { poses } from './poses.generated.ts';

/** Wheels: origin at the hub, axle along y. Rear frame: origin at the rear hub. Front frame: origin at the front hub, axes those of the upright bicycle at zero steer. */
export const bicycleView: SystemView = {
  meta: bicycleMeta,
  poses,
  contacts: [],
  tracks: [
    { body: 0, role: 'second', rim: 'rearRadius' },
    { body: 3, role: 'first', rim: 'frontRadius' },
  ],
};
