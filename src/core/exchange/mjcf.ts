/**
 * MJCF, the format of MuJoCo (E. Todorov, T. Erez, Y. Tassa, IROS 2012): bodies, joints, inertias, springs, dampers and motors.
 * The joints are the description's own coordinates, so that positions and velocities are the same numbers in another order.
 * Velocities that vanish without the place being bound, as a skate's, cannot be said there; nor can what only an energy says.
 */
import type { BodyModel, Model } from '../description/model.ts';
import { ScenarioError } from '../scenario/types.ts';
import { dynamicsOf, type FreeDynamics } from './freeDynamics.ts';
import { jointTreeOf, kinematicsOf, type JointNode, type JointTree, type Kinematics } from './jointTree.ts';
import { shapesOf } from './mjcfShapes.ts';
import type { Source } from './source.ts';
import { wrapped } from './wrapped.ts';
import {
  add,
  applyInverse,
  between,
  cross,
  dot,
  norm,
  principalAxes,
  quaternionOf,
  type Pose,
  type V3,
} from './spatial.ts';

/** MuJoCo refuses bodies that move and weigh less than 1e-15; this is as good as nothing beside anything that is built. */
const NOTHING = 1e-14;
const LIGHT: V3 = [NOTHING, NOTHING, NOTHING];
/** An inertia that no body has: the largest moment may be the sum of the others, and by rounding more. */
const ROUNDING = 1e-12;

/**
 * @param source what is exported
 * @throws ScenarioError where the system is no tree of hinges and slides, or more than its bodies
 */
export function mjcfOf(source: Source): { text: string; notes: string[] } {
  const { model, id, held, p } = source;
  if (!model.mechanical)
    throw new ScenarioError('system', 'MJCF knows bodies, and this system has equations of first order alone');
  if (model.clock !== null)
    throw new ScenarioError('system', 'MJCF knows no time in a system: take drives and t out of the description');
  const states = statesOf(source);
  const { kinematics, tree } = hang(model, p, states, held);
  const dynamics = dynamicsOf(source, kinematics, states);
  const joints: number[] = [];
  const writer = new Writer(source, kinematics, tree, dynamics, joints);
  const world = writer.world();
  const notes = [...notesOf(source), ...dynamics.notes];
  const names = joints.map((i) => model.coordinates[i]!.name);
  const comment = [
    `${model.title}, from RipStik Lab.`,
    ...notes,
    `qpos and qvel are the coordinates ${names.join(' ')}, in this order.`,
  ];
  const text = [
    `<mujoco model="${id}">`,
    ...comment.flatMap((line) =>
      wrapped(line, 110).map((part) => `  <!-- ${part.replaceAll('--', '- -').replace(/-$/, '- ')} -->`),
    ),
    '  <compiler angle="radian"/>',
    `  <option timestep="0.001" integrator="RK4" gravity="0 0 ${number(-dynamics.gravity)}"/>`,
    '  <default>',
    '    <geom contype="0" conaffinity="0"/>',
    '  </default>',
    '  <worldbody>',
    ...world,
    '  </worldbody>',
    ...writer.tendons(),
    ...writer.actuators(),
    '  <keyframe>',
    `    <key name="start" qpos="${joints.map((i) => number(source.q[i]!)).join(' ')}" qvel="${joints.map((i) => number(source.v[i]!)).join(' ')}"/>`,
    '  </keyframe>',
    '</mujoco>',
    '',
  ].join('\n');
  return { text, notes };
}

const number = (x: number): string => String(Math.abs(x) < 1e-15 ? 0 : x);
const numbers = (values: ArrayLike<number>): string => Array.from(values, number).join(' ');

/** q = 0, and two states without symmetry within reach of a person's coordinates; what is held is where the scenario has it. */
function statesOf({ q, held }: Source): [Float64Array, Float64Array, Float64Array] {
  const state = (of: (i: number) => number): Float64Array => q.map((x, i) => (held.includes(i) ? x : of(i)));
  return [
    state(() => 0),
    state((i) => 0.7 * Math.sin(1.3 * i + 0.9) + 0.05),
    state((i) => 0.8 * Math.cos(2.1 * i - 0.4) - 0.07),
  ];
}

/** All bodies that are more than a point to follow; where those without mass are in no tree, the others alone. */
function hang(
  model: Model,
  p: Float64Array,
  states: [Float64Array, Float64Array, Float64Array],
  held: readonly number[],
): { kinematics: Kinematics; tree: JointTree } {
  const heavy = model.bodies.filter(({ mass, inertia }) => mass !== null || inertia !== null);
  const points = new Set(model.tracks.map(({ body }) => model.bodies[body]!));
  const all = model.bodies.filter((body) => heavy.includes(body) || !points.has(body));
  const attempt = (bodies: readonly BodyModel[]): { kinematics: Kinematics; tree: JointTree } => {
    const kinematics = kinematicsOf(model, bodies, p);
    return { kinematics, tree: jointTreeOf(model, kinematics, states, held) };
  };
  try {
    return attempt(all);
  } catch (error) {
    if (!(error instanceof ScenarioError) || heavy.length === all.length) throw error;
    return attempt(heavy);
  }
}

