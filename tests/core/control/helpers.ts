import { EigenvalueDecomposition, Matrix, QrDecomposition } from 'ml-matrix';
import { linearizedInputs, operatingPoint } from '../../../src/core/control/design/scenarioControl.ts';
import { linearize, type Linearization } from '../../../src/core/control/linearization/linearize.ts';
import type { Complex } from '../../../src/core/control/linearization/spectrum.ts';
import { systems } from '../../../src/core/systems/all.ts';
import { scenarioOf } from '../../helpers.ts';

/** Entries normal enough for tests: a sum of uniform numbers, from a seeded generator. */
export function randomMatrix(random: () => number, rows: number, columns: number): Matrix {
  const entry = (): number => random() + random() + random() + random() - 2;
  return new Matrix(Array.from({ length: rows }, () => Array.from({ length: columns }, entry)));
}

export function randomRotation(random: () => number, n: number): Matrix {
  return new QrDecomposition(randomMatrix(random, n, n)).orthogonalMatrix;
}

export function blockDiagonal(...blocks: Matrix[]): Matrix {
  const size = blocks.reduce((sum, b) => sum + b.rows, 0);
  const A = Matrix.zeros(size, size);
  let at = 0;
  for (const block of blocks) {
    A.setSubMatrix(block, at, at);
    at += block.rows;
  }
  return A;
}

/** Linearization at a scenario's operating point. */
export function linearizationOf(raw: Record<string, unknown>): Linearization {
  const scenario = scenarioOf({ version: 1, system: 'ripstik', ...raw });
  const system = systems[scenario.system]!;
  return linearize(operatingPoint(scenario, system), linearizedInputs(scenario, system.meta));
}

export function spectrumOf(A: Matrix): Complex[] {
  const { realEigenvalues, imaginaryEigenvalues } = new EigenvalueDecomposition(A);
  return realEigenvalues.map((re, i) => [re, imaginaryEigenvalues[i]!]);
}

/** Largest distance from each of `values` to the nearest of `others`, relative to its size (of at least 1e-3). */
export function spectralDistance(values: readonly Complex[], others: readonly Complex[]): number {
  return Math.max(
    ...values.map(
      ([re, im]) =>
        Math.min(...others.map((o) => Math.hypot(re - o[0], im - o[1]))) / Math.max(1e-3, Math.hypot(re, im)),
    ),
  );
}

export function relativeDifference(A: Matrix, B: Matrix): number {
  return Matrix.sub(A, B).norm() / B.norm();
}
