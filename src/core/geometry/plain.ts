import type { Sketch } from './drawing.ts';
import { ball, tube } from './solids.ts';

/** Bodies nobody has drawn: a ball at each origin with a bar along x, so that a new system moves on the stage at once. */
export const plain = (bodies: readonly string[]): Sketch => ({
  bodies: Object.fromEntries(
    bodies.map((id) => [
      id,
      {
        about: 'Marker at the origin, bar along x.',
        parts: [
          { group: 'marker', material: 'accent', triangles: ball([0, 0, 0], 0.05) },
          { group: 'axis', material: 'aluminium', triangles: tube([0, 0, 0], [0.2, 0, 0], 0.012) },
        ],
      },
    ]),
  ),
});
