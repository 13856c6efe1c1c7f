// A controller that a computer runs: sampled, held, delayed.
import { Matrix } from 'ml-matrix';
import { describe, expect, test } from 'vitest';
import { feedbackOf } from '../../../src/core/control/design/feedback.ts';
import { lqrOf, sampledDesignOf } from '../../../src/core/control/design/scenarioControl.ts';
import { methods } from '../../../src/core/integrators/methods.ts';
import { Simulation } from '../../../src/core/simulation/simulation.ts';
import { systems } from '../../../src/core/systems/all.ts';
import { runOf, scenarioOf, type FinishedRun } from '../../helpers.ts';

const regulator = { type: 'lqr', inputs: ['tau_fc', 'tau_bc'], at: { X_dot: 1 } };
/** Weights on what falls and steers alone. */
const LEAN = { alpha: 1, alpha_fp: 1, alpha_bp: 1, theta_fc: 1, theta_bc: 1 };
const board = (control: object, more: object = {}) => ({
  version: 1,
  system: 'ripstik',
  initial: { X_dot: 1, alpha_fp: 1e-6, alpha_bp: 1e-6 },
  control: { ...regulator, ...control },
  columns: ['inputs'],
  ...more,
});

/** z of the quotient in each row. */
function quotientRows(file: object, run: FinishedRun): number[][] {
  const design = lqrOf(scenarioOf(file), systems['ripstik']!);
  const { motion, states } = design.linearization;
  const names = states;
  const t = run.columns.get('t')!;
  return Array.from(t, (time, row) => {
    const x = names.map((name, i) => {
      const n = motion.q.length;
      const at = i < n ? motion.q[i]! + motion.v[i]! * time : motion.v[i - n]!;
      return run.columns.get(name)![row]! - at;
    });
    return design.quotient.fromStates.mmul(Matrix.columnVector(x)).to1DArray();
  });
}

describe.each([
  ['held', { sample: 0.001 }],
  ['held and late', { sample: 0.001, delay: 0.0004 }],
  ['sampled', { sample: 0.005, design: 'sampled' }],
  ['sampled and late', { sample: 0.005, delay: 0.005, design: 'sampled' }],
  ['sampled and late by parts of a sample', { sample: 0.005, delay: 0.007, design: 'sampled' }],
  [
    'sampled, late and lagging',
    { sample: 0.005, delay: 0.003, design: 'sampled', actuators: { tau_bc: { lag: 0.004 } } },
  ],
])('a regulator that is %s', (_, control) => {
  const file = board(control, {
    duration: 20 * control.sample,
    outputStep: control.sample,
    method: { name: 'dop853', rtol: 1e-12, atol: 1e-18 },
  });
  const run = runOf(file);

  test('moves small deviations as its matrices say', () => {
    const { A, B, K } = sampledDesignOf(scenarioOf(file), lqrOf(scenarioOf(file), systems['ripstik']!))!;
    const rows = quotientRows(file, run);
    const step = Matrix.sub(A, B.mmul(K));
    const d = rows[0]!.length;
    let z = new Matrix(A.rows, 1);
    rows[0]!.forEach((value, i) => z.set(i, 0, value));
    const size = Math.max(...rows.flat().map(Math.abs));
    rows.forEach((row, k) => {
      for (let i = 0; i < d; i++) {
        expect(Math.abs(row[i]! - z.get(i, 0)), `sample ${k}, coordinate ${i}`).toBeLessThan(1e-6 * size);
      }
      z = step.mmul(z);
    });
  });
});

