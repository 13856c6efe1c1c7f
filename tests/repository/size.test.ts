// The build stage refuses a page that carries a system's equations twice, or itself.
import { expect, test } from 'vitest';
import { equationsIn } from '../../scripts/chunks.ts';

const of = (entry: boolean, imports: string[], ...modules: string[]) => ({
  entry,
  imports,
  styles: [],
  modules: Object.fromEntries(modules.map((module) => [module, 100])),
});
const EQUATIONS = 'src/core/systems/bicycle/equations.generated.ts';
const POSES = 'src/core/systems/bicycle/poses.generated.ts';

test('equations once, in a file that comes when it is asked for; poses wherever something is drawn or computed', () => {
  const { systems, faults } = equationsIn({
    'assets/index.js': of(true, ['assets/shared.js'], 'src/main.tsx'),
    'assets/shared.js': of(false, [], POSES, 'src/core/systems/bicycle/index.ts'),
    'assets/bicycle.js': of(false, ['assets/shared.js'], EQUATIONS),
    'assets/ripstik.js': of(false, [], 'src/core/systems/ripstik/generated/rolling.generated.ts'),
  });
  expect(systems).toEqual(['bicycle', 'ripstik']);
  expect(faults).toEqual([]);
});

test('two files with the same equations, and equations that come at once, are named', () => {
  expect(
    equationsIn({ 'assets/a.js': of(false, [], EQUATIONS), 'assets/b.js': of(false, [], EQUATIONS) }).faults,
  ).toEqual([`${EQUATIONS} is in 2 files: assets/a.js, assets/b.js`]);
  const along = { 'assets/worker.js': of(true, ['assets/load.js']), 'assets/load.js': of(false, [], EQUATIONS) };
  expect(equationsIn(along).faults).toEqual([`${EQUATIONS} is loaded with the page or the worker: assets/load.js`]);
});

test('a module of which the bundler left nothing is not held', () => {
  const empty = { entry: true, imports: [], styles: [], modules: { [EQUATIONS]: 0 } };
  expect(equationsIn({ 'assets/page.js': empty })).toEqual({ systems: [], faults: [] });
});
