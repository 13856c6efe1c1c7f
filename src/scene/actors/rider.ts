/** Where a rider's eye is: over the tail, looking ahead along the nose. Pure geometry. */
import type { Triple } from '../camera/views.ts';

/** Vertical field of view (rad): wide, as from aboard. */
export const RIDER_FIELD = (58 * Math.PI) / 180;
/** Eye and what it looks at, ahead and above, per metre of the subject's largest extent: far enough back that the tail stands above the buttons at the picture's foot. */
const EYE = [-1.35, 0.8] as const;
const LOOK = [1.4, -0.6] as const;
/** The same behind somebody who stands: over the shoulders, and with the way ahead in the picture. */
const EYE_STANDING = [-1.9, 0.95] as const;
const LOOK_STANDING = [1.6, 0.05] as const;

export interface RiderPlace {
  eye: Triple;
  target: Triple;
  up: Triple;
}

/**
 * @param size largest extent of what is ridden (m); `position` its origin (m), `heading` about world z (rad)
 * @param lean the subject's upward axis, which the picture leans with; null keeps the horizon level
 * @param standing whether it is taller than it is long
 */
export function riderPlace(
  size: number,
  position: Triple,
  heading: number,
  lean: Triple | null,
  standing = false,
): RiderPlace {
  const [c, s] = [Math.cos(heading), Math.sin(heading)];
  const length = lean ? Math.hypot(...lean) : 0;
  const up: Triple = lean && length > 1e-6 ? [lean[0] / length, lean[1] / length, lean[2] / length] : [0, 0, 1];
  const place = ([ahead, above]: readonly [number, number]): Triple => [
    position[0] + size * (ahead * c + above * up[0]),
    position[1] + size * (ahead * s + above * up[1]),
    position[2] + size * above * up[2],
  ];
  return { eye: place(standing ? EYE_STANDING : EYE), target: place(standing ? LOOK_STANDING : LOOK), up };
}
