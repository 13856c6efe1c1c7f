import { describe, expect, test } from 'vitest';
import { methods } from '../../src/core/integrators/methods.ts';
import type { Continuation } from '../../src/core/simulation/simulation.ts';
import { distance, endOf, seeded } from '../helpers.ts';
import { runs, SEED, tally } from './tally.ts';

/** What acts briefly: every run with it against the same run made piece by piece, with steps that must see it. */

const adaptive = methods.filter((m) => m.adaptive).map((m) => m.id);

type Raw = Record<string, unknown>;

/** Where pulses are tried, how large they are, and how long they can be followed, s. */
interface Place {
  file: Raw;
  /** What a formula acts as. */
  put(formula: string): Raw;
  /** Area of a pulse (inputs), or about its height (references, whose rate acts too: each tooth of a saw pushes by its height). */
  size: number;
  high?: boolean;
  duration: number;
}

const push =
  (input: string) =>
  (formula: string): Raw => ({ inputs: { [input]: formula } });

/** Inputs: impulses in N·s or N·m·s. */
const pushed: Place[] = [
  {
    file: { system: 'rolling-wheel', initial: { theta_dot: 1, phi_dot: 2 } },
    put: push('tau_phi'),
    size: 0.5,
    duration: 4,
  },
  { file: { system: 'cart-pendulum', initial: { theta: '-90 deg' } }, put: push('f_X'), size: 0.1, duration: 4 },
  { file: { system: 'chaplygin-sleigh', initial: { x_dot: 1 } }, put: push('tau_theta'), size: 0.2, duration: 3 },
  { file: { system: 'casterboard-robot', initial: { phi_f: 0.1 } }, put: push('tau_f'), size: 0.001, duration: 3 },
  { file: { system: 'bicycle', initial: { speed: 5 } }, put: push('f_roll'), size: 5, duration: 3 },
  { file: { system: 'wheel-pendulum' }, put: push('tau_phi'), size: 0.5, duration: 1.2 },
  { file: { system: 'ripstik', initial: { X_dot: 1 } }, put: push('tau_fc'), size: 0.0005, duration: 0.4 },
  { file: { system: 'ripstik', constraints: 'none' }, put: push('f_theta'), size: 0.05, duration: 2 },
];

const follow =
  (kp: number, kd: number, inputs: string[], limit?: number) =>
  (formula: string): Raw => ({
    control: {
      type: 'track',
      kp,
      kd,
      reference: Object.fromEntries(inputs.map((input) => [input, formula])),
      ...(limit === undefined ? {} : { limits: Object.fromEntries(inputs.map((input) => [input, limit])) }),
    },
  });

/** References: heights in rad or m. */
const followed: Place[] = [
  {
    file: { system: 'rolling-wheel', initial: { theta_dot: 1, phi_dot: 2 } },
    put: follow(4, 1, ['tau_theta', 'tau_phi']),
    size: 0.5,
    high: true,
    duration: 4,
  },
  {
    file: { system: 'cart-pendulum', initial: { theta: '-90 deg' } },
    put: follow(20, 5, ['f_X']),
    size: 0.2,
    high: true,
    duration: 4,
  },
  {
    file: { system: 'chaplygin-sleigh', initial: { x_dot: 1 } },
    put: follow(2, 0.5, ['tau_theta']),
    size: 0.5,
    high: true,
    duration: 3,
  },
  {
    file: { system: 'casterboard-robot', initial: { phi_f: 0.1 } },
    put: follow(60, 3, ['tau_f', 'tau_r']),
    size: 0.1,
    high: true,
    duration: 2,
  },
  {
    file: { system: 'casterboard-robot', initial: { phi_f: 0.01 } },
    put: follow(60, 3, ['tau_f', 'tau_r'], 2),
    size: 0.2,
    high: true,
    duration: 2,
  },
  {
    file: { system: 'bicycle', initial: { speed: 5 } },
    put: follow(5, 1, ['tau_steer']),
    size: 0.1,
    high: true,
    duration: 2,
  },
  { file: { system: 'wheel-pendulum' }, put: follow(2, 1, ['tau_phi']), size: 0.2, high: true, duration: 1 },
  {
    file: { system: 'ripstik', initial: { X_dot: 1 } },
    put: follow(60, 3, ['tau_fp', 'tau_bp']),
    size: 0.002,
    high: true,
    duration: 0.4,
  },
];

/** Gains that follow the speed, which a push along changes. */
const scheduled: Place[] = [
  {
    file: { system: 'bicycle', initial: { speed: 5, roll: '2 deg' } },
    put: (formula) => ({
      inputs: { tau_rear: formula },
      control: {
        type: 'lqr',
        inputs: ['tau_steer'],
        at: { speed: 5 },
        Q: { roll: 1, yaw: 1 },
        schedule: { from: 4.6, to: 5.6, count: 3 },
      },
    }),
    size: 10,
    duration: 3,
  },
  {
    file: { system: 'ripstik', initial: { X_dot: 1, alpha_fp: '2 deg', alpha_bp: '2 deg' } },
    put: (formula) => ({
      inputs: { f_X: formula },
      control: {
        type: 'lqr',
        inputs: ['tau_fc', 'tau_bc'],
        at: { X_dot: 1 },
        schedule: { from: 0.9, to: 1.4, count: 3 },
      },
    }),
    size: 0.5,
    duration: 1,
  },
];

