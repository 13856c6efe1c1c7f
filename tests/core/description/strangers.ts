/** What strangers type (`strangers/`), each with an experiment and what is known of it from books. */
import { controlReport } from '../../../src/core/control/design/report.ts';
import { checkScenario } from '../../../src/core/scenario/schema.ts';
import { systemMetas } from '../../../src/core/systems/registry.ts';
import { run, type Finished, type Plan, type Walked } from './walk.ts';

interface Stranger {
  plan: Plan;
  /** Throws where the answer is another one. */
  known?(walked: Walked): void;
}

const g = 9.81;
const TIGHT = { method: { name: 'gauss', stages: 4, rtol: 1e-12, atol: 1e-14 } };

function near(what: string, found: number, right: number, tolerance: number): void {
  if (!(Math.abs(found - right) <= tolerance * Math.max(1, Math.abs(right))))
    throw new Error(`${what} is ${found}, not ${right}`);
}
const again = ({ system, scenario }: Walked, raw: object = {}): Finished =>
  run(system, checkScenario({ ...scenario, ...TIGHT, ...raw }, systemMetas));
const column = ({ columns, data }: Finished, name: string): Float64Array => data[columns.indexOf(name)]!;
/** Frequencies of a system at a rest, 1/s, ascending; each once. */
function frequencies({ system, scenario, report }: Walked, raw?: object): number[] {
  const { eigenvalues } = raw ? controlReport(checkScenario({ ...scenario, ...raw }, systemMetas), system) : report!;
  return eigenvalues
    .map(([, im]) => im)
    .filter((w) => w > 0)
    .sort((a, b) => a - b);
}
const growth = ({ report }: Walked): number => Math.max(...report!.eigenvalues.map(([re]) => re));

