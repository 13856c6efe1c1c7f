// The rider on the board against an independent model (tests/reference/ripstik-rider.json).
import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { lqrOf, operatingPoint } from '../../src/core/control/design/scenarioControl.ts';
import { controlReport } from '../../src/core/control/design/report.ts';
import type { Complex } from '../../src/core/control/linearization/spectrum.ts';
import { marginsOf } from '../../src/core/control/margins.ts';
import { systems } from '../../src/core/systems/all.ts';
import { cases } from '../../src/core/systems/registry.ts';
import { formulations } from '../../src/core/mechanics/formulations/formulations.ts';
import { ConstrainedSystem } from '../../src/core/mechanics/constrainedSystem.ts';
import { spectralDistance } from '../core/control/helpers.ts';
import { distance, endOf, runOf, scenarioOf } from '../helpers.ts';

interface Reference {
  cases: {
    ankleStiffness: number;
    ankleDamping: number;
    speed: number;
    multipliers: number[];
    eigenvalues: Complex[];
  }[];
}
const reference = JSON.parse(readFileSync('tests/reference/ripstik-rider.json', 'utf8')) as Reference;
const system = systems['ripstik-rider']!;
const { scenario: balanced } = cases.find((c) => c.id === 'rider-balanced')!;

/** The reference's own rounding of a zero. */
const NEUTRAL = 1e-4;
const size = ([re, im]: Complex) => Math.hypot(re, im);

test.each(reference.cases)(
  'multipliers and eigenvalues with ankles of $ankleStiffness N·m/rad at $speed m/s',
  ({ ankleStiffness, ankleDamping, speed, multipliers, eigenvalues }) => {
    const scenario = scenarioOf({
      version: 1,
      system: 'ripstik-rider',
      parameters: { ankleStiffness, ankleDamping },
      at: { X_dot: speed },
    });
    const { lambda } = operatingPoint(scenario, system);
    multipliers.forEach((known, i) => expect(Math.abs(lambda[i]! - known)).toBeLessThan(1e-6));
    const found = controlReport(scenario, system).eigenvalues;
    const moving = eigenvalues.filter((value) => size(value) >= NEUTRAL);
    expect(found).toHaveLength(eigenvalues.length);
    expect(found.filter(([re, im]) => re === 0 && im === 0)).toHaveLength(eigenvalues.length - moving.length);
    expect(
      spectralDistance(
        moving,
        found.filter((value) => size(value) > 0),
      ),
    ).toBeLessThan(1e-6);
  },
);

describe('balanced by the feet', () => {
  test.each([
    { speed: 0, largest: 58_226, delay: 0.205, growth: 2.998 },
    { speed: 1, largest: 1_684, delay: 0.21, growth: 2.889 },
    { speed: 5, largest: 144, delay: 0.236, growth: 2.564 },
  ])('at $speed m/s: largest gain $largest, delay margin $delay s', ({ speed, largest, delay, growth }) => {
    const design = lqrOf(
      scenarioOf({ ...balanced, control: { ...balanced.control, at: speed > 0 ? { X_dot: speed } : {} } }),
      system,
    );
    const gains = design.gain.to2DArray().flat().map(Math.abs);
    expect(Math.abs(Math.max(...gains) / largest - 1)).toBeLessThan(0.01);
    const growing = design.openLoop.filter(([re]) => re > 0);
    expect(growing).toHaveLength(1);
    expect(Math.abs(growing[0]![0] - growth)).toBeLessThan(1e-3);
    const { A, B } = design.quotient;
    const margins = marginsOf({ A, B, K: design.riccati.gain }, design.linearization.inputs);
    expect(Math.abs(margins.delay / delay - 1)).toBeLessThan(0.01);
  });

  test.each([0.001, 0.01, 0.03, 0.1, 0.3, 0.5, 0.7, 3, 10])(
    'at %d m/s, however weakly the casters move the board: solved, heading and place left alone',
    (speed) => {
      const design = lqrOf(scenarioOf({ ...balanced, control: { ...balanced.control, at: { X_dot: speed } } }), system);
      expect(design.split.reachable.columns).toBe(12);
      expect(design.placed).toHaveLength(10);
      expect(design.unseen).toHaveLength(2);
      expect(design.riccati.residual).toBeLessThan(1e-11);
      for (const [re] of design.placed) expect(re).toBeLessThan(-1);
    },
  );

  test('from three degrees of the rider’s own lean at 1 m/s, the board upright: at most 88.2 N·m per ankle', () => {
    const run = runOf({ ...balanced, outputStep: 0.001 });
    expect(run.end.reason).toBe('end');
    const largest = (name: string) => run.columns.get(name)!.reduce((most, x) => Math.max(most, Math.abs(x)), 0);
    expect(Math.abs(Math.max(largest('tau_af'), largest('tau_ab')) - 88.2)).toBeLessThan(0.1);
    expect(Math.abs(run.columns.get('beta')!.at(-1)!)).toBeLessThan(1e-3);
  });
});

