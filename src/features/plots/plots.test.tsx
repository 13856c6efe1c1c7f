// @vitest-environment happy-dom
// Without a motion the plots say how to get one.
import { cleanup, screen } from '@testing-library/preact';
import { afterEach, expect, test } from 'vitest';
import { draw } from '../../../tests/ui/page.tsx';
import { PlotsTool } from './plotsTool.tsx';
import type { Motion } from '../../app/runs/motion.ts';
import { readSystem } from '../../core/description/index.ts';
import { suggested } from './panes.ts';
import { text } from './words.ts';

afterEach(cleanup);

test('an empty stage', () => {
  draw(<PlotsTool />);
  expect(screen.getByText(text.empty)).toBeTruthy();
});

test.each([
  [
    'what a description shows, by kind and in its order',
    "coordinate x, y\ncoordinate a [rad]\nkinetic x'^2 + y'^2 + a'^2\ndrive a = sin(t)\nshow a', y, a, x",
    [
      ['Rates', 't', ['a_dot']],
      ['Positions', 't', ['y', 'x']],
      ['Angles', 't', ['a']],
      ['Path', 'x', ['y']],
    ],
  ],
  [
    'all of one that says nothing, but its clock',
    "coordinate s\ncoordinate a [rad]\nkinetic s'^2 + a'^2\ndrive a = sin(t)",
    [
      ['Angles', 't', ['a']],
      ['Positions', 't', ['s']],
      ['Rates', 't', ['a_dot']],
    ],
  ],
  [
    'of first order, what is shown',
    "coordinate x, y, z\nx' = y\ny' = -x\nz' = -z\nshow z, x",
    [['State', 't', ['z', 'x']]],
  ],
])('plots of %s', (_, description, right) => {
  const { view } = readSystem(description);
  const columns = ['t', ...view!.meta.coordinates.flatMap(({ name }) => [name, `${name}_dot`])];
  const motion = {
    source: 'run',
    system: view,
    constraints: null,
    scenario: null,
    trajectory: { columns, has: (name: string) => columns.includes(name) },
  } as unknown as Motion;
  expect(suggested(motion, 'own').map(({ title, x, y }) => [title, x, y])).toEqual(right);
});
