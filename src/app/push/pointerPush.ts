/** The push by pointer: what can be pushed, how firmly, and with what force. A spring and damper draw a body's point to the pointer. */
import type { Push } from '../../core/simulation/push.ts';
import type { Motion } from '../runs/motion.ts';

type Triple = readonly [number, number, number];
type Rows = Pick<Motion, 'system' | 'parameters' | 'trajectory'>;

/** A mass on the push's spring would swing at this rate (rad/s), damped by this ratio. */
const RATE = 5;
const DAMPING = 0.35;
/** Rates are looked at over this much time, s. */
const STEP_S = 1e-5;

/** Only a run of a system with forces can be pushed. */
export const canPush = (motion: Motion | null): boolean => motion?.source === 'run' && motion.system.meta.order !== 1;

/** Spring (N/m) and damper (N s/m) that suit what is moved: by the sum of the masses among its parameters, kg. */
export function firmness({
  system: { meta },
  parameters,
}: Pick<Motion, 'system' | 'parameters'>): Pick<Push, 'stiffness' | 'damping'> {
  const masses = meta.parameters
    .filter(({ unit }) => unit === 'kg')
    .map(({ name, default: value }) => Math.abs(parameters[name] ?? value));
  const mass = masses.reduce((sum, m) => sum + m, 0) || 1;
  return { stiffness: rounded(mass * RATE * RATE), damping: rounded(2 * DAMPING * mass * RATE) };
}

/** Velocity (m/s) of a body's origin in a run at a time: along the coordinates' rates, by a central difference of the poses. */
export function bodyVelocity(motion: Rows, time: number, body: number): [number, number, number] {
  const row = motion.trajectory.locate(time);
  const [ahead, behind] = [STEP_S, -STEP_S].map((s) => posesNear(motion, row, s));
  const rate = (c: number): number => (ahead![12 * body + c]! - behind![12 * body + c]!) / (2 * STEP_S);
  return [rate(0), rate(1), rate(2)];
}

/** Poses, 12 numbers a body, so long (s) after a row as its rates would have them. */
export function posesNear({ system, parameters, trajectory }: Rows, row: number, after = 0): Float64Array {
  const { coordinates, parameters: known, bodies } = system.meta;
  const value = (name: string): number => trajectory.column(name)?.[row] ?? 0;
  const p = Float64Array.from(known, ({ name, default: rest }) => parameters[name] ?? rest);
  const poses = new Float64Array(12 * bodies.length);
  system.poses(
    Float64Array.from(coordinates, ({ name }) => value(name) + after * value(`${name}_dot`)),
    p,
    poses,
  );
  return poses;
}

/** World position (m) of a point of body `index` among poses of 12 numbers each. */
export function bodyPoint(poses: Float64Array, index: number, [x, y, z]: Triple): [number, number, number] {
  const o = 12 * index;
  const row = (i: number): number =>
    poses[o + i]! + poses[o + 3 + 3 * i]! * x + poses[o + 4 + 3 * i]! * y + poses[o + 5 + 3 * i]! * z;
  return [row(0), row(1), row(2)];
}

/** Of the spring alone, N. */
export const springForce = ({ stiffness, target }: Pick<Push, 'stiffness' | 'target'>, at: Triple): number =>
  stiffness * Math.hypot(target[0] - at[0], target[1] - at[1], target[2] - at[2]);

const rounded = (x: number): number => Number(x.toPrecision(3));
