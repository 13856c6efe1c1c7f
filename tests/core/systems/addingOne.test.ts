// docs/adding-a-system.md, done: a folder and its line in the registry, in a copy of core, and the new system runs.
import { cpSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { expect, test } from 'vitest';
import type * as registryModule from '../../../src/core/systems/registry.ts';
import type * as schemaModule from '../../../src/core/scenario/schema.ts';
import type * as simulationModule from '../../../src/core/simulation/simulation.ts';

test('adding a system is one folder and one line with its import', async () => {
  mkdirSync(resolve('.cache'), { recursive: true });
  const copy = mkdtempSync(resolve('.cache', 'core-'));
  try {
    cpSync(resolve('src/core'), copy, { recursive: true });
    const folder = join(copy, 'systems', 'ice-yacht');
    cpSync(join(copy, 'systems', 'chaplygin-sleigh'), folder, { recursive: true });
    for (const name of readdirSync(folder)) {
      const text = readFileSync(join(folder, name), 'utf8');
      writeFileSync(
        join(folder, name),
        text.replaceAll('chaplygin-sleigh', 'ice-yacht').replaceAll('chaplyginSleigh', 'iceYacht'),
      );
    }
    const registry = join(copy, 'systems', 'registry.ts');
    const before = readFileSync(registry, 'utf8');
    const after = before
      .replace(
        'import type { SystemFolder }',
        "import { iceYacht } from './ice-yacht/index.ts';\nimport type { SystemFolder }",
      )
      .replace('  chaplyginSleigh,\n', '  chaplyginSleigh,\n  iceYacht,\n');
    expect(after.split('\n').length - before.split('\n').length).toBe(2);
    writeFileSync(registry, after);

    const [{ systemViews, systemIds, loadSystem, loadDrawing, loadTypeset, cases }, { checkScenario }, { Simulation }] =
      (await Promise.all([
        import(/* @vite-ignore */ registry),
        import(/* @vite-ignore */ join(copy, 'scenario', 'schema.ts')),
        import(/* @vite-ignore */ join(copy, 'simulation', 'simulation.ts')),
      ])) as [typeof registryModule, typeof schemaModule, typeof simulationModule];
    expect(systemIds.at(-1)).toBe('ice-yacht');
    const metas = Object.fromEntries(Object.entries(systemViews).map(([id, view]) => [id, view.meta]));
    const own = cases.filter(({ scenario }) => scenario.system === 'ice-yacht');
    expect(own.length).toBeGreaterThan(0);
    const simulation = new Simulation(checkScenario(own[0]!.scenario, metas), (await loadSystem('ice-yacht'))!);
    simulation.advance(() => false);
    expect(simulation.end!.reason).toBe('end');
    expect((await loadDrawing(metas['ice-yacht']!, {})).bodies.length).toBe(1);
    expect((await loadTypeset('ice-yacht'))!.system).toBe('ice-yacht');
  } finally {
    rmSync(copy, { recursive: true });
  }
});
