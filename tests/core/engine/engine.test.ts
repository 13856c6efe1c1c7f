// Both engines give the same bits: accelerations at random states, and whole runs with projection, events, forces and rows.
import { describe, expect, test } from 'vitest';
import { machineFor } from '../../../src/core/engine/machine.ts';
import { embeddedPairs } from '../../../src/core/integrators/explicit.ts';
import { dopri5 } from '../../../src/core/integrators/runge-kutta/tableaus/dopri5.ts';
import { checkScenario } from '../../../src/core/scenario/schema.ts';
import type { ScenarioFile } from '../../../src/core/scenario/types.ts';
import { Simulation } from '../../../src/core/simulation/simulation.ts';
import { systems } from '../../../src/core/systems/all.ts';
import { seeded } from '../../helpers.ts';

const SEED = 20261128;
const STATES = 1000;
const metas = Object.fromEntries(Object.values(systems).map(({ meta }) => [meta.id, meta]));

const sets = Object.values(systems).flatMap((system) =>
  Object.values(system.constraintSets)
    .filter(({ direct }) => direct?.tape)
    .flatMap((set) =>
      Object.keys(system.meta.parameterSets).map((parameterSet) => ({
        name: `${system.meta.id}, ${set.id}, ${parameterSet}`,
        system,
        set,
        parameterSet,
      })),
    ),
);

/** Bits, so that -0 and NaN count too. */
const bits = (x: Float64Array): BigUint64Array => new BigUint64Array(x.slice().buffer);

describe('accelerations in WebAssembly', () => {
  test('there are some', () => expect(sets.length).toBeGreaterThan(3));

  test.each(sets)('$name: those of TypeScript, to the bit', ({ system, set, parameterSet }) => {
    const random = seeded(SEED);
    const n = system.meta.coordinates.length;
    const direct = set.direct!;
    const machine = machineFor(direct.tape!, set.id, dopri5, set.contact, n, true)!;
    const { memory, layout, run } = machine;
    const p = Float64Array.from(
      system.meta.parameters,
      (x) => system.meta.parameterSets[parameterSet]![x.name] ?? x.default,
    );
    const c = new Float64Array(direct.constantCount);
    const known = (direct.holdable ?? []).length;
    const [y, f, rate] = [new Float64Array(2 * n), new Float64Array(n), new Float64Array(2 * n)];
    const [lambda, factors] = [new Float64Array(set.rows), new Float64Array(direct.factorCount)];
    const [at, to] = [layout.steps, layout.steps + layout.place];
    const part = (from: number, length: number): Float64Array => memory.slice(from, from + length);
    for (let state = 0; state < STATES; state++) {
      // What may be held is, or is not.
      direct.prepare(Float64Array.from([...p, ...Array.from({ length: known }, (_, k) => (state >> (k + 1)) & 1)]), c);
      memory.set(c, layout.constants);
      // Ever larger angles: every quadrant, and ranges that lose digits.
      const size = state % 4 === 3 ? 1e3 : 2;
      for (let i = 0; i < 2 * n; i++) y[i] = size * (2 * random() - 1);
      for (let i = 0; i < n; i++) f[i] = state % 2 === 0 ? 0 : 10 * (2 * random() - 1);
      memory.set(y, at);
      memory.set(f, layout.force);
      const [mine, theirs] = [
        run.accelerations(8 * at, 8 * to) === 1,
        direct.accelerations(y, c, f, rate, lambda, factors),
      ];
      expect(mine, `seed ${SEED}, state ${state}`).toBe(theirs);
      if (!theirs) continue;
      expect(bits(part(to, 2 * n)), `seed ${SEED}, state ${state}`).toEqual(bits(rate));
      expect(bits(part(layout.lambda, set.rows)), `seed ${SEED}, state ${state}`).toEqual(bits(lambda));
      expect(bits(part(layout.factors, factors.length)), `seed ${SEED}, state ${state}`).toEqual(bits(factors));
    }
  });
});

