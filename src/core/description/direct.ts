/**
 * The short way to constrained accelerations: M and S = Omega M^-1 Omega^T are factored on the graph itself, so that what is
 * zero costs nothing, and one function makes the accelerations of a state. What derivation/elimination.py and
 * derivation/direct.py write for the built-in systems, with the same outputs, so that every engine takes it.
 *
 * M = L D L^T (Golub and Van Loan, Matrix Computations, 4th ed., section 4.1.2), coordinates in an order in which little fills
 * in (section 11.1.4), and the Schur complement of the saddle-point system (Benzi, Golub and Liesen, Acta Numerica 14 (2005),
 * section 5).
 */
import type { ConstraintSet, DirectDynamics } from '../model/system.ts';
import type { Op, Tape } from '../model/tape.ts';
import { DEPENDENT } from '../linalg/saddle.ts';
import type { Equations } from './derive.ts';
import { code, GrowthError, type Graph, type Id } from './graph.ts';
import type { Model } from './model.ts';
import { needed, opOf, Program, type Call } from './program.ts';

/** Operations up to which one straight line is worth its length. */
const MOST_OPERATIONS = 30_000;

class Factors {
  readonly diagonal: Id[];
  readonly pivots: Id[] = [];
  readonly inverse: Id[] = [];
  private readonly L: Id[][];
  private readonly n: number;

  constructor(
    private readonly graph: Graph,
    matrix: readonly (readonly Id[])[],
  ) {
    const n = (this.n = matrix.length);
    const A = matrix.map((row) => [...row]);
    this.diagonal = A.map((row, i) => row[i]!);
    this.L = A.map(() => []);
    for (let j = 0; j < n; j++) {
      const below = A.map((row) => row[j]!);
      this.pivots.push(below[j]!);
      this.inverse.push(graph.div(graph.one, below[j]!));
      for (let i = j + 1; i < n; i++) this.L[i]![j] = graph.mul(below[i]!, this.inverse[j]!);
      for (let i = j + 1; i < n; i++)
        for (let k = j + 1; k <= i; k++)
          A[i]![k] = A[k]![i] = graph.sub(A[i]![k]!, graph.mul(this.L[i]![j]!, below[k]!));
    }
  }

  /** x of L x = b. */
  forward(b: readonly Id[]): Id[] {
    const x = [...b];
    for (let i = 0; i < this.n; i++)
      for (let k = 0; k < i; k++) x[i] = this.graph.sub(x[i]!, this.graph.mul(this.L[i]![k]!, x[k]!));
    return x;
  }

  /** D^-1 b. */
  scaled(b: readonly Id[]): Id[] {
    return b.map((x, i) => this.graph.mul(x, this.inverse[i]!));
  }

  /** x of L^T x = b. */
  back(b: readonly Id[]): Id[] {
    const x = [...b];
    for (let i = this.n - 1; i >= 0; i--)
      for (let k = i + 1; k < this.n; k++) x[i] = this.graph.sub(x[i]!, this.graph.mul(this.L[k]![i]!, x[k]!));
    return x;
  }
}

/** The next to be eliminated is always the one that is coupled to fewest. */
function sparsestFirst(graph: Graph, M: readonly Id[], n: number): number[] {
  const near = Array.from(
    { length: n },
    (_, i) => new Set([...Array(n).keys()].filter((j) => j !== i && M[i * n + j] !== graph.zero)),
  );
  const left = new Set(near.keys());
  const order: number[] = [];
  while (left.size > 0) {
    const i = [...left].reduce((best, k) => (near[k]!.size < near[best]!.size ? k : best));
    for (const a of near[i]!) {
      near[a]!.delete(i);
      for (const b of near[i]!) if (a !== b) near[a]!.add(b);
    }
    order.push(i);
    left.delete(i);
  }
  return order;
}

/**
 * Nothing where a clock is held, or where one line of operations would be too long.
 *
 * @param model what was read of a description
 * @param equations of the model
 * @param k place of the constraint set
 */
