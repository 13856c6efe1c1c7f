import { describe, expect, test } from 'vitest';
import { ConstrainedSystem } from '../../src/core/mechanics/constrainedSystem.ts';
import { systems } from '../../src/core/systems/all.ts';
import { MujocoBoard } from '../../src/cli/bench/mujoco.ts';
import { scenarioOf, seeded } from '../helpers.ts';

const system = systems['ripstik']!;
const n = system.meta.coordinates.length;
const SEED = 20171207;

/** Positions, attitudes short of 90° pitch and velocities, far from any equilibrium. */
function stateOf(seed: number) {
  const random = seeded(seed);
  const q = Float64Array.from({ length: n }, (_, i) => (i === 4 ? 1.2 : 3) * (2 * random() - 1));
  const v = Float64Array.from({ length: n }, () => 8 * random() - 4);
  return { q, v };
}

test.each(['street', 'authors'])(
  'MuJoCo gives the free board the same acceleration at 50 states: %s',
  async (parameterSet) => {
    const { parameters } = scenarioOf({ version: 1, system: 'ripstik', parameterSet, constraints: 'none' });
    const p = Float64Array.from(system.meta.parameters, (m) => parameters[m.name]!);
    const dynamics = new ConstrainedSystem(system, p, 'none', [], null);
    const board = await MujocoBoard.load(parameters, 'hinges');
    const free = await MujocoBoard.load(parameters, 'free');
    const [a, expected] = [new Float64Array(n), new Float64Array(n)];
    for (let seed = SEED; seed < SEED + 50; seed++) {
      const { q, v } = stateOf(seed);
      expect(dynamics.acceleration(0, q, v, a, new Float64Array(0))).toBe(true);
      board.forward(board.positionsOf(q), board.velocitiesOf(q, v));
      board.acceleration(expected);
      const size = Math.max(...expected.map(Math.abs));
      a.forEach((x, i) =>
        expect(Math.abs(x - expected[i]!) / size, `seed ${seed}, ${system.meta.coordinates[i]!.name}`).toBeLessThan(
          1e-9,
        ),
      );
      // With a free joint the rod's rates are other numbers; its translation and the four joints are the same.
      free.forward(free.positionsOf(q), free.velocitiesOf(q, v));
      for (const [ours, theirs] of [
        [0, 0],
        [1, 1],
        [2, 2],
        [6, 6],
        [8, 7],
        [7, 8],
        [9, 9],
      ] as const) {
        expect(Math.abs(a[ours]! - free.accelerationAt(theirs)) / size, `free joint, seed ${seed}`).toBeLessThan(1e-9);
      }
    }
    board.dispose();
    free.dispose();
  },
);

const limp = { ankleStiffness: 0, ankleDamping: 0, legStiffness: 0, legDamping: 0, hipStiffness: 0, hipDamping: 0 };
type Moving = readonly ('crouch' | 'twist')[];

// Seven bodies: the rider's ankles, legs and hips are applied to MuJoCo's as generalized forces of their own.
describe.each<{ moving: Moving }>([
  { moving: [] },
  { moving: ['crouch'] },
  { moving: ['twist'] },
  { moving: ['crouch', 'twist'] },
])('of the rider moves $moving', ({ moving }) => {
  test.each([
    ['limp', limp],
    ['as they are', {}],
    [
      'a light and low rider',
      { riderMass: 25, riderHeight: 0.5, riderIxx: 1, riderIyy: 1.2, riderIzz: 0.4, hipIzz: 0.18, ankleStiffness: 90 },
    ],
  ])('MuJoCo gives the free board and its rider the same acceleration at 50 states: %s', async (_, changed) => {
    const ridden = systems['ripstik-rider']!;
    const { coordinates, parameters: metas } = ridden.meta;
    const { parameters } = scenarioOf({
      version: 1,
      system: 'ripstik-rider',
      parameters: changed,
      constraints: 'none',
      release: moving,
    });
    const p = Float64Array.from(metas, (m) => parameters[m.name]!);
    const at = (name: string): number => coordinates.findIndex((c) => c.name === name);
    const held = ['crouch', 'twist'].filter((name) => !moving.includes(name as 'crouch')).map(at);
    const dynamics = new ConstrainedSystem(ridden, p, 'none', held, null);
    const board = await MujocoBoard.load(parameters, 'hinges', moving);
    const count = coordinates.length;
    const [alpha, beta] = [at('alpha'), at('beta')];
    const [a, expected, force] = [new Float64Array(count), new Float64Array(count), new Float64Array(count)];
    for (let seed = SEED; seed < SEED + 50; seed++) {
      const random = seeded(seed);
      const q = Float64Array.from({ length: count }, (_x, i) => (i === 4 ? 1.2 : 3) * (2 * random() - 1));
      const v = Float64Array.from({ length: count }, () => 8 * random() - 4);
      // A joint that MuJoCo lacks is where its bodies were built; a body's height above the rod is never nothing.
      q[at('crouch')]! *= held.includes(at('crouch')) ? 0 : 0.1 * p[metas.findIndex((m) => m.name === 'riderHeight')]!;
      for (const i of held) q[i] = v[i] = 0;
      force.fill(0);
      for (const [name, stiffness, damping, weight] of [
        ['crouch', 'legStiffness', 'legDamping', parameters.riderMass! * parameters.gravity!],
        ['twist', 'hipStiffness', 'hipDamping', 0],
      ] as const)
        force[at(name)] = -weight - parameters[stiffness]! * q[at(name)]! - parameters[damping]! * v[at(name)]!;
      for (const plate of [at('alpha_fp'), at('alpha_bp')]) {
        const torque =
          -parameters.ankleStiffness! * (q[alpha]! + q[plate]! - q[beta]!) -
          parameters.ankleDamping! * (v[alpha]! + v[plate]! - v[beta]!);
        force[alpha]! += torque;
        force[plate]! += torque;
        force[beta]! -= torque;
      }
      expect(dynamics.acceleration(0, q, v, a, new Float64Array(0))).toBe(true);
      board.apply(force);
      board.forward(board.positionsOf(q), board.velocitiesOf(q, v));
      board.acceleration(expected);
      const size = Math.max(...expected.map(Math.abs));
      a.forEach((x, i) =>
        expect(Math.abs(x - expected[i]!) / size, `seed ${seed}, ${coordinates[i]!.name}`).toBeLessThan(1e-10),
      );
    }
    board.dispose();
  });
});
