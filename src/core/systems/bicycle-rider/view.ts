import type { SystemView } from '../../model/system.ts';
import { bicycleView } from '../bicycle/view.ts';
import { bicycleRiderMeta } from './meta.ts';
import { poses } from './poses.generated.ts';

/** Frames as the bicycle's; the upper body has its origin on the axis that it leans about, above the rear hub. */
export const bicycleRiderView: SystemView = { ...bicycleView, meta: bicycleRiderMeta, poses };