export const strangers: Readonly<Record<string, Stranger>> = {
  'double-pendulum-cart': {
    plan: {
      initial: { a: 0.3, b: -0.2 },
      at: {},
      lqr: { inputs: ['f_X'], Q: { x: 1, a: 10, b: 10 }, from: { a: 0.05, b: -0.02 }, holds: ['a', 'b'] },
    },
  },
  kapitza: {
    plan: { duration: 0.2 },
    known(walked) {
      // Shaken so, upright is a rest: slowly it swings with w² = A² w² / (2 l²) - g / l.
      const slow = Math.sqrt((0.003 * 1200) ** 2 / (2 * 0.3 ** 2) - g / 0.3);
      const period = (2 * Math.PI) / slow;
      const theta = column(again(walked, { duration: period, outputStep: period / 200 }), 'theta');
      const first = theta.findIndex((x) => x < 0) / 200;
      near('a quarter of the slow swing', first, 0.25, 0.01);
      // Below A w = √(2 g l) it falls.
      const falls = again(walked, { parameters: { w: 700 }, duration: 2, outputStep: 0.01 });
      if (!(Math.max(...column(falls, 'theta').map(Math.abs)) > 1))
        throw new Error('it does not fall below the threshold');
    },
  },
  furuta: {
    plan: {
      initial: { theta: 0.3, phi_dot: 1 },
      at: {},
      lqr: { inputs: ['tau_phi'], Q: { phi: 1, theta: 10 }, from: { theta: 0.1 }, holds: ['phi', 'theta'] },
    },
    known(walked) {
      const [J, r, m, l] = [0.01, 0.2, 0.1, 0.3];
      const square = (m * g * l * (J + m * r * r)) / ((J + m * r * r) * m * l * l - (m * r * l) ** 2);
      near('growth upright', growth(walked), Math.sqrt(square), 1e-10);
    },
  },
  trikke: {
    plan: {
      initial: { x_dot: 1, phi: 0.1, s_dot: 0.1 },
      at: { x_dot: 2 },
      loses: true,
      lqr: {
        inputs: ['tau_phi', 'f_s'],
        Q: { theta: 1, y: 1, s: 1, phi: 1 },
        from: { x_dot: 2, phi: 0.1 },
        holds: ['theta'],
      },
    },
  },
  snake: {
    plan: { duration: 2 },
    known(walked) {
      // Every skate rolls: the rates follow from the joints alone, here asked of the constraints at the end.
      const { end } = again(walked);
      const { theta, a1, x_dot: vx, y_dot: vy, theta_dot: w, a1_dot } = end as Record<string, number>;
      near('middle skate', -vx! * Math.sin(theta!) + vy! * Math.cos(theta!), 0, 1e-12);
      const along = vx! * Math.cos(theta!) + vy! * Math.sin(theta!);
      near('front skate', -along * Math.sin(a1!) + 0.2 * w! * Math.cos(a1!) + 0.2 * (w! + a1_dot!), 0, 1e-12);
    },
  },
  unicycle: {
    plan: {
      initial: { lean: 0.1, spin_dot: 4, yaw_dot: 0.3 },
      duration: 0.5,
      at: { speed: 1 },
      lqr: {
        inputs: ['tau_pedal', 'tau_yaw'],
        Q: { lean: 10, yaw: 1 },
        from: { speed: 1, lean: 0.05 },
        holds: ['lean', 'yaw'],
      },
    },
  },
  foucault: {
    plan: { duration: 20, at: { x: 0 } },
    known(walked) {
      // In axes that turn by -W sin(latitude) the plane stands still.
      const s = 0.01 * Math.sin((48.85 * Math.PI) / 180);
      const [w, t] = [Math.sqrt(g / 67 + s * s), 20];
      const { end } = again(walked);
      const [u, v] = [Math.cos(w * t), (s / w) * Math.sin(w * t)];
      near('x', end['x']!, u * Math.cos(s * t) + v * Math.sin(s * t), 1e-10);
      near('y', end['y']!, -u * Math.sin(s * t) + v * Math.cos(s * t), 1e-10);
    },
  },
  'spring-pendulum': {
    plan: { at: { r: 1 + g / 40, theta: 0 }, locus: null },
    known(walked) {
      const [pendulum, spring] = frequencies(walked);
      near('pendulum', pendulum!, Math.sqrt(g / (1 + g / 40)), 1e-10);
      near('spring', spring!, Math.sqrt(40), 1e-10);
    },
  },
  hoop: {
    plan: { duration: 1 },
    known(walked) {
      const theta = Math.acos(g / (0.2 * 12 ** 2));
      const { end } = again(walked, { initial: { theta }, duration: 3 });
      near('the bead stays', end['theta']!, theta, 1e-9);
    },
  },
  'bead-wire': {
    plan: { ends: 'there', at: { x: 0 } },
    known(walked) {
      near('frequency below', frequencies(walked)[0]!, Math.sqrt(2 * 2 * g), 1e-10);
    },
  },
  tautochrone: {
    plan: { at: { s: 0 } },
    known(walked) {
      const quarter = Math.PI * Math.sqrt(0.5 / g);
      for (const s of [0.5, 2, 3])
        near(`from ${s}`, again(walked, { initial: { s }, duration: quarter }).end['s']!, 0, 1e-9);
    },
  },
  trailers: {
    plan: {
      initial: { speed: 3, steer: 0.3 },
      duration: 5,
      at: { speed: 3 },
      lqr: { inputs: ['tau_steer'], Q: { y: 1, t3: 1, theta: 1 }, from: { speed: 3, steer: 0.02 }, holds: ['theta'] },
    },
    known(walked) {
      // In a steady circle each trailer runs d² further in.
      const { end } = again(walked, { duration: 60, hold: ['steer'] });
      const R = 2.5 / Math.tan(0.3);
      const speed = Math.hypot(end['x_dot']!, end['y_dot']!);
      near('circle of the car', speed / end['theta_dot']!, R, 1e-8);
      const behind = (heading: number, before: number): number => Math.cos(heading - before);
      near('first trailer', behind(end['t1']!, end['theta']!), Math.sqrt(R * R - 4) / R, 1e-6);
      near('second trailer', behind(end['t2']!, end['t1']!), Math.sqrt(R * R - 8) / Math.sqrt(R * R - 4), 1e-6);
    },
  },
  acrobot: {
    plan: {
      initial: { q1: 0.1 },
      at: {},
      lqr: { inputs: ['tau_q2'], from: { q1: 0.02, q2: -0.04 }, holds: ['q1', 'q2'] },
    },
    known(walked) {
      // Slopes of the potential and the mass matrix, upright.
      const [a, b, c] = [0.25 + 0.0833 + 1 + 0.25 + 1 + 0.0833, 0.25 + 0.0833 + 0.5, 0.25 + 0.0833];
      const [k1, k2] = [g * (0.5 + 1 + 0.5), g * 0.5];
      const [A, B, C] = [a * c - b * b, -(a * k2 + c * k1 - 2 * b * k2), k1 * k2 - k2 * k2];
      near('growth upright', growth(walked), Math.sqrt((-B + Math.sqrt(B * B - 4 * A * C)) / (2 * A)), 1e-9);
    },
  },
  'ball-turntable': {
    plan: { initial: { yaw: 0.1 }, duration: 1 },
    known(walked) {
      // Its centre goes in a circle, 2/7 as fast as the table turns.
      const { end } = again(walked, { initial: { x_dot: 0.1, y_dot: 0.9 }, duration: 1.5 });
      const k = (2 / 7) * 3;
      const c = [0.3 - 0.9 / k, 0.1 / k];
      const [sin, cos] = [Math.sin(k * 1.5), Math.cos(k * 1.5)];
      near('x', end['x']!, c[0]! + (0.3 - c[0]!) * cos - (0 - c[1]!) * sin, 1e-9);
      near('y', end['y']!, c[1]! + (0.3 - c[0]!) * sin + (0 - c[1]!) * cos, 1e-9);
    },
  },
  'chaplygin-ball': { plan: { initial: { yaw_dot: 2, pitch_dot: 1, roll_dot: 3 }, duration: 0.3, at: {} } },
  top: {
    plan: { initial: { phi_dot: 200, psi_dot: 5 }, duration: 0.3 },
    known(walked) {
      // I1 cos θ Ω² - I3 s Ω + m g l = 0 with the spin s = ψ' cos θ + φ' about the axis.
      const [I1, I3, m, l, c, s] = [0.0008, 0.0004, 0.5, 0.05, Math.cos(Math.PI / 6), 200];
      const rate = (I3 * s - Math.sqrt((I3 * s) ** 2 - 4 * I1 * c * m * g * l)) / (2 * I1 * c);
      const { end } = again(walked, { initial: { psi_dot: rate, phi_dot: s - rate * c }, duration: 1 });
      near('nutation', end['theta']!, Math.PI / 6, 1e-9);
      near('precession', end['psi']!, rate, 1e-9);
    },
  },
  wilberforce: {
    plan: { duration: 3, at: { z: 0 } },
    known(walked) {
      const [a, b, e] = [2.8 / 0.5, 8e-4 / 1.45e-4, 0.0093 / 2];
      const root = Math.sqrt((a - b) ** 2 / 4 + (e * e) / (0.5 * 1.45e-4));
      const [slow, fast] = frequencies(walked);
      near('slow', slow!, Math.sqrt((a + b) / 2 - root), 1e-10);
      near('fast', fast!, Math.sqrt((a + b) / 2 + root), 1e-10);
    },
  },
  governor: {
    plan: { initial: { phi_dot: 9 }, loses: true, at: { phi_dot: 9, beta: 'acos(9.81/(81*0.2))' } },
  },
  fourbar: {
    plan: { initial: { a_dot: 4 }, duration: 1 },
    known(walked) {
      // Freudenstein's equation.
      const { end } = again(walked);
      const [l1, l2, l3, d] = [0.2, 0.5, 0.4, 0.5];
      const left =
        l1 ** 2 + l3 ** 2 + d ** 2 - l2 ** 2 + 2 * l3 * d * Math.cos(end['c']!) - 2 * l1 * d * Math.cos(end['a']!);
      near('Freudenstein', left, 2 * l1 * l3 * Math.cos(end['a']! - end['c']!), 1e-12);
    },
  },
  rattleback: { plan: { initial: { yaw_dot: -5, roll: 0.01, pitch: 0.02 }, duration: 1, at: {} } },
  slider: {
    plan: {
      loses: true,
      ends: 'back',
      at: { x: 0 },
      lqr: { inputs: ['f'], from: { x: -0.1 }, holds: ['x'] },
    },
    known(walked) {
      const [s, w] = [0.6, Math.sqrt(25 - 0.36)];
      near('it is back at', again(walked).end['t']!, (Math.PI / 2 + Math.atan(s / w)) / w, 1e-9);
    },
  },
  rc: {
    plan: { duration: 0.5, at: { u1: 5, u2: 5 }, locus: 'R' },
    known({ report }: Walked) {
      const rates = report!.eigenvalues.map(([re]) => re).sort((x, y) => x - y);
      near('fast', rates[0]!, (-3 - Math.sqrt(5)) / 2 / 0.1, 1e-10);
      near('slow', rates[1]!, (-3 + Math.sqrt(5)) / 2 / 0.1, 1e-10);
    },
  },
  lorenz: {
    plan: { duration: 2, at: { x: 'sqrt(72)', y: 'sqrt(72)', z: 27 } },
    known({ report }: Walked) {
      // λ³ + (σ + β + 1) λ² + β (σ + ρ) λ + 2 σ β (ρ - 1) = 0
      const [b, c, d] = [10 + 8 / 3 + 1, (8 / 3) * 38, 2 * 10 * (8 / 3) * 27];
      for (const [x, y] of report!.eigenvalues) {
        const re = x ** 3 - 3 * x * y * y + b * (x * x - y * y) + c * x + d;
        const im = 3 * x * x * y - y ** 3 + 2 * b * x * y + c * y;
        near('characteristic polynomial', Math.hypot(re, im), 0, 1e-9);
      }
    },
  },
  'predator-prey': {
    plan: { duration: 10, at: { hares: 4, lynxes: 2.75 }, locus: null },
    known(walked) {
      const V = (h: number, l: number): number => 0.1 * h - 0.4 * Math.log(h) + 0.4 * l - 1.1 * Math.log(l);
      const { end } = again(walked, { duration: 30 });
      near('what stays the same', V(end['hares']!, end['lynxes']!), V(10, 5), 1e-10);
      near('frequency', frequencies(walked, { at: { hares: 4, lynxes: 2.75 } })[0]!, Math.sqrt(1.1 * 0.4), 1e-12);
    },
  },
  atwood: {
    plan: {},
    known(walked) {
      const { end } = again(walked);
      near('fall', end['z1']!, 0.5 * (g / 5), 1e-12);
      near('rope', Math.abs(end['lambda_1']!), (2 * 2 * 3 * g) / 5, 1e-12);
    },
  },
  segway: {
    plan: {
      initial: { pitch: 0.2, yaw_dot: 1 },
      duration: 0.3,
      at: { speed: 1 },
      lqr: {
        inputs: ['tau_left', 'tau_right'],
        Q: { pitch: 10, yaw: 1, left: 1 },
        from: { speed: 1, pitch: 0.1 },
        holds: ['pitch', 'yaw'],
      },
    },
  },
  motor: { plan: { loses: true, duration: 0.5 } },
  roller: {
    plan: {},
    known(walked) {
      // The rope pulls at twice the radius: (m + I/r²) a = m g sin(slope) - 2 F.
      const { end } = again(walked);
      const a = (2 * g * Math.sin((20 * Math.PI) / 180) - 1) / 3;
      near('s', end['s']!, a / 2, 1e-10);
    },
  },
  masses30: {
    plan: { initial: { x30: 0.05 }, at: {} },
    known(walked) {
      const found = frequencies(walked);
      for (let j = 1; j <= 30; j++)
        near(`mode ${j}`, found[j - 1]!, 2 * Math.sqrt(1000) * Math.sin(((2 * j - 1) * Math.PI) / (2 * 61)), 1e-9);
    },
  },
  chain30: { plan: { initial: { a1: 0.5, a15: -0.3 }, duration: 0.5, at: {} } },
};
