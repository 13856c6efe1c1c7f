/** Rotations (3 x 3, row by row) and vectors as plain arrays: what a joint tree is made of. */

export type V3 = [number, number, number];

/** A rigid place: `R` from the body's axes to the world's. */
export interface Pose {
  p: V3;
  R: number[];
}

/** A twist about the world's origin: angular velocity, and velocity of the point that is there. */
export interface Twist {
  omega: V3;
  v: V3;
}

export const cross = (a: V3, b: V3): V3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const dot = (a: V3, b: V3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const add = (a: V3, b: V3, scale = 1): V3 => [a[0] + scale * b[0], a[1] + scale * b[1], a[2] + scale * b[2]];
export const norm = (a: V3): number => Math.hypot(...a);

/** R x. */
export const apply = (R: readonly number[], x: V3): V3 =>
  [0, 3, 6].map((k) => R[k]! * x[0] + R[k + 1]! * x[1] + R[k + 2]! * x[2]) as V3;

/** R^T x. */
export const applyInverse = (R: readonly number[], x: V3): V3 =>
  [0, 1, 2].map((k) => R[k]! * x[0] + R[k + 3]! * x[1] + R[k + 6]! * x[2]) as V3;

/** A^T B. */
export const between = (A: readonly number[], B: readonly number[]): number[] =>
  Array.from({ length: 9 }, (_, k) => {
    const [i, j] = [Math.floor(k / 3), k % 3];
    return A[i]! * B[j]! + A[i + 3]! * B[j + 3]! + A[i + 6]! * B[j + 6]!;
  });

/**
 * A pose moved along a unit twist (Rodrigues' formula).
 *
 * @param by rad about it, or m along it where it does not turn
 */
export function moved({ p, R }: Pose, { omega, v }: Twist, by: number): Pose {
  if (norm(omega) < 0.5) return { p: add(p, v, by), R };
  const [s, c] = [Math.sin(by), 1 - Math.cos(by)];
  const turned = (x: V3): V3 => {
    const once = cross(omega, x);
    return add(add(x, once, s), cross(omega, once), c);
  };
  const centre = cross(omega, v);
  const columns = [0, 1, 2].map((k) => turned([R[k]!, R[k + 3]!, R[k + 6]!]));
  return { p: add(centre, turned(add(p, centre, -1))), R: [0, 1, 2].flatMap((k) => columns.map((x) => x[k]!)) };
}

/**
 * Unit quaternion (w, x, y, z) of a rotation, w not negative (S. W. Shepperd, J. Guidance and Control 1 (1978) 223).
 *
 * @param R 3 x 3
 */
export function quaternionOf(R: readonly number[]): [number, number, number, number] {
  const [xx, yy, zz] = [R[0]!, R[4]!, R[8]!];
  const squares = [1 + xx + yy + zz, 1 + xx - yy - zz, 1 - xx + yy - zz, 1 - xx - yy + zz];
  const k = squares.indexOf(Math.max(...squares));
  const [x, y, z] = [R[7]! - R[5]!, R[2]! - R[6]!, R[3]! - R[1]!];
  const [xy, xz, yz] = [R[3]! + R[1]!, R[6]! + R[2]!, R[7]! + R[5]!];
  const rows = [
    [squares[0]!, x, y, z],
    [x, squares[1]!, xy, xz],
    [y, xy, squares[2]!, yz],
    [z, xz, yz, squares[3]!],
  ];
  const size = 2 * Math.sqrt(squares[k]!);
  const q = rows[k]!.map((c) => (c! / size) * (rows[k]![0]! < 0 ? -1 : 1));
  return q as [number, number, number, number];
}

/**
 * Moments and axes of a symmetric matrix by Jacobi's rotations (Golub and Van Loan, Matrix Computations, 4th ed., section 8.5):
 * I = R diag(moments) R^T, R a rotation.
 *
 * @param I 3 x 3, symmetric
 */
export function principalAxes(I: readonly number[]): { moments: V3; R: number[] } {
  const A = [...I];
  let R = [1, 0, 0, 0, 1, 0, 0, 0, 1];
  for (let sweep = 0; sweep < 20; sweep++)
    for (const [i, j] of [
      [0, 1],
      [0, 2],
      [1, 2],
    ] as const) {
      const off = A[3 * i + j]!;
      if (off === 0) continue;
      const tau = (A[4 * j]! - A[4 * i]!) / (2 * off);
      const t = (tau < 0 ? -1 : 1) / (Math.abs(tau) + Math.hypot(1, tau));
      const c = 1 / Math.hypot(1, t);
      const s = t * c;
      const k = 3 - i - j;
      const [ki, kj] = [A[3 * k + i]!, A[3 * k + j]!];
      A[4 * i]! -= t * off;
      A[4 * j]! += t * off;
      A[3 * i + j] = A[3 * j + i] = 0;
      A[3 * k + i] = A[3 * i + k] = c * ki - s * kj;
      A[3 * k + j] = A[3 * j + k] = s * ki + c * kj;
      R = R.map((x, at) => {
        const row = at - (at % 3);
        if (at % 3 === i) return c * x - s * R[row + j]!;
        return at % 3 === j ? s * R[row + i]! + c * x : x;
      });
    }
  return { moments: [A[0]!, A[4]!, A[8]!], R };
}
