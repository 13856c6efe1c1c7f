// What works on the built-in systems works on a described one: linearization, regulators, drives, first order beside bodies.
import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { controlReport } from '../../../src/core/control/design/report.ts';
import { deriveSystem, readSystem } from '../../../src/core/description/index.ts';
import { templates } from '../../../src/core/description/templates.ts';
import { judgeMotion } from '../../../src/core/simulation/judge.ts';
import { feedbackOf } from '../../../src/core/control/design/feedback.ts';
import type { System } from '../../../src/core/model/system.ts';
import { decodeLink, descriptionInLink, encodeLink, LONGEST_LINK } from '../../../src/core/scenario/link.ts';
import { settled, written } from '../../../src/core/scenario/own.ts';
import { checkScenario } from '../../../src/core/scenario/schema.ts';
import type { Scenario } from '../../../src/core/scenario/types.ts';
import '../../../src/core/simulation/everyMotion.ts';
import { Simulation } from '../../../src/core/simulation/simulation.ts';
import { cases, learnSystem, loadSystem, systemMetas } from '../../../src/core/systems/registry.ts';

const systemFrom = (text: string): System => {
  const { model, view, faults } = readSystem(text);
  expect(faults).toEqual([]);
  return deriveSystem(model!, view!);
};
const template = async (id: string): Promise<string> => (await templates.find((t) => t.id === id)!.load()).default;
const scenarioOf = ({ meta }: System, raw: object): Scenario =>
  checkScenario({ version: 1, system: meta.id, ...raw }, { [meta.id]: meta });

function ends(system: System, raw: object): Record<string, number> {
  const scenario = scenarioOf(system, raw);
  const feedback = scenario.control ? feedbackOf(scenario, system) : null;
  const simulation = new Simulation(scenario, system, { feedback, extras: ['lambda', 'energy', 'residual'] });
  while (!simulation.end) simulation.advance(() => false);
  expect(simulation.end.message).toMatch(/^ran to/);
  const { columns, rows } = simulation.takeChunk();
  return Object.fromEntries(simulation.columns.map((name, k) => [name, columns[k]![rows - 1]!]));
}

interface Benchmark {
  eigenvalues_by_speed: Record<string, { capsize: number; castering: number; weave_re: number; weave_im: number }>;
}
const { eigenvalues_by_speed } = JSON.parse(
  readFileSync('tests/reference/whipple-benchmark.json', 'utf8'),
) as Benchmark;

test('the typed bicycle has the benchmark’s eigenvalues at every speed, to 1e-9', async () => {
  const bicycle = systemFrom(await template('bicycle'));
  for (const [speed, { capsize, castering, weave_re, weave_im }] of Object.entries(eigenvalues_by_speed)) {
    const found = controlReport(scenarioOf(bicycle, { at: { speed: Number(speed) } }), bicycle).eigenvalues;
    for (const [re, im] of [
      [capsize, 0],
      [castering, 0],
      [weave_re, weave_im],
    ] as const)
      expect(Math.min(...found.map(([a, b]) => Math.hypot(a - re, b - im)))).toBeLessThan(1e-9);
  }
});

test('a regulator balances the double pendulum by its cart alone', async () => {
  const system = systemFrom(await template('double-pendulum-cart'));
  const control = { type: 'lqr', inputs: ['f_X'], Q: { X: 1, theta1: 10, theta2: 10 } };
  const end = ends(system, { initial: { theta1: 0.1, theta2: -0.05 }, control, duration: 12 });
  for (const name of ['X', 'theta1', 'theta2']) expect(Math.abs(end[name]!)).toBeLessThan(1e-3);
});

test('a driven cart: the multiplier is the force that drives it', () => {
  const system = systemFrom("coordinate x\nparameter m = 3\nkinetic 1/2 m x'^2\ndrive x = 0.2 sin(2 t) + 0.1 t^2");
  for (const method of [{ name: 'dop853' }, { name: 'radau', formulation: 'nullspace-qr' }, { name: 'ida' }]) {
    const end = ends(system, { duration: 1.5, method: { ...method, rtol: 1e-9, atol: 1e-11 } });
    expect(end['x']).toBeCloseTo(0.2 * Math.sin(3) + 0.225, 12);
    expect(end['x_dot']).toBeCloseTo(0.4 * Math.cos(3) + 0.3, 12);
    expect(end['lambda_1']).toBeCloseTo(3 * (-0.8 * Math.sin(3) + 0.2), 9);
  }
});

