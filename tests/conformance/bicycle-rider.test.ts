// The bicycle with a leaning rider against the published linear model (tests/reference/bicycle-rider.json).
import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { controlReport } from '../../src/core/control/design/report.ts';
import type { Complex } from '../../src/core/control/linearization/spectrum.ts';
import { systems } from '../../src/core/systems/all.ts';
import { cases } from '../../src/core/systems/registry.ts';
import { spectralDistance } from '../core/control/helpers.ts';
import { runOf, scenarioOf } from '../helpers.ts';

interface Reference {
  cases: { parameters: Record<string, number>; speed: number; eigenvalues: Complex[] }[];
}
const reference = JSON.parse(readFileSync('tests/reference/bicycle-rider.json', 'utf8')) as Reference;
const system = systems['bicycle-rider']!;

const moving = (parameters: Record<string, number>, speed: number): Complex[] =>
  controlReport(
    scenarioOf({ version: 1, system: 'bicycle-rider', parameters, at: { speed } }),
    system,
  ).eigenvalues.filter(([re, im]) => Math.hypot(re, im) > 0);

test.each([
  [5, [7.3016, 0], [0.1416, 2.6187], [0.1416, -2.6187], [-1.5783, 0], [-6.7762, 0], [-12.2337, 0]],
  [8, [7.1069, 0], [0.1006, 0], [-2.2869, 6.1922], [-2.2869, -6.1922], [-5.9692, 0], [-17.4699, 0]],
] as [number, ...Complex[]][])('eigenvalues at %d m/s as printed', (speed, ...printed) => {
  const found = moving({}, speed);
  expect(found).toHaveLength(6);
  for (const [re, im] of printed)
    expect(Math.min(...found.map(([a, b]) => Math.max(Math.abs(a - re), Math.abs(b - im))))).toBeLessThan(5.01e-5);
});

test.each(reference.cases)('eigenvalues at $speed m/s with $parameters', ({ parameters, speed, eigenvalues }) => {
  const found = moving(parameters, speed);
  expect(found).toHaveLength(eigenvalues.length);
  expect(spectralDistance(eigenvalues, found)).toBeLessThan(1e-9);
});

test('with the lean held it is the Whipple bicycle whose rear frame carries the rider', () => {
  const { parameters: p } = scenarioOf({ version: 1, system: 'bicycle-rider' });
  const mass = p.frameMass! + p.riderMass!;
  const [x, z] = (['X', 'Z'] as const).map(
    (axis) => (p.frameMass! * p[`frame${axis}`]! + p.riderMass! * p[`rider${axis}`]!) / mass,
  ) as [number, number];
  const sum = (axes: string, steiner: (dx: number, dz: number) => number): number =>
    (['frame', 'rider'] as const).reduce(
      (total, body) =>
        total + p[`${body}I${axes}`]! + p[`${body}Mass`]! * steiner(p[`${body}X`]! - x, p[`${body}Z`]! - z),
      0,
    );
  const whipple = Object.fromEntries(systems.bicycle!.meta.parameters.map(({ name }) => [name, p[name]!]));
  const rigid = scenarioOf({
    version: 1,
    system: 'bicycle',
    parameters: {
      ...whipple,
      frameMass: mass,
      frameX: x,
      frameZ: z,
      frameIxx: sum('xx', (_, dz) => dz * dz),
      frameIyy: sum('yy', (dx, dz) => dx * dx + dz * dz),
      frameIzz: sum('zz', (dx) => dx * dx),
      frameIxz: sum('xz', (dx, dz) => -dx * dz),
    },
    at: { speed: 4 },
  });
  const held = scenarioOf({ version: 1, system: 'bicycle-rider', hold: ['lean'], at: { speed: 4 } });
  const nonzero = (values: readonly Complex[]) => values.filter((value) => Math.hypot(...value) > 0);
  expect(
    spectralDistance(
      nonzero(controlReport(rigid, systems.bicycle!).eigenvalues),
      nonzero(controlReport(held, system).eigenvalues),
    ),
  ).toBeLessThan(1e-9);
});

describe('in motion', () => {
  const run = (id: string) => runOf(cases.find((c) => c.id === id)!.scenario);
  test('a limp rider topples at the rate of the fastest mode', () => {
    const { columns } = run('bicycle-rider-limp');
    const [t, lean] = [columns.get('t')!, columns.get('lean')!];
    const at = (time: number) => Math.abs(lean[t.findIndex((x) => x >= time - 1e-9)]!);
    // Once the slower modes are behind, and before the sine is no line.
    expect(Math.abs(Math.log(at(0.6) / at(0.4)) / 0.2 / 7.3016 - 1)).toBeLessThan(0.02);
  });
  test('a firm waist rights it, and what its damper takes is missing in the energy', () => {
    const { columns, counts } = runOf({
      ...cases.find((c) => c.id === 'bicycle-rider-firm')!.scenario,
      columns: ['energy'],
    });
    for (const name of ['roll', 'lean']) expect(Math.abs(columns.get(name)!.at(-1)!)).toBeLessThan(0.01);
    const energy = columns.get('energy')!;
    expect(energy.at(-1)!).toBeLessThan(energy[0]!);
    expect(counts.steps).toBeGreaterThan(0);
  });
});
