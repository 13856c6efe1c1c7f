/** Angles as motion capture and sensors write them, made continuous, and attitudes as the contract's three angles. */
import { extentOf, forgetExtent } from './extent.ts';

/**
 * Takes whole turns out of jumps of more than half a turn from row to row, where the column is one that wraps: it stays
 * within a turn and jumps by nearly a whole one.
 * @param x radians, changed in place
 * @returns number of jumps mended
 */
export function unwrap(x: Float64Array): number {
  const turn = 2 * Math.PI;
  const { low, high } = extentOf(x);
  if (!(high - low > Math.PI)) return 0;
  const symmetric = low >= -Math.PI - 1e-3 && high <= Math.PI + 1e-3;
  const positive = low >= -1e-3 && high <= turn + 1e-3;
  if (!symmetric && !positive) return 0;
  let [jumps, shift, last] = [0, 0, NaN];
  for (let i = 0; i < x.length; i++) {
    const raw = x[i]!;
    if (raw - raw !== 0) continue;
    const step = raw - last;
    // The shorter way between two rows, as the picture draws it.
    if (Math.abs(step) > Math.PI) {
      shift -= Math.sign(step) * turn;
      jumps++;
    }
    last = raw;
    x[i] = raw + shift;
  }
  forgetExtent(x);
  return jumps;
}

/**
 * Yaw, pitch and roll of `R = Rz(yaw) Ry(pitch) Rx(roll)` from unit quaternions, continuous from row to row. J. Diebel,
 * "Representing attitude" (2006), section 5.6 (sequence 3-2-1). At a pitch of exactly ±90° yaw keeps its value of before.
 * @returns number of rows whose quaternion was no rotation (all zeros); they are NaN
 */
export function anglesOf(
  [qx, qy, qz, qw]: readonly [Float64Array, Float64Array, Float64Array, Float64Array],
  yaw: Float64Array,
  pitch: Float64Array,
  roll: Float64Array,
): number {
  let bad = 0;
  let [lastYaw, lastRoll] = [0, 0];
  for (let i = 0; i < qx.length; i++) {
    const norm = Math.hypot(qx[i]!, qy[i]!, qz[i]!, qw[i]!);
    if (!(norm > 1e-6)) {
      yaw[i] = pitch[i] = roll[i] = NaN;
      bad++;
      continue;
    }
    const [x, y, z, w] = [qx[i]! / norm, qy[i]! / norm, qz[i]! / norm, qw[i]! / norm];
    const sine = Math.max(-1, Math.min(1, 2 * (w * y - x * z)));
    let newYaw = Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
    let newRoll = Math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y));
    if (1 - Math.abs(sine) < 1e-12) {
      newYaw = lastYaw;
      newRoll = 2 * Math.atan2(x, w) + Math.sign(sine) * lastYaw;
    }
    lastYaw = yaw[i] = near(newYaw, lastYaw);
    pitch[i] = Math.asin(sine);
    lastRoll = roll[i] = near(newRoll, lastRoll);
  }
  return bad;
}

/**
 * Unit quaternions of Euler angles, each turn about the axes turned by those before (intrinsic; the letters' rotation
 * matrices multiplied from left to right): Diebel (2006), section 5.
 * @param order of the axes, `XYZ`
 * @param angles about each axis, rad
 * @returns x, y, z and the scalar
 */
export function quaternionsOf(
  order: string,
  angles: Readonly<Record<'X' | 'Y' | 'Z', Float64Array>>,
): [Float64Array, Float64Array, Float64Array, Float64Array] {
  const n = angles.X.length;
  const made = [0, 1, 2, 3].map(() => new Float64Array(n)) as [Float64Array, Float64Array, Float64Array, Float64Array];
  for (let i = 0; i < n; i++) {
    let [x, y, z, w] = [0, 0, 0, 1];
    for (const axis of order) {
      const half = angles[axis as 'X' | 'Y' | 'Z'][i]! / 2;
      const [c, s] = [Math.cos(half), Math.sin(half)];
      // Hamilton's product with the turn about one axis.
      if (axis === 'X') [x, y, z, w] = [c * x + s * w, c * y + s * z, c * z - s * y, c * w - s * x];
      else if (axis === 'Y') [x, y, z, w] = [c * x - s * z, c * y + s * w, c * z + s * x, c * w - s * y];
      else [x, y, z, w] = [c * x + s * y, c * y - s * x, c * z + s * w, c * w - s * z];
    }
    [made[0][i], made[1][i], made[2][i], made[3][i]] = [x, y, z, w];
  }
  return made;
}

/** The same angle within half a turn of another. */
function near(angle: number, other: number): number {
  return angle + 2 * Math.PI * Math.round((other - angle) / (2 * Math.PI));
}
