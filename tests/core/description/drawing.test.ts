import { expect, test } from 'vitest';
import { templates } from '../../../src/core/description/templates.ts';
import { learnSystem, loadDrawing, systemMetas } from '../../../src/core/systems/registry.ts';

test.each(templates.map((template) => [template.id, template] as const))(
  '%s is drawn by its shapes',
  async (_, { load }) => {
    const { meta } = await learnSystem((await load()).default);
    expect(systemMetas[meta.id]).toBe(meta);
    const drawing = await loadDrawing(meta, {});
    expect(drawing.bodies.map(({ id }) => id)).toEqual(meta.bodies.map(({ id }) => id));
    for (const { model } of drawing.bodies) {
      expect(drawing.pairs[model]!.mdl).toMatch(/^f /m);
      expect(drawing.pairs[model]!.mdl).not.toMatch(/NaN|Infinity/);
    }
    // What parameters shape is drawn anew, whatever they are.
    const wild = Object.fromEntries(meta.parameters.map(({ name }, k) => [name, [0, -1, 1e9][k % 3]!]));
    for (const { mdl } of Object.values((await loadDrawing(meta, wild)).pairs)) expect(mdl).not.toMatch(/NaN|Infinity/);
  },
);
