import { expect, test } from 'vitest';
import { cases } from '../../src/core/systems/registry.ts';
import { systems } from '../../src/core/systems/all.ts';
import { runOf } from '../helpers.ts';

const caseNamed = (id: string) => cases.find((c) => c.id === id)!.scenario;
const tight = { rtol: 1e-10 };

test('the hanging board keeps its energy within 1e-7 of its largest kinetic energy over 10 s', () => {
  const run = runOf({ ...caseNamed('hanging'), duration: 10, method: tight });
  expect(run.end.reason).toBe('end');
  expect(energySpread(run)).toBeLessThan(1e-7);
});

test('the falling board of the report keeps energy, velocity constraints and contact heights over 10 s', () => {
  const run = runOf({ ...caseNamed('falling-report'), duration: 10, method: tight });
  expect(run.end.reason).toBe('end');
  expect(energySpread(run)).toBeLessThan(1e-7);
  const worst = constraintErrors(run);
  expect(worst.velocity).toBeLessThan(1e-12);
  expect(worst.height).toBeLessThan(1e-12);
});

test('the falling board of the report runs its 5.8 s; the plates swing almost a full turn and back within 1.2 s', () => {
  const run = runOf(caseNamed('falling-report'));
  expect(run.end).toMatchObject({ reason: 'end', time: 5.8 });
  const front = run.columns.get('alpha_fp')!.subarray(0, 121);
  const peak = Math.max(...front);
  expect(peak).toBeGreaterThan(4.5);
  expect(peak).toBeLessThan(2 * Math.PI);
  expect(front[120]!).toBeLessThan(0.5);
});

test('released at 1 m/s with half a degree of lean the board falls and stops at touchdown, where a corner is at height zero', () => {
  const run = runOf({ version: 1, system: 'ripstik', initial: { X_dot: 1, alpha: '0.5 deg' } });
  expect(run.end.reason).toBe('touchdown');
  expect(run.end.message).toMatch(/touchdown.*ground/);
  const last = run.rows - 1;
  expect(run.columns.get('t')![last]).toBe(run.end.time);
  const q = Float64Array.from(systems['ripstik']!.meta.coordinates, (c) => run.columns.get(c.name)![last]!);
  expect(Math.abs(systems['ripstik']!.clearance!(q, run.simulation.dynamics.parameters))).toBeLessThan(1e-9);
});

test('with rolling rows and touchdown ignored the falling board ends where a skate lies flat, at about 4 s', () => {
  const run = runOf({ ...caseNamed('falling-report'), constraints: 'rolling', duration: 10 });
  expect(run.end.reason).toBe('constraint-singular');
  expect(run.end.time).toBeGreaterThan(3.8);
  expect(run.end.time).toBeLessThan(4.2);
});

test('the ridden board gathers speed without a push', () => {
  const run = runOf(caseNamed('ridden'));
  const speed = (k: number) => Math.hypot(run.columns.get('X_dot')![k]!, run.columns.get('Y_dot')![k]!);
  expect(speed(run.rows - 1)).toBeGreaterThan(1.5 * speed(0));
});

function energySpread(run: ReturnType<typeof runOf>): number {
  const energy = run.columns.get('energy')!;
  const potentials = systems['ripstik']!;
  const out = new Float64Array(2);
  let kinetic = 0;
  forRows(run, (q, v) => {
    potentials.energy(q, v, run.simulation.dynamics.parameters, out);
    kinetic = Math.max(kinetic, out[0]!);
  });
  return Math.max(...energy.map((e) => Math.abs(e - energy[0]!))) / kinetic;
}

/** Omega v and heights from the emitted numbers alone. */
function constraintErrors(run: ReturnType<typeof runOf>): { velocity: number; height: number } {
  const { dynamics } = run.simulation;
  const set = dynamics.constraints!;
  const omega = new Float64Array(set.rows * dynamics.n);
  const gamma = new Float64Array(set.rows);
  const heights = new Float64Array(set.contact!.count);
  const worst = { velocity: 0, height: 0 };
  forRows(run, (q, v) => {
    set.evaluate(q, v, dynamics.parameters, omega, gamma);
    for (let r = 0; r < set.rows; r++) {
      let sum = 0;
      for (let i = 0; i < dynamics.n; i++) sum += omega[r * dynamics.n + i]! * v[i]!;
      worst.velocity = Math.max(worst.velocity, Math.abs(sum));
    }
    set.contact!.heights(q, dynamics.parameters, heights);
    worst.height = Math.max(worst.height, ...heights.map(Math.abs));
  });
  return worst;
}

function forRows(run: ReturnType<typeof runOf>, visit: (q: Float64Array, v: Float64Array) => void): void {
  const names = systems['ripstik']!.meta.coordinates.map((c) => c.name);
  for (let k = 0; k < run.rows; k++) {
    visit(
      Float64Array.from(names, (name) => run.columns.get(name)![k]!),
      Float64Array.from(names, (name) => run.columns.get(`${name}_dot`)![k]!),
    );
  }
}
