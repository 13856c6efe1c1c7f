// Kalman filters: what sensors see by name, the duality with the regulator, and a filter at work in a run.
import { Matrix } from 'ml-matrix';
import { describe, expect, test } from 'vitest';
import { feedbackOf } from '../../../src/core/control/design/feedback.ts';
import { filterOf, lqrOf } from '../../../src/core/control/design/scenarioControl.ts';
import { modulus } from '../../../src/core/control/linearization/spectrum.ts';
import { computerReport } from '../../../src/core/control/sampled/computerReport.ts';
import { Simulation } from '../../../src/core/simulation/simulation.ts';
import { systems } from '../../../src/core/systems/all.ts';
import { runOf, scenarioOf, type FinishedRun } from '../../helpers.ts';

const ROLLS = ['alpha + alpha_fp', 'alpha + alpha_bp'];
const RATES = ['alpha_dot + alpha_fp_dot', 'alpha_dot + alpha_bp_dot'];
const sensorsOf = (...names: string[]) => Object.fromEntries(names.map((name) => [name, { noise: 1e-3 }]));
const LOCAL = sensorsOf(...ROLLS, ...RATES, 'theta_fc', 'theta_bc');

const board = (control: object, more: object = {}) => ({
  version: 1,
  system: 'ripstik',
  initial: { X_dot: 1, alpha: '2 deg' },
  duration: 1,
  control: {
    type: 'lqr',
    inputs: ['tau_fc', 'tau_bc'],
    at: { X_dot: 1 },
    sample: 0.005,
    design: 'sampled',
    ...control,
  },
  ...more,
});
const system = systems['ripstik']!;
const filterAt = (control: object) => {
  const scenario = scenarioOf(board(control));
  return filterOf(scenario, lqrOf(scenario, system))!;
};

