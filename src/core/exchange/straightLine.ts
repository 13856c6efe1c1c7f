/**
 * A graph of expressions as lines of a programming language: what is used once is written where it is used, what is used more
 * often gets a name. Only the parentheses that are needed.
 */
import { OPS, type Graph, type Id, type OpName } from '../description/graph.ts';
import { needed } from '../description/program.ts';

/** How a language writes what no two of them write alike. */
export interface Syntax {
  number(x: number): string;
  /** A function of one or two operands. */
  call(name: OpName, operands: readonly string[]): string;
  /** 1 where it is true, else 0. */
  truth(condition: string): string;
  /** `condition` is a comparison, or a number that is not 0. */
  select(condition: string, yes: string, no: string): string;
  /** Of a number, whether it is not 0. */
  isTrue(x: string): string;
}

export interface Line {
  name: string;
  text: string;
}

/** A name for what is used more than once, and for what would make a line longer than this. */
const LONGEST = 96;
const SUM = 1;
const PRODUCT = 2;
const ATOM = 3;

const COMPARISONS: Partial<Record<OpName, string>> = { lt: '<', le: '<=', eq: '==' };

interface Written {
  text: string;
  level: number;
}

/**
 * Lines that compute expressions, in order, and what to write for each of them afterwards.
 *
 * @param graph that holds the nodes
 * @param wanted nodes
 * @param given what to write for the variables
 * @param prefix of names that are made: `w` gives w1, w2, …
 * @param syntax of the language
 */
export function straightLine(
  graph: Graph,
  wanted: readonly Id[],
  given: ReadonlyMap<Id, string>,
  prefix: string,
  syntax: Syntax,
): { lines: Line[]; of: (id: Id) => string } {
  const order = needed(graph, wanted, given);
  const uses = new Map<Id, number>();
  const use = (id: Id): void => void uses.set(id, (uses.get(id) ?? 0) + 1);
  for (const id of order) for (const x of [graph.a[id]!, graph.b[id]!, graph.c[id]!]) if (x >= 0) use(x);
  wanted.forEach(use);
  const written = new Map<Id, Written>([...given].map(([id, text]) => [id, { text, level: ATOM }]));
  const lines: Line[] = [];
  for (const id of order) {
    const one = write(graph, id, written, syntax);
    const simple = one.level === ATOM || graph.isNumber(id);
    if (simple || (uses.get(id) === 1 && one.text.length <= LONGEST)) {
      written.set(id, one);
      // A function is worth a name where it is used twice.
      if (graph.isNumber(id) || uses.get(id) === 1) continue;
    }
    const name = `${prefix}${lines.length + 1}`;
    lines.push({ name, text: one.text });
    written.set(id, { text: name, level: ATOM });
  }
  return { lines, of: (id) => written.get(id)!.text };
}

function write(graph: Graph, id: Id, written: ReadonlyMap<Id, Written>, syntax: Syntax): Written {
  const name = OPS[graph.op[id]!]!;
  if (name === 'const') {
    const x = graph.value[id]!;
    return { text: syntax.number(x), level: x < 0 ? SUM : ATOM };
  }
  const operands = [graph.a[id]!, graph.b[id]!, graph.c[id]!].filter((x) => x >= 0);
  const at = (k: number, least: number): string => {
    const { text, level } = written.get(operands[k]!)!;
    return level < least ? `(${text})` : text;
  };
  switch (name) {
    case 'add':
      return { text: `${at(0, SUM)} + ${at(1, PRODUCT)}`, level: SUM };
    case 'sub':
      return { text: `${at(0, SUM)} - ${at(1, PRODUCT)}`, level: SUM };
    case 'mul':
      return operands[0] === operands[1]
        ? { text: `${at(0, ATOM)}*${at(0, ATOM)}`, level: PRODUCT }
        : { text: `${at(0, PRODUCT)}*${at(1, ATOM)}`, level: PRODUCT };
    case 'div':
      return { text: `${at(0, PRODUCT)}/${at(1, ATOM)}`, level: PRODUCT };
    case 'neg':
      return { text: `-${at(0, ATOM)}`, level: SUM };
    case 'lt':
    case 'le':
    case 'eq':
      return { text: syntax.truth(comparison(graph, id, written)!), level: ATOM };
    case 'select': {
      const condition = comparison(graph, operands[0]!, written) ?? syntax.isTrue(at(0, SUM));
      return { text: syntax.select(condition, at(1, SUM), at(2, SUM)), level: ATOM };
    }
    default:
      return {
        text: syntax.call(
          name,
          operands.map((_, k) => at(k, SUM)),
        ),
        level: ATOM,
      };
  }
}

/** A comparison as a condition; null where the node is none. */
function comparison(graph: Graph, id: Id, written: ReadonlyMap<Id, Written>): string | null {
  const sign = COMPARISONS[OPS[graph.op[id]!]!];
  return sign === undefined ? null : `${written.get(graph.a[id]!)!.text} ${sign} ${written.get(graph.b[id]!)!.text}`;
}
