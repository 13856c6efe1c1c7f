import { type Sketch, sizeOf, type Value } from '../../geometry/drawing.ts';
import { spokedWheel } from '../../geometry/wheels.ts';

/**
 * An upright wheel with a marked spoke.
 *
 * @param p parameters by name, SI
 */
export function draw(p: Value): Sketch {
  const radius = sizeOf(p('rho', 1));
  return {
    bodies: {
      wheel: {
        about: 'Wheel: origin at the hub, axle along y.',
        parts: spokedWheel({
          radius,
          halfWidth: 0.06 * radius,
          spokes: 8,
          spokeRadius: 0.018 * radius,
          marked: 'accent-back',
        }),
      },
    },
    stage: {
      facing: 'axle',
      frame: [
        [-1.4 * radius, -0.7 * radius, -radius],
        [1.4 * radius, 0.7 * radius, 1.1 * radius],
      ],
    },
  };
}
