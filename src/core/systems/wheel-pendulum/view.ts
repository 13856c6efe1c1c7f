import type { SystemView } from '../../model/system.ts';
import { wheelPendulumMeta } from './meta.ts';
import { poses } from './poses.generated.ts';

/** In the X-Z plane. Wheel: origin at the hub at height rho, axle along y. Pendulum: origin at the hub, x along the rod to its centre of mass at L. */
export const wheelPendulumView: SystemView = {
  meta: wheelPendulumMeta,
  poses,
  contacts: [],
};
