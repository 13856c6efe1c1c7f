// What MuJoCo makes of the exported file moves as the program's own equations say: two engines, one motion.
import loadMujoco, { type MjData } from 'mujoco-js';
import { describe, expect, test } from 'vitest';
import { exportScenario } from '../../../src/core/exchange/index.ts';
import { ConstrainedSystem } from '../../../src/core/mechanics/constrainedSystem.ts';
import { seeded } from '../../helpers.ts';
import { exported, read, typed } from './exports.ts';

const SEED = 1128;
const STATES = 10;
const AGREES = 1e-10;

const mujoco = await loadMujoco();
const files = (mujoco as unknown as { FS: { writeFile(name: string, text: string): void } }).FS;

/** Largest difference of accelerations at random states with random inputs, relative to the largest acceleration. */
async function apart(raw: object): Promise<number> {
  const { scenario, system } = await read(raw);
  const { text } = await exportScenario(scenario, system, 'mjcf');
  files.writeFile('/exported.xml', text);
  const model = mujoco.MjModel.loadFromXML('/exported.xml');
  const data: MjData = new mujoco.MjData(model);
  const [qpos, qvel, qacc, ctrl] = ['qpos', 'qvel', 'qacc', 'ctrl'].map(
    (name) => (data as unknown as Record<string, Float64Array>)[name]!,
  ) as [Float64Array, Float64Array, Float64Array, Float64Array];
  const { coordinates, parameters, inputs } = system.meta;
  const n = coordinates.length;
  const place = (name: string): number => coordinates.findIndex((c) => c.name === name);
  const joints = [...text.matchAll(/<joint name="(\w+)"/g)].map(([, name]) => place(name!));
  const motors = [...text.matchAll(/<motor name="(\w+)"/g)].map(([, name]) => inputs.find((i) => i.name === name)!);
  const held = scenario.hold.map(place);
  expect(joints.length + held.length).toBe(n);
  const u = new Float64Array(motors.length);
  const p = Float64Array.from(parameters, ({ name }) => scenario.parameters[name]!);
  const dynamics = new ConstrainedSystem(system, p, 'none', held, (_t, _q, _v, force) =>
    motors.forEach(({ column }, k) => {
      for (const [name, weight] of Object.entries(column)) force[place(name)]! += weight * u[k]!;
    }),
  );
  const random = seeded(SEED);
  const draw = (): number => 2 * random() - 1;
  let worst = 0;
  for (let state = 0; state < STATES; state++) {
    const q = Float64Array.from(coordinates, (_, i) => (held.includes(i) ? 0 : draw()));
    for (const i of held) q[i] = scenario.initial[coordinates[i]!.name] ?? coordinates[i]!.rest ?? 0;
    const v = Float64Array.from(coordinates, (_, i) => (held.includes(i) ? 0 : 3 * draw()));
    u.forEach((_, k) => (u[k] = 5 * draw()));
    const a = new Float64Array(n);
    expect(dynamics.acceleration(0, q, v, a, new Float64Array(0)), `seed ${SEED}`).toBe(true);
    joints.forEach((i, k) => {
      qpos[k] = q[i]!;
      qvel[k] = v[i]!;
    });
    ctrl?.set(u);
    mujoco.mj_forward(model, data);
    const size = Math.max(1, ...a.map(Math.abs));
    joints.forEach((i, k) => (worst = Math.max(worst, Math.abs(qacc[k]! - a[i]!) / size)));
  }
  data.delete();
  model.delete();
  return worst;
}

const springy = { torsionStiffness: 7, torsionDamping: 0.3, jointDamping: 0.2, casterDamping: 0.01 };

test.each([
  ['the board', { system: 'ripstik' }],
  ['the authors’ board with springs and dampers', { system: 'ripstik', parameterSet: 'authors', parameters: springy }],
  [
    'the board held by its rod',
    { system: 'ripstik', hold: ['X', 'Y', 'Z', 'alpha', 'psi', 'theta'], constraints: 'none', initial: { psi: 0.2 } },
  ],
  ['the rider', { system: 'ripstik-rider' }],
  ['the bicycle', { system: 'bicycle' }],
  ['a caster', { system: 'caster-rotation' }],
  ['the cart and its pendulum', { system: 'cart-pendulum' }],
  ['a rolling wheel', { system: 'rolling-wheel' }],
  ['the wheel and its pendulum', { system: 'wheel-pendulum' }],
  ['the sleigh', { system: 'chaplygin-sleigh' }],
])('MuJoCo gives the same accelerations: %s', async (_, raw) => {
  expect(await apart(raw)).toBeLessThan(AGREES);
});

