import { expect, test } from 'vitest';
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
