// @ts-expect-error: exported by mathjs, though its type declarations leave the factories out
import { createParse } from 'mathjs/number';

/**
 * mathjs' parser alone. The rest of mathjs is many times the parser: `create` brings its dispatch on types, conversions
 * and configuration, its own nodes bring compilation, LaTeX and formats of numbers. A text of numbers needs a tree to
 * walk and its text for messages, so the nodes are the plain ones below.
 */
export interface MathTree {
  type: string;
  toString(): string;
}

type ParserFactory = (dependencies: Readonly<Record<string, unknown>>) => (text: string) => MathTree;

/** Marked as the parser looks for it: `isNode` on the prototype, `is<Type>` on the node. */
abstract class Node {
  abstract readonly type: string;

  get isNode(): true {
    return true;
  }
}

class ConstantNode extends Node {
  readonly type = 'ConstantNode';
  readonly isConstantNode = true;

  constructor(readonly value: unknown) {
    super();
  }

  override toString(): string {
    return String(this.value);
  }
}

class SymbolNode extends Node {
  readonly type = 'SymbolNode';
  readonly isSymbolNode = true;

  constructor(readonly name: string) {
    super();
  }

  override toString(): string {
    return this.name;
  }
}

class ParenthesisNode extends Node {
  readonly type = 'ParenthesisNode';

  constructor(readonly content: Node) {
    super();
  }

  override toString(): string {
    return `(${this.content})`;
  }
}

class OperatorNode extends Node {
  readonly type = 'OperatorNode';
  readonly isOperatorNode = true;

  constructor(
    readonly op: string,
    readonly fn: string,
    readonly args: readonly Node[],
    readonly implicit = false,
    readonly isPercentage = false,
  ) {
    super();
  }

  override toString(): string {
    const [first, second] = this.args;
    if (second === undefined) return `${this.op}${first}`;
    return this.implicit ? `${first} ${second}` : `${first} ${this.op} ${second}`;
  }
}

class FunctionNode extends Node {
  readonly type = 'FunctionNode';
  readonly isFunctionNode = true;

  constructor(
    readonly fn: Node,
    readonly args: readonly Node[],
  ) {
    super();
  }

  override toString(): string {
    return `${this.fn}(${this.args.join(', ')})`;
  }
}

class ConditionalNode extends Node {
  readonly type = 'ConditionalNode';

  constructor(
    readonly condition: Node,
    readonly trueExpr: Node,
    readonly falseExpr: Node,
  ) {
    super();
  }

  override toString(): string {
    return `${this.condition} ? ${this.trueExpr} : ${this.falseExpr}`;
  }
}

const SIGNS: Readonly<Record<string, string>> = {
  smaller: '<',
  smallerEq: '<=',
  larger: '>',
  largerEq: '>=',
  equal: '==',
  unequal: '!=',
};

class RelationalNode extends Node {
  readonly type = 'RelationalNode';

  constructor(
    readonly conditionals: readonly string[],
    readonly params: readonly Node[],
  ) {
    super();
  }

  override toString(): string {
    return this.params.map((part, i) => (i === 0 ? part : `${SIGNS[this.conditionals[i - 1]!]} ${part}`)).join(' ');
  }
}

/** A kind of part that no expression may have: the parser can make it, and who walks the tree refuses it by its type. */
const refused = (type: string): new () => Node =>
  class extends Node {
    readonly type = type;

    override toString(): string {
      return type;
    }
  };

/** `parse` is one function for text, lists and options; only its text is of use here. */
const textOnly = (_name: string, signatures: { string(text: string): MathTree }): ((text: string) => MathTree) =>
  signatures.string;

textOnly.addConversion = (): void => {};

/** The tree of an expression. @throws SyntaxError with `(char n)` in its message, counted from 1 */
export const parseMath = (createParse as ParserFactory)({
  typed: textOnly,
  numeric: Number,
  config: { number: 'number', numberFallback: 'number' },
  SymbolNode,
  ConstantNode,
  ParenthesisNode,
  OperatorNode,
  FunctionNode,
  ConditionalNode,
  RelationalNode,
  AccessorNode: refused('AccessorNode'),
  ArrayNode: refused('ArrayNode'),
  AssignmentNode: refused('AssignmentNode'),
  BlockNode: refused('BlockNode'),
  FunctionAssignmentNode: refused('FunctionAssignmentNode'),
  IndexNode: refused('IndexNode'),
  ObjectNode: refused('ObjectNode'),
  RangeNode: refused('RangeNode'),
});
