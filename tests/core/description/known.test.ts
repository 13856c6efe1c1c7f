// Answers known from the books, of descriptions that a person can begin with.
import { describe, expect, test } from 'vitest';
import '../../../src/core/simulation/everyMotion.ts';
import { scenarioLocus } from '../../../src/core/control/locus/scenarioLocus.ts';
import { deriveSystem, readSystem } from '../../../src/core/description/index.ts';
import { templates } from '../../../src/core/description/templates.ts';
import { ConstrainedSystem } from '../../../src/core/mechanics/constrainedSystem.ts';
import type { System } from '../../../src/core/model/system.ts';
import { checkScenario } from '../../../src/core/scenario/schema.ts';
import { Simulation } from '../../../src/core/simulation/simulation.ts';

async function template(id: string): Promise<System> {
  const { default: text } = await templates.find((t) => t.id === id)!.load();
  const { model, view } = readSystem(text);
  return deriveSystem(model!, view!);
}

const g = 9.81;
const disc = await template('torus-disc');
const check = (raw: object): ReturnType<typeof checkScenario> =>
  checkScenario({ version: 1, system: disc.meta.id, ...raw }, { [disc.meta.id]: disc.meta });

describe('a rolling torus disc is stable above', () => {
  // v² = A m g a R² / (C (C + m R²)), R = a + b.
  const torus = { m: 1.3, a: 0.2, b: 0.03, A: 0.027, C: 0.054 };
  const R = torus.a + torus.b;
  test.each([
    ['its speed', torus, (torus.A * torus.m * g * torus.a * R ** 2) / (torus.C * (torus.C + torus.m * R ** 2))],
    ['g R / 3: a sharp disc', { m: 2, a: 0.3, b: 0, A: (2 * 0.09) / 4, C: (2 * 0.09) / 2 }, (g * 0.3) / 3],
    ['g R / 4: a hoop', { m: 2, a: 0.3, b: 0, A: (2 * 0.09) / 2, C: 2 * 0.09 }, (g * 0.3) / 4],
  ])('%s', (_, parameters, square) => {
    const request = { vary: 'at', name: 'x_dot', from: 0.2, to: 3, count: 60, closed: false } as const;
    const { critical } = scenarioLocus(check({ parameters }), disc, request, () => {});
    expect(critical).toHaveLength(1);
    expect(critical[0]!.unstableBelow).toBeGreaterThan(critical[0]!.unstableAbove);
    expect(Math.abs(critical[0]!.value ** 2 / square - 1)).toBeLessThan(1e-8);
  });
});

describe('Euler’s disc, its centre at rest', () => {
  const [m, a] = [0.4, 0.0375];
  const parameters = { m, a, b: 0, A: (m * a ** 2) / 4, C: (m * a ** 2) / 2 };
  /** Inclined by delta to the floor: the lean from upright is what is left of a right angle. */
  const steady = (delta: number): { initial: Record<string, number>; rate: number; energy: number } => {
    const rate = Math.sqrt((4 * g) / (a * Math.sin(delta)));
    const lean = Math.PI / 2 - delta;
    return {
      rate,
      energy: 1.5 * m * g * a * Math.sin(delta),
      initial: { lean, yaw_dot: rate, lean_dot: 0, spin_dot: -rate * Math.sin(lean), x_dot: 0, y_dot: 0 },
    };
  };

  test.each([30, 20, 10, 5, 2, 1])('precesses at √(4 g / (a sin δ)) with energy 3/2 m g a sin δ at %s°', (degrees) => {
    const { initial, rate, energy } = steady((degrees * Math.PI) / 180);
    const p = Float64Array.from(disc.meta.parameters, ({ name }) =>
      name === 'gravity' ? g : parameters[name as keyof typeof parameters],
    );
    const q = Float64Array.of(0, 0, 0.3, initial['lean']!, 0.2);
    const v = Float64Array.from(disc.meta.coordinates, ({ name }) => initial[`${name}_dot`]!);
    const dynamics = new ConstrainedSystem(disc, p, 'rolling', [], null);
    const [acceleration, lambda] = [new Float64Array(5), new Float64Array(2)];
    expect(dynamics.acceleration(0, q, v, acceleration, lambda)).toBe(true);
    // The motion is steady: nothing changes the rates.
    for (const x of acceleration) expect(Math.abs(x) / rate ** 2).toBeLessThan(1e-12);
    const energies = new Float64Array(2);
    disc.energy(q, v, p, energies);
    expect(Math.abs((energies[0]! + energies[1]!) / energy - 1)).toBeLessThan(1e-12);
  });

  test('keeps its energy for 10 s', () => {
    const { initial } = steady((20 * Math.PI) / 180);
    const simulation = new Simulation(
      check({
        parameters,
        initial: { ...initial, lean_dot: 0.3 },
        duration: 10,
        outputStep: 0.5,
        columns: ['energy'],
        method: { name: 'gauss', stages: 4, rtol: 1e-12, atol: 1e-14 },
      }),
      disc,
    );
    while (!simulation.end) simulation.advance(() => false);
    expect(simulation.end.reason).toBe('end');
    const { columns } = simulation.takeChunk();
    const energy = columns[simulation.columns.indexOf('energy')]!;
    for (const E of energy) expect(Math.abs(E / energy[0]! - 1)).toBeLessThan(1e-12);
  });
});
