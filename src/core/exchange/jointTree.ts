/**
 * Finds the tree of hinges and slides that a description's bodies hang in. A description says where bodies are as formulas of the
 * coordinates; a tree of joints moves body b by the product of exponentials
 *
 *     T_b(q) = exp(S_1 q_1) … exp(S_k q_k) T_b(0)
 *
 * over the joints from the root to it (R. M. Murray, Z. Li, S. S. Sastry, A Mathematical Introduction to Robotic Manipulation,
 * 1994, section 3.2). So every coordinate has to move all bodies beyond it by one and the same unit twist, which depends on
 * the coordinates before it alone. That is what is looked for, in numbers, at states far from any symmetry; the tree that is found
 * is compared with the formulas at other states. What is not such a tree is refused with the name of what is not.
 */
import type { BodyModel, Model } from '../description/model.ts';
import { jacobianOf } from '../description/derive.ts';
import { Program } from '../description/program.ts';
import { ScenarioError } from '../scenario/types.ts';
import { add, apply, cross, dot, moved, norm, type Pose, type Twist, type V3 } from './spatial.ts';

/** Rounding of formulas of some hundred operations, and no more. */
const SAME = 1e-9;

/** Bodies of a description in numbers: places, and how each coordinate moves them. */
export interface Kinematics {
  bodies: readonly BodyModel[];
  poses(q: Float64Array): Pose[];
  /** [body][coordinate]. */
  twists(q: Float64Array): Twist[][];
}

export interface JointNode {
  /** Place of its coordinate; -1 of the world. */
  coordinate: number;
  /** At q = 0, but for held coordinates. */
  twist: Twist;
  children: JointNode[];
  /** Bodies that no further coordinate moves, by their place in `Kinematics.bodies`. */
  bodies: number[];
}

export interface JointTree {
  root: JointNode;
  /** Places at q = 0, but for held coordinates. */
  rest: Pose[];
  /** Coordinates that move no body. */
  loose: number[];
}

/**
 * @param model that was read
 * @param bodies those that are asked for
 * @param p parameters
 */
export function kinematicsOf(model: Model, bodies: readonly BodyModel[], p: Float64Array): Kinematics {
  const { graph, q, v } = model;
  const n = q.length;
  const B = bodies.length;
  const position = bodies.flatMap((body) => [...body.position]);
  const spin = bodies.flatMap(({ frame }) => [...frame.spin]);
  const outputs = {
    position,
    R: bodies.flatMap(({ frame }) => [...frame.R]),
    J: jacobianOf(graph, position, q),
    W: jacobianOf(graph, spin, v),
  };
  const call = new Program(graph, { q, p: model.p }, outputs).interpreted();
  const [at, R, J, W] = [3 * B, 9 * B, 3 * B * n, 3 * B * n].map((size) => new Float64Array(size));
  const three = (x: Float64Array, k: number, stride = 1): V3 => [x[k]!, x[k + stride]!, x[k + 2 * stride]!];
  const evaluate = (state: Float64Array): void => call(state, p, at!, R!, J!, W!);
  const pose = (b: number): Pose => ({ p: three(at!, 3 * b), R: [...R!.subarray(9 * b, 9 * b + 9)] });
  return {
    bodies,
    poses(state) {
      evaluate(state);
      return bodies.map((_, b) => pose(b));
    },
    twists(state) {
      evaluate(state);
      return bodies.map((_, b) =>
        q.map((__, i) => {
          const here = pose(b);
          const omega = apply(here.R, three(W!, 3 * b * n + i, n));
          return { omega, v: add(three(J!, 3 * b * n + i, n), cross(omega, here.p), -1) };
        }),
      );
    },
  };
}

/**
 * The tree, or the reason why there is none.
 *
 * @param model that was read
 * @param kinematics of the bodies that are to hang in it
 * @param states three: q = 0 but for held coordinates, and two far from there and from each other
 * @param held places of coordinates that do not move
 * @throws ScenarioError
 */
