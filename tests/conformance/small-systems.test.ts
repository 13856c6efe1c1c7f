// Known answers of the small systems: closed forms, conserved quantities, published numbers recomputed elsewhere.
import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { caseColumns, measured } from '../../src/core/motion/caseMeasures.ts';
import { controlReport } from '../../src/core/control/design/report.ts';
import { methods } from '../../src/core/integrators/methods.ts';
import { ScenarioError } from '../../src/core/scenario/types.ts';
import { systems } from '../../src/core/systems/all.ts';
import { runOf, scenarioOf } from '../helpers.ts';

const tight = { name: 'dop853', rtol: 1e-12, atol: 1e-12 };

/** Rows of a run as functions of a column's name. */
function rowsOf(raw: { system: string } & Record<string, unknown>) {
  const run = runOf({ version: 1, ...raw });
  expect(run.end.reason).toBe('end');
  const column = caseColumns(systems[raw.system]!, scenarioOf({ version: 1, ...raw }).parameters, (name) =>
    run.columns.get(name),
  );
  return {
    run,
    column,
    each: (check: (at: (name: string) => number) => void) => {
      for (let k = 0; k < run.rows; k++) check((name) => column(name)[k]!);
    },
  };
}

describe('caster-rotation', () => {
  test.each([-0.05, 0.04])(
    'trail %f: the skate point draws a circle of radius |trail| about the steering axis',
    (casterTrail) => {
      const angle = Math.PI / 6;
      const { run, column } = rowsOf({
        system: 'caster-rotation',
        parameters: { casterTrail },
        initial: { theta_c_dot: '2*pi' },
        duration: 1,
      });
      const [x, y, z, steer] = ['caster.x', 'caster.y', 'caster.z', 'theta_c'].map(column) as [
        Float64Array,
        Float64Array,
        Float64Array,
        Float64Array,
      ];
      for (let k = 0; k < run.rows; k++) {
        const alongAxis = x[k]! * Math.sin(angle) + z[k]! * Math.cos(angle);
        expect(alongAxis).toBeCloseTo(-0.095, 14);
        expect(Math.sqrt(x[k]! ** 2 + y[k]! ** 2 + z[k]! ** 2 - alongAxis ** 2)).toBeCloseTo(Math.abs(casterTrail), 14);
        expect(y[k]!).toBeCloseTo(-casterTrail * Math.sin(steer[k]!), 14);
      }
      expect(steer.at(-1)).toBeCloseTo(2 * Math.PI, 12);
    },
  );

  test('with gravity on it swings, and keeps its energy', () => {
    const { run } = rowsOf({
      system: 'caster-rotation',
      parameters: { gravity: 9.81 },
      initial: { theta_c: 0.5 },
      method: tight,
      duration: 5,
    });
    const energy = run.columns.get('energy')!;
    expect(Math.max(...energy) - Math.min(...energy)).toBeLessThan(1e-11);
    expect(Math.max(...run.columns.get('theta_c_dot')!.map(Math.abs))).toBeGreaterThan(1);
  });
});

describe('cart-pendulum', () => {
  test('energy stays; the common centre of mass keeps its sideways speed', () => {
    const { run, each } = rowsOf({
      system: 'cart-pendulum',
      initial: { theta: 'pi/2 - 0.1', X_dot: 0.3, theta_dot: 0 },
      method: tight,
      duration: 10,
    });
    const energy = run.columns.get('energy')!;
    expect(Math.max(...energy) - Math.min(...energy)).toBeLessThan(1e-11);
    const momentum = 0.4 * 0.3;
    each((at) => expect(0.4 * at('X_dot') - 0.1 * Math.sin(at('theta')) * at('theta_dot')).toBeCloseTo(momentum, 11));
  });

  test('rests upright', () => {
    const { each } = rowsOf({ system: 'cart-pendulum', duration: 1 });
    each((at) => expect(at('theta')).toBeCloseTo(Math.PI / 2, 12));
  });
});

describe('rolling-wheel', () => {
  test.each([
    [3, 0],
    [3, 1],
    [-2, 0.7],
    [1, -4],
  ])("phi' = %f, theta' = %f: line or circle in closed form within 1e-9", (spin, turn) => {
    const { run, column, each } = rowsOf({
      system: 'rolling-wheel',
      initial: { theta: 1.2, phi_dot: spin, theta_dot: turn },
      method: tight,
      duration: 5,
      outputStep: 0.05,
    });
    let worst = 0;
    each((at) => {
      const t = at('t');
      const radius = spin / turn;
      const [X, Y] =
        turn === 0
          ? [spin * t * Math.cos(1.2), spin * t * Math.sin(1.2)]
          : [radius * (Math.sin(1.2 + turn * t) - Math.sin(1.2)), radius * (Math.cos(1.2) - Math.cos(1.2 + turn * t))];
      const heading = 1.2 + turn * t;
      const expected = {
        X,
        Y,
        theta: heading,
        phi: spin * t,
        lambda_1: -spin * turn * Math.sin(heading),
        lambda_2: spin * turn * Math.cos(heading),
      };
      for (const [name, value] of Object.entries(expected)) worst = Math.max(worst, Math.abs(at(name) - value));
    });
    expect(worst).toBeLessThan(1e-9);
    expect(run.rows).toBe(101);
    if (turn !== 0)
      expect(measured({ kind: 'diameter', x: 'X', y: 'Y' }, column)).toBeCloseTo(2 * Math.abs(spin / turn), 9);
  });
});

