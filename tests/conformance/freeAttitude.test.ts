import { describe, expect, test } from 'vitest';
import { methods } from '../../src/core/integrators/methods.ts';
import { formulations } from '../../src/core/mechanics/formulations/formulations.ts';
import { ConstrainedSystem } from '../../src/core/mechanics/constrainedSystem.ts';
import { actuationOf } from '../../src/core/simulation/actuation.ts';
import { motionOf } from '../../src/core/simulation/motion.ts';
import { systems } from '../../src/core/systems/all.ts';
import { MujocoBoard } from '../../src/cli/bench/mujoco.ts';
import { runOf, scenarioOf, seeded } from '../helpers.ts';

const meta = systems['ripstik']!.meta;
const names = meta.coordinates.map((c) => c.name);
/** Our coordinates' places among MuJoCo's velocities: the joints of the back plate and the front caster change places. */
const JOINTS = [
  [6, 6],
  [7, 8],
  [8, 7],
  [9, 9],
] as const;
const SEED = 20260128;
const DURATION = 3;
const ADAPTIVE = methods.filter((m) => m.adaptive).map((m) => m.id);

interface Start {
  q: Float64Array;
  v: Float64Array;
}

const start = (values: Readonly<Record<string, number>>): Start => ({
  q: Float64Array.from(names, (name) => values[name] ?? 0),
  v: Float64Array.from(names, (name) => values[`${name}_dot`] ?? 0),
});

const random = seeded(SEED);
const around = (size: number): number => size * (2 * random() - 1);
const STARTS: Readonly<Record<string, Start>> = {
  'at 90°, tumbling on': start({ psi: Math.PI / 2, psi_dot: 2.5, alpha_dot: 0.4, alpha_fp_dot: 0.5 }),
  'at -90°': start({ psi: -Math.PI / 2, psi_dot: -3, theta_dot: 0.7, theta_fc: 0.3 }),
  'straight through 90° and 270°': start({ psi: 0.5, psi_dot: 3 }),
  'at 89.999999°, turning on': start({
    psi: (89.999999 * Math.PI) / 180,
    psi_dot: 0.4,
    theta_dot: 2e-9,
    alpha_dot: 0.3,
  }),
  'close by': start({ psi: 0.6, psi_dot: 3, theta_dot: 1e-3, alpha_dot: -2e-3 }),
  'anyhow, a': start({ ...randomState() }),
  'anyhow, b': start({ ...randomState() }),
};

function randomState(): Record<string, number> {
  return Object.fromEntries(
    names.flatMap((name) => [
      [name, around(1)],
      [`${name}_dot`, name === 'psi' ? 4 : around(1.5)],
    ]),
  );
}

/** Rz(theta) Ry(psi) Rx(alpha) of a row. */
function attitudeOf(theta: number, psi: number, alpha: number): number[] {
  const [ct, st, cp, sp] = [Math.cos(theta), Math.sin(theta), Math.cos(psi), Math.sin(psi)];
  const [ca, sa] = [Math.cos(alpha), Math.sin(alpha)];
  return [
    ct * cp, ct * sp * sa - st * ca, ct * sp * ca + st * sa,
    st * cp, st * sp * sa + ct * ca, st * sp * ca - ct * sa,
    -sp, cp * sa, cp * ca,
  ]; // prettier-ignore
}

const matrixOf = ([w, x, y, z]: readonly number[]): number[] => [
  1 - 2 * (y! * y! + z! * z!), 2 * (x! * y! - w! * z!), 2 * (x! * z! + w! * y!),
  2 * (x! * y! + w! * z!), 1 - 2 * (x! * x! + z! * z!), 2 * (y! * z! - w! * x!),
  2 * (x! * z! - w! * y!), 2 * (y! * z! + w! * x!), 1 - 2 * (x! * x! + y! * y!),
]; // prettier-ignore

