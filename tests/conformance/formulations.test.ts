import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { kernelFile, kernelSizes, kernelText } from '../../scripts/write-kernels.ts';
import { cases } from '../../src/core/systems/registry.ts';
import { ConstrainedSystem } from '../../src/core/mechanics/constrainedSystem.ts';
import { actuationOf } from '../../src/core/simulation/actuation.ts';
import { blockOrder } from '../../src/core/mechanics/formulations/blockOrder.ts';
import { BlockTriangular } from '../../src/core/mechanics/formulations/blockTriangular.ts';
import type { Formulation } from '../../src/core/mechanics/formulations/contract.ts';
import { formulations } from '../../src/core/mechanics/formulations/formulations.ts';
import { NullSpace } from '../../src/core/mechanics/formulations/nullSpace.ts';
import { createFormulation } from '../../src/core/mechanics/formulations/registry.ts';
import { Projection } from '../../src/core/mechanics/projection.ts';
import { qrFull } from '../../src/core/linalg/qr.ts';
import { loopKernels, saddleKernels } from '../../src/core/linalg/saddle.ts';
import { systems } from '../../src/core/systems/all.ts';
import { runOf, scenarioOf, seeded } from '../helpers.ts';

const system = systems['ripstik']!;
const { coordinates } = system.meta;
const n = coordinates.length;
const SEED = 20171206;
const ids = formulations.map((f) => f.id);
const heldRod = ['X', 'Y', 'Z', 'alpha', 'psi', 'theta'];
const steered = {
  inputs: { tau_fc: '0.3*sin(3*t)', f_X: 2 },
  control: { type: 'track', reference: { tau_fp: '0.2*sin(t)', tau_bp: '0.1' }, kp: 6, kd: 0.3, limits: { tau_bp: 1 } },
};

/** Every kind of problem: constraint set, held coordinates, inputs. */
const setups = [
  { name: 'rolling', constraints: 'rolling', hold: [], extra: {} },
  { name: 'report', constraints: 'report', hold: [], extra: {} },
  { name: 'none', constraints: 'none', hold: [], extra: {} },
  { name: 'rolling, casters held', constraints: 'rolling', hold: ['theta_fc', 'theta_bc'], extra: {} },
  { name: 'report, a plate held, with inputs', constraints: 'report', hold: ['alpha_fp'], extra: steered },
  { name: 'none, rod held', constraints: 'none', hold: heldRod, extra: {} },
  { name: 'none, rod held, with inputs', constraints: 'none', hold: heldRod, extra: steered },
  { name: 'rolling, with inputs and a controller', constraints: 'rolling', hold: [], extra: steered },
];

function dynamicsOf({ constraints, hold, extra }: (typeof setups)[number]): ConstrainedSystem {
  const scenario = scenarioOf({ version: 1, system: 'ripstik', constraints, hold, ...extra });
  const p = Float64Array.from(system.meta.parameters, (m) => scenario.parameters[m.name]!);
  const held = hold.map((name) => coordinates.findIndex((c) => c.name === name));
  return new ConstrainedSystem(system, p, constraints, held, actuationOf(scenario, system.meta).forcing);
}

/** A state on the constraints; from far away one projection's fixed factors don't get there. */
function drawState(dynamics: ConstrainedSystem, seed: number) {
  const random = seeded(seed);
  const q = Float64Array.from({ length: n }, (_, i) => (i === 4 ? 0.4 : 0.9) * (2 * random() - 1));
  const v = Float64Array.from({ length: n }, () => 2 * random() - 1);
  for (const i of dynamics.held) v[i] = 0;
  const projection = new Projection(dynamics);
  for (let k = 0; k < 20; k++) expect(projection.project(0, q, v), `seed ${seed}`).toBe(true);
  expect(projection.residual(q, v), `seed ${seed}`).toBeLessThan(1e-13);
  return { q, v, t: random() };
}

/** a = d/dt of v(y) = (dv/dy) y', with the first n rows of the Jacobian as dv/dy: also for independent speeds. */
function accelerationOf(formulation: Formulation, t: number, q: Float64Array, v: Float64Array): Float64Array {
  const size = formulation.dimension;
  const [y, f, J] = [new Float64Array(size), new Float64Array(size), new Float64Array(size * size)];
  formulation.fromState(q, v, y);
  expect(formulation.derivative(t, y, f), String(formulation.failure)).toBe(true);
  expect(formulation.jacobian!(t, y, J)).toBe(true);
  return Float64Array.from({ length: n }, (_, i) => f.reduce((sum, x, j) => sum + J[i * size + j]! * x, 0));
}

