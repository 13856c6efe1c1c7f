import { growthOf, type Sketch, sizeOf, type Value } from '../../geometry/drawing.ts';
import { along, ball, drum, link, tube } from '../../geometry/solids.ts';
import { alongY } from '../../geometry/vectors.ts';
import type { Part } from '../../geometry/wavefront.ts';
import { spokedWheel } from '../../geometry/wheels.ts';

/** A plate on the roll axis, with its weight on a rod of length `length` above it. */
function arm(half: number, length: number, weight: number): Part[] {
  const [long, wide, thick] = [0.42 * half, 0.3 * half, 0.05 * half];
  return [
    {
      group: 'plate',
      material: 'deck-rubber',
      triangles: link([-long, 0], [long, 0], wide, 0.1 * half, 0.1 * half + thick),
    },
    { group: 'joint', material: 'steel', triangles: drum(along([1, 0, 0], [0, 0, 0]), 0.11 * half, 0.3 * half, 28) },
    { group: 'arm', material: 'aluminium', triangles: tube([0, 0, 0.1 * half], [0, 0, length], 0.045 * half, 18) },
    { group: 'weight', material: 'accent', triangles: ball([0, 0, length], weight, 28) },
  ];
}

/** A caster standing on the origin, its fork reaching up to the roll axis at `height`. */
function caster(height: number): Part[] {
  const radius = 0.36 * height;
  const hub = [0, 0, radius] as const;
  return [
    ...spokedWheel({
      radius,
      halfWidth: 0.28 * radius,
      spokes: 5,
      spokeRadius: 0.06 * radius,
      tyre: 'urethane',
      marked: 'urethane',
      hub,
    }),
    {
      group: 'fork',
      material: 'accent',
      triangles: [
        ...[1, -1].flatMap((side) =>
          tube([0, side * 0.45 * radius, radius], [0, side * 0.3 * radius, 2.2 * radius], 0.1 * radius, 12),
        ),
        ...drum(alongY(hub, [1, 0, 0]), 0.12 * radius, 0.55 * radius, 16),
        ...tube([0, 0, 2.1 * radius], [0, 0, 0.95 * height], 0.36 * radius, 24),
      ],
    },
  ];
}

/**
 * Two plates with weights on one roll axis, a caster under each; the axis lies at half of l1.
 *
 * @param p parameters by name, SI
 */
export function draw(p: Value): Sketch {
  const [half, length] = [sizeOf(p('l1', 0.095)), sizeOf(p('l2', 0.115))];
  const weight = 0.2 * half * growthOf(p('m2', 0.29), 0.29);
  return {
    bodies: {
      body: {
        about: 'Body: origin at its centre, roll axis along x.',
        parts: [{ group: 'bar', material: 'aluminium', triangles: tube([-half, 0, 0], [half, 0, 0], 0.07 * half, 24) }],
      },
      'front-arm': {
        about: 'Front plate and its weight: origin on the roll axis, weight along z.',
        parts: arm(half, length, weight),
      },
      'rear-arm': {
        about: 'Rear plate and its weight: origin on the roll axis, weight along z.',
        parts: arm(half, length, weight),
      },
      'front-wheel': {
        about: 'Front caster: origin where it touches the ground, axle along y.',
        parts: caster(half / 2),
      },
      'rear-wheel': {
        about: 'Rear caster: origin where it touches the ground, axle along y.',
        parts: caster(half / 2),
      },
    },
    stage: { subject: 'body' },
  };
}
