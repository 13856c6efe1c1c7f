import { Matrix } from 'ml-matrix';
import { describe, expect, test } from 'vitest';
import { compareOrders, linearize } from '../../../src/core/control/linearization/linearize.ts';
import { columnSpace } from '../../../src/core/control/linearization/matrices.ts';
import { operatingPoint } from '../../../src/core/control/design/scenarioControl.ts';
import { eigenvalues } from '../../../src/core/control/linearization/spectrum.ts';
import { steadyMotionAt } from '../../../src/core/control/linearization/steadyMotion.ts';
import { inputsOf } from '../../../src/core/model/inputs.ts';
import { systems } from '../../../src/core/systems/all.ts';
import { scenarioOf, seeded } from '../../helpers.ts';

const board = systems['ripstik']!;
const named = board.meta.inputs;
const motionOf = (raw: Record<string, unknown>) =>
  operatingPoint(scenarioOf({ version: 1, system: 'ripstik', ...raw }), board);
const rolling = (speed: number, heading: number) => ({
  X_dot: speed * Math.cos(heading),
  Y_dot: speed * Math.sin(heading),
  theta: heading,
});

describe('both orders of linearization', () => {
  const random = seeded(31);
  const points: [string, Record<string, unknown>][] = [
    ['upright at rest', {}],
    ['rolling at 1 m/s', { at: { X_dot: 1 } }],
    ['rolling at 7 m/s, wheels ahead of their pivots', { at: { X_dot: 7 }, parameterSet: 'authors' }],
    ['rolling backwards', { at: { X_dot: -0.8 } }],
    [
      'rolling with the rod rolled',
      { at: { ...rolling(2, 0), alpha: '20 deg', alpha_fp: '-20 deg', alpha_bp: '-20 deg' } },
    ],
    ['held rod', { at: {}, hold: ['X', 'Y', 'theta', 'alpha'] }],
    ["the report's rows", { at: { X_dot: 1 }, constraints: 'report' }],
    [
      'springs and losses at rest',
      { parameters: { torsionStiffness: 20, torsionDamping: 0.3, casterDamping: 0.01, wheelDrag: 2 } },
    ],
  ];
  for (let k = 0; k < 3; k++) {
    const [speed, heading] = [4 * random() - 2, 6 * random() - 3];
    points.push([
      `rolling at ${speed.toFixed(2)} m/s towards ${heading.toFixed(2)} rad`,
      { at: rolling(speed, heading) },
    ]);
  }

  test.each(points)('agree: %s', (_, raw) => {
    const orders = compareOrders(motionOf(raw), named);
    expect(orders.difference).toBeLessThan(1e-10);
    expect(orders.frozenDifference).toBeGreaterThan(1);
    // The tangent space is left only by rounding: the linear motion keeps the constraints.
    const { A, basis: N, tangentA } = orders.eliminateFirst;
    expect(Matrix.sub(A.mmul(N), N.mmul(tangentA)).norm()).toBeLessThan(1e-10);
  });

  test('the upright board: 10.99, with Omega frozen 14.04', () => {
    const { eliminateFirst, linearizeFirst, frozen } = compareOrders(motionOf({}), []);
    const fastest = (A: Matrix) => Math.max(...eigenvalues(A).map(([re]) => re));
    expect(fastest(eliminateFirst.tangentA)).toBeCloseTo(10.994308619, 8);
    expect(fastest(linearizeFirst.tangentA)).toBeCloseTo(10.994308619, 8);
    expect(fastest(frozen.tangentA)).toBeCloseTo(14.0386, 4);
  });

  test('where no multiplier carries weight, freezing Omega changes nothing', () => {
    const { frozenDifference } = compareOrders(motionOf({ parameters: { gravity: 0 } }), []);
    expect(frozenDifference).toBeLessThan(1e-11);
  });
});

