import { expect, test } from 'vitest';
import '../../../src/core/simulation/everyMotion.ts';
import { deriveSystem, readSystem } from '../../../src/core/description/index.ts';
import { checkScenario } from '../../../src/core/scenario/schema.ts';
import { Simulation } from '../../../src/core/simulation/simulation.ts';

const TEXT = `
system "Snakeboard"
coordinate x, y [m]
coordinate theta, psi, phi_f, phi_b [rad]
parameter m [kg] = 6
parameter J [kg·m²] = 0.016
parameter Jr [kg·m²] = 0.072
parameter Jw [kg·m²] = 0.0013
parameter l [m] = 0.2
kinetic 1/2 m (x'^2 + y'^2) + 1/2 J theta'^2 + 1/2 Jr (theta' + psi')^2
kinetic 1/2 Jw ((theta' + phi_f')^2 + (theta' + phi_b')^2)
frame board = world turned z theta
frame front = board turned z phi_f
frame back = board turned z phi_b
point O = (x, y, 0)
velocity dot(velocity(O + board(l, 0, 0)), front.y) = 0
velocity dot(velocity(O - board(l, 0, 0)), back.y) = 0
drive psi = 0.7 sin(t + pi/2)
drive phi_f = 0.3 sin(t + pi/4)
drive phi_b = -0.3 sin(t + pi/4)
`;

test.each([
  ['dopri5', 'multipliers'],
  ['dopri5', 'nullspace-qr'],
  ['gauss', 'blt'],
  ['ida', undefined],
])('the drive gait of the snakeboard ends where Ostrowski’s does: %s, %s', (name, formulation) => {
  const { model, view, faults } = readSystem(TEXT);
  expect(faults).toEqual([]);
  const { id } = view!.meta;
  const duration = 8 * Math.PI;
  const tolerance = name === 'ida' ? 1e-8 : 1e-10;
  const method = { name, ...(formulation ? { formulation } : {}), rtol: tolerance, atol: tolerance };
  const scenario = checkScenario(
    { version: 1, system: id, duration, outputStep: duration, method },
    { [id]: view!.meta },
  );
  const simulation = new Simulation(scenario, deriveSystem(model!, view!));
  while (!simulation.end) simulation.advance(() => false);
  const { columns, rows } = simulation.takeChunk();
  const at = (column: string): number => columns[simulation.columns.indexOf(column)]![rows - 1]!;
  expect(at('x')).toBeCloseTo(1.45869, 5);
  expect(at('y')).toBeCloseTo(-0.01561, 5);
  expect(at('theta')).toBeCloseTo(-0.12121, 5);
  expect(at('phi_f')).toBeCloseTo(0.3 * Math.sin(duration + Math.PI / 4), 12);
});