test.each(['twistcar', 'ripstik', 'ripstik-rider', 'bicycle'])(
  'MuJoCo gives the same accelerations of a typed system: %s',
  async (id) => {
    expect(await apart(await typed(id))).toBeLessThan(AGREES);
  },
);

const own = (description: string): object => ({ system: { description } });

test('springs between coordinates, with a length at rest, become tendons and joints', async () => {
  const raw = own(`coordinate a, b, c [rad]
frame one = world turned z a
frame two = one turned x b
frame three = one turned y c
body first mass 1 inertia (1, 2, 2.5) at one(1, 0, 0) in one
body second mass 2 inertia (1, 2, 2.5, 0.1, 0.2, 0.3) at one(1, 0, 0) + two(0, 1, 1) in two
body third mass 0.5 at one(1, 1, 0) + three(0, 0, 1) in three
parameter gravity [m/s²] = 9.81
spring 3 on a free -0.4
spring 2 on a - b + 2 c free -0.3
spring 5 on b + c free 0.7
damper 0.7 on a - 2 b
damper 0.1 on c
input push on a - 3 c`);
  expect(await apart(raw)).toBeLessThan(AGREES);
});

test('where branches part between bodies there is a body without mass', async () => {
  const raw = own(`coordinate x, y [m]
coordinate yaw, a, b [rad]
parameter gravity [m/s²] = 9.81
frame turning = world turned z yaw
frame left = turning turned x a
frame right = turning turned x b
body l mass 1 inertia (1, 1, 1) at (x, y, 0) + left(0, 0.3, 0.2) in left
body r mass 2 inertia (1, 1, 1) at (x, y, 0) + right(0, -0.3, 0.4) in right`);
  expect((await exported(raw, 'mjcf')).text).toContain('<body name="fork-x-y-yaw"');
  expect(await apart(raw)).toBeLessThan(AGREES);
});

describe('what cannot be said is refused, with what it is', () => {
  test.each([
    ['stiff-decay', { system: 'stiff-decay' }, /equations of first order alone/],
    [
      'an energy',
      own(`coordinate theta [rad]\nkinetic 1/2 (1 + cos(theta)^2) theta'^2`),
      /kinetic energy .* more than that of bodies/,
    ],
    [
      'weight as an energy',
      own(`coordinate theta [rad]\nkinetic 1/2 theta'^2\npotential -cos(theta)`),
      /potential energy/,
    ],
    [
      'a gear',
      own(`coordinate a [rad]\nframe g = world turned z 2 a\nbody b mass 1 inertia (1, 1, 1) at g(1, 0, 0) in g`),
      /a moves b by 2\.000/,
    ],
    [
      'a screw',
      own(`coordinate a [rad]\nframe g = world turned z a\nbody b mass 1 inertia (1, 1, 1) at (0, 0, a) in g`),
      /a is a screw/,
    ],
    [
      'two branches',
      own(`coordinate a [m]\nbody b mass 1 at (a, 0, 0)\nbody c mass 1 at (0, a, 0)`),
      /a moves b and c differently/,
    ],
    ['a drive', own(`coordinate x, y [m]\nbody b mass 1 at (x, y, 0)\ndrive y = sin(t)`), /take drives and t out/],
    [
      'an inertia that no body has',
      own(`coordinate a, b [rad]\nframe g = world turned z a, x b\nbody b1 mass 1 inertia (9, 1, 1) at (0, 0, 0) in g`),
      /MuJoCo refuses the inertia of b1/,
    ],
    ['a wheel that stands on its rim', typed('torus-disc'), /moved by more than its joints/],
    ['angles that are not those of joints', typed('double-pendulum-cart'), /theta1 moves .* differently; an angle is/],
  ])('%s', async (_, raw, why) => {
    await expect(exported(await Promise.resolve(raw), 'mjcf')).rejects.toThrow(why);
  });
});

test('what is left out is told: the skates, and the drag of the wheels', async () => {
  const { notes, text } = await exported({ system: 'ripstik', parameters: { wheelDrag: 0.5 } }, 'mjcf');
  expect(notes.join('\n')).toMatch(/cannot be expressed in MJCF: the constraints "rolling" \(front lateral/);
  expect(notes.join('\n')).toMatch(/losses that are not linear dampers/);
  expect(text.replaceAll(/ -->\n {2}<!-- /g, ' ')).toContain(notes[0]);
  expect((await exported({ system: 'ripstik', constraints: 'none' }, 'mjcf')).notes).toEqual([]);
});