describe('the linearization', () => {
  test('is 14-dimensional on the rolling board, 8 positions and 6 velocities, with an orthonormal basis', () => {
    const { basis, tangentA } = linearize(motionOf({ at: { X_dot: 1 } }), named);
    expect([basis.rows, basis.columns, tangentA.rows]).toEqual([20, 14, 14]);
    expect(Matrix.sub(basis.transpose().mmul(basis), Matrix.eye(14)).norm()).toBeLessThan(1e-13);
  });

  test('B is what each input does to the accelerations, raw forces included', () => {
    const motion = motionOf({ at: { X_dot: 1 } });
    const inputs = inputsOf(board.meta);
    const { B, inputs: names } = linearize(motion, inputs);
    const { dynamics: d, q, v } = motion;
    const [M, h] = [new Float64Array(100), new Float64Array(10)];
    board.mechanics(q, v, d.parameters, M, h);
    const mass = new Matrix(Array.from({ length: 10 }, (_, i) => [...M.subarray(10 * i, 10 * i + 10)]));
    const columns = B.subMatrix(10, 19, 0, names.length - 1);
    // M a - b is a constraint force: it does no work on velocities that Omega allows.
    d.refreshOmega(q, v);
    const Omega = new Matrix(Array.from({ length: 4 }, (_, r) => [...d.omega.subarray(10 * r, 10 * r + 10)]));
    expect(Omega.mmul(columns).norm()).toBeLessThan(1e-9);
    const unit = new Matrix(inputs.map((i) => board.meta.coordinates.map((c) => i.column[c.name] ?? 0))).transpose();
    const allowed = columnSpace(Omega.transpose(), 1e-10).complement;
    expect(
      allowed
        .transpose()
        .mmul(Matrix.sub(mass.mmul(columns), unit))
        .norm(),
    ).toBeLessThan(1e-9);
  });

  test('a held coordinate has neither column nor row', () => {
    const { A, B, basis } = linearize(motionOf({ hold: ['alpha', 'theta'] }), inputsOf(board.meta));
    expect(basis.columns).toBe(10);
    for (const i of [3, 5, 13, 15]) expect(Math.max(...basis.getRow(i).map(Math.abs))).toBeLessThan(1e-14);
    expect(Math.max(...[...A.getRow(13), ...B.getRow(13)].map(Math.abs))).toBe(0);
  });
});

describe('the point', () => {
  test('carries the weight: 29.4 and 19.6 N', () => {
    const { lambda, moving } = motionOf({ at: { X_dot: 1 } });
    expect(Math.abs(lambda[1]!)).toBeCloseTo(29.4, 1);
    expect(Math.abs(lambda[3]!)).toBeCloseTo(19.6, 1);
    expect(moving).toEqual(['X']);
  });

  test.each([
    ['a lean', { at: { alpha_fp: 0.1 } }, /^at: this is no steady motion.*theta_fc_dot/],
    ['a circle', { at: { X_dot: 1, theta_fc: 0.1, theta_bc: 0.1 } }, /no steady motion/],
    ['drag that slows it down', { at: { X_dot: 1 }, parameters: { wheelDrag: 1 } }, /no steady motion.*X_dot by -/],
    ['free fall', { constraints: 'none' }, /Z_dot by -9\.81/],
    ['an equilibrium typed with too few digits', { at: { alpha_fp: 1e-6 } }, /no steady motion/],
  ])('%s is refused by name', (_, raw, message) => {
    expect(() => motionOf(raw)).toThrow(message);
  });

  test('a coordinate that moves and matters is named', () => {
    // A pendulum-like force on what rolls: gravity along X as a spring would be.
    const { dynamics: _fused, ...withoutDynamics } = board.constraintSets['rolling']!;
    const spring = {
      ...board,
      mechanics: (q: Float64Array, v: Float64Array, p: Float64Array, M: Float64Array, h: Float64Array) => {
        board.mechanics(q, v, p, M, h);
        h[1]! -= 3 * q[0]! * q[1]!;
      },
      jacobians: (
        q: Float64Array,
        v: Float64Array,
        a: Float64Array,
        p: Float64Array,
        dq: Float64Array,
        dv: Float64Array,
      ) => {
        board.jacobians(q, v, a, p, dq, dv);
        dq[10]! += 3 * q[1]!;
        dq[11]! += 3 * q[0]!;
      },
      constraintSets: { rolling: withoutDynamics },
    };
    const parameters = Float64Array.from(board.meta.parameters, (p) => p.default);
    const plant = { system: spring, parameters, constraints: 'rolling', hold: [] };
    expect(() => steadyMotionAt(plant, { X_dot: 1 })).toThrow(/the equations depend on X, which moves/);
  });
});
