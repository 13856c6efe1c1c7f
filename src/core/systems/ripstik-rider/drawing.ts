import { type Sketch, sizeOf, type Value } from '../../geometry/drawing.ts';
import { ball, tube } from '../../geometry/solids.ts';
import type { Triangle } from '../../geometry/shapes.ts';
import type { Vec3 } from '../../geometry/vectors.ts';
import type { Part } from '../../geometry/wavefront.ts';
import { draw as drawBoard } from '../ripstik/drawing.ts';
import { type Figure, figureOf, LIMBS, placeLegs } from './figure.ts';

/**
 * The board, and on it a rider: the shoes are fast on the plates and turn with them under the ankles, which stay where they are
 * at zero roll.
 *
 * @param p parameters by name, SI
 */
export function draw(p: Value): Sketch {
  const board = drawBoard(p);
  const [height, thickness] = [sizeOf(p('riderHeight', 0.9)), sizeOf(p('plateThickness'))];
  const figure = figureOf(height, sizeOf(p('plateOffset', 0.26)), thickness);
  const shod = (name: 'front-plate' | 'back-plate') => {
    const plate = board.bodies[name]!;
    return { ...plate, parts: [...plate.parts, shoe(figure.scale, thickness)] };
  };
  return {
    ...board,
    bodies: {
      ...board.bodies,
      'front-plate': shod('front-plate'),
      'back-plate': shod('back-plate'),
      ...riderBodies(figure),
    },
    limbs: {
      ids: LIMBS,
      place: (poses) => placeLegs(figure, p('riderHeight', 0.9), poses, [0, 5, 6]),
    },
  };
}

const both = (make: (side: 1 | -1) => Triangle[]): Triangle[] => [...make(1), ...make(-1)];

/** On the top of a plate, heel to the left and toes to the right, in the plate's axes; k metres a measured metre. */
function shoe(k: number, thickness: number): Part {
  const at = (y: number, z: number): Vec3 => [0, k * y, thickness / 2 + k * z];
  const [heel, toe, ankle] = [at(0.06, 0.042), at(-0.11, 0.034), at(0.03, 0.085)];
  return {
    group: 'shoe',
    material: 'grip',
    triangles: [
      ...tube(heel, toe, k * 0.042, 14, k * 0.034),
      ...ball(heel, k * 0.042, 10),
      ...ball(toe, k * 0.034, 8),
      ...ball(ankle, k * 0.05, 12),
    ],
  };
}

/** A figure of tubes and balls that stands sideways, left foot ahead and chest to the right, and looks ahead. */
function riderBodies({ scale: k, sole, thigh, shank }: Figure): Sketch['bodies'] {
  /** Point with y to the back of the body and z above the soles, as measured. */
  const at = (x: number, y: number, z: number): Vec3 => [k * x, k * y, sole + k * z];
  const limb = (points: readonly Vec3[], from: number, to: number): Triangle[] =>
    points.slice(1).flatMap((point, i) => {
      const thick = (j: number): number => k * (from + ((to - from) * j) / (points.length - 1));
      return [...tube(points[i]!, point, thick(i), 12, thick(i + 1)), ...ball(point, thick(i + 1), 10)];
    });
  const piece = (length: number, from: number, to: number, joint: number) => ({
    about: 'A piece of a leg: origin at its upper end, z from the lower end to the upper one.',
    parts: [
      {
        group: 'rider',
        material: 'cloth' as const,
        triangles: [
          ...ball([0, 0, 0], k * joint, 10),
          ...limb(
            [
              [0, 0, 0],
              [0, 0, -length],
            ],
            from,
            to,
          ),
        ],
      },
    ],
  });
  const arm = (side: 1 | -1): Triangle[] => {
    const shoulder = at(0.18 * side, -0.02, 1.27);
    return [
      ...ball(shoulder, k * 0.062, 12),
      ...limb([shoulder, at(0.4 * side, 0, 1.08), at(0.6 * side, -0.12, 1.1)], 0.055, 0.034),
    ];
  };
  const [pelvis, chest] = [at(0, 0.08, 0.84), at(0, -0.01, 1.2)];
  const upper = piece(thigh, 0.082, 0.0635, 0.085);
  const lower = piece(shank, 0.0635, 0.045, 0.0635);
  return {
    rider: {
      about: 'Rider: origin at the centre of mass, x forward along the board, z up along the body.',
      parts: [{ group: 'rider', material: 'cloth', triangles: ball(at(0, 0.06, 0.8), k * 0.1, 14) }],
    },
    torso: {
      about:
        'Hips and above: origin at the centre of mass, x forward, z up along the body, where the hips are not turned.',
      parts: [
        {
          group: 'rider',
          material: 'cloth',
          triangles: [
            ...tube(pelvis, chest, k * 0.115, 20, k * 0.14),
            ...ball(pelvis, k * 0.125, 16),
            ...ball(chest, k * 0.145, 16),
            ...tube(at(-0.16, -0.02, 1.265), at(0.16, -0.02, 1.265), k * 0.065, 16),
            ...both(arm),
          ],
        },
        {
          group: 'head',
          material: 'paint',
          triangles: [
            ...tube(at(0, -0.02, 1.28), at(0.01, -0.04, 1.42), k * 0.05),
            ...ball(at(0.015, -0.045, 1.5), k * 0.108, 18),
            ...ball(at(0.122, -0.05, 1.49), k * 0.02, 8),
          ],
        },
      ],
    },
    'front-thigh': upper,
    'front-shank': lower,
    'back-thigh': upper,
    'back-shank': lower,
  };
}