function notesOf({ model, set, held }: Source): string[] {
  const notes: string[] = [];
  if (set) {
    const rows = set.rows.map(({ label, line }) => label || `the row of line ${line}`);
    notes.push(
      `Skates and wheels that roll without slip cannot be expressed in MJCF: the constraints "${set.id}" (${rows.join(', ')}) are left out, and what moves here moves freely.`,
    );
  }
  if (held.length > 0)
    notes.push(
      `Held where the scenario has them, so without a joint: ${held.map((i) => model.coordinates[i]!.name).join(', ')}.`,
    );
  return notes;
}

const none = (): string[] => [];

class Writer {
  private readonly tendonLines: string[] = [];
  private readonly tendonNames = new Set<string>();

  constructor(
    private readonly source: Source,
    private readonly kinematics: Kinematics,
    private readonly tree: JointTree,
    private readonly dynamics: FreeDynamics,
    /** Coordinates in the order of MuJoCo's positions; filled as the bodies are written. */
    private readonly joints: number[],
  ) {}

  world(): string[] {
    const { root, loose } = this.tree;
    const origin: Pose = { p: [0, 0, 0], R: [1, 0, 0, 0, 1, 0, 0, 0, 1] };
    return [
      ...root.bodies.flatMap((b) => this.body(b, [], origin, none, '    ')),
      ...root.children.flatMap((child) => this.branch(child, origin, '    ')),
      ...loose.flatMap((i) => {
        this.joints.push(i);
        return [
          `    <body name="${this.name(i)}">`,
          `      ${inertial(NOTHING, LIGHT)}`,
          `      ${this.joint(i, 'slide', [1, 0, 0], [0, 0, 0])}`,
          '    </body>',
        ];
      }),
    ];
  }

  /** Joints up to the next body or fork, with what hangs beyond. */
  private branch(first: JointNode, parent: Pose, indent: string): string[] {
    const chain = [first];
    let node = first;
    while (node.bodies.length === 0 && node.children.length === 1) {
      node = node.children[0]!;
      chain.push(node);
    }
    const [carrier, ...others] = node.bodies;
    const beyond = (pose: Pose): string[] => [
      ...others.flatMap((b) => this.body(b, [], pose, none, `${indent}  `)),
      ...node.children.flatMap((child) => this.branch(child, pose, `${indent}  `)),
    ];
    if (carrier !== undefined) return this.body(carrier, chain, parent, beyond, indent);
    const pose = {
      ...parent,
      p: node.twist.omega.some((x) => x !== 0) ? cross(node.twist.omega, node.twist.v) : parent.p,
    };
    const name = `fork-${chain.map((joint) => this.name(joint.coordinate)).join('-')}`;
    const joints = chain.map((joint) => this.jointAt(joint, pose));
    const light = inertial(NOTHING, LIGHT);
    return this.element(name, pose, parent, [...joints, light], indent, beyond(pose));
  }

  private body(
    b: number,
    chain: readonly JointNode[],
    parent: Pose,
    beyond: (pose: Pose) => string[],
    indent: string,
  ): string[] {
    const body = this.kinematics.bodies[b]!;
    const pose = this.tree.rest[b]!;
    // Joints are written before what hangs beyond them: that is MuJoCo's order of positions.
    const lines = [
      ...chain.map((node) => this.jointAt(node, pose)),
      this.inertial(b),
      ...shapesOf(this.source, body, number),
    ];
    return this.element(body.id, pose, parent, lines, indent, beyond(pose));
  }

  private element(
    name: string,
    pose: Pose,
    parent: Pose,
    lines: readonly string[],
    indent: string,
    beyond: readonly string[],
  ): string[] {
    const at = applyInverse(parent.R, add(pose.p, parent.p, -1));
    const quat = quaternionOf(between(parent.R, pose.R));
    const turned = quat.slice(1).some((x) => Math.abs(x) > 1e-15);
    return [
      `${indent}<body name="${name}" pos="${numbers(at)}"${turned ? ` quat="${numbers(quat)}"` : ''}>`,
      ...lines.map((line) => `${indent}  ${line}`),
      ...beyond,
      `${indent}</body>`,
    ];
  }

  private jointAt({ coordinate, twist }: JointNode, { p, R }: Pose): string {
    this.joints.push(coordinate);
    const hinge = norm(twist.omega) > 0.5;
    const axis = applyInverse(R, hinge ? twist.omega : twist.v);
    const from = applyInverse(R, add(cross(twist.omega, twist.v), p, -1));
    return this.joint(
      coordinate,
      hinge ? 'hinge' : 'slide',
      axis,
      hinge ? add(from, axis, -dot(axis, from)) : [0, 0, 0],
    );
  }

