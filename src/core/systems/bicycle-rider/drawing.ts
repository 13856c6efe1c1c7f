import type { Sketch, Value } from '../../geometry/drawing.ts';
import { drawLeaning } from '../bicycle/drawing.ts';

/**
 * The bicycle, with a rider whose trunk, arms and head lean about the saddle.
 *
 * @param p parameters by name, SI
 */
export const draw = (p: Value): Sketch => drawLeaning(p, -p('hingeZ', -1.011));
