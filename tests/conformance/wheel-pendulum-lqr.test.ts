import { readFileSync } from 'node:fs';
import { Matrix } from 'ml-matrix';
import { describe, expect, test } from 'vitest';
import { compareOrders } from '../../src/core/control/linearization/linearize.ts';
import { splitByReachability, unobservableSubspace } from '../../src/core/control/linearization/reachability.ts';
import { solveCare } from '../../src/core/control/design/riccati.ts';
import { lqrOf, operatingPoint } from '../../src/core/control/design/scenarioControl.ts';
import type { Complex } from '../../src/core/control/linearization/spectrum.ts';
import { systems } from '../../src/core/systems/all.ts';
import { relativeDifference, spectralDistance } from '../core/control/helpers.ts';
import { runOf, scenarioOf } from '../helpers.ts';

const reference = JSON.parse(readFileSync('tests/reference/wheel-pendulum.json', 'utf8')) as {
  parameters: Record<string, number>;
  state: string[];
  A: number[][];
  B: number[];
  Q: number[];
  R: number;
  gain_psi_psidot_phi_phidot: number[];
  closedLoopEigenvalues: Complex[];
  columns: string[];
  rows: number[][];
};
const known = Matrix.rowVector(reference.gain_psi_psidot_phi_phidot);
const { rho } = reference.parameters as { rho: number };

/** What is determined of a gain in (psi, psi_dot, phi, phi_dot): along these states X goes as rho phi. */
const combined = (gain: (state: string) => number) =>
  Matrix.rowVector([
    gain('psi'),
    gain('psi_dot'),
    gain('phi') + rho * gain('X'),
    gain('phi_dot') + rho * gain('X_dot'),
  ]);

describe('the closed-form A and B', () => {
  const A = new Matrix(reference.A);
  const B = Matrix.columnVector(reference.B);
  const split = splitByReachability(A, B);

  test('four of six modes are reachable; what rolls without turning is not', () => {
    expect(split.reachable.columns).toBe(4);
    expect(split.complementResidual).toBeLessThan(1e-14);
  });

  test('gain and closed loop on the reachable subspace', () => {
    const root = Matrix.diag(reference.Q.map(Math.sqrt)).mmul(split.reachable);
    expect(unobservableSubspace(split.A, root).unseen.columns).toBe(0);
    const { gain, closedLoop, residual } = solveCare(split.A, split.B, root.transpose().mmul(root), [reference.R]);
    const K = gain.mmul(split.W);
    expect(residual).toBeLessThan(1e-12);
    expect(
      relativeDifference(
        combined((name) => K.get(0, reference.state.indexOf(name))),
        known,
      ),
    ).toBeLessThan(1e-8);
    expect(spectralDistance(reference.closedLoopEigenvalues, closedLoop)).toBeLessThan(1e-7);
  });
});

describe('the system', () => {
  const Q = Object.fromEntries(reference.state.map((name, i) => [name, reference.Q[i]!]));
  const raw = {
    version: 1,
    system: 'wheel-pendulum',
    initial: { psi: '-96 deg' },
    inputs: { tau_phi: '22*exp(-10*(t-8)^2) - 22*exp(-10*(t-12)^2)' },
    control: { type: 'lqr', inputs: ['tau_phi'], Q },
    method: { rtol: 1e-10, atol: 1e-12 },
    duration: reference.rows.at(-1)![0]!,
    outputStep: reference.rows[1]![0]!,
  };
  const design = () => lqrOf(scenarioOf(raw), systems['wheel-pendulum']!);

  test('gain and closed-loop eigenvalues', () => {
    const { gain, placed, linearization, riccati } = design();
    expect(
      relativeDifference(
        combined((name) => gain.get(0, linearization.states.indexOf(name))),
        known,
      ),
    ).toBeLessThan(1e-8);
    expect(spectralDistance(reference.closedLoopEigenvalues, placed)).toBeLessThan(1e-7);
    expect(riccati.residual).toBeLessThan(1e-10);
  });

  test('all three orders of linearization agree: no multiplier at this point', () => {
    const scenario = scenarioOf(raw);
    const orders = compareOrders(operatingPoint(scenario, systems['wheel-pendulum']!), []);
    expect(orders.difference).toBeLessThan(1e-10);
    expect(orders.frozenDifference).toBeLessThan(1e-10);
  });

  test('the run with both disturbances', () => {
    const run = runOf(raw);
    for (const [r, row] of reference.rows.entries()) {
      row.forEach((value, c) => {
        const name = reference.columns[c]!;
        expect(Math.abs(run.columns.get(name)![r]! - value), `${name} in row ${r}`).toBeLessThan(1e-5);
      });
    }
  });
});