test.each([
  ['a drive', "coordinate x, y\nkinetic x'^2 + y'^2\nspring 20 on x - y\ndrive x = 0.1 sin(3 t) + 0.2 t^2", {}],
  [
    'a frame turned by t',
    'coordinate s = 0.2\nframe f = world turned z 3 t\nbody b mass 2 at f(s, 0, 0)\nspring 50 on s',
    {},
  ],
  ['a weight that changes', "coordinate x = 1\nkinetic x'^2\npotential (3 + sin(5 t)) x^2", {}],
  [
    'a moving belt',
    "coordinate x\ncoordinate phi [rad]\nkinetic x'^2 + 0.1 phi'^2\nspring 9 on x\nvelocity x' + 0.3 phi' = 0.2 + sin(t)",
    {},
  ],
  ['a force by t', "coordinate x\nkinetic x'^2\nspring 30 on x\nforce 2 sin(4 t) on x", {}],
  [
    'a force and an input',
    "coordinate x\nkinetic x'^2\nforce 2 - x' on x\ninput u on x",
    { inputs: { u: 'sin(3 t)' } },
  ],
  [
    'a length of first order',
    "coordinate x = 0.1\ncoordinate l = 1\nkinetic x'^2\nspring 40 on x - l\nl' = cos(2 t) - x",
    {},
  ],
])('what %s puts in is the work that is told', (_, text, raw) => {
  const system = systemFrom(text);
  const method = { name: 'gauss', stages: 4, rtol: 1e-11, atol: 1e-13 };
  const simulation = new Simulation(scenarioOf(system, { duration: 2, method, ...raw }), system);
  while (!simulation.end) simulation.advance(() => false);
  const { energyDrift, energyChange, work } = simulation.counts;
  expect(Math.abs(energyChange)).toBeGreaterThan(1e-3);
  expect(Math.abs(energyChange - work!)).toBeLessThan(1e-8 * Math.abs(energyChange));
  expect(Math.abs(energyDrift!)).toBeLessThan(1e-8);
});

test('a start at a later time starts every drive at its phase', () => {
  const system = systemFrom("coordinate x\nkinetic 1/2 x'^2\ndrive x = sin(t)");
  const end = ends(system, { duration: 1, initial: { clock: 2 } });
  expect(end['x']).toBeCloseTo(Math.sin(3), 12);
  expect(end['clock']).toBeCloseTo(3, 12);
});

test('a moving belt carries what does not slip on it', () => {
  const system = systemFrom("coordinate x\nkinetic 1/2 x'^2\nvelocity x' = 0.3");
  for (const formulation of ['multipliers', 'nullspace-qr', 'blt'])
    expect(ends(system, { duration: 2, method: { name: 'rk4', formulation, step: 0.01 } })['x']).toBeCloseTo(0.6, 12);
});

test('a motor: first order beside a body, as by hand', () => {
  const system = systemFrom(
    "coordinate phi [rad]\ncoordinate i [1]\nkinetic 1/2 0.01 phi'^2\nforce 0.1 i on phi\ni' = (12 - 2 i - 0.1 phi')/0.5",
  );
  // J w' = k i, L i' = U - R i - k w: by its matrix, whose eigenvalues are real.
  const [J, k, L, R, U, t] = [0.01, 0.1, 0.5, 2, 12, 0.7];
  const [b, c] = [R / L, (k * k) / (J * L)];
  const [s1, s2] = [(-b + Math.sqrt(b * b - 4 * c)) / 2, (-b - Math.sqrt(b * b - 4 * c)) / 2];
  const steady = U / k;
  // w(0) = 0, w'(0) = 0.
  const w = steady * (1 + (s2 * Math.exp(s1 * t) - s1 * Math.exp(s2 * t)) / (s1 - s2));
  for (const formulation of ['multipliers', 'nullspace-qr', 'blt']) {
    const end = ends(system, { duration: t, method: { name: 'dop853', formulation, rtol: 1e-11, atol: 1e-13 } });
    expect(end['phi_dot']).toBeCloseTo(w, 8);
  }
});

test('first order beside bodies gives way to nothing that acts on it', () => {
  const system = systemFrom("coordinate x = 0.1\ncoordinate l = 1\nkinetic x'^2\nspring 40 on x - l\nl' = 1 - x");
  for (const method of [{ name: 'dopri5' }, { name: 'gauss', stages: 4 }, { name: 'dop853', formulation: 'blt' }]) {
    const end = ends(system, { duration: 0.3, method: { ...method, rtol: 1e-11, atol: 1e-13 } });
    // x''' = 20 (1 - x - x'): the same as one equation of third order, by its own series in t.
    let [a, b, c] = [0.1, 0, 20 * (1 - 0.1)];
    let [x, factor] = [0, 1];
    for (let k = 0; k < 40; k++) {
      x += a * factor;
      factor *= 0.3 / (k + 1);
      [a, b, c] = [b, c, 20 * ((k === 0 ? 1 : 0) - a - b)];
    }
    expect(end['x']).toBeCloseTo(x, 9);
  }
});

test('first order alone, with time', () => {
  const system = systemFrom("coordinate y [1] = 1\ny' = -y + sin(t)");
  const t = 2;
  const exact = 1.5 * Math.exp(-t) + (Math.sin(t) - Math.cos(t)) / 2;
  expect(ends(system, { duration: t, method: { rtol: 1e-11, atol: 1e-13 } })['y']).toBeCloseTo(exact, 9);
});

