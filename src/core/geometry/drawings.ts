import type { SystemMeta } from '../model/system.ts';
import { castOf, type Drawing, type Model, type Sketch, type Wearer } from './drawing.ts';
import { plain } from './plain.ts';
import { type Body, writeMaterials, writeMesh } from './wavefront.ts';

/**
 * A system's sketch as meshes, bodies and stage.
 *
 * @param meta of the system
 * @param sketch plain markers where it is left out
 * @throws Error that names a body without a mesh
 */
export function drawingFrom(
  meta: SystemMeta,
  sketch: Sketch = plain([...new Set(meta.bodies.map(({ id, model }) => model ?? id))]),
): Drawing {
  const pairs: Record<string, Model> = {};
  for (const [name, body] of Object.entries({ ...sketch.fixtures, ...sketch.bodies }))
    pairs[name] = textOf({ ...body, name });
  const cast = castOf(meta, sketch);
  const undrawn = cast.bodies.find(({ model }) => !sketch.bodies[model]);
  if (undrawn) throw new Error(`the drawing of ${meta.id} has no mesh for ${undrawn.id}`);
  return {
    pairs,
    ...cast,
    fixtures: Object.keys(sketch.fixtures ?? {}).map((id): Wearer => ({ id, role: 'neutral', model: id })),
  };
}

const textOf = (body: Body): Model => ({ mdl: writeMesh(body), mat: writeMaterials(body) });
