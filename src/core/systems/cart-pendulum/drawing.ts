import { growthOf, type Sketch, sizeOf, type Value } from '../../geometry/drawing.ts';
import { ball, box, drum, tube } from '../../geometry/solids.ts';
import { alongY, type Vec3 } from '../../geometry/vectors.ts';
import type { Part } from '../../geometry/wavefront.ts';

/** A rod along x from the pivot to a bob at `length`, at `y`; the bob's volume goes with its mass. */
function pendulum(length: number, bob: number, y: number): Part[] {
  const rod = 0.012 * length;
  const at = (x: number): Vec3 => [x, y, 0];
  return [
    { group: 'rod', material: 'aluminium', triangles: tube(at(0), at(length), rod, 20) },
    { group: 'joint', material: 'steel', triangles: drum(alongY(at(0), [1, 0, 0]), 2.6 * rod, 1.5 * rod, 28) },
    { group: 'bob', material: 'accent', triangles: ball(at(length), bob, 36) },
  ];
}

const PENDULUM = 'Pendulum: origin at its pivot, x along the rod to the bob at its centre of mass.';

/**
 * A cart on a rail, its rod beside it, so that it can fall past the rail.
 *
 * @param p parameters by name, SI
 */
export function draw(p: Value): Sketch {
  const length = sizeOf(p('L', 1));
  const [cart, bob] = [0.12 * length * growthOf(p('m1', 0.3), 0.3), 0.065 * length * growthOf(p('m2', 0.1), 0.1)];
  const [halfLength, halfWidth, wheel] = [1.7 * cart, 0.75 * cart, 0.34 * cart];
  const rail = { top: -0.5 * cart - 1.9 * wheel, half: 4 * length, floor: -1.25 * length };
  const wheels = [1, -1].flatMap((end) =>
    [1, -1].map((side): Vec3 => [end * 0.68 * halfLength, side * 0.55 * halfWidth, rail.top + wheel]),
  );
  const posts = Array.from({ length: 9 }, (_, k) => (k - 4) * 0.95 * length);
  const beside = -halfWidth - bob;
  return {
    bodies: {
      cart: {
        about: 'Cart: origin at the pivot of the pendulum, rail along x.',
        parts: [
          {
            group: 'cart',
            material: 'paint',
            triangles: box(
              [-halfLength, -halfWidth, -0.5 * cart - wheel],
              [halfLength, halfWidth, 0.5 * cart],
              0.06 * cart,
            ),
          },
          {
            group: 'trim',
            material: 'accent',
            triangles: box(
              [-1.004 * halfLength, -1.004 * halfWidth, -0.1 * cart],
              [1.004 * halfLength, 1.004 * halfWidth, 0.1 * cart],
              0.01 * cart,
            ),
          },
          {
            group: 'wheels',
            material: 'grip',
            triangles: wheels.flatMap((at) => drum(alongY(at, [1, 0, 0]), wheel, 0.2 * cart, 28)),
          },
          {
            group: 'pivot',
            material: 'steel',
            triangles: tube([0, 0, 0], [0, beside - 0.02 * length, 0], 0.016 * length, 24),
          },
        ],
      },
      pendulum: { about: PENDULUM, parts: pendulum(length, bob, beside) },
    },
    fixtures: {
      rail: {
        about: 'Rail along X on its posts.',
        parts: [
          {
            group: 'rail',
            material: 'aluminium',
            triangles: box(
              [-rail.half, -0.7 * halfWidth, rail.top - 0.03 * length],
              [rail.half, 0.7 * halfWidth, rail.top],
              0.004 * length,
            ),
          },
          {
            group: 'posts',
            material: 'steel',
            triangles: posts.flatMap((x) =>
              tube([x, 0, rail.floor], [x, 0, rail.top - 0.03 * length], 0.014 * length, 16),
            ),
          },
        ],
      },
    },
    stage: {
      subject: 'cart',
      facing: 'world',
      floor: rail.floor,
      frame: [
        [-0.7 * length, -0.15 * length, -1.05 * length],
        [0.7 * length, 0.15 * length, 1.1 * length],
      ],
    },
  };
}
