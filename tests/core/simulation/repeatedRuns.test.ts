// A run that takes over what the one before was built of is the run that is built anew, to the bit.
import { describe, expect, test } from 'vitest';
import { methods } from '../../../src/core/integrators/methods.ts';
import { StartError } from '../../../src/core/mechanics/consistentStart.ts';
import { checkScenario } from '../../../src/core/scenario/schema.ts';
import type { Scenario, ScenarioFile } from '../../../src/core/scenario/types.ts';
import '../../../src/core/simulation/everyMotion.ts';
import { RepeatedRuns } from '../../../src/core/simulation/repeatedRuns.ts';
import { Simulation } from '../../../src/core/simulation/simulation.ts';
import { systems } from '../../../src/core/systems/all.ts';

const metas = Object.fromEntries(Object.values(systems).map(({ meta }) => [meta.id, meta]));
const board: ScenarioFile = { version: 1, system: 'ripstik', initial: { X_dot: 1, alpha: 0.01 }, duration: 0.3 };
const options = { extras: ['lambda', 'energy', 'residual'] };
const check = (file: ScenarioFile): Scenario => checkScenario(file, metas);

function resultOf(simulation: Simulation) {
  simulation.advance(() => false);
  const { end, counts, adjustments, notes, engine } = simulation;
  const { columns, rows } = simulation.takeChunk();
  return { end, counts, adjustments, notes, engine, rows, columns: columns.map((c) => new BigUint64Array(c.buffer)) };
}

/** Runs one after another, each beside one built anew. @returns which of them took over the one before */
function compared(files: readonly ScenarioFile[]): boolean[] {
  const runs = new RepeatedRuns();
  let last: Simulation | null = null;
  return files.map((file) => {
    const scenario = check(file);
    const system = systems[scenario.system]!;
    const simulation = runs.next(scenario, system, options);
    const taken = simulation === last;
    last = simulation;
    expect(resultOf(simulation), JSON.stringify(file)).toEqual(resultOf(new Simulation(scenario, system, options)));
    return taken;
  });
}

describe.each(methods.map(({ id }) => id))('by %s', (name) => {
  test('another start, other parameters, and both back again', () => {
    const method = { name, rtol: 1e-5 };
    const taken = compared([
      { ...board, method },
      { ...board, method, initial: { X_dot: 2, alpha: -0.02 } },
      { ...board, method, parameters: { plateMass: 3, casterTrail: 0.05 } },
      { ...board, method },
    ]);
    expect(taken).toEqual([false, ...Array<boolean>(3).fill(name !== 'ida')]);
  });
});

test('by TypeScript, without projection, and to a touchdown', () => {
  for (const method of [{ engine: 'typescript' }, { projection: false }, { engine: 'wasm' }] as const)
    expect(compared([board, { ...board, duration: 2 }].map((file) => ({ ...file, method })))).toEqual([false, false]);
  expect(
    compared([
      { ...board, duration: 2 },
      { ...board, duration: 2, initial: { alpha: 0.1 } },
    ]),
  ).toEqual([false, true]);
});

test('the bicycle, and a wheel without a short way', () => {
  for (const system of ['bicycle', 'rolling-wheel']) {
    const file: ScenarioFile = { version: 1, system, duration: 0.2 };
    const { name } = metas[system]!.parameters[0]!;
    const value = 1.1 * check(file).parameters[name]!;
    compared([file, { ...file, parameters: { [name]: value } }, file]);
  }
});

test('whatever else differs is built anew', () => {
  const others: Partial<ScenarioFile>[] = [
    { constraints: 'report' },
    { constraints: 'none' },
    { hold: ['alpha'] },
    { inputs: { tau_fp: '0.1*sin(t)' } },
    { outputStep: 0.02 },
    { parameters: { wheelDrag: 0.5 } },
    { method: { name: 'dopri5', formulation: 'nullspace-qr' } },
  ];
  for (const other of others)
    expect(compared([board, { ...board, ...other }, board]), JSON.stringify(other)).toEqual([false, false, false]);
});

test('a start that is refused leaves nothing behind', () => {
  const runs = new RepeatedRuns();
  const system = systems['ripstik']!;
  const next = (file: ScenarioFile): Simulation => runs.next(check(file), system, options);
  next(board);
  expect(() => next({ ...board, initial: { psi: '90 deg' } })).toThrow(StartError);
  expect(resultOf(next(board))).toEqual(resultOf(new Simulation(check(board), system, options)));
});
