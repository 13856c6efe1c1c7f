/**
 * Equations of motion of a model: Lagrange's with multipliers, by differentiating the graph of its energies.
 *
 *     M a = h + B u + Omega^T lambda,  Omega a + gamma = 0
 *     M = d2L/dv2,  h = dL/dq - (d2L/dv dq) v - dR/dv + Q,  Omega = d(row)/dv,  gamma = (d(row)/dq) v
 *
 * H. Goldstein, C. Poole, J. Safko, Classical Mechanics, 3rd ed., sections 1.5 (Rayleigh's function) and 2.4 (constraints that
 * are linear in the rates).
 */
import type { Graph, Id } from './graph.ts';
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
