import { type Drawing, type Sketch, type Value, valueOf } from '../src/core/geometry/drawing.ts';
import { drawingFrom } from '../src/core/geometry/drawings.ts';
import type { SystemMeta } from '../src/core/model/system.ts';
import { systemIds } from '../src/core/systems/registry.ts';

const sketches = new Map(
  await Promise.all(
    systemIds.map(
      async (id) => [id, (await import(`../src/core/systems/${id}/drawing.ts`)) as { draw(p: Value): Sketch }] as const,
    ),
  ),
);

/** `loadDrawing` without the wait. */
export const drawingOf = (meta: SystemMeta, parameters: Readonly<Record<string, number>>): Drawing =>
  drawingFrom(meta, sketches.get(meta.id)!.draw(valueOf(meta, parameters)));
