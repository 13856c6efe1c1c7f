// A push by hand, on every system: its force is the gradient of what it does, its power is what the energy gains.
import { describe, expect, test } from 'vitest';
import { ConstrainedSystem } from '../../src/core/mechanics/constrainedSystem.ts';
import { PushForce } from '../../src/core/simulation/pushForce.ts';
import type { Push, PushRecord } from '../../src/core/simulation/push.ts';
import { Simulation } from '../../src/core/simulation/simulation.ts';
import { systems } from '../../src/core/systems/all.ts';
import type { System } from '../../src/core/model/system.ts';
import { scenarioOf, seeded } from '../helpers.ts';

const pushable = Object.entries(systems).filter(([, system]) => system.poseJacobian);
const SEEDS = [1, 2, 3, 4];

/** A state near the ground's, default parameters, a push on any body. */
function draw(system: System, seed: number) {
  const random = seeded(seed);
  const between = (a: number, b: number): number => a + (b - a) * random();
  const { coordinates, bodies, parameters } = system.meta;
  const q = Float64Array.from(coordinates, ({ rest = 0 }) => rest + between(-0.3, 0.3));
  const v = Float64Array.from(coordinates, () => between(-2, 2));
  const p = Float64Array.from(parameters, (m) => m.default);
  const triple = (): [number, number, number] => [between(-1, 1), between(-1, 1), between(-1, 1)];
  const push: Push = {
    body: bodies[Math.floor(random() * bodies.length)]!.id,
    point: triple(),
    target: triple(),
    stiffness: between(10, 200),
    damping: between(1, 20),
    ...(seed % 2 === 0 ? { moving: { velocity: triple(), since: between(-0.1, 0.1) } } : {}),
  };
  return { q, v, p, push };
}

/** Where a point of a body is, m. */
function placeOf(system: System, p: Float64Array, { body, point }: Push, q: Float64Array): number[] {
  const poses = new Float64Array(12 * system.meta.bodies.length);
  system.poses(q, p, poses);
  const o = 12 * system.meta.bodies.findIndex((b) => b.id === body);
  return [0, 1, 2].map(
    (c) => poses[o + c]! + [0, 1, 2].reduce((sum, k) => sum + poses[o + 3 + 3 * c + k]! * point[k]!, 0),
  );
}

describe.each(pushable)('a push on %s', (id, system) => {
  const n = system.meta.coordinates.length;

  test.each(SEEDS)('moves the point as its velocity says (seed %i)', (seed) => {
    const { q, v, p, push } = draw(system, seed);
    const hand = new PushForce(system, p);
    hand.set(push);
    hand.at(0, q, v);
    const step = 1e-5;
    const [ahead, behind] = [step, -step].map((s) =>
      placeOf(
        system,
        p,
        push,
        q.map((x, i) => x + s * v[i]!),
      ),
    );
    for (let c = 0; c < 3; c++) {
      expect(hand.place[c]).toBeCloseTo(placeOf(system, p, push, q)[c]!, 13);
      expect(hand.velocity[c]).toBeCloseTo((ahead![c]! - behind![c]!) / (2 * step), 7);
    }
  });

  test.each(SEEDS)('gives energy at the rate of its power (seed %i)', (seed) => {
    const { q, v, p, push } = draw(system, seed);
    const hand = new PushForce(system, p);
    const set = system.meta.constraintSets[0]?.id ?? 'none';
    const dynamics = new ConstrainedSystem(system, p, set, [], hand.forcing);
    // Velocities that the constraints allow: their forces do no work then.
    if (dynamics.m > 0) {
      expect(dynamics.prepare(0, q, v)).toBe(true);
      dynamics.measure(q, v);
      dynamics.shift(
        dynamics.slip.map((x) => -x),
        v,
      );
    }
    const [free, pushed] = [new Float64Array(n), new Float64Array(n)];
    expect(dynamics.acceleration(0, q, v, free, new Float64Array(dynamics.m))).toBe(true);
    hand.set(push);
    dynamics.forget();
    expect(dynamics.acceleration(0, q, v, pushed, new Float64Array(dynamics.m))).toBe(true);
    const massMatrix = new Float64Array(n * n);
    system.mechanics(q, v, p, massMatrix, new Float64Array(n));
    let gained = 0;
    for (let i = 0; i < n; i++)
      for (let k = 0; k < n; k++) gained += v[i]! * massMatrix[i * n + k]! * (pushed[k]! - free[k]!);
    const power = [0, 1, 2].reduce((sum, c) => sum + hand.pull[c]! * hand.velocity[c]!, 0);
    expect(Math.abs(gained - power), id).toBeLessThan(1e-10 * (Math.abs(power) + push.stiffness));
  });

  test.each(SEEDS)('has the derivatives that Newton’s iterations ask for (seed %i)', (seed) => {
    const { q, v, p, push } = draw(system, seed);
    const hand = new PushForce(system, p);
    hand.set(push);
    const [forceQ, forceV] = [new Float64Array(n * n), new Float64Array(n * n)];
    hand.forcing.jacobians!(0, q, v, forceQ, forceV);
    const force = (): Float64Array => {
      const out = new Float64Array(n);
      hand.forcing(0, q, v, out);
      return out;
    };
    for (const [x, slopes] of [
      [q, forceQ],
      [v, forceV],
    ] as const) {
      for (let j = 0; j < n; j++) {
        const kept = x[j]!;
        x[j] = kept + 1e-5;
        const up = force();
        x[j] = kept - 1e-5;
        const down = force();
        x[j] = kept;
        for (let i = 0; i < n; i++)
          expect(Math.abs((up[i]! - down[i]!) / 2e-5 - slopes[i * n + j]!)).toBeLessThan(1e-5 * push.stiffness);
      }
    }
  });
});