export function jointTreeOf(
  model: Model,
  kinematics: Kinematics,
  states: readonly [Float64Array, Float64Array, Float64Array],
  held: readonly number[],
): JointTree {
  const { bodies } = kinematics;
  const nameOf = (i: number): string => model.coordinates[i]!.name;
  const refuse = (why: string): never => {
    throw new ScenarioError('system', `MJCF knows trees of hinges and slides: ${why}`);
  };
  const [zero, one, other] = states;
  const free = model.q.map((_, i) => i).filter((i) => !held.includes(i));
  const [rest, atRest, here, there] = [
    kinematics.poses(zero),
    kinematics.twists(zero),
    kinematics.twists(one),
    kinematics.twists(other),
  ];
  if (![rest, kinematics.poses(one)].every((poses) => poses.every(finite)))
    refuse('where its coordinates are 0, this system’s bodies are nowhere');
  const moves = model.q.map((_, i) =>
    bodies.flatMap((__, b) => (held.includes(i) || (still(here[b]![i]!) && still(there[b]![i]!)) ? [] : [b])),
  );
  for (const i of free) {
    const [first, ...more] = moves[i]!;
    if (first === undefined) continue;
    for (const twists of [here, there]) {
      const twist = twists[first]![i]!;
      const apart = more.find((b) => !same(twists[b]![i]!, twist));
      if (apart !== undefined)
        refuse(
          `${nameOf(i)} moves ${bodies[first]!.label} and ${bodies[apart]!.label} differently; an angle is measured from the body before it`,
        );
      const turn = norm(twist.omega);
      if (turn < SAME ? Math.abs(norm(twist.v) - 1) > SAME : Math.abs(turn - 1) > SAME)
        refuse(
          `${nameOf(i)} moves ${bodies[first]!.label} by ${(turn < SAME ? norm(twist.v) : turn).toPrecision(4)} of itself; a joint’s coordinate is its own angle or length`,
        );
      if (turn >= SAME && Math.abs(dot(twist.omega, twist.v)) > SAME) refuse(`${nameOf(i)} is a screw`);
    }
  }
  const order =
    orderOf(
      kinematics,
      one,
      here,
      moves,
      free.filter((i) => moves[i]!.length > 0),
    ) ?? refuse('its coordinates turn about each other in a circle');
  const root: JointNode = { coordinate: -1, twist: { omega: [0, 0, 0], v: [0, 0, 0] }, children: [], bodies: [] };
  const nodes = new Map<number, { node: JointNode; parent: JointNode }>();
  bodies.forEach((_, b) => {
    let at = root;
    for (const i of order.filter((k) => moves[k]!.includes(b))) {
      const known = nodes.get(i);
      if (known && known.parent !== at) refuse(`${nameOf(i)} moves two branches`);
      const node = known?.node ?? { coordinate: i, twist: atRest[b]![i]!, children: [], bodies: [] };
      if (!known) {
        nodes.set(i, { node, parent: at });
        at.children.push(node);
      }
      at = node;
    }
    at.bodies.push(b);
  });
  for (const q of [one, other])
    check(root, rest, kinematics.poses(q), q, (b) => refuse(`${bodies[b]!.label} is moved by more than its joints`));
  return { root, rest, loose: free.filter((i) => moves[i]!.length === 0) };
}

const finite = ({ p, R }: Pose): boolean => [...p, ...R].every(Number.isFinite);
const still = ({ omega, v }: Twist): boolean => norm(omega) < SAME && norm(v) < SAME;
const same = (a: Twist, b: Twist): boolean => norm(add(a.omega, b.omega, -1)) < SAME && norm(add(a.v, b.v, -1)) < SAME;

/** From the root outwards: who moves more bodies, and who carries another's axis, comes before. Null where that is a circle. */
function orderOf(
  kinematics: Kinematics,
  q: Float64Array,
  here: readonly Twist[][],
  moves: readonly number[][],
  coordinates: readonly number[],
): number[] | null {
  const before = new Map<number, Set<number>>(coordinates.map((i) => [i, new Set()]));
  for (const i of coordinates) {
    const turned = q.slice();
    // Neither a whole turn nor a half.
    turned[i]! += 0.9;
    const after = kinematics.twists(turned);
    for (const j of coordinates) {
      if (i === j) continue;
      const b = moves[j]![0]!;
      const carries = !same(after[b]![j]!, here[b]![j]!);
      const more = moves[i]!.length > moves[j]!.length && moves[j]!.every((x) => moves[i]!.includes(x));
      if (carries || more) before.get(j)!.add(i);
    }
  }
  const order: number[] = [];
  while (order.length < coordinates.length) {
    const next = coordinates.find((i) => !order.includes(i) && [...before.get(i)!].every((k) => order.includes(k)));
    if (next === undefined) return null;
    order.push(next);
  }
  return order;
}

/** The product of exponentials against the formulas. */
function check(
  root: JointNode,
  rest: readonly Pose[],
  poses: readonly Pose[],
  q: Float64Array,
  differs: (body: number) => never,
): void {
  const visit = (node: JointNode, chain: readonly JointNode[]): void => {
    for (const b of node.bodies) {
      let pose = rest[b]!;
      for (const joint of [...chain].reverse()) pose = moved(pose, joint.twist, q[joint.coordinate]!);
      const wrong = [...pose.p, ...pose.R].some((x, k) => Math.abs(x - [...poses[b]!.p, ...poses[b]!.R][k]!) > SAME);
      if (wrong) differs(b);
    }
    for (const child of node.children) visit(child, [...chain, child]);
  };
  visit(root, []);
}