/** MuJoCo's free joint and its accelerations, integrated by the classical method with a small step: position, attitude, joints at the end. */
async function byMujoco({ q, v }: Start): Promise<{ position: number[]; R: number[]; joints: number[] }> {
  const { parameters } = scenarioOf({ version: 1, system: 'ripstik', constraints: 'none' });
  const board = await MujocoBoard.load(parameters, 'free');
  let x = Float64Array.of(...board.positionsOf(q), ...board.velocitiesOf(q, v));
  const slope = (state: Float64Array): Float64Array => {
    const out = new Float64Array(21);
    const [w, a, b, c] = [state[3]!, state[4]!, state[5]!, state[6]!];
    const [p, r, s] = [state[14]!, state[15]!, state[16]!];
    out.set(state.subarray(11, 14));
    out.set([-a * p - b * r - c * s, w * p + b * s - c * r, w * r + c * p - a * s, w * s + a * r - b * p].map((k) => k / 2), 3); // prettier-ignore
    out.set(state.subarray(17, 21), 7);
    board.forward(state.subarray(0, 11), state.subarray(11));
    for (let i = 0; i < 10; i++) out[11 + i] = board.accelerationAt(i);
    return out;
  };
  const steps = 3000;
  const h = DURATION / steps;
  for (let k = 0; k < steps; k++) {
    const k1 = slope(x);
    const k2 = slope(x.map((y, i) => y + (h / 2) * k1[i]!));
    const k3 = slope(x.map((y, i) => y + (h / 2) * k2[i]!));
    const k4 = slope(x.map((y, i) => y + h * k3[i]!));
    x = x.map((y, i) => y + (h / 6) * (k1[i]! + 2 * k2[i]! + 2 * k3[i]! + k4[i]!));
    const size = Math.hypot(...x.subarray(3, 7));
    for (let i = 3; i < 7; i++) x[i]! /= size;
  }
  board.dispose();
  return {
    position: [...x.subarray(0, 3)],
    R: matrixOf([...x.subarray(3, 7)]),
    joints: JOINTS.map(([, theirs]) => x[theirs + 1]!),
  };
}

const scenarioFrom = ({ q, v }: Start, method: object) => ({
  version: 1,
  system: 'ripstik',
  constraints: 'none',
  initial: Object.fromEntries(names.flatMap((name, i) => [[name, q[i]!], [`${name}_dot`, v[i]!]])),
  method,
  duration: DURATION,
  outputStep: 0.01,
}); // prettier-ignore

describe.each(Object.entries(STARTS))(`a free board through pitch ±90°, ${'%s'} (seed ${SEED})`, (_, from) => {
  const truth = byMujoco(from);

  test.each(ADAPTIVE)('%s agrees with MuJoCo’s free joint', async (name) => {
    const { position, R, joints } = await truth;
    const { rows, end, columns } = runOf(scenarioFrom(from, { name, rtol: 1e-11, atol: 1e-12 }));
    expect(end.reason).toBe('end');
    const at = (column: string, row = rows - 1): number => columns.get(column)![row]!;
    ['X', 'Y', 'Z'].forEach((c, i) => expect(Math.abs(at(c) - position[i]!), c).toBeLessThan(1e-6));
    attitudeOf(at('theta'), at('psi'), at('alpha')).forEach((x, i) => expect(Math.abs(x - R[i]!)).toBeLessThan(1e-6));
    JOINTS.forEach(([ours], i) => expect(Math.abs(at(names[ours]!) - joints[i]!), names[ours]).toBeLessThan(1e-6));
  });

  test('rows go on without a jump in the attitude, and energy is kept', () => {
    const { rows, columns } = runOf(scenarioFrom(from, { rtol: 1e-11, atol: 1e-12 }));
    const energy = columns.get('energy')!;
    for (let row = 1; row < rows; row++) {
      expect(Math.abs(energy[row]! - energy[0]!)).toBeLessThan(1e-7);
      for (const name of ['theta', 'psi', 'alpha'])
        expect(Math.abs(columns.get(name)![row]! - columns.get(name)![row - 1]!), `${name}, row ${row}`).toBeLessThan(
          Math.PI,
        );
    }
  });
});

test.each(formulations.map(({ id }) => id))(
  '%s starts at exactly 90°, where yaw and roll turn about one axis',
  (formulation) => {
    const { end, columns, rows } = runOf({
      version: 1,
      system: 'ripstik',
      constraints: 'none',
      initial: { psi: '90 deg', alpha_dot: 1, theta_dot: 1 },
      method: { formulation },
      duration: 1,
    });
    expect(end.reason).toBe('end');
    // Equal rates of yaw and roll cancel there: it falls without turning.
    expect(Math.abs(columns.get('Z')![rows - 1]! + 9.81 / 2)).toBeLessThan(1e-9);
    const [theta, psi, alpha] = ['theta', 'psi', 'alpha'].map((name) => columns.get(name)![rows - 1]!);
    const level = attitudeOf(0, Math.PI / 2, 0);
    attitudeOf(theta!, psi!, alpha!).forEach((x, i) => expect(Math.abs(x - level[i]!)).toBeLessThan(1e-9));
  },
);