describe.each(setups)('$name', (setup) => {
  test('all formulations give the same acceleration at 20 states', () => {
    const dynamics = dynamicsOf(setup);
    const made = ids.map((id) => createFormulation(id, dynamics)!);
    for (let seed = SEED; seed < SEED + 20; seed++) {
      const { q, v, t } = drawState(dynamics, seed);
      const expected = accelerationOf(made[0]!, t, q, v);
      const size = Math.max(...expected.map(Math.abs)) || 1;
      made.forEach((formulation, k) => {
        // A chart stays while it is good, so that most states are away from its base.
        formulation.rebase(q, v);
        accelerationOf(formulation, t, q, v).forEach((a, i) => {
          expect(Math.abs(a - expected[i]!) / size, `${ids[k]}, seed ${seed}, ${coordinates[i]!.name}`).toBeLessThan(
            1e-9,
          );
        });
      });
    }
  });

  test.each(ids)('%s: its Jacobian is its finite difference, and a state comes back from y', (id) => {
    const dynamics = dynamicsOf(setup);
    for (let seed = SEED; seed < SEED + 5; seed++) {
      const formulation = createFormulation(id, dynamics)!;
      const { q, v, t } = drawState(dynamics, seed);
      formulation.rebase(q, v);
      const size = formulation.dimension;
      const y = new Float64Array(size);
      formulation.fromState(q, v, y);
      const [q2, v2] = [new Float64Array(n), new Float64Array(n)];
      formulation.toState(y, q2, v2);
      for (let i = 0; i < n; i++) {
        expect(q2[i]).toBe(q[i]);
        expect(Math.abs(v2[i]! - v[i]!), `seed ${seed}`).toBeLessThan(1e-13);
      }
      // Away from the chart's base, where its own curvature shows; velocities there still meet the constraints.
      for (let i = 0; i < n; i++) if (!dynamics.held.includes(i)) y[i]! += 0.05 * Math.sin(i + seed);
      const J = new Float64Array(size * size);
      expect(formulation.jacobian!(t, y, J)).toBe(true);
      const at = (moved: number, step: number) => {
        const out = new Float64Array(size);
        const x = y.slice();
        x[moved]! += step;
        expect(formulation.derivative(t, x, out)).toBe(true);
        return out;
      };
      const h = 1e-4;
      const largest = Math.max(1, ...J.map(Math.abs));
      for (let j = 0; j < size; j++) {
        const [a, b, c, d] = [at(j, 2 * h), at(j, h), at(j, -h), at(j, -2 * h)];
        for (let i = 0; i < size; i++) {
          const difference = (8 * (b[i]! - c[i]!) - (a[i]! - d[i]!)) / (12 * h);
          expect(Math.abs(difference - J[i * size + j]!) / largest, `${id}, seed ${seed}, [${i}][${j}]`).toBeLessThan(
            1e-8,
          );
        }
      }
    }
  });
});

