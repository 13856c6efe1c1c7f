import type { Dimensions } from './dimensions.ts';
import { circle, convexHull, plateOf, type ProfilePoint, type Triangle, turned } from '../../../geometry/shapes.ts';
import { add, alongY, mix, type Placement, place, scale, steps, upright } from '../../../geometry/vectors.ts';
import type { Body, Part } from '../../../geometry/wavefront.ts';

const tyreSegments = 36;
const spokes = 5;

/** Proportions of the wheel as fractions of its radius. */
const wheel = { halfWidth: 0.3, rimOuter: 0.64, rimInner: 0.56, coreOuter: 0.3, bearing: 0.23, bore: 0.12 };

/**
 * One model serves both ends: turntable, fork and wheel, standing on the origin.
 *
 * @param d dimensions, m
 */
export function casterBody(d: Dimensions): Body {
  return {
    name: 'caster',
    about:
      'Caster of the board: origin at the skate point, steering axis along z; group "wheel" turns about y through the hub.',
    parts: [...forkParts(d), ...wheelParts(d)],
  };
}

function forkParts(d: Dimensions): Part[] {
  const { radius, half, lift } = d.crown;
  const crown = upright(add(d.pivot, [0, 0, lift]));
  const race: ProfilePoint[] = [
    [0, -half],
    [0.86 * radius, -half],
    [radius, -0.5 * half],
    [radius, 0.25 * half],
    [0.93 * radius, 0.4 * half],
  ];
  const gap: ProfilePoint[] = [
    [0.93 * radius, 0.4 * half],
    [0.86 * radius, 0.4 * half],
    [0.86 * radius, 0.7 * half],
  ];
  const cap: ProfilePoint[] = [
    [0.86 * radius, 0.7 * half],
    [0.97 * radius, 0.7 * half],
    [0.97 * radius, half],
    [0, half],
  ];
  const bolt = boltProfile(d);
  const axle = alongY(d.hub, d.up);
  return [
    {
      group: 'fork',
      material: 'steel',
      triangles: [...turned(race, 24, crown), ...turned(cap, 24, crown), ...arm(d, 1), ...arm(d, -1)],
    },
    { group: 'fork', material: 'seal', triangles: turned(gap, 24, crown) },
    { group: 'fork', material: 'steel', triangles: turned(bolt, 6, axle), crease: 20 },
  ];
}

/** Distances of the arms from the wheel's mid plane. */
const armInner = (R: number): number => 0.37 * R;
const armOuter = (R: number): number => 0.47 * R;

/**
 * A swept side plate: wide under the crown, round about the axle (the hull of both), with a narrower
 * pressed rib on its outside.
 */
function arm(d: Dimensions, side: 1 | -1): Triangle[] {
  const R = d.wheelRadius;
  // In the plane's own axes (first along x, second downwards) the normal is +y.
  const frame: Placement = { origin: [0, 0, 0], ex: [1, 0, 0], ey: [0, 0, -1], ez: [0, 1, 0] };
  const outline = armOutline(d, 1);
  const rib = armOutline(d, 0.62);
  const between = (a: number, b: number, polygon: typeof outline) =>
    plateOf(polygon, Math.min(side * a, side * b), Math.max(side * a, side * b), 0.03 * R, frame);
  return [...between(armInner(R), armOuter(R), outline), ...between(0.46 * R, 0.515 * R, rib)];
}

function armOutline(d: Dimensions, part: number) {
  const R = d.wheelRadius;
  const [x, z] = [d.pivot[0], d.pivot[2] + d.crown.lift];
  const chord = 0.62 * d.crown.radius * part;
  return convexHull([
    ...circle(d.hub[0], -d.hub[2], 0.29 * R * part, 16),
    ...circle(x, -(z - 0.45 * d.crown.radius), 0.55 * d.crown.radius * part, 12),
    ...(part === 1
      ? ([
          [x - chord, -z],
          [x + chord, -z],
        ] as const)
      : []),
  ]);
}

/** The axle with its two hexagon heads. */
function boltProfile(d: Dimensions): ProfilePoint[] {
  const R = d.wheelRadius;
  const [head, shaft] = [0.15 * R, 0.1 * R];
  const [seat, end] = [0.5 * R, 0.6 * R];
  return [
    [0, -end],
    [head, -end],
    [head, -seat],
    [shaft, -seat],
    [shaft, seat],
    [head, seat],
    [head, end],
    [0, end],
  ];
}

