/** What an engine of rigid bodies has to be told beside where they are: masses, springs, dampers; in numbers. */
import { equationsOf, jacobianOf } from '../description/derive.ts';
import { OPS, type Graph, type Id } from '../description/graph.ts';
import { Program } from '../description/program.ts';
import { ScenarioError } from '../scenario/types.ts';
import type { Kinematics } from './jointTree.ts';
import { squaresOf, type Square } from './quadratic.ts';
import type { Source } from './source.ts';
import { applyInverse, cross, add, type V3 } from './spatial.ts';

/** Rounding, relative to the largest of what is compared. */
const SAME = 1e-9;

export interface FreeDynamics {
  gravity: number;
  /** By body of the kinematics. */
  masses: number[];
  /** 3 x 3, about the centre of mass, in the body's axes. */
  inertias: number[][];
  /** Whether a body ever turns about each of its axes. */
  turns: boolean[][];
  /** By coordinate: inertia that only its own rate knows. */
  armature: Float64Array;
  springs: Square[];
  dampers: Square[];
  /** What is left out. */
  notes: string[];
}

/**
 * @param source what is exported
 * @param kinematics of the bodies
 * @param states q = 0 and two others
 * @throws ScenarioError where the energies are more than bodies, springs and gravity
 */
export function dynamicsOf(source: Source, kinematics: Kinematics, states: readonly Float64Array[]): FreeDynamics {
  const { model, p, held } = source;
  const { graph } = model;
  const n = model.q.length;
  const free = model.q.map((_, i) => i).filter((i) => !held.includes(i));
  const refuse = (why: string): never => {
    throw new ScenarioError('system', `MJCF knows bodies, springs and weight: ${why}`);
  };
  const fixed = new Program(
    graph,
    { p: model.p },
    {
      mass: kinematics.bodies.map(({ mass }) => mass ?? graph.zero),
      inertia: kinematics.bodies.flatMap(({ inertia }) =>
        Array.from({ length: 6 }, (_, k) => inertia?.[k] ?? graph.zero),
      ),
    },
  );
  const B = kinematics.bodies.length;
  const [mass, moments] = [new Float64Array(B), new Float64Array(6 * B)];
  fixed.interpreted()(p, mass, moments);
  const inertias = kinematics.bodies.map((_, b) => {
    const [xx, yy, zz, xy, xz, yz] = moments.subarray(6 * b, 6 * b + 6) as unknown as number[];
    return [xx!, xy!, xz!, xy!, yy!, yz!, xz!, yz!, zz!];
  });
  const gravityAt = model.parameters.findIndex(({ name }) => name === 'gravity');
  const gravity = gravityAt < 0 ? 0 : p[gravityAt]!;
  const weight = graph.sum(
    model.bodies.map(({ mass: m, position }) =>
      m === null || gravityAt < 0 ? graph.zero : graph.mul(graph.mul(m, model.p[gravityAt]!), position[2]),
    ),
  );
  const stored = graph.sub(model.potential, weight);
  const slope = graph.gradient(stored, model.q);
  const numbersOf = evaluator(source, {
    M: equationsOf(model).M,
    slope,
    stiffness: jacobianOf(graph, slope, model.q),
    forces: model.q.map((_, i) => model.forces[i] ?? graph.zero),
  });
  const still = new Float64Array(n);
  const [one, other] = [states[1]!, states[2]!].map((q) => ({ ...numbersOf(q, still), q }));
  const turns = kinematics.bodies.map(() => [false, false, false]);
  const armature = new Float64Array(n);
  for (const { q, M } of [one!, other!]) {
    const bodies = bodiesMassMatrix(kinematics, q, mass, inertias, turns);
    const size = Math.max(...M!.map(Math.abs));
    for (const i of free)
      for (const j of free) {
        const more = M![i * n + j]! - bodies[i * n + j]!;
        if (
          i !== j
            ? Math.abs(more) > SAME * size
            : more < -SAME * size || (q === other!.q && Math.abs(more - armature[i]!) > SAME * size)
        )
          refuse('the kinetic energy of this system is more than that of bodies with mass; say it with body lines');
        if (i === j) armature[i] = more > SAME * size ? more : 0;
      }
  }
  const constant = one!.stiffness!.every(
    (x, k) => Math.abs(x - other!.stiffness![k]!) <= SAME * Math.max(1, Math.abs(x)),
  );
  const offset = one!.slope!.map(
    (x, i) => x - one!.stiffness!.subarray(i * n, i * n + n).reduce((sum, k, j) => sum + k * one!.q[j]!, 0),
  );
  // Of what is held only its place counts, which the offset knows.
  const K = one!.stiffness!.map((x, k) => (held.includes(Math.floor(k / n)) || held.includes(k % n) ? 0 : x));
  const shift = offset.map((x, i) =>
    held.includes(i) ? 0 : x + held.reduce((sum, k) => sum + one!.stiffness![i * n + k]! * one!.q[k]!, 0),
  );
  const rounding = SAME * Math.max(1, ...K.map(Math.abs));
  const springs = constant
    ? squaresOf(
        K,
        shift.map((x) => (Math.abs(x) < rounding ? 0 : x)),
      )
    : null;
  if (!springs)
    refuse('the potential energy of this system is more than weight and linear springs; say weight with body lines');
  const { squares, left } = losses(source, states);
  const notes =
    left === 0
      ? []
      : ['Left out: losses that are not linear dampers between coordinates, such as the drag of a wheel.'];
  if ([one!, other!].some(({ forces }) => forces!.some((x) => x !== 0)))
    notes.push('Left out: the forces and torques that the description gives by a formula.');
  const masses = [...mass];
  return { gravity, masses, inertias, turns, armature, springs: springs!, dampers: squares, notes };
}

