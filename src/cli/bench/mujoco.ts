import loadMujoco, { type MjData, type MjModel } from 'mujoco-js';

/**
 * The board in MuJoCo's own WebAssembly build (Todorov, Erez, Tassa, "MuJoCo: a physics engine for model-based
 * control", IROS 2012): the same five bodies with explicit inertias, no geoms, contacts and constraints disabled; two more,
 * the rider and what is above the hips, where `p` has one. The rider's hinge is on the rod there, and turns by `beta - alpha`:
 * the same axis; then comes a slide down along the body, and on it the hips, a body of mass and three moments of inertia, which
 * the rest of the rider gives.
 */

/** How the rod's six degrees of freedom are given to MuJoCo: `hinges` has our own coordinates, `free` a quaternion. */
export type RootJoint = 'hinges' | 'free';

/** Place of our coordinates among MuJoCo's with hinges: X Y Z theta psi alpha, front plate and caster, back ones. */
const PLACE = [0, 1, 2, 5, 4, 3, 6, 8, 7, 9] as const;
const n = PLACE.length;
/** Places of the rod's roll and of the rider's hinge in both orders; slide and hips follow it. */
const [ALPHA, RIDER] = [3, n] as const;
/** Of the mass, and of the hips' own inertia about the vertical, about the others: any will do. */
const ABOVE = { mass: 0.4, across: 0.8 };

/** The board as MJCF, with its rider where `p` has one; `p` by name as in the system's meta. Without springs, damping and drag. */
export function boardXml(
  p: Readonly<Record<string, number>>,
  root: RootJoint,
  moving: readonly ('crouch' | 'twist')[] = ['crouch', 'twist'],
): string {
  const { rodMass, rodLength, rodRadius, plateMass, plateLength, plateWidth, plateThickness, plateOffset } =
    p as Record<string, number>;
  const { pivotDrop, casterAngle, casterTrail, casterDrop, casterMass, wheelRadius, gravity } = p as Record<
    string,
    number
  >;
  const inertial = (mass: number, pos: readonly number[], diagonal: readonly number[]): string =>
    `<inertial mass="${mass}" pos="${pos.join(' ')}" diaginertia="${diagonal.join(' ')}"/>`;
  const side = (rodMass! * (3 * rodRadius! ** 2 + rodLength! ** 2)) / 12;
  const rod = inertial(rodMass!, [0, 0, 0], [(rodMass! * rodRadius! ** 2) / 2, side, side]);
  const squares = [
    plateWidth! ** 2 + plateThickness! ** 2,
    plateLength! ** 2 + plateThickness! ** 2,
    plateLength! ** 2 + plateWidth! ** 2,
  ];
  const plate = inertial(
    plateMass!,
    [0, 0, 0],
    squares.map((s) => (plateMass! * s) / 12),
  );
  const disc = casterMass! * wheelRadius! ** 2;
  const caster = inertial(casterMass!, [-casterTrail!, 0, -casterDrop!], [disc / 4, disc / 2, disc / 4]);
  const half = (name: string, sign: number): string => `
      <body name="${name}-plate" pos="${sign * plateOffset!} 0 0"><joint type="hinge" axis="1 0 0"/>${plate}
        <body name="${name}-caster" pos="0 0 ${-pivotDrop!}" quat="${Math.cos(casterAngle! / 2)} 0 ${Math.sin(casterAngle! / 2)} 0">
          <joint type="hinge" axis="0 0 1"/>${caster}
        </body>
      </body>`;
  const rider = p.riderMass === undefined ? '' : riderXml(p as Record<string, number>, inertial, moving);
  const axes = ['1 0 0', '0 1 0', '0 0 1'];
  const hinges = [
    ...axes.map((axis) => `<joint type="slide" axis="${axis}"/>`),
    ...axes.reverse().map((axis) => `<joint type="hinge" axis="${axis}"/>`),
  ];
  return `<mujoco>
  <compiler angle="radian"/>
  <option gravity="0 0 ${-gravity!}"><flag contact="disable" constraint="disable"/></option>
  <worldbody>
    <body name="rod">${root === 'free' ? '<freejoint/>' : hinges.join('')}${rod}${half('front', 1)}${half('back', -1)}${rider}
    </body>
  </worldbody>
</mujoco>`;
}

type Inertial = (mass: number, pos: readonly number[], diagonal: readonly number[]) => string;

function riderXml(p: Readonly<Record<string, number>>, inertial: Inertial, moving: readonly string[]): string {
  const across = ABOVE.across * p.hipIzz!;
  const pos = [0, 0, p.riderHeight!];
  const lower = [p.riderIxx! - across, p.riderIyy! - across, p.riderIzz! - p.hipIzz!];
  const slide = moving.includes('crouch') ? '<joint type="slide" axis="0 0 -1"/>' : '';
  const turn = moving.includes('twist') ? '<joint type="hinge" axis="0 0 1"/>' : '';
  return `<body name="rider"><joint type="hinge" axis="1 0 0"/>${slide}${inertial((1 - ABOVE.mass) * p.riderMass!, pos, lower)}
      <body name="torso">${turn}${inertial(ABOVE.mass * p.riderMass!, pos, [across, across, p.hipIzz!])}</body></body>`;
}

/** The board loaded, with views of its arrays; its states go in and out in our order of coordinates. */
export class MujocoBoard {
  readonly version: string;
  private readonly mujoco: Awaited<ReturnType<typeof loadMujoco>>;
  private readonly model: MjModel;
  private readonly data: MjData;
  private readonly qpos: Float64Array;
  private readonly qvel: Float64Array;
  private readonly qacc: Float64Array;
  private readonly applied: Float64Array;
  /** Degrees of freedom: 10, or 11 to 13 with a rider. */
  private readonly count: number;

