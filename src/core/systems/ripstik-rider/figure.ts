import type { Vec3 } from '../../geometry/vectors.ts';

/**
 * The measures of the figure that is drawn, and where its legs are: feet that stand on the plates, hips that go down and turn, and
 * knees between them. Legs have no mass of their own, so they are no bodies.
 */

/** Height of the centre of mass over the soles (m) at which the measures below are in metres. */
const MEASURED_AT = 0.875;
/** To the side of the body by a foot's share of the stance or in metres, to its back, above the soles: where crouch and twist are 0. */
const HIP = [0.09, 0.09, 0.79] as const;
const KNEE = [0.92, -0.13, 0.43] as const;
const ANKLE = [1, 0.03, 0.09] as const;
/** How much of a turn of the hips the knees make. */
const KNEES_TURN = 0.5;

/** Pieces of the legs in the order of their poses. */
export const LIMBS = ['front-thigh', 'front-shank', 'back-thigh', 'back-shank'] as const;

export interface Figure {
  /** Metres in a measured metre. */
  scale: number;
  /** The soles, in the standing rider's own axes (m). */
  sole: number;
  /** Of each leg. */
  thigh: number;
  shank: number;
  /** By side: hip in the axes of the hips, ankle and the way the knee points in the rider's, where crouch is 0. */
  legs: readonly { hip: Vec3; ankle: Vec3; knee: Vec3 }[];
}

/**
 * @param height of the centre of mass above the rod's centre, m
 * @param stance from the middle to each foot, m
 * @param thickness of the plates, m
 */
export function figureOf(height: number, stance: number, thickness: number): Figure {
  const sole = thickness / 2 - height;
  const scale = Math.max(-sole, 0.1 * height) / MEASURED_AT;
  const legs = [1, -1].map((side) => {
    const at = (x: number, [, y, z]: readonly [number, number, number]): Vec3 => [
      side * x,
      scale * y,
      sole + scale * z,
    ];
    return { hip: at(scale * HIP[0], HIP), knee: at(KNEE[0] * stance, KNEE), ankle: at(ANKLE[0] * stance, ANKLE) };
  });
  const { hip, knee, ankle } = legs[0]!;
  return { scale, sole, legs, thigh: distance(hip, knee), shank: distance(knee, ankle) };
}

const distance = (a: Vec3, b: Vec3): number => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);

/**
 * Puts both legs' pieces behind the bodies' poses: a piece's z points to its upper end, where its origin is.
 *
 * @param figure that stands so
 * @param height of the centre of mass above the rod's centre where crouch is 0, m
 * @param poses 12 numbers each
 * @param bodies indices of the rod, the rider, in whose axes the feet stand, and what the hips turn
 */
export function placeLegs(
  { legs, thigh, shank }: Figure,
  height: number,
  poses: Float64Array,
  [rod, rider, torso]: readonly [rod: number, rider: number, torso: number],
): void {
  const [r, t] = [12 * rider, 12 * torso];
  let [above, c, s] = [0, 0, 0];
  for (let i = 0; i < 3; i++) {
    const row = 3 + 3 * i;
    above += (poses[r + i]! - poses[12 * rod + i]!) * poses[r + row + 2]!;
    c += poses[r + row]! * poses[t + row]!;
    s += poses[r + row + 1]! * poses[t + row]!;
  }
  const [crouch, twist] = [height - above, Math.atan2(s, c)];
  legs.forEach((leg, side) => {
    const hip = turned(leg.hip, twist);
    const ankle: Vec3 = [leg.ankle[0], leg.ankle[1], leg.ankle[2] + crouch];
    const down = minus(ankle, hip);
    const far = Math.hypot(...down);
    const u = scaled(down, 1 / far);
    const reach = Math.min(far, thigh + shank);
    const share = (thigh * thigh - shank * shank + reach * reach) / (2 * reach);
    const bend = Math.sqrt(Math.max(0, thigh * thigh - share * share));
    // Knees point where they do while standing, as far as that is across the line from hip to ankle.
    const way = turned(minus(leg.knee, scaled(plus(leg.hip, leg.ankle), 0.5)), KNEES_TURN * twist);
    const across = minus(way, scaled(u, way[0] * u[0] + way[1] * u[1] + way[2] * u[2]));
    const knee = plus(hip, plus(scaled(u, share), scaled(across, bend / Math.hypot(...across))));
    put(poses, rider, torso + 1 + 2 * side, hip, minus(hip, knee));
    put(poses, rider, torso + 2 + 2 * side, knee, minus(knee, ankle));
  });
}

/** A piece by its upper end and the way it points, in the rider's axes. */
function put(poses: Float64Array, rider: number, piece: number, origin: Vec3, way: Vec3): void {
  const z = scaled(way, 1 / Math.hypot(...way));
  const flat = Math.hypot(z[1], z[2]) || 1;
  const y: Vec3 = [0, z[2] / flat, -z[1] / flat];
  const x: Vec3 = [y[1] * z[2] - y[2] * z[1], y[2] * z[0] - y[0] * z[2], y[0] * z[1] - y[1] * z[0]];
  const [from, to] = [12 * rider, 12 * piece];
  for (let i = 0; i < 3; i++) {
    const row = from + 3 + 3 * i;
    const along = (a: Vec3): number => poses[row]! * a[0] + poses[row + 1]! * a[1] + poses[row + 2]! * a[2];
    poses[to + i] = poses[from + i]! + along(origin);
    [x, y, z].forEach((axis, k) => (poses[to + 3 + 3 * i + k] = along(axis)));
  }
}

const plus = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const minus = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const scaled = (a: Vec3, k: number): Vec3 => [k * a[0], k * a[1], k * a[2]];
function turned([x, y, z]: Vec3, angle: number): Vec3 {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return [c * x - s * y, s * x + c * y, z];
}