describe('legs and hips', () => {
  const body = ['crouch', 'twist'];
  const indices = body.map((name) => system.meta.coordinates.findIndex((c) => c.name === name));
  const largest = (x: Iterable<number>): number => Math.max(...[...x].map(Math.abs));

  test.each(['shortest', 'general'] as const)('held at 0 change nothing: %s way', (way) => {
    const { states } = JSON.parse(readFileSync('tests/reference/ripstik-rider-stiff.json', 'utf8')) as {
      states: Record<'q' | 'v' | 'acceleration' | 'multipliers' | 'energies', number[]>[] & { constraints: string }[];
    };
    expect(states.length).toBeGreaterThan(20);
    const p = Float64Array.from(system.meta.parameters, (m) => m.default);
    for (const { constraints, q, v, acceleration, multipliers, energies } of states) {
      const d = new ConstrainedSystem(system, p, constraints, indices, null, way);
      const [place, rate] = [Float64Array.from([...q, 0, 0]), Float64Array.from([...v, 0, 0])];
      const [a, lambda, now] = [new Float64Array(13), new Float64Array(d.m), new Float64Array(2)];
      expect(d.acceleration(0, place, rate, a, lambda)).toBe(true);
      system.energy(place, rate, p, now);
      for (const [is, was] of [
        [a, [...acceleration, 0, 0]],
        [lambda, multipliers],
        [now, energies],
      ] as const)
        is.forEach((x, i) => expect(Math.abs(x - was[i]!)).toBeLessThan(1e-12 * largest(was)));
    }
  });

  test.each([0, 1, 5])('released, upright at %d m/s: the legs bear the weight and swing by themselves', (X_dot) => {
    const scenario = scenarioOf({ version: 1, system: 'ripstik-rider', release: body, at: { X_dot } });
    const { riderMass: m, legStiffness: k, legDamping: c } = scenario.parameters;
    const held = controlReport(scenarioOf({ version: 1, system: 'ripstik-rider', at: { X_dot } }), system);
    const { states, eigenvalues } = controlReport(scenario, system);
    expect(states).toHaveLength(26);
    expect(held.states).toHaveLength(26);
    expect(eigenvalues).toHaveLength(held.eigenvalues.length + 4);
    const own: Complex = [-c! / (2 * m!), Math.sqrt(k! / m! - (c! / (2 * m!)) ** 2)];
    const apart = eigenvalues.map(([re, im]) => Math.hypot(re - own[0], Math.abs(im) - own[1])).sort((a, b) => a - b);
    expect(apart[1]).toBeLessThan(1e-8);
    expect(operatingPoint(scenario, system).lambda[1]).toBeCloseTo(
      operatingPoint(scenarioOf({ version: 1, system: 'ripstik-rider', at: { X_dot } }), system).lambda[1]!,
      9,
    );
  });

  test.each([
    ['both held, crouched', {}],
    ['crouch free', { release: ['crouch'] }],
    ['twist free', { release: ['twist'] }],
    ['both free', { hold: [] }],
  ])('%s: every formulation and method has the same motion; energy and contact stay', (_, holding) => {
    const raw = {
      version: 1,
      system: 'ripstik-rider',
      ...holding,
      initial: { X_dot: 1, beta: '1 deg', crouch: 0.06, twist: 0.2 },
      parameters: { ankleDamping: 0, legDamping: 0, hipDamping: 0 },
      duration: 0.4,
    };
    const run = runOf({ ...raw, outputStep: 0.02, method: { rtol: 1e-10, atol: 1e-12 } });
    expect(run.end.reason).toBe('end');
    const energy = run.columns.get('energy')!;
    expect(largest(energy.map((x) => x - energy[0]!)) / energy[0]!).toBeLessThan(1e-9);
    expect(largest(run.columns.get('residual')!)).toBeLessThan(1e-12);
    for (const name of body) {
      const moved = run.columns.get(name)!.at(-1)! !== run.columns.get(name)![0]!;
      expect(moved, name).toBe(!scenarioOf(raw).hold.includes(name));
    }
    const known = endOf({ ...raw, method: { rtol: 1e-10, atol: 1e-12 } });
    for (const { id } of formulations)
      expect(distance(endOf({ ...raw, method: { formulation: id, rtol: 1e-10, atol: 1e-12 } }), known)).toBeLessThan(
        1e-7,
      );
    expect(distance(endOf({ ...raw, method: { name: 'ida', rtol: 1e-9, atol: 1e-11 } }), known)).toBeLessThan(1e-4);
  });

  test('hips that swing carry the board on: 2.09 m/s in place of 1.28 after 12 s', () => {
    const { scenario } = cases.find((c) => c.id === 'rider-hips')!;
    const speed = (raw: object): number => {
      const { columns } = runOf(raw);
      return Math.hypot(columns.get('X_dot')!.at(-1)!, columns.get('Y_dot')!.at(-1)!);
    };
    expect(speed(scenario)).toBeCloseTo(2.094, 2);
    expect(speed({ ...scenario, control: { ...scenario.control, commands: [] } })).toBeCloseTo(1.278, 2);
  });

  test('legs that give take a landing up: 10.4 cm, 1,444 N on the wheels; stiff ones 2,088 N', () => {
    const { scenario } = cases.find((c) => c.id === 'rider-landing')!;
    const landed = (parameters: object) => {
      const { columns, end } = runOf({ ...scenario, parameters });
      expect(end.reason).toBe('end');
      const [front, back] = [columns.get('lambda_2')!, columns.get('lambda_4')!];
      return { deep: Math.max(...columns.get('crouch')!), load: Math.max(...front.map((x, i) => x + back[i]!)) };
    };
    const soft = landed({});
    expect(soft.deep).toBeCloseTo(0.104, 3);
    expect(Math.abs(soft.load - 1444)).toBeLessThan(2);
    expect(Math.abs(landed({ legStiffness: 20_000 }).load - 2088)).toBeLessThan(3);
  });

  test('weights by the name of a state reach what is free, and the gain is that of the held rider where it is not', () => {
    const control = { ...balanced.control, inputs: ['tau_af', 'tau_ab', 'tau_twist_rider'] } as object;
    const Q = { ...(balanced.control as { Q: object }).Q, twist: 100, twist_dot: 1 };
    const free = lqrOf(scenarioOf({ ...balanced, release: ['twist'], control: { ...control, Q } }), system);
    const row = free.gain.getRow(2);
    expect(Math.abs(row[indices[1]!]!)).toBeGreaterThan(1);
    const [held, known] = [control, balanced.control].map(
      (one) => lqrOf(scenarioOf({ ...balanced, control: one }), system).gain,
    );
    known!
      .to2DArray()
      .forEach((gains, i) =>
        gains.forEach((x, j) => expect(Math.abs(held!.get(i, j) - x)).toBeLessThan(1e-6 * largest(gains))),
      );
  });
});