const rolling = {
  version: 1,
  system: 'ripstik',
  initial: { X_dot: 1 },
  duration: 0.6,
  outputStep: 0.001,
  columns: ['energy'],
} as const;
const sideways: Push = {
  body: 'front-plate',
  point: [0.1, 0.1, 0],
  target: [1.2, 0.3, 0.1],
  stiffness: 3,
  damping: 0.5,
};

test.each([
  ['rests', sideways],
  [
    'goes with the board',
    { ...sideways, target: [0.15, 0.2, 0.1], moving: { velocity: [1, 0, 0], since: 0 } } satisfies Push,
  ],
] as const)('what a hand that %s does to the rolling board is what its energy gains', (_what, push) => {
  const scenario = scenarioOf({ ...rolling, duration: 0.4 });
  const simulation = new Simulation(scenario, systems['ripstik']!, { pushes: [{ time: 0, push }] });
  simulation.advance(() => false);
  const { columns, rows } = simulation.takeChunk();
  const hand = new PushForce(
    systems['ripstik']!,
    Float64Array.from(systems['ripstik']!.meta.parameters, (m) => scenario.parameters[m.name]!),
  );
  hand.set(push);
  const power = Array.from({ length: rows }, (_, row) => {
    const state = (from: number): Float64Array =>
      Float64Array.from({ length: 10 }, (_unused, i) => columns[from + i]![row]!);
    hand.at(columns[0]![row]!, state(1), state(11));
    return [0, 1, 2].reduce((sum, c) => sum + hand.pull[c]! * hand.velocity[c]!, 0);
  });
  // Simpson's rule over the rows, an even number of steps.
  let work = 0;
  for (let row = 0; row + 2 < rows; row += 2)
    work += (0.001 / 3) * (power[row]! + 4 * power[row + 1]! + power[row + 2]!);
  const energy = columns[simulation.columns.indexOf('energy')]!;
  expect(rows).toBe(401);
  expect(Math.abs(work)).toBeGreaterThan(0.01);
  expect(energy[rows - 1]! - energy[0]!).toBeCloseTo(work, 7);
});

/** Grabbed and dragged while it is watched, a little at a time. */
function live(scenario: ReturnType<typeof scenarioOf>): { pushes: PushRecord[]; simulation: Simulation } {
  const simulation = new Simulation(scenario, systems['ripstik']!, { pushes: [] });
  const pushes: PushRecord[] = [];
  for (let k = 1; !simulation.end; k++) {
    simulation.horizon = 0.0163 * k;
    simulation.advance(() => false);
    expect(simulation.time).toBeLessThanOrEqual(simulation.horizon);
    if (k === 12) pushes.push(simulation.push(sideways));
    if (k > 12 && k < 30 && k % 3 === 0)
      pushes.push(
        simulation.push({
          ...sideways,
          target: [1.2 + 0.01 * k, 0.3, 0.1],
          moving: { velocity: [0.6, 0, 0], since: 0.0163 * k },
        }),
      );
    if (k === 30) pushes.push(simulation.push(null));
  }
  return { pushes, simulation };
}

test.each(['dopri5', 'dop853', 'radau', 'gauss', 'bdf', 'ida', 'rk4'])(
  '%s: a run pushed live is repeated by its record',
  (name) => {
    const scenario = scenarioOf({
      ...rolling,
      outputStep: 0.01,
      method: name === 'rk4' ? { name, step: 0.001 } : { name, rtol: 1e-8, atol: 1e-10 },
    });
    const watched = live(scenario);
    const repeated = new Simulation(scenario, systems['ripstik']!, { pushes: watched.pushes });
    repeated.advance(() => false);
    const [a, b] = [watched.simulation.takeChunk(), repeated.takeChunk()];
    expect(a.rows).toBe(61);
    expect(b.rows).toBe(61);
    expect(watched.simulation.end?.reason).toBe('end');
    let largest = 0;
    for (let c = 0; c < 21; c++)
      for (let row = 0; row < 61; row++)
        largest = Math.max(largest, Math.abs(a.columns[c]![row]! - b.columns[c]![row]!));
    expect(largest).toBeLessThan(name === 'bdf' || name === 'ida' ? 2e-5 : 1e-6);
  },
);

test('a push on what is not there is refused by name', () => {
  const simulation = new Simulation(scenarioOf(rolling), systems['ripstik']!, { pushes: [] });
  expect(() => simulation.push({ ...sideways, body: 'wing' })).toThrow(/push\.body.*front-plate/);
  expect(() => simulation.push({ ...sideways, stiffness: NaN })).toThrow(/finite/);
  expect(
    () =>
      new Simulation(scenarioOf({ version: 1, system: 'stiff-decay' }), systems['stiff-decay']!, {
        pushes: [{ time: 0, push: sideways }],
      }),
  ).toThrow(/nothing of stiff-decay/);
});