describe('runs', () => {
  const tight = { name: 'dopri5', rtol: 1e-9, atol: 1e-11 };
  const hanging = { ...cases.find((c) => c.id === 'hanging')!.scenario, duration: 2 };
  const leaning = { version: 1, system: 'ripstik', initial: { X_dot: 1, alpha: '0.5 deg' }, duration: 0.5 };

  test.each([
    ['hanging for 2 s', hanging],
    ['rolling at 1 m/s with half a degree of lean for 0.5 s', leaning],
  ])('all formulations agree within 1e-6: %s', (_, scenario) => {
    const [first, ...others] = ids.map((formulation) => runOf({ ...scenario, method: { ...tight, formulation } }));
    expect(first!.end.reason).toBe('end');
    for (const other of others) {
      expect(other.end).toEqual(first!.end);
      for (const c of coordinates) {
        for (const name of [c.name, `${c.name}_dot`]) {
          const expected = first!.columns.get(name)!;
          other.columns
            .get(name)!
            .forEach((x, k) => expect(Math.abs(x - expected[k]!), `${name}, row ${k}`).toBeLessThan(1e-6));
        }
      }
    }
  });

  test.each(ids)(
    '%s: constraints hold to 1e-12 in every row with projection, through changes of the chart',
    (formulation) => {
      const turning = cases.find((c) => c.id === 'turning')!.scenario;
      const run = runOf({ ...turning, duration: 4, method: { formulation, rtol: 1e-6, atol: 1e-8 } });
      expect(run.end.reason).toBe('end');
      expect(Math.max(...run.columns.get('residual')!)).toBeLessThan(1e-12);
    },
  );

  test.each(ids)('%s: without projection the residual grows, and the columns show it', (formulation) => {
    const scenario = { ...cases.find((c) => c.id === 'falling-report')!.scenario, duration: 4 };
    const method = { formulation, rtol: 1e-6, atol: 1e-8 };
    const residual = (projection: boolean) =>
      runOf({ ...scenario, method: { ...method, projection } }).columns.get('residual')!;
    const free = residual(false);
    const largest = (from: number, to: number) => Math.max(...free.subarray(from, to));
    expect(Math.max(...residual(true))).toBeLessThan(1e-12);
    expect(largest(0, 1)).toBeLessThan(1e-14);
    expect(largest(0, free.length)).toBeGreaterThan(1e-9);
    expect(largest(200, 401)).toBeGreaterThan(3 * largest(0, 51));
  });

  test('independent speeds keep velocity constraints without projection; only heights drift', () => {
    const scenario = {
      ...cases.find((c) => c.id === 'falling-report')!.scenario,
      duration: 2,
      method: { formulation: 'nullspace-qr', rtol: 1e-6, atol: 1e-8, projection: false },
    };
    const run = runOf(scenario);
    const dynamics = run.simulation.dynamics;
    const [q, v] = [new Float64Array(n), new Float64Array(n)];
    const [residual, omega] = [new Float64Array(4), new Float64Array(4 * n)];
    for (let k = 0; k < run.rows; k++) {
      coordinates.forEach((c, i) => {
        q[i] = run.columns.get(c.name)![k]!;
        v[i] = run.columns.get(`${c.name}_dot`)![k]!;
      });
      dynamics.constraints!.evaluate(q, v, dynamics.parameters, omega, residual);
      for (let r = 0; r < 4; r++)
        expect(Math.abs(v.reduce((sum, x, i) => sum + omega[r * n + i]! * x, 0))).toBeLessThan(1e-12);
    }
  });
});

describe('null space', () => {
  test('QR with pivoting: Q orthogonal, its last columns along the constraints; a dependent row lowers the rank', () => {
    const random = seeded(SEED);
    const [rows, columns] = [10, 4];
    const A = Float64Array.from({ length: rows * columns }, () => 2 * random() - 1);
    const Q = new Float64Array(rows * rows);
    expect(qrFull(A.slice(), rows, columns, Q, new Float64Array(rows))).toBe(columns);
    for (let i = 0; i < rows; i++) {
      for (let j = 0; j < rows; j++) {
        let product = 0;
        for (let k = 0; k < rows; k++) product += Q[k * rows + i]! * Q[k * rows + j]!;
        expect(Math.abs(product - (i === j ? 1 : 0))).toBeLessThan(1e-14);
      }
      for (let c = 0; i >= columns && c < columns; c++) {
        let along = 0;
        for (let k = 0; k < rows; k++) along += Q[k * rows + i]! * A[k * columns + c]!;
        expect(Math.abs(along)).toBeLessThan(1e-14);
      }
    }
    for (let k = 0; k < rows; k++) A[k * columns + 3] = A[k * columns]! - 2 * A[k * columns + 1]!;
    expect(qrFull(A.slice(), rows, columns, Q, new Float64Array(rows))).toBe(3);
  });

  test('a chart is kept while it is good and made anew once the upright board has turned by more than 45 degrees', () => {
    const formulation = new NullSpace(dynamicsOf(setups[0]!));
    const q = new Float64Array(n);
    const after = (yaw: number) => {
      q[coordinates.findIndex((c) => c.name === 'theta')] = yaw;
      return formulation.rebase(q);
    };
    expect([0, 0, 0.7, 0.85, 1.5, 1.7].map(after)).toEqual([true, false, false, true, false, true]);
    expect(formulation.charts).toBe(3);
  });
});