describe('what sensors see', () => {
  test('rolls and steer see eight dimensions, a place and a heading two more; the rest is named', () => {
    const local = filterAt({ sensors: LOCAL }).plant;
    expect(local.A.rows).toBe(8);
    expect(local.unseen.flatMap((m) => m.moves.slice(0, 1)).sort()).toEqual([
      'X',
      'X_dot',
      'Y',
      'alpha',
      'alpha_dot',
      'theta',
    ]);
    const placed = filterAt({ sensors: { ...LOCAL, ...sensorsOf('Y', 'X') } }).plant;
    expect(placed.A.rows).toBe(12);
    expect(placed.unseen.flatMap((m) => m.moves.slice(0, 1)).sort()).toEqual(['alpha', 'alpha_dot']);
    const alone = Object.fromEntries(placed.bySensor.map(({ sensor, dimension }) => [sensor, dimension]));
    expect(alone).toMatchObject({ theta_fc: 8, Y: 10, X: 2 });
  });

  test('an unstable mode that none sees is refused by name', () => {
    expect(() => filterAt({ sensors: sensorsOf('X') })).toThrow(/control\.sensors: X can't tell .* alpha/);
  });

  test('seen deviations come back from what is known of them', () => {
    const { plant } = filterAt({ sensors: { ...LOCAL, ...sensorsOf('Y', 'X') } });
    const back = plant.fromStates.mmul(plant.toStates);
    expect(Matrix.sub(back, Matrix.eye(plant.A.rows)).norm()).toBeLessThan(1e-10);
  });
});

describe('the filter', () => {
  test.each([0.001, 0.005, 0.02])('converges, sampled at %f s', (sample) => {
    const { filter } = filterAt({ sensors: LOCAL, sample });
    expect(filter.residual).toBeLessThan(1e-10);
    expect(Math.max(...filter.poles.map(modulus))).toBeLessThan(1);
  });

  test('sampled ever faster it is the continuous one of the same densities', () => {
    const dense = Object.fromEntries(Object.keys(LOCAL).map((name) => [name, { density: 1e-2 }]));
    const continuous = filterAt({ sensors: dense, sample: undefined, design: undefined });
    for (const [re] of continuous.filter.poles) expect(re).toBeLessThan(0);
    const distance = [1e-4, 1e-5].map((sample) => {
      const { filter } = filterAt({ sensors: dense, sample, design: undefined });
      const P = continuous.filter.covariance;
      return Matrix.sub(filter.covariance, P).norm() / P.norm();
    });
    expect(distance[1]).toBeLessThan(2e-3);
    expect(distance[1]! / distance[0]!).toBeCloseTo(0.1, 1);
  });

  test('a neutral mode that no process moves has no filter, in words', () => {
    const control = { sensors: { ...LOCAL, ...sensorsOf('Y') }, process: { alpha_fp_dot: 0 } };
    expect(() => filterAt(control)).toThrow(/needs process noise/);
  });

  test('follows an error of a sensor, which the others tell from a lean', () => {
    const [off, after] = [0.02, 4];
    const leanOf = (follow: number): number => {
      const first = { noise: 1e-3, ...(follow > 0 ? { follow } : {}) };
      const process = { alpha_fp_dot: 0.01, alpha_bp_dot: 0.01, theta_fc_dot: 0.01, theta_bc_dot: 0.01 };
      const control = { sensors: { ...LOCAL, [ROLLS[0]!]: first }, process };
      const estimate = [...feedbackOf(scenarioOf(board(control)), system)!.values()][0]!.estimator!.begin();
      for (let k = 0; k < after / 0.005; k++) {
        estimate.correct(k * 0.005, [off, 0, 0, 0, 0, 0]);
        estimate.predict([0, 0]);
      }
      estimate.correct(after, [off, 0, 0, 0, 0, 0]);
      return Math.abs(estimate.q[3]! + estimate.q[6]!);
    };
    expect(leanOf(0)).toBeGreaterThan(0.1 * off);
    expect(leanOf(0.01)).toBeLessThan(0.02 * off);
    const report = computerReport(
      scenarioOf(board({ sensors: { ...LOCAL, [ROLLS[0]!]: { noise: 1e-3, follow: 0.003 } } })),
      system,
    ).estimator!;
    expect(report).toMatchObject({ biases: [ROLLS[0]], dimension: 8 });
    expect(report.A).toHaveLength(9);
  });

  test('an error that nothing tells from a motion can not be followed, in words', () => {
    expect(() => filterAt({ sensors: { ...LOCAL, Y: { noise: 1e-3, follow: 0.01 } } })).toThrow(
      /control\.sensors: .*can not be followed/,
    );
  });

  test('stands in the report; without sensors nothing does', () => {
    expect(computerReport(scenarioOf(board({})), system).estimator).toBeNull();
    const { estimator } = computerReport(scenarioOf(board({ sensors: LOCAL })), system);
    expect(estimator).toMatchObject({ dimension: 8, sensors: Object.keys(LOCAL), eigenvalues: null });
    expect(estimator!.L.length).toBe(8);
  });
});

const column = (run: FinishedRun, name: string): number[] => [...run.columns.get(name)!];

describe('a board that sees through its sensors', () => {
  const control = {
    delay: 0.004,
    sensors: { ...LOCAL, ...sensorsOf('Y', 'theta') },
    actuators: { tau_fc: { lag: 0.002, limit: 5 }, tau_bc: { lag: 0.002 } },
  };

  test('stands; a seed is a run to the last bit, another is another', () => {
    const run = runOf(board({ ...control, seed: 3 }));
    expect(run.end.reason).toBe('end');
    const roll = column(run, 'alpha').map((a, i) => Math.abs(a + run.columns.get('alpha_fp')![i]!));
    expect(Math.max(...roll.slice(-20))).toBeLessThan(0.06);
    expect(runOf(board({ ...control, seed: 3 })).columns).toEqual(run.columns);
    expect(runOf(board({ ...control, seed: 4 })).columns).not.toEqual(run.columns);
  });

  test('small deviations without noise to speak of are estimated as they are', () => {
    const exact = Object.fromEntries(Object.keys(control.sensors).map((name) => [name, { noise: 1e-5 }]));
    const small = { initial: { X_dot: 1, alpha_fp: 1e-3, alpha_bp: 1e-3 }, duration: 0.3 };
    const seen = runOf(board({ ...control, sensors: exact }, small));
    const known = runOf(board({ ...control, sensors: undefined }, small));
    for (const name of ['alpha_fp', 'theta_fc', 'tau_fc']) {
      const [a, b] = [column(seen, name), column(known, name)];
      const size = Math.max(...b.map(Math.abs));
      // The first measurement tells place and rate of all but what only shows as time goes on.
      b.forEach((x, i) => expect(Math.abs(a[i]! - x)).toBeLessThan(0.1 * size));
    }
  });

  test('a filter without a computer is a design and no run', () => {
    const dense = Object.fromEntries(ROLLS.map((name) => [name, { density: 1e-3 }]));
    const scenario = scenarioOf(board({ sensors: dense, sample: undefined, design: undefined }));
    expect(computerReport(scenario, system).estimator!.eigenvalues!.length).toBe(8);
    expect(() => feedbackOf(scenario, system)).toThrow(/control\.sensors: .*control\.sample/);
  });

  test('goes on from a row with the noise that it would have met', () => {
    const scenario = scenarioOf(board({ ...control, seed: 3 }, { duration: 0.5 }));
    const feedback = feedbackOf(scenario, system);
    const whole = runOf(board({ ...control, seed: 3 }, { duration: 0.5 }));
    const row = 25;
    const at = (name: string): number => whole.columns.get(name)![row]!;
    const names = system.meta.coordinates.map((c) => c.name);
    const on = new Simulation(scenario, system, {
      extras: [],
      feedback,
      from: { time: at('t'), q: names.map(at), v: names.map((name) => at(`${name}_dot`)) },
    });
    on.advance(() => false);
    expect(on.end!.reason).toBe('end');
    expect(Math.abs(on.q[names.indexOf('alpha_fp')]! + on.q[names.indexOf('alpha')]!)).toBeLessThan(0.05);
  });
});
