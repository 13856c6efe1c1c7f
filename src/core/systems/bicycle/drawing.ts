import { type Sketch, sizeOf, type Value } from '../../geometry/drawing.ts';
import { ball, box, drum, moved, pipe, tube } from '../../geometry/solids.ts';
import type { Triangle } from '../../geometry/shapes.ts';
import { add, alongY, mixPoints, scale, type Vec3 } from '../../geometry/vectors.ts';
import type { Part } from '../../geometry/wavefront.ts';
import { spokedWheel } from '../../geometry/wheels.ts';

/** Points of the upright bicycle (m): x forward from the rear contact, y to the left, z up from the ground. */
interface Layout {
  /** Wheelbase: frame and rider grow with it. */
  w: number;
  rear: Vec3;
  front: Vec3;
  /** A point of the steering axis at a height. */
  axis(height: number): Vec3;
  bracket: Vec3;
  saddle: Vec3;
  crown: Vec3;
  head: Vec3;
  bar: Vec3;
}

function layoutOf(p: Value): Layout {
  const w = sizeOf(p('wheelbase', 1.02));
  const [rear, front] = [sizeOf(p('rearRadius', 0.3)), sizeOf(p('frontRadius', 0.35))];
  const slope = Math.tan(p('steerAxisTilt', Math.PI / 10));
  const foot = w + p('trail', 0.08);
  const axis = (height: number): Vec3 => [foot - height * slope, 0, height];
  const crown = 2 * front + 0.05 * w;
  return {
    w,
    axis,
    rear: [0, 0, rear],
    front: [w, 0, front],
    bracket: [0.43 * w, 0, 0.27 * w],
    saddle: [0.24 * w, 0, Math.max(0.88 * w, 2 * rear + 0.2 * w)],
    crown: axis(crown),
    head: axis(crown + 0.15 * w),
    bar: axis(crown + 0.25 * w),
  };
}

const beside = (point: Vec3, y: number): Vec3 => [point[0], point[1] + y, point[2]];
const both = (make: (side: 1 | -1) => Triangle[]): Triangle[] => [...make(1), ...make(-1)];

/** Tubes, saddle and chain set. */
function frameParts(l: Layout): Part[] {
  const { w, rear, bracket, saddle, crown, head } = l;
  const [thick, thin, width] = [0.017 * w, 0.009 * w, 0.06 * w];
  const seat = mixPoints(bracket, saddle, 0.86);
  const collar = mixPoints(crown, head, 0.12);
  const axle = alongY(bracket, [1, 0, 0]);
  return [
    {
      group: 'frame',
      material: 'accent',
      triangles: [
        ...pipe([collar, bracket, mixPoints(bracket, seat, 0.96)], thick),
        ...pipe([seat, mixPoints(crown, head, 0.88)], thick),
        ...tube(collar, head, 1.35 * thick),
        ...both((side) => pipe([beside(bracket, side * 0.3 * width), beside(rear, side * width), seat], thin)),
      ],
    },
    {
      group: 'saddle',
      material: 'grip',
      triangles: [
        ...moved(box([-0.13 * w, -0.06 * w, 0], [0.03 * w, 0.06 * w, 0.04 * w], 0.02 * w), saddle),
        ...moved(box([0, -0.022 * w, 0], [0.14 * w, 0.022 * w, 0.035 * w], 0.01 * w), saddle),
      ],
    },
    {
      group: 'cranks',
      material: 'steel',
      triangles: [
        ...tube(seat, saddle, 0.7 * thick),
        ...drum({ ...axle, origin: beside(bracket, -0.045 * w) }, 0.085 * w, 0.004 * w, 40),
        ...tube(beside(bracket, -0.07 * w), beside(bracket, 0.07 * w), thick),
        ...both((side) => tube(beside(bracket, side * 0.07 * w), pedal(l, side), thin)),
      ],
    },
  ];
}

/** The right pedal is ahead, the left one behind. */
const pedal = ({ w, bracket }: Layout, side: 1 | -1): Vec3 =>
  add(bracket, [-side * 0.15 * w, side * 0.09 * w, -0.04 * w]);

/** A figure of tubes and balls on the saddle; it belongs to the rear frame, so its hands rest near the bar, not on it. */
const riderParts = (l: Layout): Part[] => [...legs(l), ...upperBody(l)];

const hipOf = ({ w, saddle }: Layout): Vec3 => add(saddle, [-0.02 * w, 0, 0.1 * w]);

const limb = (points: readonly Vec3[], from: number, to: number): Triangle[] =>
  points.slice(1).flatMap((point, i) => {
    const thickness = (k: number): number => from + ((to - from) * k) / (points.length - 1);
    return [...tube(points[i]!, point, thickness(i), 14, thickness(i + 1)), ...ball(point, thickness(i + 1), 14)];
  });

function legs(l: Layout): Part[] {
  const { w } = l;
  const hip = hipOf(l);
  const leg = (side: 1 | -1): Triangle[] => {
    const start = beside(hip, side * 0.085 * w);
    const foot = add(pedal(l, side), [-0.02 * w, 0, 0.05 * w]);
    const knee = add(mixPoints(start, foot, 0.48), [0.17 * w + (side < 0 ? 0.02 : 0) * w, side * 0.02 * w, 0.05 * w]);
    return [
      ...ball(start, 0.085 * w, 16),
      ...limb([start, knee, foot], 0.082 * w, 0.042 * w),
      ...tube(add(foot, [-0.06 * w, 0, -0.02 * w]), add(foot, [0.13 * w, 0, -0.025 * w]), 0.035 * w, 14, 0.025 * w),
    ];
  };
  return [{ group: 'rider', material: 'cloth', triangles: both(leg) }];
}