export function directOf(model: Model, equations: Equations, k: number): Pick<ConstraintSet, 'direct'> {
  try {
    return short(model, equations, k);
  } catch (error) {
    if (error instanceof GrowthError) return {};
    throw error;
  }
}

function short(model: Model, equations: Equations, k: number): Pick<ConstraintSet, 'direct'> {
  const { graph, q } = model;
  if (model.clock !== null) return {};
  const n = q.length;
  const { rows, omega, gamma } = equations.sets[k]!;
  const m = rows.length;
  graph.work = 'the accelerations';
  const order = sparsestFirst(graph, equations.M, n);
  const f = Array.from({ length: n }, () => graph.input());
  const g = Array.from({ length: m }, () => graph.input());
  const mass = new Factors(
    graph,
    order.map((i) => order.map((j) => equations.M[i * n + j]!)),
  );
  const lines = rows.map((_, r) => mass.forward(order.map((i) => omega[r * n + i]!)));
  const weighted = lines.map((line) => mass.scaled(line));
  const dot = (a: readonly Id[], b: readonly Id[]): Id => graph.sum(a.map((x, i) => graph.mul(x, b[i]!)));
  const schur = new Factors(
    graph,
    weighted.map((a) => lines.map((b) => dot(a, b))),
  );
  const multipliers = (right: readonly Id[]): Id[] => schur.back(schur.scaled(schur.forward(right)));
  const spread = (lambda: readonly Id[]): Id[] =>
    order.map((_, i) =>
      dot(
        weighted.map((w) => w[i]!),
        lambda,
      ),
    );
  const inOrder = (x: readonly Id[]): Id[] => {
    const out: Id[] = [];
    order.forEach((i, at) => (out[i] = x[at]!));
    return out;
  };
  const forced = mass.forward(order.map((i) => graph.add(equations.h[i]!, f[i]!)));
  const lambda = multipliers(gamma.map((x, r) => graph.sub(graph.neg(x), dot(weighted[r]!, forced))));
  const along = spread(lambda);
  const a = inOrder(mass.back(mass.scaled(forced).map((x, i) => graph.add(x, along[i]!))));
  const shift = inOrder(mass.back(spread(multipliers(g))));
  const one = graph.one;
  const spreadOfS = graph.mul(
    schur.diagonal.reduce((x, y) => graph.mul(x, y), one),
    schur.inverse.reduce((x, y) => graph.mul(x, y), one),
  );
  const kept = readByShift(graph, shift, g);
  const arrays = {
    rate: [...model.v, ...a],
    lambda,
    factors: [...kept, spreadOfS],
    larger: [...mass.pivots, ...schur.pivots],
    smaller: [
      ...mass.pivots.map(() => graph.zero),
      ...schur.diagonal.map((x) => graph.mul(graph.number(DEPENDENT), x)),
    ],
    slip: rows.map((row) => row.velocity),
    heights: rows.flatMap(({ height }) => (height === null ? [] : [height])),
    shift,
  };
  return bound(model, equations.sets[k]!.id, f, g, kept, arrays);
}

/** Values that the shift reads and that do not depend on what it changes. */
function readByShift(graph: Graph, shift: readonly Id[], g: readonly Id[]): Id[] {
  const depends = new Set(g);
  const wanted = new Set<Id>();
  for (const i of graph.reach(shift)) {
    const parts = [graph.a[i]!, graph.b[i]!, graph.c[i]!].filter((x) => x >= 0);
    if (!parts.some((x) => depends.has(x))) continue;
    depends.add(i);
    parts.forEach((x) => wanted.add(x));
  }
  return [...wanted].filter((i) => !depends.has(i) && graph.op[i] !== code.const).sort((a, b) => a - b);
}

type DirectArrays = Record<'rate' | 'lambda' | 'factors' | 'larger' | 'smaller' | 'slip' | 'heights' | 'shift', Id[]>;