test('an event of one’s own ends a run, and can be ignored', () => {
  const text =
    'coordinate z = 1\nparameter gravity = 10\nbody ball mass 1 at (0, 0, z)\nevent landed "the ball is down" z';
  const system = systemFrom(text);
  const run = (raw: object): { reason: string; time: number } => {
    const simulation = new Simulation(scenarioOf(system, { duration: 1, ...raw }), system);
    while (!simulation.end) simulation.advance(() => false);
    return { reason: simulation.end.reason, time: simulation.end.time };
  };
  expect(run({})).toEqual({ reason: 'landed', time: expect.closeTo(Math.sqrt(0.2), 6) });
  expect(run({ events: { landed: 'ignore' } }).reason).toBe('end');
});

test('a held coordinate stays, and a motion from its columns is judged', async () => {
  const system = systemFrom(await template('wheel-pendulum'));
  const end = ends(system, { hold: ['phi'], initial: { psi: -1.5 }, duration: 1 });
  expect(end['X']).toBeCloseTo(0, 12);
  expect(end['psi']).not.toBeCloseTo(-1.5, 2);
  const columns = Object.fromEntries(Object.entries(end).map(([name, x]) => [name, Float64Array.of(x)]));
  expect(judgeMotion(system, {}, 'rolling', (name) => columns[name])!.residual).toBeLessThan(1e-14);
});

test('a link carries the description, and gives the same scenario back', async () => {
  const text = await template('ripstik');
  const { meta } = await learnSystem(text);
  const known = { cases, systems: systemMetas };
  const scenario = { version: 1 as const, system: meta.id, initial: { X_dot: 1 } };
  const link = encodeLink({ caseId: null, title: 'Mine', scenario }, known);
  expect(descriptionInLink(`#${link}`)).toBe(text);
  expect(decodeLink(link, known)).toEqual({ caseId: null, title: 'Mine', scenario, altered: false });
  const file = written(scenario, systemMetas);
  expect(file.system).toEqual({ description: text });
  expect(settled(file)).toEqual(scenario);
  expect(checkScenario(file, systemMetas)).toEqual(checkScenario(scenario, systemMetas));
  expect(written(checkScenario(file, systemMetas), systemMetas)).not.toHaveProperty('description');
});

test('a description of 40 coordinates, with words and comments, takes a quarter of the longest link', async () => {
  const lines = ['system "Chain of 40 links"', 'parameter gravity = 9.81', 'point P0 = (0, 0, 0)'];
  for (let k = 1; k <= 40; k++)
    lines.push(
      `# link ${k}`,
      `coordinate a${k} [rad] = ${Math.sin(k).toFixed(3)} "angle of link ${k}"`,
      `parameter m${k} [kg] = ${(0.05 + 0.01 * Math.cos(k * k)).toFixed(4)} positive "mass of link ${k}"`,
      `parameter l${k} [m] = ${(0.1 + 0.02 * Math.cos(7 * k)).toFixed(4)} positive "length"`,
      `frame f${k} = world turned y a${k}`,
      `point P${k} = P${k - 1} + f${k}(0, 0, -l${k})`,
      `body f${k} mass m${k} inertia (0, m${k} l${k}^2/12, 0) at P${k - 1} + f${k}(0, 0, -l${k}/2)`,
      `shape f${k} rod 0.01, l${k} along z`,
    );
  const { meta } = await learnSystem(lines.join('\n'));
  const scenario = { version: 1 as const, system: meta.id };
  const link = encodeLink({ caseId: null, scenario }, { cases, systems: systemMetas });
  expect(link.length).toBeLessThan(LONGEST_LINK / 4);
  expect(decodeLink(link, { cases, systems: systemMetas }).scenario).toEqual(scenario);
});

test('a wrong description in a scenario is told by its path, line and column', async () => {
  await expect(learnSystem('coordinate x\nkinetic 1/2 q')).rejects.toThrow(
    'system.description: line 2, column 13: unknown name "q"',
  );
  expect(() => checkScenario({ version: 1, system: { description: 3 } }, systemMetas)).toThrow(
    'system.description: must be the text',
  );
  expect(() => checkScenario({ version: 1, system: { text: '' } }, systemMetas)).toThrow(/system\.text/);
  expect(() => checkScenario({ version: 1, system: 'own-1' }, systemMetas)).toThrow(/unknown/);
});

test('many descriptions one after another: the first still runs, read anew', async () => {
  const text = (k: number): string => `coordinate x = ${k}\nkinetic 1/2 x'^2`;
  const first = await learnSystem(text(0));
  const system = await loadSystem(first.meta.id)!;
  for (let k = 1; k < 20; k++) await learnSystem(text(k));
  const again = await loadSystem(first.meta.id)!;
  expect(again).not.toBe(system);
  expect(again.meta.description).toBe(text(0));
  expect(ends(again, { duration: 0.1, initial: { x_dot: 1 } })['x']).toBeCloseTo(0.1, 12);
  expect(await loadSystem(first.meta.id)).toBe(again);
});
