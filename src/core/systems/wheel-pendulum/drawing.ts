import { growthOf, type Sketch, sizeOf, type Value } from '../../geometry/drawing.ts';
import { tube } from '../../geometry/solids.ts';
import { spokedWheel } from '../../geometry/wheels.ts';

/**
 * A wheel on the ground that carries on its axle a thin rod of length 2 L (its inertia says so), the centre marked.
 *
 * @param p parameters by name, SI
 */
export function draw(p: Value): Sketch {
  const [length, radius] = [sizeOf(p('L', 1)), sizeOf(p('rho', 0.5))];
  const thick = 0.03 * length * growthOf(p('mP', 1), 1);
  const halfWidth = 0.07 * radius;
  const beside = -halfWidth - 1.6 * thick;
  return {
    bodies: {
      wheel: {
        about: 'Wheel: origin at the hub, axle along y.',
        parts: [
          ...spokedWheel({ radius, halfWidth, spokes: 8, spokeRadius: 0.018 * radius, marked: 'accent-back' }),
          {
            group: 'axle',
            material: 'steel',
            triangles: tube([0, 0, 0], [0, beside - 1.4 * thick, 0], 0.6 * thick, 24),
          },
        ],
      },
      pendulum: {
        about: 'Pendulum: origin at the hub, x along the rod.',
        parts: [
          {
            group: 'rod',
            material: 'accent',
            triangles: tube([-0.05 * length, beside, 0], [2 * length, beside, 0], thick, 24),
          },
          {
            group: 'centre',
            material: 'steel',
            triangles: tube([length - 0.6 * thick, beside, 0], [length + 0.6 * thick, beside, 0], 1.25 * thick, 28),
          },
        ],
      },
    },
    stage: {
      subject: 'wheel',
      facing: 'world',
      frame: [
        [-1.1 * length, -0.15 * length, -radius],
        [1.1 * length, 0.15 * length, 2.05 * length],
      ],
    },
  };
}