describe('the default regulator at 1 m/s', () => {
  const size = (run: FinishedRun, from: number, to: number): number => {
    const u = run.columns.get('tau_fc')!;
    return Math.max(...u.slice(Math.floor(from * u.length), Math.floor(to * u.length)).map(Math.abs));
  };
  const run = (sample: number): FinishedRun =>
    runOf(
      board({ sample }, { initial: { X_dot: 1, alpha_fp: 1e-4, alpha_bp: 1e-4 }, duration: 3, outputStep: sample }),
    );

  test('stands at 1.70 ms', () => {
    const stands = run(0.0017);
    expect(stands.end.reason).toBe('end');
    expect(size(stands, 0.9, 1)).toBeLessThan(1e-2 * size(stands, 0, 0.1));
  });

  test('swings ever wider at 1.80 ms', () => {
    const falls = run(0.0018);
    expect(size(falls, 0.9, 1)).toBeGreaterThan(size(falls, 0.05, 0.1));
  });
});

test('a sampled design rides at 5 ms with 5 ms of delay, upright', () => {
  const file = board(
    { sample: 0.005, delay: 0.005, design: 'sampled', Q: LEAN },
    { initial: { X_dot: 1, alpha_fp: '3 deg', alpha_bp: '3 deg' }, duration: 5 },
  );
  const run = runOf(file);
  expect(run.end.reason).toBe('end');
  for (const name of ['alpha_fp', 'alpha_bp']) expect(Math.abs(run.columns.get(name)!.at(-1)!)).toBeLessThan(1e-2);
  expect(Math.abs(run.columns.get('theta_fc')!.at(-1)!)).toBeLessThan(1e-2);
});

describe('the inputs of the rows', () => {
  const file = (more: object, method: object = {}) =>
    board(
      { sample: 0.01, delay: 0.004, design: 'sampled', Q: LEAN, ...more },
      { initial: { X_dot: 1, alpha_fp: 0.02, alpha_bp: 0.01 }, duration: 0.2, outputStep: 0.001, method },
    );

  test.each(methods.map((m) => m.id))('are held between the instants with %s, and the same each time', (name) => {
    const once = runOf(file({}, { name }));
    const u = once.columns.get('tau_fc')!;
    const t = once.columns.get('t')!;
    expect(once.end.reason).toBe('end');
    for (let row = 1; row < u.length - 1; row++) {
      const ms = Math.round(t[row]! * 1000);
      if (ms % 10 === 4) expect(u[row], `t = ${t[row]}`).not.toBe(u[row - 1]);
      else expect(u[row], `t = ${t[row]}`).toBe(u[row - 1]);
    }
    expect(u[0]).toBe(0);
    expect(runOf(file({}, { name })).columns).toEqual(once.columns);
  });

  test('keep within the limit, the rate and the steps of their actuators', () => {
    const free = runOf(file({})).columns.get('tau_fc')!;
    const most = Math.max(...free.map(Math.abs));
    const limit = 0.5 * most;
    const limited = runOf(file({ actuators: { tau_fc: { limit } } })).columns.get('tau_fc')!;
    expect(Math.max(...limited.map(Math.abs))).toBe(limit);
    const rate = (0.2 * most) / 0.01;
    const ramped = runOf(file({ actuators: { tau_fc: { rate } } })).columns.get('tau_fc')!;
    const changes = ramped.slice(1).map((u, i) => Math.abs(u - ramped[i]!));
    expect(Math.max(...changes)).toBeCloseTo(rate * 0.01, 12);
    const resolution = most / 7;
    const stepped = runOf(file({ actuators: { tau_fc: { resolution } } })).columns.get('tau_fc')!;
    for (const u of stepped) expect(u / resolution).toBeCloseTo(Math.round(u / resolution), 9);
    expect(new Set(stepped).size).toBeGreaterThan(2);
  });
});

test('a follower of a reference is sampled too', () => {
  const run = runOf({
    version: 1,
    system: 'casterboard-robot',
    control: {
      type: 'track',
      kp: 2,
      kd: 0.2,
      reference: { tau_f: '0.3*sin(6.4*t)', tau_r: '0.3*sin(6.4*t)' },
      sample: 0.02,
    },
    duration: 0.5,
    outputStep: 0.005,
    columns: ['inputs'],
  });
  const u = run.columns.get('tau_f')!;
  for (let row = 1; row < u.length - 1; row++) {
    if (row % 4 === 0) expect(u[row]).not.toBe(u[row - 1]);
    else expect(u[row]).toBe(u[row - 1]);
  }
});