describe('stiff-decay', () => {
  const decay = { version: 1, system: 'stiff-decay', duration: 1 };

  test('every method follows the exact solution to its tolerance, or to its order', () => {
    for (const { id, adaptive } of methods) {
      const run = runOf({
        ...decay,
        method: { name: id, ...(adaptive ? { rtol: 1e-10, atol: 1e-12 } : { step: 1 / 256 }) },
      });
      const y = run.columns.get('y')!;
      const worst = Math.max(...y.map((value, k) => Math.abs(value - Math.exp(-15 * run.columns.get('t')![k]!))));
      expect(worst, id).toBeLessThan(
        id === 'euler' ? 0.02 : id === 'adams-moulton' ? 2e-4 : id === 'rk4' ? 1e-6 : 1e-7,
      );
      run.columns.get('y_dot')!.forEach((rate, k) => expect(rate, id).toBeCloseTo(-15 * y[k]!, 12));
      expect(
        [...run.columns.values()].every((column) => column.every(Number.isFinite)),
        id,
      ).toBe(true);
    }
  });

  test('Fig. 13: Euler h = 1/4 and 1/8, Adams–Moulton h = 1/8, step by step', () => {
    for (const [name, step, factor] of [
      ['euler', 1 / 4, -2.75],
      ['euler', 1 / 8, -0.875],
      ['adams-moulton', 1 / 8, 1 / 31],
    ] as const) {
      const y = runOf({ ...decay, method: { name, step }, outputStep: step }).columns.get('y')!;
      expect(y.length).toBe(1 + 1 / step);
      y.forEach((value, k) => expect(value / factor ** k, `${name}, step ${k}`).toBeCloseTo(1, 10));
    }
  });

  test.each([
    ['a rate in the start', { initial: { y_dot: 1 } }, 'initial.y_dot'],
    ['an input', { inputs: { f_y: 1 } }, 'inputs.f_y'],
    ['a regulator', { control: { type: 'lqr', inputs: ['f_y'] } }, 'control.inputs[0]'],
  ])('has no %s', (_, extra, path) => {
    expect(() => scenarioOf({ ...decay, ...extra })).toThrow(ScenarioError);
    try {
      scenarioOf({ ...decay, ...extra });
    } catch (error) {
      expect((error as ScenarioError).path).toBe(path);
    }
  });

  test('held it stands still', () => {
    const y = runOf({ ...decay, hold: ['y'], initial: { y: 2 } }).columns.get('y')!;
    expect(y.every((value) => value === 2)).toBe(true);
  });
});

describe('wheel-pendulum', () => {
  const reference = JSON.parse(readFileSync('tests/reference/wheel-pendulum.json', 'utf8')) as {
    state: string[];
    A: number[][];
    B: number[];
  };

  test('A and B are those of the closed form within 1e-12', () => {
    const report = controlReport(scenarioOf({ version: 1, system: 'wheel-pendulum' }), systems['wheel-pendulum']!);
    const index = reference.state.map((name) => report.states.indexOf(name));
    expect(report.inputs).toEqual(['tau_phi']);
    index.forEach((i, r) => {
      index.forEach((j, c) =>
        expect(Math.abs(report.A[i]![j]! - reference.A[r]![c]!), `A[${r}][${c}]`).toBeLessThan(1e-12),
      );
      expect(Math.abs(report.B[i]![0]! - reference.B[r]!), `B[${r}]`).toBeLessThan(1e-12);
    });
  });

  test.each([
    [0.3, 5, 0.4, 1, 2],
    [0.8, 1, 2, 3, 0.6],
  ])('and with other parameters: rho %f, m %f, mP %f, Jspin %f, L %f', (rho, m, mP, Jspin, L) => {
    const report = controlReport(
      scenarioOf({ version: 1, system: 'wheel-pendulum', parameters: { rho, m, mP, Jspin, L } }),
      systems['wheel-pendulum']!,
    );
    const D = 4 * Jspin + rho ** 2 * (4 * m + mP);
    const g = 9.81;
    const at = (row: string, column: string) => report.A[report.states.indexOf(row)]![report.states.indexOf(column)]!;
    expect(at('X_dot', 'psi')).toBeCloseTo((-3 * g * mP * rho ** 2) / D, 11);
    expect(at('psi_dot', 'psi')).toBeCloseTo((3 * g * (Jspin + rho ** 2 * (m + mP))) / (L * D), 11);
    expect(at('phi_dot', 'psi')).toBeCloseTo((-3 * g * mP * rho) / D, 11);
    expect(['X_dot', 'psi_dot', 'phi_dot'].map((name) => report.B[report.states.indexOf(name)]![0])).toEqual(
      [(4 * rho) / D, (-3 * rho) / (L * D), 4 / D].map((value) => expect.closeTo(value, 11) as number),
    );
  });

  test('let go it keeps its energy', () => {
    const { run } = rowsOf({ system: 'wheel-pendulum', initial: { psi: '-96 deg' }, method: tight, duration: 10 });
    const energy = run.columns.get('energy')!;
    expect(Math.max(...energy) - Math.min(...energy)).toBeLessThan(1e-10);
  });
});

