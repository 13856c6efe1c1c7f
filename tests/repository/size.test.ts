// The build stage refuses a page that carries a system's equations twice, or itself.
import { expect, test } from 'vitest';
import { equationsIn } from '../../scripts/chunks.ts';

const of = (by: 'page' | 'worker', ...modules: string[]) => ({
  by,
  imports: [],
  styles: [],
  modules: Object.fromEntries(modules.map((module) => [module, 100])),
});
const EQUATIONS = 'src/core/systems/bicycle/equations.generated.ts';
const POSES = 'src/core/systems/bicycle/poses.generated.ts';

test('equations once, in a worker’s file; poses wherever something is drawn or computed', () => {
  const { systems, faults } = equationsIn({
    'assets/index.js': of('page', POSES, 'src/core/systems/bicycle/index.ts', 'src/main.tsx'),
    'assets/bicycle.js': of('worker', EQUATIONS),
    'assets/ripstik.js': of('worker', 'src/core/systems/ripstik/generated/rolling.generated.ts'),
    'assets/load.js': of('worker', POSES),
  });
  expect(systems).toEqual(['bicycle', 'ripstik']);
  expect(faults).toEqual([]);
});

test('two files with the same equations, and equations in the page, are named', () => {
  expect(
    equationsIn({ 'assets/a.js': of('worker', EQUATIONS), 'assets/b.js': of('worker', EQUATIONS) }).faults,
  ).toEqual([`${EQUATIONS} is in 2 files: assets/a.js, assets/b.js`]);
  expect(equationsIn({ 'assets/page.js': of('page', EQUATIONS) }).faults).toEqual([
    `${EQUATIONS} is in the page itself: assets/page.js`,
  ]);
});

test('a module of which the bundler left nothing is not held', () => {
  const empty = { by: 'page' as const, imports: [], styles: [], modules: { [EQUATIONS]: 0 } };
  expect(equationsIn({ 'assets/page.js': empty })).toEqual({ systems: [], faults: [] });
});