describe('a scenario says where it is wrong:', () => {
  test.each([
    [{ delay: 0.01 }, 'control.delay'],
    [{ design: 'sampled' }, 'control.design'],
    [{ actuators: { tau_fc: { rate: 1 } } }, 'control.actuators'],
    [{ sample: -1 }, 'control.sample'],
    [{ sample: 1e-9 }, 'control.sample'],
    [{ sample: 0.01, design: 'other' }, 'control.design'],
    [{ sample: 0.01, design: 'sampled', delay: 2 }, 'control.delay'],
    [{ sample: 0.01, design: 'sampled', schedule: { from: 1, to: 2 } }, 'control.design'],
    [{ sample: 0.01, actuators: { tau_fp: {} } }, 'control.actuators.tau_fp'],
    [{ sample: 0.01, actuators: { tau_fc: { lag: -0.1 } } }, 'control.actuators.tau_fc.lag'],
    [{ sample: 0.01, actuators: { tau_fc: { rate: 0 } } }, 'control.actuators.tau_fc.rate'],
    [{ sample: 0.01, limits: { tau_fc: 1 }, actuators: { tau_fc: { limit: 2 } } }, 'control.actuators.tau_fc.limit'],
    [{ sample: 0.01, sensors: {} }, 'control.sensors'],
    [{ sample: 0.01, process: {} }, 'control.process'],
    [{ sample: 0.01, seed: 1 }, 'control.seed'],
    [{ sample: 0.01, sensors: { alpha: { noise: 1 } }, seed: 0.5 }, 'control.seed'],
    [{ sample: 0.01, sensors: { alpha: {} } }, 'control.sensors.alpha'],
    [{ sample: 0.01, sensors: { 'alpha + beta': { noise: 1 } } }, 'control.sensors.alpha + beta'],
    [{ sample: 0.01, sensors: { '2 + 3': { noise: 1 } } }, 'control.sensors.2 + 3'],
    [{ sample: 0.01, sensors: { alpha: { noise: 1, density: 1 } } }, 'control.sensors.alpha.density'],
    [{ sample: 0.01, sensors: { alpha: { noise: -1 } } }, 'control.sensors.alpha.noise'],
    [{ sensors: { alpha: { noise: 1 } } }, 'control.sensors.alpha'],
    [{ sample: 0.01, sensors: { alpha: { noise: 1 } }, schedule: { from: 1, to: 2 } }, 'control.sensors'],
    [{ sample: 0.01, sensors: { alpha: { noise: 1 } }, process: { gamma: 1 } }, 'control.process.gamma'],
  ])('%j', (control, path) => {
    expect(() => scenarioOf(board(control))).toThrow(expect.objectContaining({ path }) as Error);
  });
});

test('a run that goes on from a row acts at once, and measures at the same instants', () => {
  const scenario = scenarioOf(
    board(
      { sample: 0.01, delay: 0.004, design: 'sampled', Q: LEAN },
      { initial: { X_dot: 1, alpha_fp: 0.02, alpha_bp: 0.01 }, duration: 0.1, outputStep: 0.001 },
    ),
  );
  const system = systems['ripstik']!;
  const feedback = feedbackOf(scenario, system);
  const first = new Simulation(scenario, system, { feedback });
  const from = { time: 0.05, q: [...first.q], v: [...first.v] };
  const onward = new Simulation(scenario, system, { feedback, from });
  onward.advance(() => false);
  expect(onward.end?.reason).toBe('end');
  const { columns, rows } = onward.takeChunk();
  const u = columns[onward.columns.indexOf('tau_fc')]!;
  expect(u[0]).not.toBe(0);
  const jumps = Array.from({ length: rows - 1 }, (_, i) => i + 1).filter((row) => u[row] !== u[row - 1]);
  // The row after 0.05 s is the first; what is measured at 0.05 s acts from 0.054 s on.
  expect(jumps).toEqual([3, 13, 23, 33, 43]);
});