describe('casterboard-robot', () => {
  const reference = JSON.parse(readFileSync('tests/reference/casterboard-robot.json', 'utf8')) as {
    cases: { name: string; x_at_5s_m?: number | number[]; circle_diameter_m?: number }[];
  };
  const known = (name: string) => reference.cases.find((c) => c.name === name)!;
  const [A, w] = [Math.PI / 9, 6.4];
  const forward = (phase: number) =>
    rowsOf({
      system: 'casterboard-robot',
      initial: { phi_r: -A * Math.sin(phase), phi_f_dot: A * w, phi_r_dot: A * w * Math.cos(phase) },
      control: {
        type: 'track',
        reference: { tau_f: 'pi/9 * sin(6.4*t)', tau_r: `pi/9 * sin(6.4*t - ${phase})` },
        kp: 400,
        kd: 3,
      },
      duration: 5,
    });

  test('x(5 s) at five phase differences', () => {
    (known('phase difference').x_at_5s_m as number[]).forEach((x, k) => {
      expect(
        Math.abs(
          forward((k * Math.PI) / 4)
            .column('x')
            .at(-1)! - x,
        ),
        `phase ${k} pi/4`,
      ).toBeLessThan(0.002);
    });
  });

  test('in phase it follows its references and stays straight', () => {
    const { column, each } = forward(0);
    expect(Math.abs(column('x').at(-1)! - (known('in phase').x_at_5s_m as number))).toBeLessThan(0.01);
    each((at) => expect(Math.abs(at('phi_f') - A * Math.sin(w * at('t')))).toBeLessThan(0.002));
    each((at) => expect(Math.abs(at('theta'))).toBeLessThan(1e-9));
  });
});

describe('chaplygin-sleigh', () => {
  const [mass, a, inertia] = [1, 0.2, 0.05];
  const J = inertia + mass * a * a;

  test.each([
    [-1, 0.01],
    [-1, -0.3],
    [0.5, 2],
    [-2, 1],
  ])("u = %f, theta' = %f: heading in closed form; energy stays", (u, turn) => {
    const { run, each } = rowsOf({
      system: 'chaplygin-sleigh',
      initial: { x_dot: u, theta_dot: turn },
      method: tight,
      duration: 6,
    });
    const energy = run.columns.get('energy')!;
    expect(Math.max(...energy) - Math.min(...energy)).toBeLessThan(1e-11 * energy[0]!);
    // u = U tanh(s), theta' = +-W sech(s), s = k t + s0.
    const [U, W] = [Math.sqrt((2 * energy[0]!) / mass), Math.sqrt((2 * energy[0]!) / J)];
    const k = (mass * a * U) / J;
    const s0 = Math.atanh(u / U);
    each((at) => {
      const heading = Math.sign(turn) * (W / k) * (Math.atan(Math.sinh(k * at('t') + s0)) - Math.atan(Math.sinh(s0)));
      expect(Math.abs(at('theta') - heading)).toBeLessThan(1e-9);
      expect(Math.abs(Math.hypot(at('x_dot'), at('y_dot')) - U * Math.abs(Math.tanh(k * at('t') + s0)))).toBeLessThan(
        1e-9,
      );
    });
  });

  test('from running backwards to running forwards it turns by pi sqrt(J / (m a²)), and no further', () => {
    const { column } = rowsOf({
      system: 'chaplygin-sleigh',
      initial: { x_dot: -1, theta_dot: 1e-6 },
      method: tight,
      duration: 20,
    });
    expect(column('theta').at(-1)).toBeCloseTo(Math.PI * Math.sqrt(J / (mass * a * a)), 5);
  });
});
