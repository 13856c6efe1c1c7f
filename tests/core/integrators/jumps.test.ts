// The contract at jumps: a step ends exactly where it must, begins anew from there, and is never longer than its bound.
import { describe, expect, test } from 'vitest';
import type { OdeProblem, Stepper } from '../../../src/core/integrators/contract.ts';
import { methods, type MethodInfo } from '../../../src/core/integrators/methods.ts';
import { Bdf } from '../../../src/core/integrators/multistep/bdf.ts';
import { Ida } from '../../../src/core/integrators/multistep/ida.ts';
import { createStepper } from '../../../src/core/integrators/registry.ts';
import type { DaeProblem } from '../../../src/core/integrators/shared/dae.ts';
import { distance, run } from './problems.ts';

/** An oscillator x'' = push - stiffness x, whose push and stiffness are switched from outside. */
class Switched implements OdeProblem, DaeProblem {
  readonly dimension = 2;
  readonly failure = null;
  readonly differential = Uint8Array.of(1, 1);
  push = 0;
  stiffness = 1;
  evaluations: number[] = [];

  derivative(t: number, y: Float64Array, out: Float64Array): boolean {
    this.evaluations.push(t);
    out[0] = y[1]!;
    out[1] = this.push - this.stiffness * y[0]!;
    return true;
  }
  start(t: number, y: Float64Array, yp: Float64Array): boolean {
    return this.derivative(t, y, yp);
  }
  residual(t: number, y: Float64Array, yp: Float64Array, out: Float64Array): boolean {
    this.derivative(t, y, out);
    for (let i = 0; i < 2; i++) out[i] = yp[i]! - out[i]!;
    return true;
  }
  /** Of the residual where it is `ida` that asks, else df/dy. */
  jacobian(t: number, y: Float64Array, ...rest: unknown[]): boolean {
    const out = rest.at(-1) as Float64Array;
    if (rest.length === 1) out.set([0, 1, -this.stiffness, 0]);
    else out.set([rest[1] as number, -1, this.stiffness, rest[1] as number]);
    return true;
  }
}

/** The state after a time under constant push and stiffness. */
function after(time: number, [x, v]: readonly number[], push: number, stiffness: number): number[] {
  const w = Math.sqrt(stiffness);
  const rest = push / stiffness;
  const [c, s] = [Math.cos(w * time), Math.sin(w * time)];
  return [rest + (x! - rest) * c + (v! / w) * s, -(x! - rest) * w * s + v! * c];
}

/** Times at which push, stiffness and velocity jump; none is a multiple of a step. */
const jumps = [
  { time: 0.31, push: 5, stiffness: 1, kick: 0 },
  { time: 0.77, push: -40, stiffness: 1, kick: 0 },
  { time: 1.0004, push: 0, stiffness: 400, kick: 3 },
  { time: 1.3, push: 0, stiffness: 1, kick: -1 },
];
const END = 1.9;

interface Case {
  name: string;
  info: MethodInfo;
  make(problem: Switched): Stepper;
}
const cases: readonly Case[] = (methods as readonly MethodInfo[]).flatMap((info) =>
  (info.stages ?? [undefined]).map((stages) => ({
    name: stages ? `${info.id} ${stages}` : info.id,
    info,
    make(problem: Switched): Stepper {
      const options = {
        rtol: stages === 1 ? 1e-6 : 1e-8,
        atol: stages === 1 ? 1e-7 : 1e-10,
        ...(stages ? { stages } : {}),
        ...(info.adaptive ? {} : { step: info.id === 'euler' ? 2e-5 : 5e-4 }),
      };
      return info.id === 'ida' ? new Ida(problem, options) : createStepper(info.id, problem, options)!;
    },
  })),
);