function bound(
  model: Model,
  id: string,
  f: readonly Id[],
  g: readonly Id[],
  kept: readonly Id[],
  arrays: DirectArrays,
): Pick<ConstraintSet, 'direct'> {
  const { graph, q, v, p } = model;
  const y = [...q, ...v];
  const wanted = Object.values(arrays).flat();
  const constants = fixedBy(graph, wanted, p);
  const given = new Map([...y, ...constants, ...f].map((i) => [i, true]));
  if (needed(graph, [...arrays.rate, ...arrays.lambda], given).length > MOST_OPERATIONS) return {};
  const prepare = once(() => new Program(graph, { p }, { constants }).interpreted());
  const { rate, lambda, factors, larger, smaller } = arrays;
  const accelerate = once(() =>
    new Program(graph, { y, constants, f }, { rate, lambda, factors, larger, smaller }).tiered(),
  );
  const shift = once(() => new Program(graph, { kept, g }, { shift: arrays.shift }).tiered());
  const slip = once(() =>
    new Program(graph, { q, v, constants }, { slip: arrays.slip, heights: arrays.heights }).tiered(),
  );
  const [large, small] = [new Float64Array(larger.length), new Float64Array(smaller.length)];
  const change = new Float64Array(q.length);
  const factorsHere = new Float64Array(kept.length);
  const direct: DirectDynamics = {
    tape: tapeOf(model, id, f, g, constants, arrays),
    constantCount: constants.length,
    factorCount: factors.length,
    prepare: (ps, c) => prepare()(ps, c),
    accelerations(ys, c, forces, rates, lambdas, factorsOut) {
      accelerate()(ys, c, forces, rates, lambdas, factorsOut, large, small);
      for (let i = 0; i < large.length; i++) if (!(large[i]! > small[i]!)) return false;
      return true;
    },
    shift(factorsOf, by, x) {
      for (let i = 0; i < factorsHere.length; i++) factorsHere[i] = factorsOf[i]!;
      shift()(factorsHere, by, change);
      for (let i = 0; i < x.length; i++) x[i]! += change[i]!;
    },
    slip: (qs, vs, c, out, heights) => slip()(qs, vs, c, out, heights),
  };
  return { direct };
}

function once(make: () => Call): () => Call {
  let made: Call | null = null;
  return () => (made ??= make());
}

/** Values that depend on the parameters alone and are read by others, which are made once. */
function fixedBy(graph: Graph, wanted: readonly Id[], p: readonly Id[]): Id[] {
  const order = graph.reach(wanted);
  const parameters = new Set(p);
  const fixed = new Set<Id>();
  const found = new Set<Id>();
  for (const i of order) {
    const parts = [graph.a[i]!, graph.b[i]!, graph.c[i]!].filter((x) => x >= 0);
    if (graph.op[i] === code.const || parameters.has(i) || (parts.length > 0 && parts.every((x) => fixed.has(x))))
      fixed.add(i);
    else for (const x of parts) if (fixed.has(x) && graph.op[x] !== code.const) found.add(x);
  }
  for (const i of wanted) if (fixed.has(i) && graph.op[i] !== code.const) found.add(i);
  return [...found].sort((a, b) => a - b);
}

/** The same as data, for the engine that writes whole steps. */
function tapeOf(
  { graph, q, v, p }: Model,
  id: string,
  f: readonly Id[],
  g: readonly Id[],
  constants: readonly Id[],
  arrays: DirectArrays,
): Tape {
  const ops: Op[] = [];
  const place = new Map<Id, number>();
  for (const [name, ids] of Object.entries({ q, v, p, f, g }))
    ids.forEach((node, k) => {
      place.set(node, ops.length);
      ops.push(['input', name, k]);
    });
  for (const node of needed(graph, [...constants, ...Object.values(arrays).flat()], place)) {
    place.set(node, ops.length);
    ops.push(opOf(graph, node, place));
  }
  const at = (ids: readonly Id[]): number[] => ids.map((node) => place.get(node)!);
  const set = Object.fromEntries(Object.entries(arrays).map(([name, ids]) => [name, at(ids)])) as Record<
    keyof DirectArrays,
    number[]
  >;
  return { ops, prepare: at(constants), sets: { [id]: set } };
}