function evaluator<Name extends string>(
  { model, p }: Source,
  outputs: Readonly<Record<Name, readonly Id[]>>,
): (q: Float64Array, v: Float64Array) => Record<Name, Float64Array> {
  const call = new Program(model.graph, { q: model.q, v: model.v, p: model.p }, outputs).interpreted();
  return (q, v) => {
    const made = Object.entries<readonly Id[]>(outputs).map(
      ([name, ids]) => [name, new Float64Array(ids.length)] as const,
    );
    call(q, v, p, ...made.map(([, array]) => array));
    return Object.fromEntries(made) as Record<Name, Float64Array>;
  };
}

/** Sum of m J^T J + W^T I W; notes about which axes each body turns. */
function bodiesMassMatrix(
  kinematics: Kinematics,
  q: Float64Array,
  mass: Float64Array,
  inertias: readonly number[][],
  turns: boolean[][],
): Float64Array {
  const n = q.length;
  const M = new Float64Array(n * n);
  const poses = kinematics.poses(q);
  kinematics.twists(q).forEach((twists, b) => {
    const { p, R } = poses[b]!;
    const I = inertias[b]!;
    const J = twists.map(({ omega, v }) => add(v, cross(omega, p)));
    const W = twists.map(({ omega }) => applyInverse(R, omega));
    W.forEach((w) => w.forEach((x, k) => (turns[b]![k] ||= Math.abs(x) > 1e-12)));
    const IW = W.map((w): V3 => [0, 3, 6].map((k) => I[k]! * w[0] + I[k + 1]! * w[1] + I[k + 2]! * w[2]) as V3);
    for (let i = 0; i < n; i++)
      for (let j = 0; j < n; j++)
        for (let k = 0; k < 3; k++) M[i * n + j]! += mass[b]! * J[i]![k]! * J[j]![k]! + W[i]![k]! * IW[j]![k]!;
  });
  return M;
}

/** Rayleigh's function, term by term: those that are quadratic forms of the rates with constant weights, and how many are not. */
function losses(source: Source, states: readonly Float64Array[]): { squares: Square[]; left: number } {
  const { model, held } = source;
  const { graph, v } = model;
  const n = v.length;
  const all = new Float64Array(n * n);
  let left = 0;
  const speeds = [v.map((_, i) => Math.sin(2 * i + 1)), v.map((_, i) => Math.cos(3 * i))].map((x) =>
    Float64Array.from(x),
  );
  for (const term of termsOf(graph, model.loss)) {
    const slope = graph.gradient(term, v);
    const numbersOf = evaluator(source, { slope, C: jacobianOf(graph, slope, v) });
    const [one, other] = speeds.map((speed, k) => numbersOf(states[k + 1]!, speed));
    const linear = one!.slope!.every((x, i) => {
      const sum = speeds[0]!.reduce((total, rate, j) => total + one!.C![i * n + j]! * rate, 0);
      return Math.abs(x - sum) <= SAME * Math.max(1, Math.abs(x));
    });
    const constant = one!.C!.every((x, k) => Math.abs(x - other!.C![k]!) <= SAME * Math.max(1, Math.abs(x)));
    if (linear && constant) for (let k = 0; k < n * n; k++) all[k]! += one!.C![k]!;
    else if (one!.slope!.some((x) => x !== 0)) left++;
  }
  for (let k = 0; k < n * n; k++) if (held.includes(Math.floor(k / n)) || held.includes(k % n)) all[k] = 0;
  const squares = squaresOf(all, new Float64Array(n));
  return squares ? { squares, left } : { squares: [], left: left + 1 };
}

function termsOf(graph: Graph, id: Id): Id[] {
  return OPS[graph.op[id]!] === 'add' ? [...termsOf(graph, graph.a[id]!), ...termsOf(graph, graph.b[id]!)] : [id];
}
