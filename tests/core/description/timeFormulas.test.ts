// What a description gives by t acts, however short it is and however quiet the motion before it.
import { expect, test } from 'vitest';
import { deriveSystem, readSystem } from '../../../src/core/description/index.ts';
import { methods } from '../../../src/core/integrators/methods.ts';
import { checkScenario } from '../../../src/core/scenario/schema.ts';
import '../../../src/core/simulation/everyMotion.ts';
import { Simulation } from '../../../src/core/simulation/simulation.ts';
import { seeded } from '../../helpers.ts';

const adaptive = methods.filter((m) => m.adaptive).map((m) => m.id);

function runOf(text: string, raw: object) {
  const { model, view, faults } = readSystem(text);
  expect(faults).toEqual([]);
  const system = deriveSystem(model!, view!);
  const { meta } = system;
  const scenario = checkScenario({ version: 1, system: meta.id, outputStep: 1000, ...raw }, { [meta.id]: meta });
  const simulation = new Simulation(scenario, system, { extras: [] });
  simulation.advance(() => false);
  expect(simulation.end!.message).toMatch(/^ran to/);
  const { columns, rows } = simulation.takeChunk();
  const at = (name: string): number => columns[simulation.columns.indexOf(name)]![rows - 1]!;
  return { at, warnings: simulation.warnings };
}

const cart = (line: string): string => `system "Cart"
coordinate x [m] "cart"
coordinate phi [rad] "arm"
parameter width [s] = 0.01
frame arm = world turned z phi
body cart mass 1 inertia (0.1, 0.1, 0.1) at (x, 0, 0)
body arm mass 1 inertia (0.1, 0.1, 0.1) at (x, 0, 0) + arm(0.5, 0, 0)
${line}
`;

const random = seeded(271);
const pulses = ['exp(-((t-A)/width)^2)', '(t > A ? (t < A + width ? 1 : 0) : 0)', 'exp(-((t-A)/width)^4)'];
const areas = [Math.sqrt(Math.PI), 1, 1.8128049541109541];

test.each(adaptive)('%s: a short force on a system at rest gives its impulse', (name) => {
  for (let trial = 0; trial < 3; trial++) {
    const width = 10 ** (-4 + 3 * random());
    const at = 1 + 3 * random();
    const k = trial % pulses.length;
    const formula = pulses[k]!.replaceAll('A', `${at}`);
    const { at: end } = runOf(cart(`force ${0.1 / width} ${formula} on x\ndrive phi = pi/2`), {
      parameters: { width },
      duration: 6,
      method: { name, rtol: 1e-9, atol: 1e-11 },
    });
    // On both masses, which the drive keeps from turning.
    expect(Math.abs(end('x_dot') / ((0.1 * areas[k]!) / 2) - 1), `${formula}, width ${width}`).toBeLessThan(1e-6);
  }
});

test.each(methods.map(({ id }) => id))('%s: a force that switches gives its impulse to rounding', (name) => {
  for (const [formula, impulse] of [
    ['(t >= 0.5) (t < 0.6)', 0.1],
    ['(t > 0.3 ? (t < 0.301 ? 100 : 0) : 0)', 0.1],
    // Switches at the end of the run too.
    ['(mod(t, 0.1) < 0.05)', 0.5],
  ] as const) {
    const { at } = runOf(cart(`force ${formula} on x`), { duration: 1, method: { name, step: 0.01, rtol: 1e-6 } });
    expect(Math.abs((2 * at('x_dot')) / impulse - 1), formula).toBeLessThan(2e-11);
  }
});

test.each(adaptive)('%s: a short drive moves what hangs on it, whenever the clock starts', (name) => {
  for (const clock of [0, 1.25]) {
    const run = (method: object) =>
      runOf(cart('drive phi = pi/2 + 0.3*(1 + tanh((t-3)/width))'), { initial: { clock }, duration: 4, method }).at;
    const end = run({ name, rtol: 1e-9, atol: 1e-11 });
    const fine = run({ name: 'dop853', rtol: 1e-11, atol: 1e-13, maxStep: 1e-3 });
    expect(Math.abs(fine('x'))).toBeGreaterThan(0.01);
    expect(Math.abs(end('x') - fine('x'))).toBeLessThan(1e-6);
  }
});

test.each(adaptive)('%s: a drive with a corner', (name) => {
  const { at } = runOf(cart('drive phi = t > 3 ? 0.1*(t-3) : 0'), { duration: 6, method: { name, rtol: 1e-9 } });
  // The cart takes half of the arm's way: x + cos(phi)/4 is where it was.
  expect(at('x')).toBeCloseTo((1 - Math.cos(0.3)) / 4, 6);
});

test.each(adaptive)('%s: an equation of first order', (name) => {
  const { at } = runOf(
    `system "Filter"
coordinate y [1]
y' = 100*exp(-((t-3)/0.001)^2) - 0.5 y
`,
    { duration: 4, method: { name, rtol: 1e-8, atol: 1e-10 } },
  );
  expect(at('y')).toBeCloseTo(0.1 * Math.sqrt(Math.PI) * Math.exp(-0.5) * (1 + 6.25e-8), 6);
});

test('a fixed step that passes over a drive says so', () => {
  const warnings = (step: number): string =>
    runOf(cart('force exp(-((t-3)/width)^2) on x'), { duration: 4, method: { name: 'rk4', step } }).warnings.join();
  expect(warnings(0.1)).toMatch(/what is given by t changes within a step at t = 2\.\d+ s/);
  expect(warnings(0.001)).toBe('');
});
