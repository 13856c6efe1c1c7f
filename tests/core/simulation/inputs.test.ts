import { describe, expect, test } from 'vitest';
import { methods } from '../../../src/core/integrators/methods.ts';
import { InputPlan } from '../../../src/core/simulation/inputPlan.ts';
import { distance, endOf, runOf } from '../../helpers.ts';

const adaptive = methods.filter((m) => m.adaptive).map((m) => m.id);

type Raw = Record<string, unknown>;

describe('inputs that act briefly', () => {
  const wheel = { version: 1, system: 'rolling-wheel', duration: 20 };
  test.each(adaptive)(
    "%s: the report's double Gaussian turns a resting wheel by 24.66 rad, between two and -two",
    (name) => {
      const { columns, rows } = runOf({
        ...wheel,
        inputs: { tau_phi: '22*exp(-10*(t-8)^2) - 22*exp(-10*(t-12)^2)' },
        method: { name, rtol: 1e-10 },
      });
      // The impulse 22 sqrt(pi/10) on the inertia 1 + 1, for 4 s.
      const rate = (22 * Math.sqrt(Math.PI / 10)) / 2;
      expect(columns.get('phi_dot')![1000]!).toBeCloseTo(rate, 6);
      expect(columns.get('phi')![rows - 1]!).toBeCloseTo(4 * rate, 5);
      expect(columns.get('phi_dot')![rows - 1]!).toBeCloseTo(0, 6);
    },
  );

  test.each(adaptive)('%s: 100 N·m on the roll of a bicycle for 0.1 s', (name) => {
    const bicycle = {
      version: 1,
      system: 'bicycle',
      initial: { speed: 5 },
      method: { name, rtol: 1e-10 },
      duration: 4,
    };
    const run = endOf({ ...bicycle, inputs: { f_roll: '(t > 3) * (t < 3.1) * 100' } });
    const before = endOf({ ...bicycle, duration: 3 });
    const pushed = endOf({ ...bicycle, duration: 3.1, inputs: { f_roll: 100 } }, before);
    const after = endOf(bicycle, pushed);
    expect(distance(after, endOf(bicycle))).toBeGreaterThan(0.1);
    expect(distance(run, after)).toBeLessThan(1e-6);
  });

  test.each(adaptive)('%s: a board that steers from 5 to 5.5 s', (name) => {
    const board = { version: 1, system: 'ripstik', initial: { X_dot: 1 }, method: { name }, duration: 5.3 };
    const run = endOf({ ...board, inputs: { tau_fc: 't>5 ? (t<5.5 ? 0.05 : 0) : 0' } });
    const steered = endOf({ ...board, inputs: { tau_fc: 0.05 } }, endOf({ ...board, duration: 5 }));
    expect(Math.abs(steered.q[8]!)).toBeGreaterThan(0.01);
    expect(distance(run, steered)).toBeLessThan(1e-4);
  });

  test.each(adaptive)('%s: a disturbance of the balanced wheel-pendulum', (name) => {
    const pendulum = {
      version: 1,
      system: 'wheel-pendulum',
      control: { type: 'lqr', inputs: ['tau_phi'] },
      method: { name, rtol: 1e-10 },
      duration: 6,
    };
    const run = endOf({ ...pendulum, inputs: { tau_phi: '300*(abs(t-4) < 0.005)' } });
    const before = endOf({ ...pendulum, duration: 3.995 });
    const pushed = endOf({ ...pendulum, duration: 4.005, inputs: { tau_phi: 300 } }, before);
    const after = endOf(pendulum, pushed);
    expect(distance(after, endOf(pendulum))).toBeGreaterThan(1e-3);
    expect(distance(run, after) / distance(after, endOf(pendulum))).toBeLessThan(1e-5);
  });

  test.each(adaptive)('%s: a pulse in the reference of a gait, in a run that goes on from a row', (name) => {
    const gait = (pulse: string): Raw => ({
      version: 1,
      system: 'casterboard-robot',
      control: {
        type: 'track',
        kp: 60,
        kd: 3,
        reference: { tau_f: `pi/9*sin(6.4*t)${pulse}`, tau_r: 'pi/9*sin(6.4*t)' },
      },
      method: { name, rtol: 1e-9 },
      duration: 2,
    });
    const start = endOf({ ...gait(''), duration: 1 });
    const pulse = ' + 0.1*exp(-((t-1.5)/0.01)^2)';
    const run = endOf(gait(pulse), start);
    const short = endOf({ ...gait(pulse), method: { name, rtol: 1e-9, maxStep: 5e-4 } }, start);
    const effect = distance(short, endOf(gait(''), start));
    expect(effect).toBeGreaterThan(1e-4);
    expect(distance(run, short)).toBeLessThan(1e-3 * effect);
  });

  test.each([
    // The one root has no slope at its start while the other is dead: each part of a sum keeps its own pace.
    ['sqrt(mod(t,0.3))+sqrt(max(0,cos(3*t)))'],
    // Rounding puts the end of a stretch just outside of the root.
    ['sqrt(abs(sin(4*t)))'],
    ['sin(4*t) > 0 ? sqrt(sin(4*t)) : 0'],
    ['sin(20*(t-0.5))/(t-0.5)'],
    ['atan(tan(3*t))'],
  ])('all methods agree on %s', (tau_phi) => {
    const rates = adaptive.map(
      (name) => endOf({ ...wheel, duration: 1.2, inputs: { tau_phi }, method: { name, rtol: 1e-9 } }).v[3]!,
    );
    for (const rate of rates) expect(Math.abs(rate - rates[0]!)).toBeLessThan(3e-7);
  });

  test.each([
    ['exp(-X)/(1+exp(-X))^2', 1],
    ['2/(exp(X)+exp(-X))', Math.PI],
    ['2*exp(X)/(exp(2*X)+1)', Math.PI],
    ['1/(1+exp(-X)) - exp(X)/(exp(2)+exp(X))', 2],
    ['1/cosh(X)^2', 2],
  ])('a pulse of %s a millionth of a second wide, whose exponentials leave doubles', (shape, area) => {
    const [at, width, size] = [3.21, 1e-6, 1e4];
    const tau_phi = `${size}*(${shape.replaceAll('X', `((t-${at})/${width})`)})`;
    for (const name of adaptive) {
      const rate = endOf({ ...wheel, duration: 5, inputs: { tau_phi }, method: { name, rtol: 1e-8 } }).v[3]!;
      // On the inertia 1 + 1. The argument itself is good to 1e-10: 3.21 / 1e-6 in doubles.
      expect(Math.abs(rate / ((size * width * area) / 2) - 1), name).toBeLessThan(1e-6);
    }
  });

  test('ida starts anew where a reference gets a large rate from rest, at a sharp tolerance', () => {
    const tooth = '(t > 0.6) * (t < 0.6014) * 140*(t-0.6)';
    const end = endOf({
      version: 1,
      system: 'casterboard-robot',
      control: { type: 'track', kp: 60, kd: 3, reference: { tau_f: tooth, tau_r: tooth } },
      method: { name: 'ida', rtol: 1e-11, atol: 1e-13 },
      duration: 0.61,
    });
    expect(end.time).toBe(0.61);
  });

  test('a logistic reference goes on where its exponential has left the range of doubles', () => {
    const reference = { tau_fp: '10 deg/(1+exp(100*(t-1)))', tau_bp: '-10 deg/(1+exp(100*(t-1)))' };
    const { end, counts } = runOf({
      version: 1,
      system: 'ripstik',
      initial: { X_dot: 1 },
      control: { type: 'track', kp: 60, kd: 3, reference },
      duration: 10,
    });
    expect(end.reason).toBe('end');
    expect(counts.evaluations).toBeLessThan(20000);
  });

  test('a fixed step that passes over an input says so, one that does not keeps quiet', () => {
    const warnings = (step: number, tau: string): readonly string[] =>
      runOf({ ...wheel, inputs: { tau_phi: tau }, method: { name: 'rk4', step } }).simulation.warnings;
    expect(warnings(0.1, 'exp(-((t-8)/0.003)^2)').join()).toMatch(
      /tau_phi changes within a step at t = 7\.\d+ s: .* take one of 0\.00\d+ s/,
    );
    expect(warnings(0.1, 'sin(t)')).toEqual([]);
    expect(warnings(0.1, 't > 3.05 ? 1 : 0')).toEqual([]);
    expect(warnings(2e-4, 'exp(-((t-8)/0.003)^2)')).toEqual([]);
    // All of it within a step that two switches shorten.
    expect(warnings(0.1, 'abs(t-3) < 0.04 ? sin(2000*t) : 0').join()).toMatch(/take one of 0\.000\d+ s/);
    // Of the end of a root's range no step would do.
    expect(warnings(0.1, 't < 3 ? sqrt(3-t) : 0').join()).toMatch(/cannot follow it; take a method that chooses/);
  });

  test.each(methods.map(({ id }) => id))('%s: what a choice keeps away from a root, a logarithm or a pole', (name) => {
    const exact: [formula: string, impulse: number][] = [
      ['abs(t-1.0748) < 0.0433 ? exp(-1/(1-((t-1.0748)/0.0433)^2)) : 0', 0.0433 * 0.443993816168079],
      ['abs(t-0.3) < 0.1 ? sqrt(0.01-(t-0.3)^2) : 0', (Math.PI * 0.01) / 2],
      ['t < 1 ? sqrt(1-t) : 0', 2 / 3],
      ['t > 1 ? (t-1)^0.3 : 0', 1 / 1.3],
    ];
    for (const [tau_phi, impulse] of exact) {
      const { v } = endOf({ ...wheel, duration: 2, inputs: { tau_phi }, method: { name, step: 1e-3, rtol: 1e-9 } });
      const isFixed = methods.some(({ id, adaptive: chooses }) => id === name && !chooses);
      expect(Math.abs((2 * v[3]!) / impulse - 1), tau_phi).toBeLessThan(isFixed ? 2e-3 : 3e-6);
    }
  });

  test('a fixed step ends at a switch', () => {
    const end = endOf({
      ...wheel,
      inputs: { tau_phi: '(t > 3.0101) * (t < 3.0202)' },
      method: { name: 'euler', step: 0.1 },
    });
    expect(end.v[3]).toBeCloseTo(0.0101 / 2, 14);
  });
});

