/**
 * Equations of motion of a model: Lagrange's with multipliers, by differentiating the graph of its energies.
 *
 *     M a = h + B u + Omega^T lambda,  Omega a + gamma = 0
 *     M = d2L/dv2,  h = dL/dq - (d2L/dv dq) v - dR/dv + Q,  Omega = d(row)/dv,  gamma = (d(row)/dq) v
 *
 * H. Goldstein, C. Poole, J. Safko, Classical Mechanics, 3rd ed., sections 1.5 (Rayleigh's function) and 2.4 (constraints that
 * are linear in the rates).
 */
import { OPS, type Graph, type Id } from './graph.ts';
import type { Model, Row } from './model.ts';

export interface Equations {
  /** n x n. */
  M: Id[];
  h: Id[];
  sets: { id: string; rows: readonly Row[]; omega: Id[]; gamma: Id[] }[];
}

/**
 * The mass matrix, h, and rows of every constraint set.
 *
 * @param model what was read of a description
 * @param step is told of every part, and may stop by throwing
 */
export function equationsOf(model: Model, step: (done: number, of: number) => void = () => {}): Equations {
  const { graph, q, v } = model;
  const n = q.length;
  const total = n + 2;
  graph.work = 'the Lagrangian';
  const L = graph.sub(graph.add(model.kinetic, model.inertia), model.potential);
  const momenta = graph.gradient(L, v);
  const slopes = graph.gradient(L, q);
  step(1, total);
  graph.work = 'the mass matrix';
  const order = graph.reach(momenta);
  const M: Id[] = Array.from({ length: n * n }, () => graph.zero);
  for (let i = 0; i < n; i++) {
    const column = graph.forward(momenta, new Map([[v[i]!, graph.one]]), order);
    for (let j = i; j < n; j++) M[i * n + j] = M[j * n + i] = column[j]!;
    step(2 + i, total);
  }
  graph.work = 'the generalized forces';
  const seed = new Map(q.map((id, i) => [id, v[i]!]));
  const rates = graph.forward(momenta, seed, order);
  const losses = graph.gradient(model.loss, v);
  const h = slopes.map((slope, i) =>
    graph.add(graph.sub(graph.sub(slope, rates[i]!), losses[i]!), model.forces[i] ?? graph.zero),
  );
  if (model.clock !== null) h[model.clock] = graph.zero;
  for (const i of weightlessOf(model)) h[i] = graph.zero;
  graph.work = 'the constraints';
  const sets = model.sets
    .filter(({ rows }) => rows.length > 0)
    .map(({ id, rows }) => ({
      id,
      rows,
      omega: rows.flatMap((row) => graph.gradient(row.velocity, v)),
      gamma: graph.forward(
        rows.map((row) => row.velocity),
        seed,
      ),
    }));
  step(total, total);
  return { M, h, sets };
}

/**
 * Kinetic and potential energy, whose sum nothing but outside forces changes. Of a kinetic energy that is quadratic in the rates
 * these are T and V. Written in axes that turn or move, T has parts T1 linear in the rates and T0 without: the sum that stays is
 * then Jacobi's integral v dT/dv - T + V, and T0 counts as potential (Goldstein, section 2.7).
 *
 * @param model what was read of a description
 */
export function energiesOf({ graph, v, kinetic, potential }: Model): [kinetic: Id, potential: Id] {
  if (kinetic === graph.zero || degreeOf(graph, kinetic, new Set(v)) === 2) return [kinetic, potential];
  graph.work = 'the energy';
  const [T0] = graph.replace([kinetic], new Map(v.map((id) => [id, graph.zero]))) as [Id];
  const momenta = graph.gradient(kinetic, v);
  const rest = graph.sub(kinetic, T0);
  const moving = graph.sum(momenta.map((p, i) => graph.mul(v[i]!, p)));
  return [graph.sub(moving, rest), graph.sub(potential, T0)];
}

