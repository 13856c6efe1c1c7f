/**
 * What the equations of a description hold of the time alone, as formulas that a run looks at before it takes a step: a drive's
 * rate and acceleration, a force that is given by t. A run would else pass over what they do while all is quiet.
 */
import { node, number, variable, type Node } from '../scenario/expressions/tree.ts';
import { OPS, type Id, type OpName } from './graph.ts';
import type { Model } from './model.ts';

/** Beyond so many parts a formula is looked at by its operands. */
const MOST_PARTS = 300;
const MOST_FORMULAS = 100;

/** What the operations of a graph are called in formulas, where that is something else. */
const operators: Partial<Record<OpName, string>> = {
  add: '+',
  sub: '-',
  mul: '*',
  div: '/',
  neg: 'negative',
  pow: '^',
  lt: '<',
  le: '<=',
  eq: '==',
  select: '?',
};

/**
 * The largest parts of results that depend on the time, and but for it on parameters alone.
 *
 * @param model that the results are of
 * @param results nodes
 * @returns makes their trees from parameters and what the clock is ahead of t, s
 */
export function timeFormulas(model: Model, results: readonly Id[]): (p: Float64Array, ahead: number) => Node[] {
  const { graph, clock } = model;
  if (clock === null) return () => [];
  const [time, rate] = [model.q[clock]!, model.v[clock]!];
  const place = new Map(model.p.map((id, k) => [id, k]));
  const order = graph.reach(results);
  /** 0: of the parameters alone, 1: of the time too, 2: of more; and how many parts its tree has. */
  const kind = new Map<Id, { of: 0 | 1 | 2; parts: number }>();
  const operandsOf = (i: Id): Id[] => [graph.a[i]!, graph.b[i]!, graph.c[i]!].filter((x) => x >= 0);
  for (const i of order) {
    const below = operandsOf(i).map((x) => kind.get(x)!);
    let of = Math.max(0, ...below.map((x) => x.of));
    if (i === time) of = 1;
    else if (OPS[graph.op[i]!] === 'input' && i !== rate && !place.has(i)) of = 2;
    kind.set(i, { of: of as 0 | 1 | 2, parts: below.reduce((sum, x) => sum + x.parts, 1) });
  }
  const found = new Set<Id>();
  const seen = new Set<Id>();
  const look = (i: Id): void => {
    const { of, parts } = kind.get(i)!;
    if (of === 0 || seen.has(i)) return;
    seen.add(i);
    if (of === 1 && parts <= MOST_PARTS) found.add(i);
    else operandsOf(i).forEach(look);
  };
  results.forEach(look);
  const roots = [...found].slice(0, MOST_FORMULAS);
  return (p, ahead) => {
    const made = new Map<Id, Node>([
      [time, ahead === 0 ? variable : node('+', variable, number(ahead))],
      [rate, number(1)],
    ]);
    const treeOf = (i: Id): Node => {
      let tree = made.get(i);
      if (tree) return tree;
      const op = OPS[graph.op[i]!]!;
      if (op === 'const') tree = number(graph.value[i]!);
      else if (place.has(i)) tree = number(p[place.get(i)!]!);
      else tree = node(operators[op] ?? op, ...operandsOf(i).map(treeOf));
      made.set(i, tree);
      return tree;
    };
    return roots.map(treeOf).filter((tree) => !tree.constant && tree !== made.get(time));
  };
}
