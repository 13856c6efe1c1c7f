import type { SystemView } from '../../model/system.ts';
import { ripstikView } from '../ripstik/view.ts';
import { rolledOn } from '../rolledOn.ts';
import { ripstikRiderMeta } from './meta.ts';

const [ROD, RIDER, TORSO] = [0, 5, 6];
const [ALPHA, BETA, CROUCH, TWIST] = [3, 10, 11, 12];
const HEIGHT = ripstikRiderMeta.parameters.findIndex((p) => p.name === 'riderHeight');

/**
 * Frames as the board's; the rider's has its origin at the centre of mass, x forward and z up along the body; that of hips and
 * above is turned from it about z.
 */
export const ripstikRiderView: SystemView = {
  ...ripstikView,
  meta: ripstikRiderMeta,
  poses(q, p, out) {
    ripstikView.poses(q, p, out);
    rolledOn(out, ROD, RIDER, q[BETA]! - q[ALPHA]!, 0, p[HEIGHT]! - q[CROUCH]!);
    const [from, to] = [12 * RIDER, 12 * TORSO];
    const [c, s] = [Math.cos(q[TWIST]!), Math.sin(q[TWIST]!)];
    for (let i = 0; i < 3; i++) {
      out[to + i] = out[from + i]!;
      const row = 3 + 3 * i;
      const [x, y] = [out[from + row]!, out[from + row + 1]!];
      out[to + row] = c * x + s * y;
      out[to + row + 1] = c * y - s * x;
      out[to + row + 2] = out[from + row + 2]!;
    }
  },
};