/**
 * What is put in from outside, W, but for what constraints that move put in: forces of statements, and what moves whatever is
 * given by t or by an equation of first order, v (p' - dL/dq + dR/dv). The energies change by it, and by what R takes.
 *
 * @param model what was read of a description
 * @param a nodes of the accelerations
 * @returns null where nothing is
 */
export function outsidePowerOf(model: Model, a: readonly Id[]): Id | null {
  const { graph, q, v, clock, kinetic, potential, loss, forces } = model;
  const weightless = weightlessOf(model);
  const parts = forces
    .map((force, i) => (weightless.includes(i) ? graph.zero : graph.mul(force ?? graph.zero, v[i]!)))
    .filter((part) => part !== graph.zero);
  const moved = clock === null ? weightless : [clock, ...weightless];
  graph.work = 'the work of what moves';
  const L = graph.sub(kinetic, potential);
  const seed = new Map([...q.map((id, i) => [id, v[i]!] as const), ...v.map((id, i) => [id, a[i]!] as const)]);
  const momenta = moved.map((i) => graph.gradient(kinetic, [v[i]!])[0]!);
  const rates = graph.forward(momenta, seed);
  moved.forEach((i, k) => {
    const [slope] = graph.gradient(L, [q[i]!]) as [Id];
    const [lost] = graph.gradient(loss, [v[i]!]) as [Id];
    parts.push(graph.mul(v[i]!, graph.add(graph.sub(rates[k]!, slope), lost)));
  });
  return parts.length > 0 ? graph.sum(parts) : null;
}

/** The degree of an expression that is homogeneous in some variables, as far as its operations tell; null for any other. */
function degreeOf(graph: Graph, root: Id, variables: ReadonlySet<Id>): number | null {
  const degrees = new Map<Id, number | null>();
  const of = (i: Id): number | null => degrees.get(i)!;
  for (const i of graph.reach([root])) {
    const [a, b] = [graph.a[i]!, graph.b[i]!];
    const all = [a, b, graph.c[i]!].filter((x) => x >= 0 && x !== graph.zero);
    const same = all.every((x) => of(x) === of(all[0]!)) ? (all.length > 0 ? of(all[0]!) : 0) : null;
    const without = all.every((x) => of(x) === 0) ? 0 : null;
    const [da, db] = [all.includes(a) ? of(a) : 0, all.includes(b) ? of(b) : 0];
    let degree = without;
    switch (OPS[graph.op[i]!]!) {
      case 'input':
        degree = variables.has(i) ? 1 : 0;
        break;
      case 'add':
      case 'sub':
      case 'neg':
        degree = same;
        break;
      case 'mul':
        degree = da === null || db === null ? null : da + db;
        break;
      case 'div':
        degree = da === null || db === null ? null : da - db;
        break;
      case 'sqrt':
        degree = da === null ? null : da / 2;
        break;
      case 'pow':
        if (da !== null && graph.isNumber(b)) degree = da * graph.value[b]!;
        break;
      default:
        break;
    }
    degrees.set(i, degree);
  }
  return of(root);
}

/**
 * Coordinates of first order that carry no inertia of their own. What would act on them is left out: their equation alone says
 * how they go, and a reaction to it would act on all whose rates stand in it.
 *
 * @param model what was read of a description
 */
export function weightlessOf({ graph, kinetic, rates, v, mechanical }: Model): number[] {
  if (!mechanical || rates.size === 0) return [];
  const inside = new Set(graph.reach([kinetic]));
  return [...rates.keys()].filter((i) => !inside.has(v[i]!));
}

/**
 * d(results)/d(variables), row by row.
 *
 * @param graph that holds the nodes
 * @param results nodes
 * @param variables nodes
 */
export function jacobianOf(graph: Graph, results: readonly Id[], variables: readonly Id[]): Id[] {
  const order = graph.reach(results);
  const k = variables.length;
  const J: Id[] = Array.from({ length: results.length * k }, () => graph.zero);
  variables.forEach((variable, c) =>
    graph.forward(results, new Map([[variable, graph.one]]), order).forEach((x, r) => (J[r * k + c] = x)),
  );
  return J;
}