describe.each(cases)('jumps: $name', ({ info, make }) => {
  test('steps end exactly at each, and the motion is right across them', () => {
    const problem = new Switched();
    const stepper = make(problem);
    let state = [1, 0];
    let last = 0;
    stepper.reset(0, Float64Array.from(state));
    const within = { euler: 2e-2, 'adams-moulton': 1e-4 }[info.id] ?? 2e-5;
    const between = new Float64Array(2);
    for (const jump of [...jumps, { time: END, push: 0, stiffness: 1, kick: 0 }]) {
      expect(
        run(stepper, jump.time, () => {
          const t = (stepper.previousT + stepper.t) / 2;
          stepper.interpolate(t, between);
          const truth = after(t - last, state, problem.push, problem.stiffness);
          expect(distance(between, truth), `t = ${t}`).toBeLessThan(within * 10);
        }),
      ).toBeNull();
      expect(stepper.t).toBe(jump.time);
      state = after(jump.time - last, state, problem.push, problem.stiffness);
      expect(distance(stepper.y, state), `t = ${jump.time}`).toBeLessThan(within * 10);
      [problem.push, problem.stiffness] = [jump.push, jump.stiffness];
      stepper.y[1]! += jump.kick;
      state[1]! += jump.kick;
      last = jump.time;
      const [steps, previousT] = [stepper.counters.steps, stepper.previousT];
      stepper.restart();
      // Counters run on, and the last step can still be read.
      expect([stepper.counters.steps, stepper.previousT, stepper.t]).toEqual([steps, previousT, jump.time]);
      stepper.interpolate(stepper.t, between);
      expect(Math.abs(between[0]! - stepper.y[0]!)).toBeLessThan(1e-12);
      expect(Math.abs(between[1]! + jump.kick - stepper.y[1]!)).toBeLessThan(1e-9);
    }
  });

  test('f is looked at nowhere beyond the limit, and after a restart nowhere before it', () => {
    const problem = new Switched();
    const stepper = make(problem);
    stepper.reset(0, Float64Array.of(1, 0));
    expect(run(stepper, 0.31)).toBeNull();
    const rounding = 1e-15;
    expect(Math.max(...problem.evaluations)).toBeLessThanOrEqual(0.31 + rounding);
    problem.evaluations = [];
    stepper.restart();
    expect(run(stepper, 0.4)).toBeNull();
    expect(problem.evaluations[0]).toBe(0.31);
    expect(Math.min(...problem.evaluations)).toBeGreaterThanOrEqual(0.31);
    problem.evaluations = [];
    stepper.restart();
    expect(run(stepper, 0.4 + 1e-7)).toBeNull();
    expect(Math.max(...problem.evaluations)).toBeLessThanOrEqual(0.4 + 1e-7 + rounding);
  });

  test('no step is longer than its bound, which may change at each, and which leaves the result right', () => {
    const problem = new Switched();
    const stepper = make(problem);
    stepper.reset(0, Float64Array.of(1, 0));
    const bound = (t: number): number => (t < 0.4 ? 0.003 : t < 0.6 ? 2e-4 : 0.01 + t / 100);
    let longest = 0;
    while (stepper.t < 1) {
      const most = bound(stepper.t);
      expect(stepper.step(1, most)).toBeNull();
      const taken = stepper.t - stepper.previousT;
      expect(taken).toBeLessThanOrEqual(most * (1 + 1e-5));
      longest = Math.max(longest, taken / most);
    }
    if (info.id !== 'euler' && info.id !== 'rk4' && info.id !== 'adams-moulton') expect(longest).toBeGreaterThan(0.99);
    expect(distance(stepper.y, after(1, [1, 0], 0, 1))).toBeLessThan(info.id === 'euler' ? 1e-3 : 1e-6);
  });

  test('a bound leaves no trace in the length of later steps of one-step methods', () => {
    const problem = new Switched();
    const [free, bounded] = [0, 1].map((k) => {
      const stepper = make(problem);
      stepper.reset(0, Float64Array.of(1, 0));
      expect(run(stepper, 0.2)).toBeNull();
      if (k) expect(stepper.step(END, 1e-4)).toBeNull();
      expect(stepper.step(END)).toBeNull();
      return stepper.t - stepper.previousT;
    });
    if (info.id !== 'bdf' && info.id !== 'ida') expect(bounded! / free!).toBeGreaterThan(0.5);
  });
});

test.each([Bdf, Ida])('%o begins anew at order 1 after a restart, and rises again', (Method) => {
  const problem = new Switched();
  const stepper = new Method(problem, { rtol: 1e-8, atol: 1e-10 });
  stepper.reset(0, Float64Array.of(1, 0));
  expect(stepper.order).toBe(1);
  expect(run(stepper, 1)).toBeNull();
  expect(stepper.order).toBeGreaterThan(2);
  problem.push = 10;
  stepper.restart();
  expect(stepper.order).toBe(1);
  expect(stepper.step(2)).toBeNull();
  expect(run(stepper, 2)).toBeNull();
  expect(stepper.order).toBeGreaterThan(2);
});

test('a jump that nobody announces costs rejected steps; one that is announced does not', () => {
  const rejected = [false, true].map((announced) => {
    const problem = new Switched();
    const stepper = createStepper('dopri5', problem, { rtol: 1e-9, atol: 1e-9 })!;
    stepper.reset(0, Float64Array.of(1, 0));
    const f = problem.derivative.bind(problem);
    if (!announced) problem.derivative = (t, y, out) => ((problem.push = t < 0.5 ? 0 : 50), f(t, y, out));
    else {
      expect(run(stepper, 0.5)).toBeNull();
      problem.push = 50;
      stepper.restart();
    }
    expect(run(stepper, 1)).toBeNull();
    return stepper.counters.rejected;
  });
  expect(rejected[1]).toBe(0);
  expect(rejected[0]!).toBeGreaterThan(2);
});
