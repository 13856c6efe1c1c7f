// A host that refuses WebAssembly: TypeScript computes, and says so where WebAssembly was asked for.
import { expect, test, vi } from 'vitest';

test('without WebAssembly a run is the same, by TypeScript', async () => {
  vi.stubGlobal('WebAssembly', {
    Module: class {
      constructor() {
        throw new EvalError('refused by the policy');
      }
    },
  });
  const { checkScenario } = await import('../../../src/core/scenario/schema.ts');
  const { Simulation } = await import('../../../src/core/simulation/simulation.ts');
  const { systems } = await import('../../../src/core/systems/all.ts');
  const board = { version: 1, system: 'ripstik', initial: { X_dot: 1 }, duration: 0.1 };
  const metas = { ripstik: systems['ripstik']!.meta };
  const run = (method: object) => {
    const simulation = new Simulation(checkScenario({ ...board, method }, metas), systems['ripstik']!);
    simulation.advance(() => false);
    return simulation;
  };
  expect(run({}).engine).toBe('typescript');
  expect(run({}).notes).toEqual(run({ engine: 'typescript' }).notes);
  expect(run({ engine: 'wasm' }).notes.at(-1)).toMatch(/^computed by TypeScript/);
  expect(run({ engine: 'wasm' }).end!.reason).toBe('end');
  expect(() => checkScenario({ ...board, method: { engine: 'c' } }, metas)).toThrow(/method\.engine.*wasm, typescript/);
  vi.unstubAllGlobals();
});
