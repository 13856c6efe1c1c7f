import { readFileSync } from 'node:fs';
import { Matrix } from 'ml-matrix';
import { describe, expect, test } from 'vitest';
import { closedLoopMatrix, gainOnUnreachable, type LqrDesign } from '../../src/core/control/design/lqr.ts';
import { lqrOf } from '../../src/core/control/design/scenarioControl.ts';
import type { Complex } from '../../src/core/control/linearization/spectrum.ts';
import { systems } from '../../src/core/systems/all.ts';
import { relativeDifference, spectralDistance, spectrumOf } from '../core/control/helpers.ts';
import { runOf, scenarioOf, type FinishedRun } from '../helpers.ts';

interface StoredDesign {
  scenario: Record<string, unknown> & { control: { Q?: Record<string, number> } };
  eigenvalues: Complex[];
  reachableDimension: number;
  controlledDimension: number;
  closedLoopEigenvalues: Complex[];
  K: number[][];
  run: { scenario: Record<string, unknown>; columns: string[]; rows: number[][] };
}
const stored = JSON.parse(readFileSync('tests/reference/ripstik-lqr.json', 'utf8')) as StoredDesign[];

const designOf = (raw: unknown): LqrDesign => {
  const scenario = scenarioOf(raw);
  return lqrOf(scenario, systems[scenario.system]!);
};
const board = (control: Record<string, unknown>, extra: Record<string, unknown> = {}) => ({
  version: 1,
  system: 'ripstik',
  control: { type: 'lqr', ...control },
  ...extra,
});
const nonZero = (values: readonly Complex[]) => values.filter(([re, im]) => Math.hypot(re, im) > 1e-3);

describe.each(stored.map((d) => [d.scenario.control.Q ? 'Q on roll and steer' : 'Q = identity', d] as const))(
  '%s at 1 m/s',
  (_, reference) => {
    const design = designOf(reference.scenario);

    test('dimensions and open-loop eigenvalues', () => {
      expect(design.split.reachable.columns).toBe(reference.reachableDimension);
      expect(design.placed).toHaveLength(reference.controlledDimension);
      expect(design.openLoop).toHaveLength(14);
      expect(design.openLoop.filter(([re, im]) => re === 0 && im === 0)).toHaveLength(6);
      expect(spectralDistance(nonZero(reference.eigenvalues), nonZero(design.openLoop))).toBeLessThan(1e-10);
    });

    test('gain, on the reachable subspace and everywhere', () => {
      const known = new Matrix(reference.K);
      const toReachable = design.linearization.basis.mmul(design.split.reachable);
      expect(relativeDifference(design.gain.mmul(toReachable), known.mmul(toReachable))).toBeLessThan(1e-10);
      expect(relativeDifference(design.gain, known)).toBeLessThan(1e-10);
      expect(gainOnUnreachable(design)).toBeLessThan(1e-13);
    });

    test('closed-loop eigenvalues, those of A - B K too, and the Riccati residual', () => {
      expect(spectralDistance(reference.closedLoopEigenvalues, design.placed)).toBeLessThan(1e-9);
      expect(spectralDistance(nonZero(design.closedLoop), spectrumOf(closedLoopMatrix(design)))).toBeLessThan(1e-7);
      expect(design.riccati.residual).toBeLessThan(1e-12);
    });

    test('the run from 10 degrees of lean, row by row', () => {
      const run = runOf({ ...reference.run.scenario, method: { rtol: 1e-11, atol: 1e-12 } });
      expect(run.end.reason).toBe('end');
      for (const [r, row] of reference.run.rows.entries()) {
        row.forEach((value, c) => {
          const name = reference.run.columns[c]!;
          expect(Math.abs(run.columns.get(name)![r]! - value), `${name} in row ${r}`).toBeLessThan(1e-5);
        });
      }
    });
  },
);

test('Q on roll and steer: heading and Y are left alone, named', () => {
  const { unseen, unreachable } = designOf(stored[1]!.scenario);
  expect(unseen.map((m) => m.eigenvalue)).toEqual([
    [0, 0],
    [0, 0],
  ]);
  expect(new Set(unseen.flatMap((m) => m.moves))).toEqual(new Set(['Y', 'theta', 'Y_dot']));
  expect(unreachable.map((m) => m.moves[0]).sort()).toEqual(['X', 'X_dot', 'alpha', 'alpha_dot']);
});

