import type { SystemView } from '../../model/system.ts';
import { ripstikView } from '../ripstik/view.ts';
import { ripstikRiderMeta } from './meta.ts';
import { poses } from './poses.generated.ts';

/** Frames as the board's; the rider's has its origin at the centre of mass, x forward and z up along the body. */
export const ripstikRiderView: SystemView = { ...ripstikView, meta: ripstikRiderMeta, poses };
