/** Points and directions of the generated meshes, metres. */
export type Vec3 = readonly [number, number, number];

export const add = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (a: Vec3, k: number): Vec3 => [k * a[0], k * a[1], k * a[2]];
export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const length = (a: Vec3): number => Math.sqrt(dot(a, a));
export const mix = (a: number, b: number, k: number): number => a + (b - a) * k;
export const mixPoints = (a: Vec3, b: Vec3, k: number): Vec3 => [
  mix(a[0], b[0], k),
  mix(a[1], b[1], k),
  mix(a[2], b[2], k),
];
export const clamp = (x: number, low: number, high: number): number => Math.min(Math.max(x, low), high);

/**
 * 0 below `from`, 1 above `to`, smooth between.
 *
 * @param from below `to`
 * @param to above `from`
 * @param x in the same units
 */
export function smoothStep(from: number, to: number, x: number): number {
  const k = clamp((x - from) / (to - from), 0, 1);
  return k * k * (3 - 2 * k);
}

/**
 * `count + 1` values from `from` to `to`, both met exactly.
 *
 * @param from the first
 * @param to the last
 * @param count of the steps between
 */
export function steps(from: number, to: number, count: number): number[] {
  return Array.from({ length: count + 1 }, (_, i) => (i === count ? to : from + ((to - from) * i) / count));
}

/** A right-handed placement: local x, y, z become `ex`, `ey`, `ez` at `origin`. */
export interface Placement {
  origin: Vec3;
  ex: Vec3;
  ey: Vec3;
  ez: Vec3;
}

export const place = (p: Placement, x: number, y: number, z: number): Vec3 =>
  add(p.origin, add(scale(p.ex, x), add(scale(p.ey, y), scale(p.ez, z))));

export const upright = (origin: Vec3): Placement => ({ origin, ex: [1, 0, 0], ey: [0, 1, 0], ez: [0, 0, 1] });

/**
 * Local z along the world's y: for everything that turns on an axle. `ex` is a unit vector normal to y.
 *
 * @param origin m
 * @param ex unit vector normal to y
 */
export function alongY(origin: Vec3, ex: Vec3): Placement {
  const ez: Vec3 = [0, 1, 0];
  return { origin, ex, ey: cross(ez, ex), ez };
}