  private readonly moving: readonly string[];

  private constructor(mujoco: Awaited<ReturnType<typeof loadMujoco>>, xml: string, moving: readonly string[]) {
    this.mujoco = mujoco;
    this.moving = moving;
    this.version = mujoco.mj_versionString() as string;
    const files = (mujoco as unknown as { FS: { writeFile(name: string, text: string): void } }).FS;
    files.writeFile('/board.xml', xml);
    this.model = mujoco.MjModel.loadFromXML('/board.xml');
    this.data = new mujoco.MjData(this.model);
    this.qpos = this.data.qpos as Float64Array;
    this.qvel = this.data.qvel as Float64Array;
    this.qacc = this.data.qacc as Float64Array;
    this.applied = this.data.qfrc_applied as Float64Array;
    this.count = this.qvel.length;
  }

  /** @param moving which of the rider's own joints there are */
  static async load(
    p: Readonly<Record<string, number>>,
    root: RootJoint,
    moving: readonly ('crouch' | 'twist')[] = ['crouch', 'twist'],
  ): Promise<MujocoBoard> {
    return new MujocoBoard(await loadMujoco(), boardXml(p, root, moving), moving);
  }

  /** Our q as MuJoCo's positions: as many with hinges, one more with a free joint. */
  positionsOf(q: Float64Array): Float64Array {
    const own = this.placed(q);
    return this.qpos.length === this.count
      ? own
      : Float64Array.of(...own.subarray(0, 3), ...attitude(q[3]!, q[4]!, q[5]!), ...own.subarray(6));
  }

  /** Our v as MuJoCo's velocities; with a free joint the rod's angular velocity in its own axes. */
  velocitiesOf(q: Float64Array, v: Float64Array): Float64Array {
    const own = this.placed(v);
    if (this.qpos.length > this.count) own.set(bodyRates(q, v), 3);
    return own;
  }

  /** Our place of one of MuJoCo's joints beyond the rider's hinge: both there are, or one of them. */
  private ours(i: number): number {
    return this.moving.length === 2 ? i : this.moving[0] === 'twist' ? RIDER + 2 : RIDER + 1;
  }

  private placed(x: Float64Array): Float64Array {
    const own = new Float64Array(this.count);
    for (let i = 0; i < n; i++) own[PLACE[i]!] = x[i]!;
    if (this.count > n) own[RIDER] = x[RIDER]! - x[ALPHA]!;
    for (let i = RIDER + 1; i < this.count; i++) own[i] = x[this.ours(i)]!;
    return own;
  }

  /** With hinges: generalized forces on our coordinates, for the next `forward`. */
  apply(force: Float64Array): void {
    for (let i = 0; i < n; i++) this.applied[PLACE[i]!] = force[i]!;
    if (this.count === n) return;
    // beta = alpha + the hinge's angle: what acts on beta acts on both.
    this.applied[RIDER] = force[RIDER]!;
    this.applied[PLACE[ALPHA]]! += force[RIDER]!;
    for (let i = RIDER + 1; i < this.count; i++) this.applied[i] = force[this.ours(i)]!;
  }

  /** `mj_forward` at MuJoCo's own positions and velocities. */
  forward(positions: Float64Array, velocities: Float64Array): void {
    this.qpos.set(positions);
    this.qvel.set(velocities);
    this.mujoco.mj_forward(this.model, this.data);
  }

  /** Entry i of MuJoCo's acceleration of the last `forward`. */
  accelerationAt(i: number): number {
    return this.qacc[i]!;
  }

  /** With hinges: the acceleration of the last `forward` in our order, into `a`. */
  acceleration(a: Float64Array): void {
    for (let i = 0; i < n; i++) a[i] = this.qacc[PLACE[i]!]!;
    if (this.count > n) a[RIDER] = this.qacc[RIDER]! + a[ALPHA]!;
    for (let i = RIDER + 1; i < this.count; i++) a[this.ours(i)] = this.qacc[i]!;
  }

  /** What one call into the module costs without any work: to know how much of a time is the border. */
  callNothing(): number {
    return this.mujoco.mj_version();
  }

  dispose(): void {
    this.data.delete();
    this.model.delete();
  }
}

/** Unit quaternion (w, x, y, z) of Rz(yaw) Ry(pitch) Rx(roll). */
function attitude(roll: number, pitch: number, yaw: number): number[] {
  const [cr, sr, cp, sp, cy, sy] = [roll, pitch, yaw].flatMap((x) => [Math.cos(x / 2), Math.sin(x / 2)]) as [
    number,
    number,
    number,
    number,
    number,
    number,
  ];
  return [
    cy * cp * cr + sy * sp * sr,
    cy * cp * sr - sy * sp * cr,
    cy * sp * cr + sy * cp * sr,
    sy * cp * cr - cy * sp * sr,
  ];
}

/** Angular velocity in the rod's axes, from the rates of roll, pitch and yaw. */
function bodyRates(q: Float64Array, v: Float64Array): number[] {
  const [roll, pitch] = [q[3]!, q[4]!];
  const [p, r, y] = [v[3]!, v[4]!, v[5]!];
  return [
    p - y * Math.sin(pitch),
    r * Math.cos(roll) + y * Math.cos(pitch) * Math.sin(roll),
    -r * Math.sin(roll) + y * Math.cos(pitch) * Math.cos(roll),
  ];
}
