// Paths and the steady turns that follow them.
import { Matrix } from 'ml-matrix';
import { describe, expect, test } from 'vitest';
import { plantOf } from '../../../../src/core/control/design/scenarioControl.ts';
import { compareOrders } from '../../../../src/core/control/linearization/linearize.ts';
import { eigenvalues } from '../../../../src/core/control/linearization/spectrum.ts';
import { steadyMotionAt, type SteadyMotion } from '../../../../src/core/control/linearization/steadyMotion.ts';
import { pathCurve, type PathPlace } from '../../../../src/core/control/path/pathCurve.ts';
import { turnMap } from '../../../../src/core/control/path/turnMap.ts';
import { steadyTurn } from '../../../../src/core/control/path/steadyTurn.ts';
import { ConstrainedSystem } from '../../../../src/core/mechanics/constrainedSystem.ts';
import { inputsOf } from '../../../../src/core/model/inputs.ts';
import { systems } from '../../../../src/core/systems/all.ts';
import { runOf, scenarioOf } from '../../../helpers.ts';
import { linearizationOf, spectralDistance } from '../helpers.ts';

const system = systems['ripstik']!;
const plant = plantOf(scenarioOf({ version: 1, system: 'ripstik' }), system);
const named = (...names: string[]) => names.map((name) => inputsOf(system.meta).find((i) => i.name === name)!);
const MOTORS = named('tau_fc', 'tau_bc');
const place = (): PathPlace => ({ x: 0, y: 0, heading: 0, curvature: 0 });

describe('the nearest place', () => {
  test('on a line and on circles to both sides', () => {
    const at = place();
    pathCurve({ line: { x: 1, y: 2, heading: Math.PI / 2 } }).nearest(4, 7, 0, at);
    expect(at.x).toBeCloseTo(1, 12);
    expect(at.y).toBeCloseTo(7, 12);
    for (const side of [1, -1]) {
      pathCurve({ circle: { radius: 2 * side, x: 0, y: 0, heading: 0 } }).nearest(5, 2 * side, 0, at);
      expect(at.x).toBeCloseTo(2, 12);
      expect(at.y).toBeCloseTo(2 * side, 12);
      expect(Math.cos(at.heading - (side * Math.PI) / 2)).toBeCloseTo(1, 12);
      expect(at.curvature).toBe(side / 2);
    }
  });

  test('on a spline through a circle, closed: its curvature and heading', () => {
    const points = Array.from({ length: 24 }, (_, i): [number, number] => {
      const a = (2 * Math.PI * i) / 24;
      return [3 * Math.cos(a), 3 * Math.sin(a)];
    });
    const curve = pathCurve({ points, closed: true });
    for (const bend of curve.bends) expect(bend).toBeCloseTo(1 / 3, 2);
    for (let i = 0; i < 40; i++) {
      const a = 0.157 * i;
      const at = place();
      curve.nearest(3.3 * Math.cos(a), 3.3 * Math.sin(a), a + Math.PI / 2, at);
      expect(Math.hypot(at.x - 3 * Math.cos(a), at.y - 3 * Math.sin(a))).toBeLessThan(2e-3);
      expect(Math.cos(at.heading - a - Math.PI / 2)).toBeGreaterThan(1 - 1e-4);
    }
  });

  test('where a path crosses itself, on the branch that goes the way it heads', () => {
    const eight = pathCurve({ curve: { x: '3*sin(t)', y: '1.5*sin(2*t)', to: 2 * Math.PI }, closed: true });
    for (const way of [1, -1]) {
      const at = place();
      eight.nearest(0.02, 0.01, (way * Math.PI) / 4 + (way < 0 ? Math.PI : 0) + 0.1, at);
      expect(Math.cos(at.heading - ((way * Math.PI) / 4 + (way < 0 ? Math.PI : 0)))).toBeGreaterThan(0.99);
    }
  });
});

