// A run loads what it takes of its system's equations, and no more: the same bits as with all of them.
import { expect, test } from 'vitest';
import { feedbackFor, partsOf, systemOf } from '../../src/compute/services/load.ts';
import { methods } from '../../src/core/integrators/methods.ts';
import { formulations } from '../../src/core/mechanics/formulations/formulations.ts';
import type { ScenarioFile } from '../../src/core/scenario/types.ts';
import { PAGE_COLUMNS, Simulation } from '../../src/core/simulation/simulation.ts';
import { loadSystem, cases, type SystemParts } from '../../src/core/systems/registry.ts';
import { scenarioOf } from '../helpers.ts';

/** Every number of the rows of a run, and how it ended. */
async function rowsWith(file: ScenarioFile, parts: SystemParts | undefined): Promise<unknown[]> {
  const scenario = scenarioOf(file);
  const system = await systemOf(scenario, parts);
  const feedback = await feedbackFor(scenario, system);
  const simulation = new Simulation(scenario, system, { extras: PAGE_COLUMNS, feedback });
  while (!simulation.end) simulation.advance(() => false);
  const { columns, rows } = simulation.takeChunk();
  return [simulation.end.reason, ...columns.map((column) => [...column.subarray(0, rows)])];
}

const brief = (file: ScenarioFile): ScenarioFile => ({ ...file, duration: 0.05, outputStep: 0.01 });

test.each(cases.map(({ id, scenario }) => [id, scenario] as const))('%s', async (_, scenario) => {
  const file = brief(scenario);
  const checked = scenarioOf(file);
  const whole = await rowsWith(file, undefined);
  expect(await rowsWith(file, partsOf(checked, false, false))).toEqual(whole);
  expect(await rowsWith(file, partsOf(checked, false, true))).toEqual(whole);
});

const falling = cases.find(({ id }) => id === 'falling-ground')!.scenario;

test.each(methods.flatMap(({ id }) => formulations.map((formulation) => [id, formulation.id] as const)))(
  'the falling board by %s, %s',
  async (name, formulation) => {
    const file = brief({ ...falling, method: { name, ...(name === 'ida' ? {} : { formulation }) } });
    expect(await rowsWith(file, partsOf(scenarioOf(file), false, false))).toEqual(await rowsWith(file, undefined));
  },
);

test('a Jacobian that was not loaded is an error, and never a zero', async () => {
  const system = (await loadSystem('ripstik', { jacobians: false }))!;
  const zeros = (n: number) => new Float64Array(n);
  expect(() => system.jacobians(zeros(10), zeros(10), zeros(10), zeros(30), zeros(100), zeros(100))).toThrow(
    'the Jacobians of ripstik were asked for and are not loaded',
  );
});
