import type { SystemView } from '../../model/system.ts';
import { cartPendulumMeta } from './meta.ts';
import { poses } from './poses.generated.ts';

/** In the X-Z plane. Cart: origin at the pivot, height 0. Pendulum: origin at the pivot, x along the rod to its centre of mass at L. */
export const cartPendulumView: SystemView = {
  meta: cartPendulumMeta,
  poses,
  contacts: [],
};
