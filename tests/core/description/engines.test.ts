import { expect, test } from 'vitest';
import { deriveSystem, readSystem } from '../../../src/core/description/index.ts';
import { templates } from '../../../src/core/description/templates.ts';
import { checkScenario } from '../../../src/core/scenario/schema.ts';
import '../../../src/core/simulation/everyMotion.ts';
import { Simulation } from '../../../src/core/simulation/simulation.ts';

const FUNCTIONS = `system "Every function"
coordinate x, y
parameter c = 0.3
kinetic (1 + 0.1 tanh(x)^2) x'^2 + (2 + cos(y)) y'^2 + 0.1 exp(-x^2) x' y'
potential sqrt(1 + x^2) + c cosh(y) + log(2 + sin(x)) + atan2(y, 2 + x^2) + 0.1 abs(x)^2.5 + cbrt(3 + y) + asin(0.1 sin(y))
potential x < 0.2 ? 0.1 x^2 : max(0.1 x^2, 0.1 x^2) + mod(2, 3)
loss 0.01 sinh(x')^2
velocity x' = (1 + 0.1 x) y'
event far "too far" 40 - x^2
`;

test.each([
  [
    'ripstik',
    {
      events: { touchdown: 'ignore' },
      initial: { X_dot: 1, alpha_fp: 0.2, alpha_bp: 0.1 },
      inputs: { tau_fc: '0.05*sin(2*pi*t)' },
    },
  ],
  ['bicycle', { initial: { speed: 5, roll: 0.1 } }],
  ['rattleback', { initial: { yaw_dot: -5, roll: 0.01 } }],
  ['every function', { initial: { x: 0.1, y_dot: 2 } }],
])('WebAssembly and TypeScript give the same bits: %s', async (id, raw) => {
  const template = templates.find((t) => t.id === id);
  const { model, view, faults } = readSystem(template ? (await template.load()).default : FUNCTIONS);
  expect(faults).toEqual([]);
  const rowsOf = (engine: 'wasm' | 'typescript'): { engine: string; values: number[] } => {
    const { meta } = view!;
    const method = { name: 'dop853', rtol: 1e-7, engine };
    const scenario = checkScenario({ version: 1, system: meta.id, duration: 1, ...raw, method }, { [meta.id]: meta });
    const simulation = new Simulation(scenario, deriveSystem(model!, view!), { extras: ['lambda', 'energy'] });
    while (!simulation.end) simulation.advance(() => false);
    expect(simulation.end.message).toMatch(/^ran to/);
    const { columns, rows } = simulation.takeChunk();
    return { engine: simulation.engine, values: columns.flatMap((column) => [...column.subarray(0, rows)]) };
  };
  const [wasm, typescript] = [rowsOf('wasm'), rowsOf('typescript')];
  expect([wasm.engine, typescript.engine]).toEqual(['wasm', 'typescript']);
  expect(wasm.values.length).toBeGreaterThan(500);
  expect(wasm.values).toEqual(typescript.values);
});
