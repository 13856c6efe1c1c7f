import { clamp, type Placement, place, type Vec3 } from './vectors.ts';

/** Counter-clockwise seen from outside. */
export type Triangle = readonly [Vec3, Vec3, Vec3];

/**
 * The skin over rows of points; every row has as many points.
 * Outside is where (direction along a row) x (direction from row to row) points.
 *
 * @param rows points, m, as many in every row
 */
export function skin(rows: readonly (readonly Vec3[])[]): Triangle[] {
  const triangles: Triangle[] = [];
  rows.slice(1).forEach((next, i) => {
    const row = rows[i] ?? [];
    for (let j = 0; j + 1 < row.length; j++) {
      const [a, b, c, d] = [row[j], row[j + 1], next[j + 1], next[j]];
      if (a && b && c && d) triangles.push([a, b, c], [a, c, d]);
    }
  });
  return triangles;
}

export const flipped = (triangles: readonly Triangle[]): Triangle[] =>
  triangles.map(([a, b, c]): Triangle => [a, c, b]);

/**
 * A convex polygon, seen counter-clockwise from outside, as a fan.
 *
 * @param polygon its corners, m
 */
export function fan(polygon: readonly Vec3[]): Triangle[] {
  const [first, ...rest] = polygon;
  return rest.slice(1).flatMap((c, i): Triangle[] => {
    const b = rest[i];
    return first && b ? [[first, b, c]] : [];
  });
}

/** [radius, height] along the axis. */
export type ProfilePoint = readonly [number, number];

/**
 * A profile turned about the placement's z axis; `from` and `to` in segments of the whole turn.
 * Outside lies to the right of the profile's direction when height points up:
 * out along the bottom, up, and back in along the top makes a solid.
 *
 * @param profile [radius, height], m
 * @param segments of a whole turn
 * @param placement origin, m, and axes
 * @param from first segment
 * @param to last segment
 */
export function turned(
  profile: readonly ProfilePoint[],
  segments: number,
  placement: Placement,
  from = 0,
  to = segments,
): Triangle[] {
  const rows = profile.map(([radius, height]) =>
    Array.from({ length: to - from + 1 }, (_, k) => {
      // Whole turns end on the very point they began with.
      const angle = (2 * Math.PI * ((from + k) % segments)) / segments;
      return place(placement, radius * Math.cos(angle), radius * Math.sin(angle), height);
    }),
  );
  return skin(rows);
}

export type PlanePoint = readonly [number, number];

/**
 * A convex polygon (counter-clockwise in the placement's x, y) made a plate between two heights, edges chamfered.
 *
 * @param polygon its corners, m
 * @param low m
 * @param high m
 * @param chamfer m
 * @param placement origin, m, and axes
 */
export function plateOf(
  polygon: readonly PlanePoint[],
  low: number,
  high: number,
  chamfer: number,
  placement: Placement,
): Triangle[] {
  const small = towardsCentre(polygon, chamfer);
  const edge = Math.min(chamfer, 0.4 * (high - low));
  const ring = (points: readonly PlanePoint[], height: number): Vec3[] =>
    [...points, ...points.slice(0, 1)].map(([x, y]) => place(placement, x, y, height));
  const walls = skin([ring(small, low), ring(polygon, low + edge), ring(polygon, high - edge), ring(small, high)]);
  return [...walls, ...fan(ring(small, high).slice(0, -1)), ...flipped(fan(ring(small, low).slice(0, -1)))];
}

function towardsCentre(polygon: readonly PlanePoint[], distance: number): PlanePoint[] {
  const centreX = polygon.reduce((sum, p) => sum + p[0], 0) / polygon.length;
  const centreY = polygon.reduce((sum, p) => sum + p[1], 0) / polygon.length;
  return polygon.map(([x, y]) => {
    const reach = Math.hypot(x - centreX, y - centreY);
    const k = reach > 0 ? 1 - clamp(distance / reach, 0, 0.5) : 1;
    return [centreX + k * (x - centreX), centreY + k * (y - centreY)];
  });
}

/**
 * Andrew's monotone chain: the convex hull, counter-clockwise.
 *
 * @param points in the plane, m
 */
export function convexHull(points: readonly PlanePoint[]): PlanePoint[] {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const half = (list: readonly PlanePoint[]): PlanePoint[] => {
    const chain: PlanePoint[] = [];
    for (const p of list) {
      while (chain.length > 1 && !turnsLeft(chain[chain.length - 2]!, chain[chain.length - 1]!, p)) chain.pop();
      chain.push(p);
    }
    return chain.slice(0, -1);
  };
  return [...half(sorted), ...half(sorted.reverse())];
}

const turnsLeft = (a: PlanePoint, b: PlanePoint, c: PlanePoint): boolean =>
  (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 1e-12;

export const circle = (x: number, y: number, radius: number, segments: number): PlanePoint[] =>
  Array.from({ length: segments }, (_, k) => {
    const angle = (2 * Math.PI * k) / segments;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
  });

/**
 * Monotone cubic interpolation (Fritsch and Carlson 1980, harmonic-mean slopes): between two knots the
 * curve never leaves their range, so an outline keeps the extent that its knots promise.
 *
 * @param knots values at positions 0, 1, 2 and so on
 */
export function monotoneCurve(knots: readonly number[]): (position: number) => number {
  const rise = knots.slice(1).map((y, i) => y - (knots[i] ?? y));
  const slope = knots.map((_, i) => {
    const [before, after] = [rise[i - 1], rise[i]];
    if (before === undefined || after === undefined) return before ?? after ?? 0;
    return before * after > 0 ? (2 * before * after) / (before + after) : 0;
  });
  return (position) => {
    const i = clamp(Math.floor(position), 0, Math.max(0, knots.length - 2));
    const t = position - i;
    const [y0, y1, m0, m1] = [knots[i] ?? 0, knots[i + 1] ?? 0, slope[i] ?? 0, slope[i + 1] ?? 0];
    if (t === 0) return y0;
    if (t === 1) return y1;
    return y0 + t * m0 + t * t * (3 * (y1 - y0) - 2 * m0 - m1) + t * t * t * (2 * (y0 - y1) + m0 + m1);
  };
}
