import { Matrix } from 'ml-matrix';
import { sampledDesignOf, filterOf, timingOf } from '../design/scenarioControl.ts';
import type { LqrDesign } from '../design/lqr.ts';
import { columnsOf } from '../linearization/matrices.ts';
import type { Scenario } from '../../scenario/types.ts';
import { normal } from '../../scenario/chance.ts';
import { heldWithDelay, lagged } from './hold.ts';

/**
 * A sampled regulator as the program that runs it: linear, once a sample, c its memory (what its filter expects, what lagging
 * actuators give, inputs on their way), y what it measures less what it would measure in the steady motion:
 *
 *     u_k = C c_k + D y_k,    c_{k+1} = A c_k + B y_k,    c_0 = 0.
 *
 * Limits, rates and steps of the actuators are not in it. With sensors y is what they read, else all states.
 */
export interface ControllerProgram {
  sample: number;
  delay: number;
  inputs: readonly string[];
  /** Names of y. */
  measured: readonly string[];
  A: number[][];
  B: number[][];
  C: number[][];
  D: number[][];
  /** Some y, one after the other from c = 0, and the u that belong to them: what is flashed can be checked by it. */
  test: { y: number[][]; u: number[][] };
}

const TESTED = 8;
const SEED = 2017;

/**
 * Null without `control.sample`.
 *
 * @param scenario checked, SI
 * @param design the continuous lqr
 * @throws ScenarioError as the designs
 */
export function programOf(scenario: Scenario, design: LqrDesign): ControllerProgram | null {
  const { control } = scenario;
  if (control?.type !== 'lqr') return null;
  const found = sampledDesignOf(scenario, design);
  if (!found) return null;
  const { sample, delay, lags } = timingOf(control);
  const { states, inputs } = design.linearization;
  const gain = control.design === 'sampled' ? found.gain : design.gain;
  const filter = filterOf(scenario, design);
  const k = inputs.length;
  const o = filter?.plant.A.rows ?? 0;
  const driven = lagged(filter?.plant.A ?? new Matrix(0, 0), filter?.plant.B ?? new Matrix(0, k), lags);
  const plant = heldWithDelay(driven.A, driven.B, sample, delay);
  const size = plant.A.rows;
  const slow = [...lags.keys()].filter((i) => lags[i]! > 0);
  // What a measurement makes of the memory, and what is asked by it.
  const kept = Matrix.eye(size);
  const taken = Matrix.zeros(size, filter ? filter.sensors.length : states.length);
  const asks = Matrix.zeros(k, size);
  if (filter) {
    const { gain: L } = filter.filter;
    kept.setSubMatrix(Matrix.sub(Matrix.eye(o), L.mmul(filter.plant.C)), 0, 0);
    taken.setSubMatrix(L, 0, 0);
    asks.setSubMatrix(gain.mmul(filter.plant.toStates), 0, 0);
  }
  slow.forEach((i, at) => asks.setColumn(o + at, found.actingGain.getColumn(i)));
  const past = columnsOf(found.inputGain, 0, size - o - slow.length);
  if (past.columns > 0) asks.setSubMatrix(past, 0, o + slow.length);
  const C = asks.mmul(kept).mul(-1);
  const D = filter ? asks.mmul(taken).mul(-1) : Matrix.mul(gain, -1);
  const A = Matrix.add(plant.A.mmul(kept), plant.B.mmul(C));
  const B = Matrix.add(plant.A.mmul(taken), plant.B.mmul(D));
  const program = {
    sample,
    delay,
    inputs,
    measured: filter?.sensors ?? states,
    A: A.to2DArray(),
    B: B.to2DArray(),
    C: C.to2DArray(),
    D: D.to2DArray(),
  };
  const y = Array.from({ length: TESTED }, (_, row) =>
    program.measured.map((_, i) => Math.round(1e4 * normal(SEED, i, row)) / 1e6),
  );
  return { ...program, test: { y, u: carriedOut(program, y) } };
}

/**
 * What the program answers to measurements, from c = 0.
 *
 * @param program its four matrices
 * @param y measurements by sample
 */
export function carriedOut(
  program: Pick<ControllerProgram, 'A' | 'B' | 'C' | 'D'>,
  y: readonly number[][],
): number[][] {
  const { A, B, C, D } = program;
  const dot = (row: readonly number[], x: readonly number[]): number => row.reduce((sum, a, i) => sum + a * x[i]!, 0);
  let c: number[] = A.map(() => 0);
  return y.map((read) => {
    const u = C.map((row, i) => dot(row, c) + dot(D[i]!, read));
    c = A.map((row, i) => dot(row, c) + dot(B[i]!, read));
    return u;
  });
}