/** Trunk, arms and head. */
function upperBody(l: Layout): Part[] {
  const { w, saddle, bar } = l;
  const hip = hipOf(l);
  const neck = add(saddle, [0.27 * w, 0, 0.56 * w]);
  const arm = (side: 1 | -1): Triangle[] => {
    const shoulder = beside(add(neck, [-0.02 * w, 0, -0.06 * w]), side * 0.17 * w);
    const hand = add(bar, [-0.14 * w, side * 0.25 * w, 0.045 * w]);
    const elbow = add(mixPoints(shoulder, hand, 0.5), [-0.04 * w, side * 0.05 * w, -0.05 * w]);
    return [...ball(shoulder, 0.058 * w, 16), ...limb([shoulder, elbow, hand], 0.055 * w, 0.033 * w)];
  };
  return [
    {
      group: 'rider',
      material: 'cloth',
      triangles: [
        ...tube(add(hip, [0, 0, -0.03 * w]), add(neck, [-0.02 * w, 0, -0.04 * w]), 0.12 * w, 22, 0.135 * w),
        ...ball(hip, 0.125 * w, 24),
        ...ball(add(neck, [-0.035 * w, 0, -0.06 * w]), 0.132 * w, 24),
        ...both(arm),
      ],
    },
    {
      group: 'rider',
      material: 'paint',
      triangles: [
        ...tube(add(neck, [-0.01 * w, 0, 0]), add(neck, [0.03 * w, 0, 0.12 * w]), 0.05 * w),
        ...ball(add(neck, [0.05 * w, 0, 0.2 * w]), 0.105 * w, 28),
      ],
    },
  ];
}

/** Fork, stem and handlebar. */
function forkParts(l: Layout): Part[] {
  const { w, front, crown, head, bar } = l;
  const [thick, width] = [0.013 * w, 0.055 * w];
  const grip = (side: 1 | -1): [Vec3, Vec3] => [
    add(bar, [-0.06 * w, side * 0.24 * w, 0.01 * w]),
    add(bar, [-0.17 * w, side * 0.27 * w, 0]),
  ];
  return [
    {
      group: 'fork',
      material: 'accent-front',
      triangles: [
        ...both((side) =>
          pipe(
            [
              beside(front, side * width),
              beside(mixPoints(front, crown, 0.8), side * width),
              beside(crown, side * 0.3 * width),
            ],
            thick,
          ),
        ),
        ...tube(beside(crown, -0.5 * width), beside(crown, 0.5 * width), 1.6 * thick),
      ],
    },
    {
      group: 'stem',
      material: 'aluminium',
      triangles: [
        ...tube(mixPoints(crown, head, 0.9), bar, thick),
        ...both((side) =>
          pipe([bar, beside(add(bar, [0.01 * w, 0, 0.02 * w]), side * 0.14 * w), ...grip(side)], 0.8 * thick),
        ),
      ],
    },
    {
      group: 'grips',
      material: 'grip',
      triangles: both((side) => {
        const [from, to] = grip(side);
        return tube(mixPoints(from, to, 0.15), to, 1.25 * thick);
      }),
    },
    {
      group: 'axle',
      material: 'steel',
      triangles: tube(beside(front, -1.3 * width), beside(front, 1.3 * width), 0.7 * thick),
    },
  ];
}

const shifted = (parts: readonly Part[], origin: Vec3): Part[] =>
  parts.map((part) => ({ ...part, triangles: moved(part.triangles, scale(origin, -1)) }));

/**
 * A bicycle with its rider: two wheels, frame, fork. Both frames are drawn as they stand upright with the steer at zero,
 * x forward and z up: the rear one from the rear hub, the front one from the front hub.
 *
 * @param p parameters by name, SI
 */
export function draw(p: Value): Sketch {
  return drawn(p, riderParts);
}

/**
 * The same with a rider of whom only the legs belong to the rear frame.
 *
 * @param p parameters by name, SI
 * @param hinge height of the axis that the upper body leans about, above the ground (m)
 */
export function drawLeaning(p: Value, hinge: number): Sketch {
  const sketch = drawn(p, legs);
  const rider = {
    about: 'Upper body: origin on the axis it leans about, x forward.',
    parts: shifted(upperBody(layoutOf(p)), [0, 0, hinge]),
  };
  return { ...sketch, bodies: { ...sketch.bodies, rider } };
}

/** @param riding what of the rider belongs to the rear frame */
function drawn(p: Value, riding: (l: Layout) => Part[]): Sketch {
  const layout = layoutOf(p);
  const wheel = (radius: number): Part[] =>
    spokedWheel({ radius, halfWidth: 0.018 * layout.w, spokes: 16, spokeRadius: 0.003 * layout.w });
  return {
    bodies: {
      'rear-wheel': { about: 'Rear wheel: origin at the hub, axle along y.', parts: wheel(layout.rear[2]) },
      'rear-frame': {
        about: 'Rear frame with its rider.',
        parts: shifted([...frameParts(layout), ...riding(layout)], layout.rear),
      },
      'front-frame': { about: 'Front frame: fork and handlebar.', parts: shifted(forkParts(layout), layout.front) },
      'front-wheel': { about: 'Front wheel: origin at the hub, axle along y.', parts: wheel(layout.front[2]) },
    },
    stage: { subject: 'rear-frame' },
  };
}
