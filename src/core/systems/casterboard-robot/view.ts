import type { SystemView } from '../../model/system.ts';
import { casterboardRobotMeta } from './meta.ts';
import { poses } from './poses.generated.ts';

/**
 * The model is flat; for the picture its roll axis lies at the height l1 / 2. Body: origin at its centre on that axis.
 * Arms: origin on the axis above a caster, x forward, the weight at (0, 0, l2). Wheels: origin on the ground, x along
 * the heading, axle along y, of radius up to l1 / 2.
 */
export const casterboardRobotView: SystemView = {
  meta: casterboardRobotMeta,
  poses,
  contacts: [],
  tracks: [
    { body: 3, role: 'first' },
    { body: 4, role: 'second' },
  ],
};