  private joint(i: number, type: 'hinge' | 'slide', axis: V3, pos: V3): string {
    const { armature, springs, dampers } = this.dynamics;
    const alone = (squares: FreeDynamics['springs']) =>
      squares.filter(({ along }) => along.every((x, k) => (k === i) === (x !== 0)));
    const attributes: [string, string][] = [
      ['name', this.name(i)],
      ['type', type],
      ['axis', numbers(axis)],
      ...(pos.some((x) => Math.abs(x) > 1e-15) ? ([['pos', numbers(pos)]] as [string, string][]) : []),
      ...(armature[i]! > 0 ? ([['armature', number(armature[i]!)]] as [string, string][]) : []),
      ...alone(springs).flatMap(({ weight, free }): [string, string][] => [
        ['stiffness', number(weight)],
        ...(free === 0 ? [] : ([['springref', number(free)]] as [string, string][])),
      ]),
      ...alone(dampers).map(({ weight }): [string, string] => ['damping', number(weight)]),
    ];
    return `<joint ${attributes.map(([key, value]) => `${key}="${value}"`).join(' ')}/>`;
  }

  private inertial(b: number): string {
    const mass = Math.max(this.dynamics.masses[b]!, NOTHING);
    const I = this.dynamics.inertias[b]!;
    const turns = this.dynamics.turns[b]!;
    const axes = [0, 1, 2].filter((k) => turns[k]);
    // About the axes that a body never turns about, any moments do; MuJoCo wants some that a body can have.
    if (axes.length < 2) {
      const moment = Math.max(axes.length === 1 ? I[4 * axes[0]!]! : 0, NOTHING);
      return inertial(mass, [moment, moment, moment]);
    }
    const { moments, R } = principalAxes(I);
    const positive = moments.map((x) => (Math.abs(x) < NOTHING ? NOTHING : x)) as V3;
    const sum = positive[0] + positive[1] + positive[2];
    if (Math.min(...positive) < 0 || 2 * Math.max(...positive) > sum * (1 + ROUNDING) + NOTHING)
      throw new ScenarioError(
        'system',
        `MuJoCo refuses the inertia of ${this.kinematics.bodies[b]!.label}: no body has a moment larger than the sum of the other two`,
      );
    return inertial(mass, positive, quaternionOf(R));
  }

  private name(i: number): string {
    return this.source.model.coordinates[i]!.name;
  }

  private tendon(name: string, along: ArrayLike<number>, attributes: string): string {
    let unique = name;
    while (this.tendonNames.has(unique)) unique += '-';
    this.tendonNames.add(unique);
    this.tendonLines.push(
      `    <fixed name="${unique}"${attributes}>`,
      ...Array.from(along).flatMap((x, i) =>
        x === 0 ? [] : [`      <joint joint="${this.name(i)}" coef="${number(x)}"/>`],
      ),
      '    </fixed>',
    );
    return unique;
  }

  tendons(): string[] {
    const { springs, dampers } = this.dynamics;
    const several = ({ along }: { along: Float64Array }): boolean => along.filter((x) => x !== 0).length > 1;
    for (const { weight, along, free } of springs.filter(several)) {
      // A negative length would mean "as long as at rest".
      const sign = free < 0 ? -1 : 1;
      this.tendon(
        'spring',
        along.map((x) => sign * x),
        ` stiffness="${number(weight)}" springlength="${number(sign * free)}"`,
      );
    }
    for (const { weight, along } of dampers.filter(several))
      this.tendon('damper', along, ` damping="${number(weight)}"`);
    this.motors = this.motorLines();
    return this.tendonLines.length === 0 ? [] : ['  <tendon>', ...this.tendonLines, '  </tendon>'];
  }

  private motors: string[] = [];

  private motorLines(): string[] {
    const { model } = this.source;
    return model.inputs.flatMap(({ name, column }) => {
      const along = model.coordinates.map((c, i) => (this.joints.includes(i) ? (column[c.name] ?? 0) : 0));
      const on = along.flatMap((x, i) => (x === 0 ? [] : [i]));
      if (on.length === 0) return [];
      const where =
        on.length === 1
          ? `joint="${this.name(on[0]!)}" gear="${number(along[on[0]!]!)}"`
          : `tendon="${this.tendon(`${name}-sum`, along, '')}" gear="1"`;
      return [`    <motor name="${name}" ${where}/>`];
    });
  }

  actuators(): string[] {
    return this.motors.length === 0 ? [] : ['  <actuator>', ...this.motors, '  </actuator>'];
  }
}

function inertial(mass: number, moments: V3, [w, x, y, z] = [1, 0, 0, 0]): string {
  const turned = [x, y, z].some((c) => c !== 0) ? ` quat="${[w, x, y, z].map(String).join(' ')}"` : '';
  // The small ones too: `number` would take them for rounding.
  return `<inertial pos="0 0 0"${turned} mass="${mass}" diaginertia="${moments.join(' ')}"/>`;
}
