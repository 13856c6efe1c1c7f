import type { Sketch, Value } from '../../geometry/drawing.ts';
import { casterBody } from './drawing/caster.ts';
import { dimensionsOf } from './drawing/dimensions.ts';
import { layout } from './drawing/layout.ts';
import { backPlateBody, frontPlateBody } from './drawing/plate.ts';
import { rodBody } from './drawing/rod.ts';

/**
 * The board; both casters wear one mesh.
 *
 * @param p parameters by name, SI
 */
export function draw(p: Value): Sketch {
  const dimensions = dimensionsOf(p);
  return {
    ...layout(p),
    bodies: {
      rod: rodBody(dimensions),
      'front-plate': frontPlateBody(dimensions),
      'back-plate': backPlateBody(dimensions),
      caster: casterBody(dimensions),
    },
  };
}
