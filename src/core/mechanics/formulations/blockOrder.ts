/**
 * Block lower triangular ordering of a square system from its incidence alone.
 *
 * Matching by augmenting paths: I. S. Duff, "On algorithms for obtaining a maximum transversal", ACM Trans. Math.
 * Softw. 7 (1981). Blocks: R. Tarjan, "Depth-first search and linear graph algorithms", SIAM J. Comput. 1 (1972), as
 * in I. S. Duff, J. K. Reid, "An implementation of Tarjan's algorithm for the block triangularization of a matrix",
 * ACM Trans. Math. Softw. 4 (1978) 137-147. For models made of equations: Cellier and Kofman, Continuous System
 * Simulation, Springer 2006, chapter 7.
 */

/** Equations and as many unknowns that are solved together. */
export interface Block {
  equations: readonly number[];
  unknowns: readonly number[];
}

/**
 * @param incidence `incidence[i]`: the unknowns that occur in equation i
 * @returns blocks in the order in which they can be solved, or null when no choice of an unknown of its own for
 * every equation exists: then the system is singular whatever its numbers
 */
export function blockOrder(incidence: readonly (readonly number[])[]): Block[] | null {
  const equationOf = matching(incidence);
  if (!equationOf) return null;
  const unknownOf = new Array<number>(incidence.length);
  equationOf.forEach((equation, unknown) => (unknownOf[equation] = unknown));
  const needs = incidence.map((unknowns) => unknowns.map((u) => equationOf[u]!));
  return components(needs).map((group) => {
    const equations = group.sort((a, b) => a - b);
    return { equations, unknowns: equations.map((i) => unknownOf[i]!).sort((a, b) => a - b) };
  });
}

/** For every unknown the equation that is matched to it. */
function matching(incidence: readonly (readonly number[])[]): number[] | null {
  const equationOf = new Array<number>(incidence.length).fill(-1);
  const augment = (equation: number, seen: Set<number>): boolean => {
    for (const unknown of incidence[equation]!) {
      if (seen.has(unknown)) continue;
      seen.add(unknown);
      if (equationOf[unknown]! < 0 || augment(equationOf[unknown]!, seen)) {
        equationOf[unknown] = equation;
        return true;
      }
    }
    return false;
  };
  return incidence.every((_, equation) => augment(equation, new Set())) ? equationOf : null;
}

/** Strongly connected components; each comes after all those it needs. */
function components(needs: readonly (readonly number[])[]): number[][] {
  const order = new Array<number>(needs.length).fill(-1);
  const low = new Array<number>(needs.length).fill(0);
  const stack: number[] = [];
  const onStack = new Set<number>();
  const found: number[][] = [];
  let next = 0;
  const visit = (node: number): void => {
    order[node] = low[node] = next++;
    stack.push(node);
    onStack.add(node);
    for (const other of needs[node]!) {
      if (order[other]! < 0) {
        visit(other);
        low[node] = Math.min(low[node]!, low[other]!);
      } else if (onStack.has(other)) low[node] = Math.min(low[node]!, order[other]!);
    }
    if (low[node] !== order[node]) return;
    const group = stack.splice(stack.indexOf(node));
    for (const member of group) onStack.delete(member);
    found.push(group);
  };
  needs.forEach((_, node) => {
    if (order[node]! < 0) visit(node);
  });
  return found;
}
