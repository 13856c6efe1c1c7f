/**
 * Sine and cosine operation by operation as derivation/trigonometry.py writes them and `tape.ts` does in WebAssembly: every
 * engine gives the same bits.
 *
 * Range reduction by pi/2 in three parts (Cody and Waite) with the rounding carried along, and the polynomials of fdlibm (Sun
 * Microsystems 1993, k_sin.c and k_cos.c). Within 1 ulp up to |x| = 2^20 pi/2.
 */

/** Adding and subtracting it rounds to an integer. */
export const ROUNDER = 1.5 * 2 ** 52;
export const TWO_OVER_PI = 0.6366197723675814;
export const HALF_PI = [1.57079632673412561417, 6.0771005063039659766e-11, 2.02226624879595063154e-21] as const;
export const SINE = [
  -1.66666666666666324348e-1, 8.33333333332248946124e-3, -1.98412698298579493134e-4, 2.75573137070700676789e-6,
  -2.50507602534068634195e-8, 1.58969099521155010221e-10,
] as const;
export const COSINE = [
  4.16666666666666019037e-2, -1.38888888888741095749e-3, 2.48015872894767294178e-5, -2.75573143513906633035e-7,
  2.0875723212981748279e-9, -1.13596475577881948265e-11,
] as const;

/** The sine, or with `ahead` 1 the cosine: the sine a quadrant on. */
function at(x: number, ahead: number): number {
  const k = x * TWO_OVER_PI + ROUNDER - ROUNDER;
  const h = x - k * HALF_PI[0];
  const w = k * HALF_PI[1];
  const r = h - w;
  const t = h - r - w - k * HALF_PI[2];
  const z = r * r;
  const u = 0.5 * z;
  const o = 1 - u;
  const q =
    z * (z * (COSINE[0] + z * (COSINE[1] + z * (COSINE[2] + z * (COSINE[3] + z * (COSINE[4] + z * COSINE[5]))))));
  const s =
    r + (z * r * (SINE[0] + z * (SINE[1] + z * (SINE[2] + z * (SINE[3] + z * (SINE[4] + z * SINE[5]))))) + t * (o + q));
  const c = o + (1 - o - u + (q - s * t));
  // The quadrant, k mod 4: exact for every k.
  const n = k - 4 * Math.floor(k * 0.25);
  if (ahead === 0) return n === 0 ? s : n === 2 ? -s : n === 1 ? c : -c;
  return n === 0 ? c : n === 2 ? -c : n === 1 ? -s : s;
}

export const sine = (x: number): number => at(x, 0);
export const cosine = (x: number): number => at(x, 1);

/**
 * The direction of (x, y), from -pi to pi; 0 of the origin. An approximation of the first octant, put right twice by its own
 * sine and cosine, so that every engine gives the same bits; within 2 ulp.
 *
 * @param y across
 * @param x ahead
 */
export function direction(y: number, x: number): number {
  const [across, ahead] = [Math.abs(y), Math.abs(x)];
  const steep = across > ahead;
  const most = steep ? across : ahead;
  if (most === 0) return 0;
  const slope = (steep ? ahead : across) / most;
  let angle = slope * (0.9724 - 0.1919 * slope * slope);
  for (let k = 0; k < 2; k++) {
    const [s, c] = [sine(angle), cosine(angle)];
    // The tangent of what is missing.
    const off = (slope * c - s) / (c + slope * s);
    angle += off - (off * off * off) / 3;
  }
  if (steep) angle = Math.PI / 2 - angle;
  if (x < 0) angle = Math.PI - angle;
  return y < 0 ? -angle : angle;
}