test.each(['dopri5', 'radau', 'ida'])(
  '%s: inputs, a controller and wheel drag act in a turned world as in the world’s own angles',
  (name) => {
    const raw = {
      version: 1,
      system: 'ripstik',
      constraints: 'none',
      parameters: { wheelDrag: 3, jointDamping: 0.2 },
      initial: { psi: '65 deg', psi_dot: 0.3, alpha: 0.2, alpha_dot: 0.5, theta: 0.4, theta_dot: -0.3, X_dot: 1 },
      inputs: { tau_fc: '0.05*sin(9*t)', f_X: 2, f_theta: '0.3*cos(5*t)', tau_twist: 0.1 },
      control: { type: 'track', reference: { tau_fp: '10 deg*sin(3*t)' }, kp: 2, kd: 0.3 },
      method: { name, rtol: 1e-10, atol: 1e-12 },
      duration: 0.4,
    };
    const { columns, rows, end, simulation } = runOf(raw);
    expect(end.reason).toBe('end');
    // The same without charts: short of the pole the world's own angles do.
    const scenario = scenarioOf(raw);
    const system = systems['ripstik']!;
    const { parameters } = simulation.dynamics;
    const dynamics = new ConstrainedSystem(system, parameters, 'none', [], actuationOf(scenario, system.meta).forcing);
    const { map, stepper } = motionOf({ ...scenario.method, name: 'dop853' }, dynamics);
    const first = (suffix: string): Float64Array => Float64Array.from(names, (c) => columns.get(c + suffix)![0]!);
    const [q, v] = [first(''), first('_dot')];
    const y = new Float64Array(stepper.y.length);
    map.rebase(q, v);
    map.fromState(q, v, y);
    stepper.reset(0, y);
    while (stepper.t < 0.4) expect(stepper.step(0.4)).toBeNull();
    map.toState(stepper.y, q, v);
    names.forEach((c, i) => {
      expect(Math.abs(columns.get(c)![rows - 1]! - q[i]!), c).toBeLessThan(1e-7);
      expect(Math.abs(columns.get(`${c}_dot`)![rows - 1]! - v[i]!), `${c}_dot`).toBeLessThan(1e-6);
    });
    // It was in a turned one: below 60° of pitch nothing of this is tried.
    expect(Math.abs(Math.cos(columns.get('psi')![0]!))).toBeLessThan(0.5);
  },
);

test('where the board is not free, pitch 90° is named, and not its masses', () => {
  const { end } = runOf({
    version: 1,
    system: 'ripstik',
    constraints: 'none',
    hold: ['Z'],
    initial: { psi: '90 deg', alpha_dot: 1 },
    duration: 0.1,
  });
  expect(end.reason).toBe('mass-matrix-singular');
  expect(end.message).toMatch(/psi is at 90°/);
});

const tumbling = { psi: 0.4, psi_dot: 5.5 };
const rolling = { psi_dot: 5.5, alpha_dot: 1 };
const TOO_NEAR = /^ran to t = 1 s; a step of [\d.]+ s passed too near to pitch 90° .*: take one of [\d.]+ s/;
test.each([
  [0.2, tumbling, TOO_NEAR],
  [0.001, tumbling, /^ran to t = 1 s$/],
  [0.005, rolling, /^ran to t = 1 s$/],
  [0.05, rolling, TOO_NEAR],
  // Past the pole in one step, to where nothing of it is seen.
  [0.25, rolling, TOO_NEAR],
  [0.5, rolling, TOO_NEAR],
  [0.1, rolling, /non-finite.*too near to pitch 90°/],
])('a fixed step of %d s past 90° says whether it was too long for it (%o)', (step, initial, message) => {
  const raw = { version: 1, system: 'ripstik', constraints: 'none', initial, duration: 1 };
  const { end } = runOf({ ...raw, method: { name: 'rk4', step } });
  expect(end.message).toMatch(message);
});
