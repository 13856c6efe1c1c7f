// What a description is made of may leave the range of doubles and come to its limit: so do its derivatives.
import { describe, expect, test } from 'vitest';
import { deriveSystem, readSystem } from '../../../src/core/description/index.ts';
import { checkScenario } from '../../../src/core/scenario/schema.ts';
import '../../../src/core/simulation/everyMotion.ts';
import { Simulation } from '../../../src/core/simulation/simulation.ts';

const text = (potential: string): string => `system "Wells"
coordinate x, y
kinetic x'^2 / 2 + y'^2 / 2
potential ${potential} + y^2 / 2
`;

describe.each([
  ['-1/cosh(x)', 0],
  ['-cosh(x)^-2', 0],
  ['-1/(1 + exp(x))', 0],
  ['atan(exp(x))', 0],
  ['tanh(sinh(x))', 0],
  ['exp(-cosh(x))', 0],
])('a potential %s', (potential) => {
  const { model, view, faults } = readSystem(text(potential));
  const system = deriveSystem(model!, view!);

  test('has finite forces and Jacobians far out on either side', () => {
    expect(faults).toEqual([]);
    for (const x of [-1e6, -800, 800, 1e6]) {
      const [q, v] = [Float64Array.of(x, 0.3), Float64Array.of(1, 0)];
      const [M, h] = [new Float64Array(4), new Float64Array(2)];
      system.mechanics(q, v, new Float64Array(0), M, h);
      expect([...M, ...h].every(Number.isFinite), `forces at ${x}: ${h.join()}`).toBe(true);
      expect(h[0]).toBeCloseTo(0, 12);
      const [dq, dv] = [new Float64Array(4), new Float64Array(4)];
      system.jacobians(q, v, new Float64Array(2), new Float64Array(0), dq, dv);
      expect([...dq, ...dv].every(Number.isFinite), `Jacobian at ${x}: ${dq.join()}`).toBe(true);
      expect(dq[0]).toBeCloseTo(0, 12);
    }
  });

  test.each(['radau', 'bdf', 'dop853'])('%s goes on out there', (name) => {
    const { meta } = view!;
    const raw = { version: 1, system: meta.id, initial: { x: 700, x_dot: 100, y: 0.1 }, duration: 3, method: { name } };
    const simulation = new Simulation(checkScenario(raw, { [meta.id]: meta }), system, {});
    simulation.advance(() => false);
    expect(simulation.end!.message).toBe('ran to t = 3 s');
    const { columns, rows } = simulation.takeChunk();
    expect(columns[1]![rows - 1]).toBeCloseTo(1000, 3);
  });
});