describe('weights that see little', () => {
  test('a weight on X alone, which no input reaches: unstable modes are mirrored, the rest stays', () => {
    const { placed, unseen, openLoop } = designOf(
      board({ inputs: ['tau_fc', 'tau_bc'], at: { X_dot: 1 }, Q: { X: 1 } }),
    );
    const mirrored = nonZero(openLoop).map(([re, im]): Complex => [-Math.abs(re), im]);
    expect(placed).toHaveLength(8);
    expect(spectralDistance(placed, mirrored)).toBeLessThan(1e-9);
    expect(unseen).toHaveLength(2);
  });

  test('undamped oscillations that the weights do not see are left alone, by name', () => {
    const design = designOf(board({ inputs: ['tau_fp'], Q: { alpha: 1 } }));
    expect(design.placed).toHaveLength(4);
    expect(design.unseen.map((m) => m.eigenvalue[0])).toEqual([0, 0, 0, 0]);
    expect(design.unseen.map((m) => m.moves[0])).toEqual(['theta_fc', 'theta_bc', 'theta_bc', 'theta_fc']);
    expect(
      spectralDistance(
        design.unseen.map((m) => m.eigenvalue),
        spectrumOf(closedLoopMatrix(design)),
      ),
    ).toBeLessThan(1e-9);
  });

  test('an input that does nothing under the constraints reaches nothing', () => {
    const { byInput, gain } = designOf(board({ inputs: ['tau_fc', 'tau_bc', 'f_Z', 'f_psi'] }));
    expect(byInput.map((i) => i.dimension)).toEqual([8, 8, 0, 0]);
    expect(Matrix.rowVector(gain.getRow(2)).norm()).toBeLessThan(1e-9);
  });
});

describe('recovery by steering alone', () => {
  const lean = { X_dot: 1, alpha_fp: '10 deg', alpha_bp: '10 deg' };
  const upright = (run: FinishedRun) => {
    const last = run.rows - 1;
    const roll = (plate: string) => Math.abs(run.columns.get('alpha')![last]! + run.columns.get(plate)![last]!);
    return Math.max(roll('alpha_fp'), roll('alpha_bp'));
  };

  test('from 10 degrees of lean at 1 m/s', () => {
    const run = runOf(board({ inputs: ['tau_fc', 'tau_bc'], at: { X_dot: 1 } }, { initial: lean, duration: 8 }));
    expect(run.end.reason).toBe('end');
    expect(upright(run)).toBeLessThan(1e-3);
  });

  test.each([
    ['tau_fc', '0.5 deg'],
    ['tau_bc', '0.04 deg'],
  ])('by %s alone: from %s of lean', (input, angle) => {
    const initial = { X_dot: 1, alpha_fp: angle, alpha_bp: angle };
    const run = runOf(board({ inputs: [input], at: { X_dot: 1 } }, { initial, duration: 8 }));
    expect(run.end.reason).toBe('end');
    expect(upright(run)).toBeLessThan(1e-3);
  });

  test('a limit is kept, and one too low lets the board fall', () => {
    const control = { inputs: ['tau_fc', 'tau_bc'], at: { X_dot: 1 }, limits: { tau_fc: 4, tau_bc: 3 } };
    const run = runOf(board(control, { initial: lean, duration: 8 }));
    expect(run.end.reason).toBe('end');
    expect(Math.max(...run.columns.get('tau_fc')!.map(Math.abs))).toBe(4);
    expect(Math.max(...run.columns.get('tau_bc')!.map(Math.abs))).toBe(3);
    const weak = runOf(board({ ...control, limits: { tau_fc: 0.01, tau_bc: 0.01 } }, { initial: lean, duration: 8 }));
    expect(weak.end.reason).toBe('touchdown');
  });

  test('open-loop inputs add to what the controller asks, also on its own inputs', () => {
    const inputs = { tau_fp: '0.15*exp(-10*(t-2)^2)', tau_fc: '0.02*sin(t)' };
    const scenario = board(
      { inputs: ['tau_fc', 'tau_bc'], at: { X_dot: 1 } },
      { initial: { X_dot: 1 }, inputs, duration: 6 },
    );
    const run = runOf(scenario);
    expect(run.end.reason).toBe('end');
    expect(Math.max(...run.columns.get('tau_fp')!)).toBeCloseTo(0.15, 6);
    expect(upright(run)).toBeLessThan(0.05);
    const {
      gain,
      linearization: {
        motion: { q, v },
        states,
        inputs: names,
      },
    } = designOf(scenario);
    const k = names.indexOf('tau_fc');
    for (const r of [0, 150, 400]) {
      const t = run.columns.get('t')![r]!;
      let u = 0.02 * Math.sin(t);
      states.forEach(
        (name, i) => (u -= gain.get(k, i) * (run.columns.get(name)![r]! - (i < 10 ? q[i]! + v[i]! * t : v[i - 10]!))),
      );
      expect(run.columns.get('tau_fc')![r]!).toBeCloseTo(u, 10);
    }
  });

  test.each([
    [0.15, 'end'],
    [0.6, 'touchdown'],
  ])('pushed by two Gaussians of %f N·m on both plates: %s', (size, reason) => {
    const push = `${size}*exp(-10*(t-2)^2) - ${size}*exp(-10*(t-6)^2)`;
    const scenario = board({ inputs: ['tau_fc', 'tau_bc'], at: { X_dot: 1 } }, { initial: { X_dot: 1 }, duration: 12 });
    const run = runOf({ ...scenario, inputs: { tau_fp: push, tau_bp: push }, method: { rtol: 1e-6 } });
    expect(run.end.reason).toBe(reason);
    if (reason === 'end') expect(upright(run)).toBeLessThan(0.01);
  });

  test('an implicit method with exact Jacobians gives the same run', () => {
    const scenario = board({ inputs: ['tau_fc', 'tau_bc'], at: { X_dot: 1 } }, { initial: lean, duration: 1 });
    const [a, b] = ['dopri5', 'radau'].map((name) => runOf({ ...scenario, method: { name, rtol: 1e-9, atol: 1e-11 } }));
    expect(b!.counts.jacobians).toBeGreaterThan(0);
    for (const name of ['Y', 'theta', 'alpha_fp', 'theta_bc']) {
      expect(Math.abs(a!.columns.get(name)![100]! - b!.columns.get(name)![100]!), name).toBeLessThan(1e-6);
    }
  });
});

