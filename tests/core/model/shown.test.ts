import { expect, test } from 'vitest';
import { showsAny, shownFirst } from '../../../src/core/model/shown.ts';
import { learnSystem } from '../../../src/core/systems/registry.ts';

test('what a description shows comes first, in its order; the rest stays as it was', async () => {
  const { meta } = await learnSystem(
    [
      'coordinate x, y, z [m]',
      'parameter a = 1',
      'parameter b = 2',
      'parameter k = 3',
      "kinetic 1/2 a (x'^2 + y'^2 + z'^2) + 0 b k",
      "show z, y', k",
    ].join('\n'),
  );
  const names = (list: readonly { name: string }[]): string[] => shownFirst(list, meta).map(({ name }) => name);
  expect(names(meta.coordinates)).toEqual(['z', 'y', 'x']);
  expect(names(meta.parameters)).toEqual(['k', 'a', 'b']);
  expect(showsAny(meta.parameters, meta)).toBe(true);
  expect(showsAny(meta.inputs, meta)).toBe(false);
});
