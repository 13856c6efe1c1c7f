import { casterBody } from '../ripstik/drawing/caster.ts';
import { dimensionsOf } from '../ripstik/drawing/dimensions.ts';
import { ripstikMeta } from '../ripstik/meta.ts';
import { type Sketch, type Value, valueOf } from '../../geometry/drawing.ts';
import { along, ball, torus, tube } from '../../geometry/solids.ts';
import { scale, type Vec3 } from '../../geometry/vectors.ts';

/**
 * The board's caster on a bracket: the steering axis, and the circle of radius |casterTrail| that its skate point draws.
 *
 * @param p parameters by name, SI
 */
export function draw(p: Value): Sketch {
  const [angle, trail, drop] = [p('casterAngle'), p('casterTrail'), p('casterDrop')];
  const wheelRadius = p('wheelRadius', 0.04);
  const axis: Vec3 = [Math.sin(angle), 0, Math.cos(angle)];
  const at = (k: number): Vec3 => scale(axis, k);
  const size = Math.max(Math.abs(drop), Math.abs(wheelRadius), 0.01);
  const thin = 0.02 * size;
  const lowest = Math.min(0, -drop * Math.cos(angle)) - Math.abs(trail * Math.sin(angle)) - 2 * thin;
  const reach = Math.abs(trail) + wheelRadius;
  const top = 0.75 * size;
  return {
    bodies: {
      caster: {
        about: 'Caster: origin at the skate point, steering axis along z.',
        parts: casterBody(
          dimensionsOf(valueOf(ripstikMeta, { casterAngle: angle, casterTrail: trail, casterDrop: drop, wheelRadius })),
        ).parts,
      },
    },
    fixtures: {
      axis: {
        about: 'Steering axis through the pivot at the origin, and the circle of the skate point about it.',
        parts: [
          { group: 'axis', material: 'steel', triangles: tube(at(-drop), at(top), thin, 12) },
          { group: 'axis', material: 'paint', triangles: tube(at(top), at(1.15 * top), 0.32 * size, 32) },
          { group: 'pivot', material: 'accent', triangles: ball([0, 0, 0], 2.4 * thin, 20) },
          ...(Math.abs(trail) > 1e-6
            ? [
                {
                  group: 'circle',
                  material: 'accent' as const,
                  triangles: torus(along(axis, at(-drop)), Math.abs(trail), 0.45 * thin, 72),
                },
              ]
            : []),
        ],
      },
    },
    stage: {
      still: true,
      facing: 'world',
      floor: lowest,
      frame: [
        [-reach - 0.5 * Math.abs(drop), -reach, lowest],
        [0.6 * size, reach, 1.1 * top],
      ],
    },
  };
}