test('balanced by the feet at rest', () => {
  const run = runOf(
    board({ inputs: ['tau_fp', 'tau_bp'] }, { initial: { alpha_fp: '2 deg', alpha_bp: '1 deg' }, duration: 5 }),
  );
  expect(run.end.reason).toBe('end');
  expect(Math.abs(run.columns.get('alpha_fp')![run.rows - 1]! + run.columns.get('alpha')![run.rows - 1]!)).toBeLessThan(
    1e-2,
  );
});

describe('refusals name what is wrong', () => {
  test.each([
    [
      'no input reaches an unstable mode',
      { inputs: ['f_X'], at: { X_dot: 1 } },
      /^control: f_X can't stabilize.*9\.37/,
    ],
    [
      'the point accelerates',
      { inputs: ['tau_fc'], at: { X_dot: 1, alpha_fp: '5 deg' } },
      /^control\.at: this is no steady motion.*theta_fc_dot/,
    ],
    [
      'the point can not be on the ground',
      { inputs: ['tau_fc'], at: { alpha: '90 deg', alpha_fp: '3 deg' } },
      /^control\.at: /,
    ],
  ])('%s', (_, control, message) => {
    expect(() => designOf(board(control))).toThrow(message);
    expect(() => runOf(board(control))).toThrow(message);
  });

  test('free fall is no steady motion', () => {
    expect(() => designOf(board({ inputs: ['tau_fc'] }, { constraints: 'none' }))).toThrow(/Z_dot by -9\.81/);
  });
});

test('R and Q by name: a dearer input does less, a weighted state is held closer', () => {
  const size = (control: Record<string, unknown>, row: number) => {
    const { gain } = designOf(board({ inputs: ['tau_fc', 'tau_bc'], at: { X_dot: 1 }, ...control }));
    return Matrix.rowVector(gain.getRow(row)).norm();
  };
  expect(size({ R: { tau_fc: 100 } }, 0)).toBeLessThan(size({}, 0));
  expect(size({ Q: { theta: 1 } }, 0)).toBeLessThan(size({ Q: { theta: 1, alpha_fp: 1e4 } }, 0));
});