describe('block triangular', () => {
  test('a known system: its blocks, each after those it needs', () => {
    // x1 from equation 2 alone; x0 and x3 together; x2 last.
    const blocks = blockOrder([[0, 1, 3], [0, 1, 2, 3], [1], [0, 3]])!;
    expect(blocks.map((b) => b.unknowns)).toEqual([[1], [0, 3], [2]]);
    expect(blocks.map((b) => b.equations)).toEqual([[2], [0, 3], [1]]);
  });

  test('no matching: structurally singular', () => {
    expect(blockOrder([[0], [0], [0, 1, 2]])).toBeNull();
    const overheld = new BlockTriangular(
      dynamicsOf({ name: '', constraints: 'rolling', hold: coordinates.map((c) => c.name), extra: {} }),
    );
    expect(overheld.blocks).toEqual([]);
    const y = new Float64Array(2 * n);
    expect(overheld.derivative(0, y, new Float64Array(2 * n))).toBe(false);
    expect(overheld.failure).toBe('constraint-singular');
  });

  test('the hanging board is two independent halves', () => {
    const { blocks } = new BlockTriangular(dynamicsOf(setups[5]!));
    expect(blocks.map((b) => [...b].sort()).sort()).toEqual([
      ['alpha_bp_ddot', 'theta_bc_ddot'],
      ['alpha_fp_ddot', 'theta_fc_ddot'],
    ]);
  });

  test.each(['rolling', 'report', 'none'])('the board with %s is essentially one block', (constraints) => {
    const { blocks } = new BlockTriangular(dynamicsOf({ name: '', constraints, hold: [], extra: {} }));
    const sizes = blocks.map((b) => b.length);
    expect(sizes.reduce((a, b) => a + b, 0)).toBe(constraints === 'none' ? n : n + 4);
    expect(sizes).toEqual([constraints === 'none' ? n : n + 4]);
  });
});

describe('kernels', () => {
  test.each(kernelSizes)('%i x %i: the committed file is what the generator writes', (rows, columns) => {
    expect(readFileSync(kernelFile(rows, columns), 'utf8')).toBe(kernelText(rows, columns));
  });

  test.each(kernelSizes)('%i x %i: straight lines give what loops give', (size, rows) => {
    const random = seeded(SEED);
    const G = Float64Array.from({ length: size * size }, () => 2 * random() - 1);
    const A = new Float64Array(size * size);
    for (let i = 0; i < size; i++)
      for (let j = 0; j < size; j++)
        for (let k = 0; k < size; k++) A[i * size + j]! += G[i * size + k]! * G[j * size + k]! + (i === j ? 0.1 : 0);
    const omega = Float64Array.from({ length: rows * size }, () => 2 * random() - 1);
    const results = [loopKernels(size, rows), saddleKernels(size, rows)].map((kernels) => {
      const L = A.slice();
      const inverse = new Float64Array(size);
      const [Y, S] = [new Float64Array(rows * size), new Float64Array(rows * rows)];
      const b = omega.slice(0, size);
      const [inverseS, f, g] = [new Float64Array(rows), omega.slice(-size), omega.slice(0, rows)];
      expect(kernels.mass.factor(L, inverse, 0)).toBe(0);
      kernels.rows(L, inverse, omega, Y, S);
      kernels.mass.forward(L, inverse, b);
      kernels.mass.back(L, inverse, b);
      expect(kernels.schur.factor(S, inverseS, 0)).toBe(0);
      kernels.solve(L, inverse, Y, S, inverseS, f, g);
      return [...L, ...inverse, ...Y, ...S, ...b, ...inverseS, ...f, ...g];
    });
    results[0]!.forEach((x, i) =>
      expect(Math.abs(x - results[1]![i]!), `entry ${i}`).toBeLessThan(1e-12 * Math.max(1, Math.abs(x))),
    );
    const indefinite = A.slice();
    indefinite[3 * size + 3] = -1;
    for (const kernels of [loopKernels(size, rows), saddleKernels(size, rows)])
      expect(kernels.mass.factor(indefinite.slice(), new Float64Array(size), 0)).toBe(4);
  });
});
