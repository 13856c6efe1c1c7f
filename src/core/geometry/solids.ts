/** The vocabulary that drawings of systems are made of: closed solids of triangles, metres, faces outwards. */
import {
  circle,
  convexHull,
  flipped,
  type PlanePoint,
  plateOf,
  type ProfilePoint,
  type Triangle,
  turned,
} from './shapes.ts';
import { add, cross, length, type Placement, place, scale, steps, subtract, upright, type Vec3 } from './vectors.ts';

/**
 * Local z along a unit axis, at a point.
 *
 * @param axis unit vector
 * @param origin m
 */
export function along(axis: Vec3, origin: Vec3): Placement {
  const helper: Vec3 = Math.abs(axis[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0];
  const across = cross(helper, axis);
  const ex = scale(across, 1 / length(across));
  return { origin, ex, ey: cross(axis, ex), ez: axis };
}

/**
 * Block between two corners, edges bevelled.
 *
 * @param low corner with the smallest coordinates, m
 * @param high corner with the largest coordinates, m
 * @param bevel m
 */
export function box(
  low: Vec3,
  high: Vec3,
  bevel = 0.04 * Math.min(high[0] - low[0], high[1] - low[1], high[2] - low[2]),
): Triangle[] {
  const outline: PlanePoint[] = [
    [low[0], low[1]],
    [high[0], low[1]],
    [high[0], high[1]],
    [low[0], high[1]],
  ];
  return plateOf(outline, low[2], high[2], bevel, upright([0, 0, 0]));
}

/**
 * Round bar from one point to another; nothing where they are one point.
 *
 * @param from m
 * @param to m
 * @param radius at `from`, m
 * @param segments of a whole turn
 * @param endRadius at `to`, m
 */
export function tube(from: Vec3, to: Vec3, radius: number, segments = 16, endRadius = radius): Triangle[] {
  const axis = subtract(to, from);
  const size = length(axis);
  if (!(size > 1e-9)) return [];
  const bevel = Math.min(0.12 * Math.min(radius, endRadius), 0.2 * size);
  const profile: ProfilePoint[] = [
    [0, 0],
    [radius - bevel, 0],
    [radius, bevel],
    [endRadius, size - bevel],
    [endRadius - bevel, size],
    [0, size],
  ];
  return turned(profile, segments, along(scale(axis, 1 / size), from));
}

/**
 * Bars through points, joined by balls of their thickness.
 *
 * @param points m, in order
 * @param radius m
 * @param segments of a whole turn
 */
export function pipe(points: readonly Vec3[], radius: number, segments = 14): Triangle[] {
  const joints = points.slice(1, -1).flatMap((point) => ball(point, radius, segments));
  return [...points.slice(1).flatMap((to, i) => tube(points[i]!, to, radius, segments)), ...joints];
}

/**
 * Ball about a point.
 *
 * @param centre m
 * @param radius m
 * @param segments of a whole turn
 */
export function ball(centre: Vec3, radius: number, segments = 28): Triangle[] {
  const profile = steps(-90, 90, Math.max(6, segments / 2)).map((degrees): ProfilePoint => {
    const angle = (degrees * Math.PI) / 180;
    return [Math.abs(degrees) === 90 ? 0 : radius * Math.cos(angle), radius * Math.sin(angle)];
  });
  return turned(profile, segments, upright(centre));
}

/**
 * Ring of round section about the placement's z.
 *
 * @param placement origin, m, and axes
 * @param radius of the ring's middle, m
 * @param thickness radius of the section, m
 * @param segments of a whole turn
 */
export function torus(placement: Placement, radius: number, thickness: number, segments = 48): Triangle[] {
  const profile = steps(0, 12, 12).map((k): ProfilePoint => {
    const angle = -Math.PI + (2 * Math.PI * (k % 12)) / 12;
    return [radius + thickness * Math.cos(angle), thickness * Math.sin(angle)];
  });
  return turned(profile, segments, placement);
}

/**
 * Straight-sided drum about the placement's z, from -half to half.
 *
 * @param placement origin, m, and axes
 * @param radius m
 * @param half of its length, m
 * @param segments of a whole turn
 */
export function drum(placement: Placement, radius: number, half: number, segments = 32): Triangle[] {
  const from = place(placement, 0, 0, -half);
  const to = place(placement, 0, 0, half);
  return tube(from, to, radius, segments);
}

/**
 * Plate of convex outline in the x-z plane, `from` to `to` in y.
 *
 * @param outline x, z, m
 * @param from m
 * @param to m
 * @param bevel m
 */
export function upstanding(outline: readonly PlanePoint[], from: number, to: number, bevel: number): Triangle[] {
  // Local x, y, z are x, z, -y: the outline keeps its sense seen from the right.
  const placement: Placement = { origin: [0, 0, 0], ex: [1, 0, 0], ey: [0, 0, 1], ez: [0, -1, 0] };
  return plateOf(outline, -to, -from, bevel, placement);
}

/**
 * Flat bar with round ends between two points of the x-y plane at a height.
 *
 * @param from m
 * @param to m
 * @param halfWidth m
 * @param low m
 * @param high m
 */
export function link(from: PlanePoint, to: PlanePoint, halfWidth: number, low: number, high: number): Triangle[] {
  const outline = convexHull([...circle(from[0], from[1], halfWidth, 20), ...circle(to[0], to[1], halfWidth, 20)]);
  return plateOf(outline, low, high, 0.12 * halfWidth, upright([0, 0, 0]));
}

export const moved = (triangles: readonly Triangle[], by: Vec3): Triangle[] =>
  triangles.map(([a, b, c]): Triangle => [add(a, by), add(b, by), add(c, by)]);

/** The mirror image across the x-z plane. */
export const mirrored = (triangles: readonly Triangle[]): Triangle[] => {
  const mirror = ([x, y, z]: Vec3): Vec3 => [x, -y, z];
  return flipped(triangles.map(([a, b, c]): Triangle => [mirror(a), mirror(b), mirror(c)]));
};