/** A pulse of an area of 1 around `at`: its formula, and pieces [from, to, formula] that are smooth and 0 outside. */
type Pulse = { formula: string; pieces: [number, number, string][] };
const shapes: Record<string, (at: number, width: number) => Pulse> = {
  rectangle(at, width) {
    const [a, b, size] = [at - width / 2, at + width / 2, 1 / width];
    return { formula: `(t > ${a} ? (t < ${b} ? ${size} : 0) : 0)`, pieces: [[a, b, `${size}`]] };
  },
  gaussian(at, width) {
    const formula = `${1 / (width * Math.sqrt(Math.PI))}*exp(-((t-${at})/${width})^2)`;
    return { formula, pieces: [[at - 6.5 * width, at + 6.5 * width, formula]] };
  },
  sawtooth(at, width) {
    const [a, b] = [at - width, at + width];
    const tooth = (k: number): string => `${1 / width}*(t-${a + (k * width) / 2})/${width / 2}`;
    return {
      formula: `(t >= ${a}) * (t < ${b}) * ${1 / width}*mod((t-${a})/${width / 2}, 1)`,
      pieces: [0, 1, 2, 3].map((k) => [a + (k * width) / 2, a + ((k + 1) * width) / 2, tooth(k)]),
    };
  },
  chirp(at, width) {
    const [a, b] = [at - width / 2, at + width / 2];
    const wave = `${3 / width}*sin(${3 / width}*(t-${a}) + ${20 / width ** 2}*(t-${a})^2)`;
    return { formula: `(abs(t-${at}) < ${width / 2}) * ${wave}`, pieces: [[a, b, wave]] };
  },
};

describe('pulses of any width, shape and time, by every method, against runs made piece by piece', () => {
  const seen = tally('pulses');
  test.each([
    ['as inputs, on every system', pushed, 32],
    ['as references that are followed', followed, 16],
    ['on what is balanced by gains that follow the speed', scheduled, 4],
  ] as const)('%s', { timeout: 3_600_000 }, (kind, places, trials) => {
    const random = seeded(SEED);
    const uniform = (a: number, b: number): number => a + (b - a) * random();
    const pick = <T>(list: readonly T[]): T => list[Math.min(list.length - 1, Math.floor(uniform(0, list.length)))]!;
    for (let trial = 0; trial < runs(trials); trial++) {
      const { file, put, size, high, duration } = places[trial % places.length]!;
      const name = adaptive[(trial + Math.floor(trial / places.length)) % adaptive.length]!;
      const shape = pick(Object.keys(shapes));
      const width = Math.min(10 ** uniform(-4, 0), duration / 16);
      const count = uniform(0, 1) < 0.3 ? 3 : 1;
      const room = 7 * width;
      const times = [uniform(room, duration - room)];
      for (let k = 1; k < count; k++) {
        const next = times.at(-1)! + 2 * room * uniform(1, 3);
        if (next < duration - room) times.push(next);
      }
      const factor = size * (high ? width : 1);
      const pulses = times.map((at) => shapes[shape]!(at, width));
      const raw = { version: 1, ...file, duration, events: {}, method: { name, rtol: 1e-10, atol: 1e-12 } };
      const quiet = { ...raw, ...put('0') };
      const told = `seed ${SEED}, ${kind}, trial ${trial}: ${name}, ${file['system'] as string}, ${shape} of ${width} s at ${times.join(', ')} s`;
      const difference = (list: Pulse[], step: number): [number, Continuation] => {
        const whole = endOf({ ...raw, ...put(list.map((p) => `${factor}*(${p.formula})`).join(' + ')) });
        let state: Continuation | undefined;
        for (const [from, to, formula] of list.flatMap((p) => p.pieces)) {
          if (from - (state?.time ?? 0) > 1e-12) state = endOf({ ...quiet, duration: from }, state);
          const method = { ...raw.method, maxStep: step };
          state = endOf({ ...raw, duration: to, method, ...put(`${factor}*(${formula})`) }, state);
        }
        return [distance(whole, endOf(quiet, state)), whole];
      };
      const [off, whole] = difference(pulses, width / 20);
      const effect = distance(whole, endOf(quiet));
      expect(effect, told).toBeGreaterThan(0);
      if (off <= 1e-5 * effect) {
        seen('within 1e-5 of the effect', duration);
        continue;
      }
      const [usual] = difference([shapes['gaussian']!(duration / 2, duration / 14)], duration / 280);
      expect(off, `${told}: effect ${effect}, a smooth one differs by ${usual}`).toBeLessThan(10 * usual);
      seen('within ten times the spread of a smooth one', duration);
    }
  });
});
