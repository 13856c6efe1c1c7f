import { Matrix } from 'ml-matrix';
import { describe, expect, test } from 'vitest';
import { analyse, type ControlAnalysis } from '../../../src/core/control/analysis.ts';
import {
  LARGEST_ANGLE,
  modeDuration,
  modeTrajectory,
  type ShownMode,
} from '../../../src/core/control/linearization/modeTrajectory.ts';
import type { Mode } from '../../../src/core/control/linearization/spectrum.ts';
import type { ScenarioFile } from '../../../src/core/scenario/types.ts';
import { systems } from '../../../src/core/systems/all.ts';
import { scenarioOf } from '../../helpers.ts';

const analysed = (file: ScenarioFile): ControlAnalysis => analyse(scenarioOf({ ...file }), systems[file.system]!);

/** exp(A) by scaling, its series, and squaring. */
function exponential(A: Matrix): Matrix {
  const halvings = Math.max(0, Math.ceil(Math.log2(A.norm('frobenius') || 1)) + 4);
  const small = Matrix.mul(A, 2 ** -halvings);
  let [sum, term] = [Matrix.eye(A.rows), Matrix.eye(A.rows)];
  for (let j = 1; j <= 24; j++) {
    term = term.mmul(small).div(j);
    sum = Matrix.add(sum, term);
  }
  for (let k = 0; k < halvings; k++) sum = sum.mmul(sum);
  return sum;
}

function shownOf(
  file: ScenarioFile,
  { states, A, B, K, point }: ControlAnalysis,
  mode: Mode,
  closed = false,
): ShownMode {
  const loop = closed ? Matrix.sub(new Matrix(A), new Matrix(B).mmul(new Matrix(K!))).to2DArray() : A;
  return {
    coordinates: systems[file.system]!.meta.coordinates,
    states,
    A: loop,
    eigenvalue: mode.eigenvalue,
    shape: mode.shape,
    q: point.q,
    v: point.v,
  };
}

/** Deviation from the steady motion in one row. */
function deviation(shown: ShownMode, row: number, trajectory: ReturnType<typeof modeTrajectory>): number[] {
  const t = trajectory.column('t')![row]!;
  const n = shown.coordinates.length;
  return shown.states.map(
    (name, i) => trajectory.column(name)![row]! - (i < n ? shown.q[i]! + shown.v[i]! * t : shown.v[i - n]!),
  );
}

const files: ScenarioFile[] = [
  { version: 1, system: 'ripstik', at: { X_dot: 1 } },
  { version: 1, system: 'ripstik' },
  { version: 1, system: 'bicycle', at: { speed: 4 } },
  { version: 1, system: 'cart-pendulum' },
];

describe('a mode as motion', () => {
  test.each(files)('is what exp(A t) makes of its first row: $system, $at', (file) => {
    const analysis = analysed(file);
    // The exponential carries its own rounding along with the fastest growth.
    const fastest = Math.max(...analysis.eigenvalues.map(([re]) => re), 0);
    for (const mode of analysis.modes) {
      if (mode.eigenvalue[1] < 0) continue;
      const shown = shownOf(file, analysis, mode);
      const trajectory = modeTrajectory(shown);
      const start = Matrix.columnVector(deviation(shown, 0, trajectory));
      for (const row of [60, 120, 240]) {
        const t = trajectory.column('t')![row]!;
        const exact = exponential(Matrix.mul(new Matrix(shown.A), t))
          .mmul(start)
          .to1DArray();
        const scale = Math.max(...exact.map(Math.abs), ...start.to1DArray().map(Math.abs));
        deviation(shown, row, trajectory).forEach((x, i) =>
          expect(Math.abs(x - exact[i]!) / scale, `${mode.eigenvalue} ${shown.states[i]} at ${t}`).toBeLessThan(
            1e-9 + 1e-11 * Math.exp(fastest * t),
          ),
        );
      }
    }
  });

  test('closed loops take their own matrix', () => {
    const input = systems['cart-pendulum']!.meta.inputs[0]!.name;
    const file: ScenarioFile = { version: 1, system: 'cart-pendulum', control: { type: 'lqr', inputs: [input] } };
    const analysis = analysed(file);
    const mode = analysis.closedLoopModes!.find(({ eigenvalue: [, im] }) => im >= 0)!;
    const shown = shownOf(file, analysis, mode, true);
    const trajectory = modeTrajectory(shown);
    const t = trajectory.column('t')![240]!;
    const exact = exponential(Matrix.mul(new Matrix(shown.A), t))
      .mmul(Matrix.columnVector(deviation(shown, 0, trajectory)))
      .to1DArray();
    deviation(shown, 240, trajectory).forEach((x, i) => expect(x).toBeCloseTo(exact[i]!, 8));
  });

  test('its largest angle is ten degrees, and without growth the second period is the first', () => {
    const file = files[0]!;
    const analysis = analysed(file);
    const swinging = analysis.modes.filter(({ eigenvalue: [re, im] }) => im > 0 && re !== 0);
    expect(swinging.length).toBeGreaterThan(0);
    for (const mode of swinging) {
      const shown = shownOf(file, analysis, mode);
      const trajectory = modeTrajectory(shown, false);
      const rows = Array.from({ length: trajectory.length }, (_, row) => deviation(shown, row, trajectory));
      const angles = shown.coordinates.flatMap(({ kind }, i) =>
        kind === 'angle' ? [Math.max(...rows.map((x) => Math.abs(x[i]!)))] : [],
      );
      expect(Math.max(...angles)).toBeLessThanOrEqual(LARGEST_ANGLE * (1 + 1e-12));
      expect(trajectory.end).toBeCloseTo(modeDuration(mode.eigenvalue, false), 12);
      rows[0]!.forEach((x, i) => {
        expect(rows[240]![i]).toBeCloseTo(x, 9);
        expect(rows[480]![i]).toBeCloseTo(x, 9);
      });
    }
  });

  test('lasts two periods, four time constants where those are shorter, two seconds when neutral', () => {
    expect(modeDuration([0, 0])).toBe(2);
    expect(modeDuration([-8, 0])).toBe(0.5);
    expect(modeDuration([0.01, Math.PI])).toBeCloseTo(4, 12);
    expect(modeDuration([8, Math.PI])).toBe(0.5);
    expect(modeDuration([8, Math.PI], false)).toBeCloseTo(4, 12);
  });
});
