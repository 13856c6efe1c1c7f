import type { SystemView } from '../../model/system.ts';
import { ripstikView } from '../ripstik/view.ts';
import { rolledOn } from '../rolledOn.ts';
import { ripstikRiderMeta } from './meta.ts';

const [ROD, RIDER, ALPHA, BETA] = [0, 5, 3, 10];
const HEIGHT = ripstikRiderMeta.parameters.findIndex((p) => p.name === 'riderHeight');

/** Frames as the board's; the rider's has its origin at the centre of mass, x forward and z up along the body. */
export const ripstikRiderView: SystemView = {
  ...ripstikView,
  meta: ripstikRiderMeta,
  poses(q, p, out) {
    ripstikView.poses(q, p, out);
    rolledOn(out, ROD, RIDER, q[BETA]! - q[ALPHA]!, 0, p[HEIGHT]!);
  },
};
