import type { SystemView } from '../../model/system.ts';
import { bicycleView } from '../bicycle/view.ts';
import { rolledOn } from '../rolledOn.ts';
import { bicycleRiderMeta } from './meta.ts';

const [REAR_FRAME, RIDER, LEAN] = [1, 4, 8];
const index = (name: string): number => bicycleRiderMeta.parameters.findIndex((p) => p.name === name);
const [REAR_RADIUS, HINGE] = [index('rearRadius'), index('hingeZ')];

/** Frames as the bicycle's; the upper body has its origin on the axis that it leans about, above the rear hub. */
export const bicycleRiderView: SystemView = {
  ...bicycleView,
  meta: bicycleRiderMeta,
  poses(q, p, out) {
    bicycleView.poses(q, p, out);
    rolledOn(out, REAR_FRAME, RIDER, q[LEAN]!, -p[HINGE]! - p[REAR_RADIUS]!, 0);
  },
};