const falling: ScenarioFile = {
  version: 1,
  system: 'ripstik',
  initial: { X_dot: 1, alpha: '0.5 deg' },
  duration: 3,
};
const moving: ScenarioFile = {
  ...falling,
  system: 'ripstik-rider',
  initial: { X_dot: 1, beta: '1 deg', crouch: 0.05, twist: 0.3, twist_dot: 1 },
};
const runs: Record<string, ScenarioFile> = {
  'the falling board, which touches down': falling,
  'to the end, corners ignored': { ...falling, events: { touchdown: 'ignore' }, duration: 1.5 },
  'without projection': { ...falling, method: { projection: false }, duration: 0.5 },
  'the report’s constraints': { ...falling, constraints: 'report', duration: 1 },
  'few rows': { ...falling, outputStep: 1.5 },
  'torques on both plates': {
    ...falling,
    inputs: { tau_fp: '0.3*sin(7*t)', tau_bp: '0.2*cos(5*t)' },
    duration: 1,
  },
  'a controller with a limit': {
    ...falling,
    control: { type: 'track', reference: { tau_fp: '0.2*sin(3*t)' }, kp: 5, kd: 1, limits: { tau_fp: 0.3 } },
    duration: 1,
  },
  'the bicycle': { version: 1, system: 'bicycle', duration: 2 },
  'a rider whose body is held': { ...falling, system: 'ripstik-rider', duration: 0.5 },
  'a rider whose body moves': { ...moving, release: ['crouch', 'twist'], duration: 0.5 },
  'a rider who crouches by a force': {
    ...moving,
    release: ['crouch'],
    inputs: { f_crouch: '200*sin(5*t)' },
    duration: 0.5,
  },
};

function resultOf(file: ScenarioFile, engine: 'wasm' | 'typescript') {
  const scenario = checkScenario({ ...file, method: { ...file.method, engine } }, metas);
  const simulation = new Simulation(scenario, systems[scenario.system]!, {
    extras: ['lambda', 'energy', 'residual', 'inputs'],
  });
  simulation.advance(() => false);
  const { end, counts, engine: made } = simulation;
  const { columns } = simulation.takeChunk();
  return { made, end, counts, columns: columns.map(bits) };
}

describe.each(Object.keys(embeddedPairs))('runs by %s', (name) => {
  test.each(Object.entries(runs))('%s: the same rows, end and counts from both engines', (_, file) => {
    const method = { rtol: name === 'bs23' ? 1e-4 : 1e-6, ...file.method, name };
    const [wasm, typescript] = [resultOf({ ...file, method }, 'wasm'), resultOf({ ...file, method }, 'typescript')];
    expect(wasm.made).toBe('wasm');
    expect(typescript.made).toBe('typescript');
    expect(wasm.end).toEqual(typescript.end);
    expect(wasm.counts).toEqual(typescript.counts);
    expect(wasm.columns).toEqual(typescript.columns);
  });
});

test('two runs that take turns on one machine leave each other alone', () => {
  const scenario = checkScenario(falling, metas);
  const alone = resultOf(falling, 'typescript');
  const both = [0, 1].map(() => new Simulation(scenario, systems['ripstik']!, { extras: [] }));
  while (both.some(({ end }) => !end)) for (const simulation of both) simulation.advance(() => true);
  for (const simulation of both) {
    const { columns } = simulation.takeChunk();
    expect(columns.map(bits)).toEqual(alone.columns.slice(0, columns.length));
  }
});

test('steps computed ahead are dropped where the run is held up, or goes on otherwise', () => {
  const held = (engine: 'wasm' | 'typescript') => {
    const scenario = checkScenario(
      { ...falling, duration: 1, events: { touchdown: 'ignore' }, method: { engine } },
      metas,
    );
    const simulation = new Simulation(scenario, systems['ripstik']!, { extras: ['lambda'] });
    for (const horizon of [0.1, 0.11, 0.3, 0.7, Infinity]) {
      simulation.horizon = horizon;
      simulation.advance(() => false);
    }
    return { end: simulation.end, counts: simulation.counts, columns: simulation.takeChunk().columns.map(bits) };
  };
  expect(held('wasm')).toEqual(held('typescript'));
});
