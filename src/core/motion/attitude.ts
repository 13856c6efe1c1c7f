/** Rotation matrices (9 numbers by rows) and unit quaternions (x y z w): conversion and interpolation. */

/**
 * Quaternion of a rotation matrix at `offset` in `m`.
 * Shepperd's choice of the largest component keeps it accurate everywhere (J. Guidance and Control 1 (1978) 223).
 *
 * @param m rotation matrices by rows, 9 numbers from `offset`
 * @param offset of the first
 * @param out w, x, y, z
 */
export function quaternionOf(m: Float64Array, offset: number, out: Float64Array): void {
  const xx = m[offset]!,
    xy = m[offset + 1]!,
    xz = m[offset + 2]!;
  const yx = m[offset + 3]!,
    yy = m[offset + 4]!,
    yz = m[offset + 5]!;
  const zx = m[offset + 6]!,
    zy = m[offset + 7]!,
    zz = m[offset + 8]!;
  const trace = xx + yy + zz;
  if (trace >= xx && trace >= yy && trace >= zz) set(out, zy - yz, xz - zx, yx - xy, 1 + trace);
  else if (xx >= yy && xx >= zz) set(out, 1 + xx - yy - zz, xy + yx, xz + zx, zy - yz);
  else if (yy >= zz) set(out, xy + yx, 1 - xx + yy - zz, yz + zy, xz - zx);
  else set(out, xz + zx, yz + zy, 1 - xx - yy + zz, yx - xy);
}

function set(out: Float64Array, x: number, y: number, z: number, w: number): void {
  const scale = 1 / Math.sqrt(x * x + y * y + z * z + w * w);
  out[0] = x * scale;
  out[1] = y * scale;
  out[2] = z * scale;
  out[3] = w * scale;
}

/**
 * Spherical interpolation along the shorter arc, into `out`; `b` may be turned to its equal opposite.
 *
 * @param a unit quaternion, w first
 * @param b unit quaternion, w first
 * @param share from 0, at a, to 1, at b
 * @param out unit quaternion
 */
export function slerp(a: Float64Array, b: Float64Array, share: number, out: Float64Array): void {
  let dot = a[0]! * b[0]! + a[1]! * b[1]! + a[2]! * b[2]! + a[3]! * b[3]!;
  const sign = dot < 0 ? -1 : 1;
  dot *= sign;
  let wa = 1 - share;
  let wb = share;
  // Below a thousandth of a degree the arc is its chord to rounding.
  if (dot < 1 - 1e-10) {
    const angle = Math.acos(dot);
    const inverse = 1 / Math.sin(angle);
    wa = Math.sin(wa * angle) * inverse;
    wb = Math.sin(wb * angle) * inverse;
  }
  wb *= sign;
  set(out, wa * a[0]! + wb * b[0]!, wa * a[1]! + wb * b[1]!, wa * a[2]! + wb * b[2]!, wa * a[3]! + wb * b[3]!);
}

/**
 * Rotation matrix of a unit quaternion, by rows, at `offset` in `out`.
 *
 * @param quaternion unit, w first
 * @param out rotation matrix by rows, 9 numbers from `offset`
 * @param offset of the first
 */
export function matrixOf(quaternion: Float64Array, out: Float64Array, offset: number): void {
  const x = quaternion[0]!,
    y = quaternion[1]!,
    z = quaternion[2]!,
    w = quaternion[3]!;
  out[offset] = 1 - 2 * (y * y + z * z);
  out[offset + 1] = 2 * (x * y - w * z);
  out[offset + 2] = 2 * (x * z + w * y);
  out[offset + 3] = 2 * (x * y + w * z);
  out[offset + 4] = 1 - 2 * (x * x + z * z);
  out[offset + 5] = 2 * (y * z - w * x);
  out[offset + 6] = 2 * (x * z - w * y);
  out[offset + 7] = 2 * (y * z + w * x);
  out[offset + 8] = 1 - 2 * (x * x + y * y);
}
