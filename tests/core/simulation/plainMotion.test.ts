// What a run takes before `everyMotion.ts` is imported (by nothing in this file but the tests themselves), and after it.
import { expect, test } from 'vitest';
import { explicitSteppers } from '../../../src/core/integrators/explicit.ts';
import { checkScenario } from '../../../src/core/scenario/schema.ts';
import { PAGE_COLUMNS, Simulation } from '../../../src/core/simulation/simulation.ts';
import { loadSystem, systemViews } from '../../../src/core/systems/registry.ts';

const metas = Object.fromEntries(Object.entries(systemViews).map(([id, { meta }]) => [id, meta]));

async function rowsOf(system: string, name: string): Promise<number[][]> {
  const method = { name, engine: 'typescript', step: 1e-3 };
  const scenario = checkScenario({ version: 1, system, method, duration: 0.2 }, metas);
  const simulation = new Simulation(scenario, (await loadSystem(system))!, { extras: PAGE_COLUMNS });
  while (!simulation.end) simulation.advance(() => false);
  const { columns, rows } = simulation.takeChunk();
  return columns.map((column) => [...column.subarray(0, rows)]);
}

test('explicit methods run, others say what is missing; with everything loaded the bits are the same', async () => {
  const runs = ['ripstik', 'stiff-decay'].flatMap((system) =>
    Object.keys(explicitSteppers).map((name) => [system, name] as const),
  );
  const before = await Promise.all(runs.map(([system, name]) => rowsOf(system, name)));
  await expect(rowsOf('ripstik', 'bdf')).rejects.toThrow('bdf is not loaded here: import simulation/everyMotion.ts');
  await import('../../../src/core/simulation/everyMotion.ts');
  for (const [k, [system, name]] of runs.entries())
    expect(await rowsOf(system, name), `${system} ${name}`).toEqual(before[k]);
  expect((await rowsOf('ripstik', 'bdf'))[0]!.at(-1)).toBe(0.2);
});