describe('steady turns of the board', () => {
  test('of curvature 0 is going straight on, its linearization that without the way along', () => {
    const turn = steadyTurn(plant, { X_dot: 1 }, 0, MOTORS);
    expect([...turn.u0]).toEqual([0, 0]);
    const straight = linearizationOf({ control: { type: 'lqr', inputs: ['tau_fc', 'tau_bc'], at: { X_dot: 1 } } });
    expect(turn.linearization.basis.columns).toBe(straight.basis.columns - 1);
    const [a, b] = [turn.linearization, straight].map((l) => eigenvalues(l.tangentA));
    expect(
      spectralDistance(
        a!.filter(([re]) => Math.abs(re) > 1),
        b!,
      ),
    ).toBeLessThan(1e-9);
  });

  test.each([
    [1, 1],
    [1, -1],
    [2, 0.4],
  ])('at %f m/s and curvature %f 1/m the free board stays on it as long as it can', (speed, curvature) => {
    const { motion, u0 } = steadyTurn(plant, { X_dot: speed }, curvature, MOTORS);
    const { coordinates } = system.meta;
    const initial = Object.fromEntries(
      coordinates.flatMap(({ name }, i) => [
        ...(name === 'Z' || name === 'psi' ? [] : [[name, motion.q[i]!]]),
        ...(motion.v[i] !== 0 ? [[`${name}_dot`, motion.v[i]!]] : []),
      ]),
    );
    const duration = 0.5;
    const run = runOf({
      version: 1,
      system: 'ripstik',
      initial,
      inputs: { tau_fc: u0[0], tau_bc: u0[1] },
      method: { name: 'dop853', rtol: 1e-12, atol: 1e-14 },
      duration,
    });
    // Growing modes of 10 to 12 1/s raise what is left of rounding.
    const end = (name: string): number => run.columns.get(name)!.at(-1)!;
    expect(end('theta') - motion.q[5]!).toBeCloseTo(curvature * speed * duration, 6);
    expect(Math.hypot(end('X'), end('Y') - 1 / curvature)).toBeCloseTo(1 / Math.abs(curvature), 6);
    expect(end('alpha_fp')).toBeCloseTo(motion.q[6]!, 6);
  });

  test('left and right are mirror images; place and heading swing once a turn', () => {
    const [left, right] = [1, -1].map((k) => steadyTurn(plant, { X_dot: 1.5 }, k, MOTORS));
    expect([...right!.u0].map((u, i) => u + left!.u0[i]!)).toSatisfy((sums: number[]) =>
      sums.every((x) => Math.abs(x) < 1e-9),
    );
    const swings = eigenvalues(left!.linearization.tangentA).filter(
      ([re, im]) => Math.abs(re) < 1e-6 && Math.abs(im) > 1,
    );
    expect(swings.map(([, im]) => Math.abs(im))).toEqual([expect.closeTo(1.5, 6), expect.closeTo(1.5, 6)]);
  });

  test.each([0.5, 1, -1])('commute too, held by inputs, at a curvature of %f 1/m', (curvature) => {
    const { motion, u0 } = steadyTurn(plant, { X_dot: 1 }, curvature, MOTORS);
    const { difference, frozenDifference } = compareOrders(motion, MOTORS);
    expect(Math.min(...u0.map(Math.abs))).toBeGreaterThan(0.05);
    expect(difference).toBeLessThan(1e-9);
    expect(frozenDifference).toBeGreaterThan(100);
  });

  test('are refused where drag stops them, and by inputs along the axes of the ground', () => {
    const dragged = plantOf(scenarioOf({ version: 1, system: 'ripstik', parameters: { wheelDrag: 0.5 } }), system);
    expect(() => steadyTurn(dragged, { X_dot: 1 }, 1, MOTORS)).toThrow(/no steady motion/);
    expect(() => steadyTurn(plant, { X_dot: 1 }, 1, named('tau_fc', 'f_X'))).toThrow(
      /f_X pushes along the ground's own axes/,
    );
    expect(() => steadyTurn(plant, {}, 1, MOTORS)).toThrow(/along x/);
  });
});

test('eliminating and linearizing commute under control forces too, as long as the force of the constraints is kept', () => {
  // At rest, leaning, held by the feet: u0 is what the acceleration asks for.
  const free = steadyMotionAt(plant, {});
  const { coordinates } = system.meta;
  const q = free.q.slice();
  const at = (name: string): number => coordinates.findIndex((c) => c.name === name);
  q[at('alpha_fp')] = 0.15;
  q[at('alpha_bp')] = 0.15;
  const bare = new ConstrainedSystem(system, plant.parameters, 'rolling', [], null);
  const [a, lambda] = [new Float64Array(10), new Float64Array(4)];
  const inputs = inputsOf(system.meta).filter(({ name }) => /^f_/.test(name));
  // Forces on all coordinates that cancel the accelerations of the leaning board.
  bare.acceleration(0, q, free.v, a, lambda);
  const M = new Matrix(10, 10);
  bare.evaluate(0, q, free.v);
  for (let i = 0; i < 10; i++) for (let k = 0; k < 10; k++) M.set(i, k, bare.massMatrix[i * 10 + k]!);
  const u0 = M.mmul(Matrix.columnVector([...a]))
    .mul(-1)
    .to1DArray();
  const forcing = Object.assign(
    (_t: number, _q: Float64Array, _v: Float64Array, force: Float64Array) => u0.forEach((u, i) => (force[i]! += u)),
    { jacobians: () => {} },
  );
  const dynamics = new ConstrainedSystem(system, plant.parameters, 'rolling', [], forcing);
  dynamics.acceleration(0, q, free.v, a, lambda);
  expect(Math.max(...a.map(Math.abs))).toBeLessThan(1e-9);
  expect(Math.max(...u0.map(Math.abs))).toBeGreaterThan(1);
  const motion: SteadyMotion = { ...free, dynamics, q, lambda };
  const { difference, frozenDifference } = compareOrders(motion, inputs);
  expect(difference).toBeLessThan(1e-8);
  expect(frozenDifference).toBeGreaterThan(1);
});

