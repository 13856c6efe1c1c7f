import type { Dimensions } from './dimensions.ts';
import { type ProfilePoint, turned } from '../../../geometry/shapes.ts';
import type { Placement } from '../../../geometry/vectors.ts';
import type { Body } from '../../../geometry/wavefront.ts';

const segments = 24;

/** Local z along the rod: turned profiles run from the back end (-x) to the front end. */
const alongX: Placement = { origin: [0, 0, 0], ex: [0, 1, 0], ey: [0, 0, 1], ez: [1, 0, 0] };

/**
 * The torsion bar: a metal cylinder of the simulated size with a rubber handle let in flush.
 *
 * @param d dimensions, m
 */
export function rodBody(d: Dimensions): Body {
  const half = d.rodLength / 2;
  const inner = d.plateOffset - d.plateLength / 2;
  // What shows between the plates is what the handle is laid out on.
  const visible = inner > 0.2 * half ? Math.min(half, inner) : half;
  const handle = 0.56 * visible;
  return {
    name: 'rod',
    about: 'Rod of the board: torsion bar with padded handle; origin at its centre, axis along x.',
    parts: [
      {
        group: 'bar',
        material: 'aluminium',
        triangles: turned(barProfile(half, handle, d.rodRadius), segments, alongX),
      },
      ...(inner > half
        ? [{ group: 'neck', material: 'aluminium' as const, triangles: neck(half, inner, d.rodRadius) }]
        : []),
      { group: 'handle', material: 'grip', triangles: turned(handleProfile(handle, d.rodRadius), segments, alongX) },
    ],
  };
}

function barProfile(half: number, handle: number, radius: number): ProfilePoint[] {
  const bevel = Math.min(0.08 * radius, 0.1 * half);
  const seat = 0.86 * radius; // under the handle
  return [
    [0, -half],
    [radius - bevel, -half],
    [radius, bevel - half],
    [radius, -handle],
    [seat, -handle],
    [seat, handle],
    [radius, handle],
    [radius, half - bevel],
    [radius - bevel, half],
    [0, half],
  ];
}

/** Rounded ribs; their crests are as thick as the bar. */
function handleProfile(handle: number, radius: number): ProfilePoint[] {
  const ribs = 6;
  const gap = 0.02 * handle;
  const pitch = (2 * (handle - gap)) / ribs;
  const [crest, valley] = [radius, 0.9 * radius];
  const profile: ProfilePoint[] = [[0.86 * radius, gap - handle]];
  for (let rib = 0; rib < ribs; rib++) {
    const start = gap - handle + rib * pitch;
    profile.push([valley, start], [crest, start + 0.22 * pitch], [crest, start + 0.78 * pitch]);
  }
  profile.push([valley, handle - gap], [0.86 * radius, handle - gap]);
  return profile;
}

/** Where the plates are out of the bar's reach, a slim neck joins them. */
function neck(half: number, inner: number, radius: number) {
  const slim = 0.6 * radius;
  return [-1, 1].flatMap((end) => {
    const [low, high] = end < 0 ? [-inner, -half] : [half, inner];
    return turned(
      [
        [0, low],
        [slim, low],
        [slim, high],
        [0, high],
      ],
      16,
      alongX,
    );
  });
}
