// The program of a sampled controller: what is exported answers as what is simulated.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { describe, expect, test } from 'vitest';
import { programFormats } from '../../../src/core/control/design/programExports.ts';
import { feedbackOf } from '../../../src/core/control/design/feedback.ts';
import { lqrOf } from '../../../src/core/control/design/scenarioControl.ts';
import { carriedOut, programOf, type ControllerProgram } from '../../../src/core/control/sampled/program.ts';
import { systems } from '../../../src/core/systems/all.ts';
import { runOf, scenarioOf } from '../../helpers.ts';

const system = systems['ripstik']!;
const file = (control: object) => ({
  version: 1,
  system: 'ripstik',
  initial: { X_dot: 1, alpha_fp: 1e-3, alpha_bp: 2e-3 },
  duration: 0.1,
  outputStep: 0.001,
  columns: ['inputs'],
  control: {
    type: 'lqr',
    inputs: ['tau_fc', 'tau_bc'],
    at: { X_dot: 1 },
    sample: 0.005,
    design: 'sampled',
    ...control,
  },
});
const program = (control: object): ControllerProgram => {
  const scenario = scenarioOf(file(control));
  return programOf(scenario, lqrOf(scenario, system))!;
};
const sensors = Object.fromEntries(
  ['alpha + alpha_fp', 'alpha + alpha_bp', 'alpha_dot + alpha_fp_dot', 'theta_fc', 'theta_bc'].map((name) => [
    name,
    // The error of one is followed.
    name === 'alpha + alpha_fp' ? { noise: 1e-3, follow: 0.003 } : { noise: 1e-3 },
  ]),
);

test.each([
  ['plain', {}],
  ['held', { design: 'continuous', sample: 0.002 }],
  ['late', { delay: 0.008 }],
  ['late and lagging', { delay: 0.003, actuators: { tau_bc: { lag: 0.004 } } }],
])('%s: answers what the run asks', (_, control) => {
  const made = program(control);
  const run = runOf(file(control));
  const { delay, sample } = made;
  const t = [...run.columns.get('t')!];
  const rowAt = (time: number): number => t.findIndex((x) => Math.abs(x - time) < 1e-9);
  const count = 12;
  const y = Array.from({ length: count }, (_, k) =>
    made.measured.map((name) => {
      const x = run.columns.get(name)![rowAt(k * sample)]!;
      const start = { X_dot: 1, Z: run.columns.get('Z')![0]! }[name] ?? 0;
      return x - (name === 'X' ? k * sample : start);
    }),
  );
  const answers = carriedOut(made, y);
  const size = Math.max(...answers.flat().map(Math.abs));
  answers.forEach((u, k) => {
    // A row between two instants, where it acts; the front motor does not lag.
    const acting = run.columns.get('tau_fc')![rowAt(Math.ceil((k * sample + delay) * 1000 + 0.5) / 1000)]!;
    expect(Math.abs(u[0]! - acting), `sample ${k}`).toBeLessThan(1e-6 * size);
  });
  expect(size).toBeGreaterThan(0);
});

test('with a filter: as the estimator and the gain that a run uses', () => {
  const control = { sensors, delay: 0.007, actuators: { tau_fc: { lag: 0.002 } } };
  const made = program(control);
  const feedbacks = [...feedbackOf(scenarioOf(file(control)), system)!.values()];
  const estimate = feedbacks[0]!.estimator!.begin();
  const { q, v } = lqrOf(scenarioOf(file(control)), system).linearization.motion;
  estimate.know(0, q, v);
  estimate.fill([0, 0]);
  const lag = 0.002;
  const past: number[] = new Array<number>(feedbacks[0]!.past!.length).fill(0);
  let given = 0;
  const history: number[][] = [];
  made.test.y.forEach((y, k) => {
    const t = k * 0.005;
    estimate.correct(t, y);
    // What the lagging motor gives at t: inputs act 7 ms after they are asked.
    given = 0;
    for (let at = 0; at < t - 1e-12; at += 1e-6) {
      const from = Math.floor((at - 0.007 + 1e-9) / 0.005);
      given += (1e-6 / lag) * ((from >= 0 ? history[from]![0]! : 0) - given);
    }
    const u = feedbacks.map((f) => {
      let asked = f.asked(t, estimate.q, estimate.v);
      f.past!.forEach((gain, i) => (asked -= gain * past[i]!));
      return asked - f.acting![0]! * given;
    });
    history.push(u);
    past.unshift(...u);
    past.length = feedbacks[0]!.past!.length;
    estimate.predict(u);
    u.forEach((x, i) => expect(Math.abs(x / made.test.u[k]![i]! - 1), `sample ${k}`).toBeLessThan(2e-2));
  });
});

describe('as source', () => {
  const made = program({ sensors, delay: 0.005 });
  const text = (id: string, of = made): string => programFormats.find((f) => f.id === id)!.write(of);

  test('JSON is read back to the bit', () => {
    expect(JSON.parse(text('json'))).toEqual(made);
  });

  test('carries its matrices and test vector, and a memory of nothing too', () => {
    for (const id of ['c', 'python', 'matlab']) {
      expect(text(id)).toContain(made.D[0]![0]!.toPrecision(17));
      expect(text(id)).toContain('alpha + alpha_fp');
    }
    const plain = program({});
    expect(plain.A).toEqual([]);
    expect(text('c', plain)).toContain('MEMORY = 0');
    expect(text('matlab', plain)).toContain('A = zeros(0, 0);');
  });

  /** Runs a program as it is saved; false where the machine has not what runs it. */
  const runs = (of: typeof made, id: string, file: string, ...commands: readonly string[][]): boolean => {
    const folder = mkdtempSync(join(tmpdir(), 'program-'));
    try {
      writeFileSync(join(folder, file), text(id, of));
      let answer = '';
      for (const [command, ...args] of commands)
        answer = execFileSync(command!, args, { cwd: folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
      expect(answer).toMatch(/^largest difference/m);
      return true;
    } catch (error) {
      if ((error as NodeJS.ErrnoException).code === 'ENOENT') return false;
      throw error;
    } finally {
      rmSync(folder, { recursive: true });
    }
  };

  test.each([
    ['C', 'c', 'a.c', ['cc', '-std=c99', '-Wall', '-Werror', '-o', 'a', 'a.c', '-lm'], ['./a']],
    ['Python', 'python', 'a.py', ['python3', 'a.py']],
    // Octave reads MATLAB's language.
    ['MATLAB', 'matlab', 'a.m', ['octave-cli', '--no-init-file', '--quiet', 'a.m']],
  ] as const)(
    'in %s it answers its test vector, where the machine can run it',
    (_name, id, file, ...commands) => {
      const lists = commands.map((command) => [...command]);
      if (!runs(made, id, file, ...lists)) return;
      runs(program({}), id, file, ...lists);
      // And it is the vector that decides.
      const wrong = { ...made, test: { ...made.test, u: made.test.u.map((row) => row.map((u) => 1.001 * u)) } };
      expect(() => runs(wrong, id, file, ...lists)).toThrow();
    },
    30_000,
  );
});