test('the map of turns: the wide ones are going straight, and what is no turn is left out', () => {
  const control = { type: 'lqr', inputs: ['tau_fc', 'tau_bc'], at: { X_dot: 1 } };
  const scenario = scenarioOf({ version: 1, system: 'ripstik', control });
  const { growth, effort, orders } = turnMap(scenario, system, () => {}, [1, 100], [1]);
  expect(orders).toMatchObject({ radius: 1, speed: 1, u0: { tau_fc: expect.closeTo(0.1962, 4) as number } });
  expect(orders!.difference).toBeLessThan(1e-9);
  expect(growth[0]![1]).toBeCloseTo(9.372, 2);
  expect(effort[0]![0]).toBeGreaterThan(10 * effort[0]![1]!);
  const dragged = scenarioOf({ version: 1, system: 'ripstik', parameters: { wheelDrag: 0.5 } });
  expect(turnMap(dragged, system, () => {}, [1], [1]).growth).toEqual([[null]]);
});

describe('a board that follows', () => {
  const file = (path: object, more: object = {}) => ({
    version: 1,
    system: 'ripstik',
    initial: { X_dot: 1 },
    duration: 7,
    control: {
      type: 'lqr',
      inputs: ['tau_fc', 'tau_bc'],
      at: { X_dot: 1 },
      sample: 0.005,
      delay: 0.005,
      design: 'sampled',
      actuators: { tau_fc: { lag: 0.001 } },
      Q: { Y: 1, theta: 1, alpha_fp: 1, alpha_bp: 1 },
      path,
    },
    ...more,
  });

  test('a circle of 1 m from going straight on, within 10 cm, and comes onto it', () => {
    const run = runOf(file({ circle: { radius: 1 } }));
    const [X, Y] = [run.columns.get('X')!, run.columns.get('Y')!];
    const off = [...X].map((x, i) => Math.abs(Math.hypot(x, Y[i]! - 1) - 1));
    expect(run.end.reason).toBe('end');
    expect(Math.max(...off)).toBeLessThan(0.1);
    expect(run.columns.get('theta')!.at(-1)).toBeGreaterThan(2 * Math.PI - 0.3);
  });

  test('a line that lies aside and across', () => {
    const run = runOf(file({ line: { heading: '10 deg', y: 0.2 } }));
    const [c, s] = [Math.cos(Math.PI / 18), Math.sin(Math.PI / 18)];
    const [x, y] = ['X', 'Y'].map((name) => run.columns.get(name)!.at(-1)!);
    expect(Math.abs(c * (y! - 0.2) - s * x!)).toBeLessThan(0.02);
  });

  test('a typed curve', () => {
    const run = runOf(file({ curve: { x: 't', y: '0.5 - 0.5*cos(0.6*t)', to: 12 } }, { duration: 8 }));
    const [X, Y] = [run.columns.get('X')!, run.columns.get('Y')!];
    expect(run.end.reason).toBe('end');
    const off = [...X].map((x, i) => Math.abs(Y[i]! - 0.5 + 0.5 * Math.cos(0.6 * x)));
    expect(Math.max(...off.slice(-200))).toBeLessThan(0.1);
  });

  test.each([
    [{}, 'control.path'],
    [{ line: {}, circle: {} }, 'control.path'],
    [{ circle: {} }, 'control.path.circle.radius'],
    [{ points: [[0, 0]] }, 'control.path.points'],
    [
      {
        points: [
          [0, 0],
          [0, 0],
          [1, 1],
        ],
      },
      'control.path.points[1]',
    ],
    [{ curve: { x: 't', y: 's', to: 1 } }, 'control.path.curve.y'],
    [{ line: {}, closed: true }, 'control.path.closed'],
  ])('%j is refused at %s', (path, where) => {
    expect(() => scenarioOf(file(path))).toThrow(expect.objectContaining({ path: where }) as Error);
  });
});