test('slow inputs cost no more evaluations than if steps knew nothing of them, but a tenth', () => {
  const slow = [
    ['tanh(t-5)', 'sin(t)', 'exp(-t)', 'exp(-(t-5)^2/4)', '1/(1+t)', 't*exp(-t)', 'sqrt(1+t)', 'atan(t-5)'],
    ['cosh(t-5)^-2', 'sin(t)+0.1*sin(3*t)', 'exp(sin(t))', 'sin(t^2/10)', '5/(1+exp(-(t-5)))', 'exp(-t/2)*cos(2*t)'],
    ['1/(1+(t-5)^2)', 't^3/100', 'exp(-(t-8)^2/9)+exp(-(t-3)^2)', 'hypot(t-5,1)', 'sin(t)/(2+cos(t))', 'log(1+t)'],
  ].flat();
  const wheel = { system: 'rolling-wheel', duration: 20, initial: { phi_dot: 2 } };
  const places = [
    { file: wheel, input: 'tau_phi', size: 1 },
    { file: { system: 'chaplygin-sleigh', initial: { x_dot: 1 } }, input: 'tau_theta', size: 0.3 },
    { file: { system: 'casterboard-robot', initial: { phi_f: 0.1 } }, input: 'tau_f', size: 0.001 },
  ];
  const bound = InputPlan.prototype.bound;
  const workOf = (raw: Raw): { evaluations: number; steps: number; end: number[] } => {
    const { columns, rows, counts } = runOf({ version: 1, outputStep: 1000, ...raw });
    const { evaluations, steps } = counts;
    return { evaluations, steps, end: [...columns.values()].map((column) => column[rows - 1]!) };
  };
  let [all, free] = [0, 0];
  slow.forEach((formula, i) =>
    adaptive.forEach((name, j) => {
      const { file, input, size } = places[(i + j) % places.length]!;
      // Multistep methods at 1e-10 take long.
      const rtols =
        name === 'bdf' || name === 'ida' || name === 'bs23' ? [1e-3, 1e-5, 1e-7] : [1e-3, 1e-5, 1e-8, 1e-10];
      for (const rtol of rtols) {
        const raw = { ...file, inputs: { [input]: `${size}*(${formula})` }, method: { name, rtol, atol: rtol / 100 } };
        const bounded = workOf(raw);
        InputPlan.prototype.bound = () => Infinity;
        const unbounded = workOf(raw);
        InputPlan.prototype.bound = bound;
        // Where steps that know nothing pass over something they are no measure.
        const off = Math.max(...bounded.end.map((x, k) => Math.abs(x - unbounded.end[k]!) / (1 + Math.abs(x))));
        if (off > 10 * rtol) continue;
        all += bounded.evaluations;
        free += unbounded.evaluations;
        // Of ten steps one is a tenth, and the last may be a short one.
        const step = unbounded.evaluations / unbounded.steps;
        const told = `${name} at ${rtol}, ${file.system}, ${formula}: ${bounded.steps} steps, ${unbounded.steps} without`;
        expect(bounded.evaluations, told).toBeLessThanOrEqual(1.1 * unbounded.evaluations + 2 * step);
      }
    }),
  );
  expect(all / free).toBeLessThan(1.02);
}, 120_000);