function wheelParts(d: Dimensions): Part[] {
  const R = d.wheelRadius;
  // Turning starts at the point of contact, so the tyre has a vertex exactly on the origin.
  const axle = alongY(d.hub, scale(d.up, -1));
  const body = (profile: readonly ProfilePoint[], segments: number) => turned(scaled(profile, R), segments, axle);
  const part = (material: Part['material'], triangles: Triangle[], crease?: number): Part => ({
    group: 'wheel',
    material,
    triangles,
    ...(crease ? { crease } : {}),
  });
  const w = wheel.halfWidth;
  const { rimInner, rimOuter, coreOuter, bearing, bore } = wheel;
  const rim: ProfilePoint[] = [
    [rimInner, 0.8 * w],
    [rimInner, -0.8 * w],
    [rimOuter, -0.86 * w],
  ];
  const rimBack: ProfilePoint[] = [
    [rimOuter, 0.86 * w],
    [rimInner, 0.8 * w],
  ];
  const core: ProfilePoint[] = [
    [bearing, -0.92 * w],
    [coreOuter, -0.86 * w],
    [coreOuter, 0.86 * w],
    [bearing, 0.92 * w],
  ];
  const seal = (side: number): ProfilePoint[] =>
    ordered(
      [
        [0.9 * bearing, side * 0.9 * w],
        [0.62 * bearing, side * 0.9 * w],
      ],
      side,
    );
  const ring = (side: number): ProfilePoint[] =>
    ordered(
      [
        [bearing, side * 0.92 * w],
        [bearing, side * w],
        [0.9 * bearing, side * w],
        [0.9 * bearing, side * 0.9 * w],
      ],
      side,
    );
  const spacer = (side: number): ProfilePoint[] =>
    ordered(
      [
        [0.62 * bearing, side * 0.9 * w],
        [0.62 * bearing, side * w],
        [bore * 0.6, side * w],
      ],
      side,
    );
  return [
    ...tyre(R, axle),
    part('aluminium', [
      ...body(rim, tyreSegments),
      ...body(rimBack, tyreSegments),
      ...body(core, 24),
      ...steps(1, spokes - 1, spokes - 2).flatMap((k) => spoke(k, R, axle)),
    ]),
    // One spoke of another colour, so that even a slow turn is seen.
    part('mark', spoke(0, R, axle)),
    part(
      'steel',
      [1, -1].flatMap((side) => [...body(ring(side), 20), ...body(spacer(side), 16)]),
    ),
    part(
      'seal',
      [1, -1].flatMap((side) => body(seal(side), 20)),
    ),
  ];
}

const scaled = (profile: readonly ProfilePoint[], k: number): ProfilePoint[] =>
  profile.map(([r, h]): ProfilePoint => [k * r, k * h]);

/** Profiles are written for the +y face; the other face runs the other way round. */
const ordered = (profile: ProfilePoint[], side: number): ProfilePoint[] => (side > 0 ? profile : profile.reverse());

/** Tread and shoulders are a super-ellipse of exponent 2.6: rounded, a little flat, widest at the rim. */
function tyreProfile(): ProfilePoint[] {
  const exponent = 2 / 2.6;
  const crown = steps(-Math.PI / 2, Math.PI / 2, 10).map((a, i): ProfilePoint => {
    const [c, s] = [Math.max(0, Math.cos(a)), Math.sin(a)];
    const height = i === 5 ? 0 : Math.sign(s) * Math.abs(s) ** exponent;
    return [i === 5 ? 1 : mix(0.74, 1, c ** exponent), wheel.halfWidth * height];
  });
  return [[wheel.rimOuter, -0.86 * wheel.halfWidth], ...crown, [wheel.rimOuter, 0.86 * wheel.halfWidth]];
}

/** Printed fields on the side walls, two long and one short per turn, out of `tyreSegments`. */
const printed = new Set([2, 3, 4, 5, 6, 14, 15, 16, 17, 18, 27, 28]);

function tyre(R: number, axle: Placement): Part[] {
  const profile = scaled(tyreProfile(), R);
  const sides = [profile.slice(0, 2), profile.slice(-2)];
  const part = (material: Part['material'], triangles: Triangle[]): Part => ({ group: 'wheel', material, triangles });
  const wall = (k: number) => sides.flatMap((side) => turned(side, tyreSegments, axle, k, k + 1));
  const all = steps(0, tyreSegments - 1, tyreSegments - 1);
  return [
    part('urethane', [
      ...turned(profile.slice(1, -1), tyreSegments, axle),
      ...all.filter((k) => !printed.has(k)).flatMap(wall),
    ]),
    part('mark', all.filter((k) => printed.has(k)).flatMap(wall)),
  ];
}

/** A tapered bar from core to rim, both ends let into the metal. */
function spoke(index: number, R: number, axle: Placement): Triangle[] {
  const angle = (2 * Math.PI * index) / spokes;
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const local: Placement = {
    origin: axle.origin,
    ex: place({ ...axle, origin: [0, 0, 0] }, c, s, 0),
    ey: place({ ...axle, origin: [0, 0, 0] }, -s, c, 0),
    ez: axle.ez,
  };
  const [from, to] = [0.96 * wheel.coreOuter * R, 1.03 * wheel.rimInner * R];
  const thick = 0.62 * wheel.halfWidth * R;
  return plateOf(
    [
      [from, -0.1 * R],
      [to, -0.065 * R],
      [to, 0.065 * R],
      [from, 0.1 * R],
    ],
    -thick,
    thick,
    0.02 * R,
    local,
  );
}
