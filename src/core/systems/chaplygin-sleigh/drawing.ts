import { type Sketch, sizeOf, type Value } from '../../geometry/drawing.ts';
import { ball, tube, upstanding } from '../../geometry/solids.ts';
import { plateOf } from '../../geometry/shapes.ts';
import { upright } from '../../geometry/vectors.ts';

/**
 * A plate on a blade (the origin) and two smooth feet, its centre of mass `a` ahead of the blade.
 *
 * @param p parameters by name, SI
 */
export function draw(p: Value): Sketch {
  const a = p('a', 0.2);
  const size = sizeOf(a);
  const side = a < 0 ? -1 : 1;
  const [half, height, thick] = [0.55 * size, 0.32 * size, 0.05 * size];
  const front = 1.75 * size * side;
  const outline = [
    [-0.3 * size, -0.22 * half],
    [-0.3 * size, 0.22 * half],
    [1.9 * size, half],
    [1.9 * size, -half],
  ].map(([x = 0, y = 0]) => [side * x, y] as const);
  return {
    bodies: {
      sleigh: {
        about: 'Sleigh: origin where the blade touches the ground, blade along x.',
        parts: [
          {
            group: 'plate',
            material: 'paint',
            triangles: plateOf(
              side > 0 ? [...outline].reverse() : outline,
              height,
              height + thick,
              0.02 * size,
              upright([0, 0, 0]),
            ),
          },
          {
            group: 'blade',
            material: 'accent',
            triangles: upstanding(
              [
                [-0.42 * size, 0],
                [0.42 * size, 0],
                [0.52 * size, 0.08 * size],
                [0.24 * size, height],
                [-0.24 * size, height],
                [-0.52 * size, 0.08 * size],
              ],
              -0.016 * size,
              0.016 * size,
              0.004 * size,
            ),
          },
          {
            group: 'feet',
            material: 'steel',
            triangles: [half, -half].flatMap((y) => [
              ...tube([front, 0.8 * y, 0.06 * size], [front, 0.8 * y, height], 0.04 * size),
              ...ball([front, 0.8 * y, 0.07 * size], 0.07 * size),
            ]),
          },
          { group: 'mass', material: 'mark', triangles: ball([a, 0, height + thick], 0.16 * size) },
        ],
      },
    },
    stage: { facing: 'nose' },
  };
}
