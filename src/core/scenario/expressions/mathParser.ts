// prettier-ignore
// @ts-expect-error: exported by mathjs, though its type declarations leave the factories out
import { createConditionalNode, createConstantNode, createFunctionNode, createNode, createOperatorNode, createParenthesisNode, createParse, createRelationalNode, createSymbolNode } from 'mathjs/number';

/**
 * mathjs' parser put together from its factories, without the rest of mathjs: `create` would bring its dispatch on types,
 * conversions and configuration, which are twice the size of the parser and do nothing for a text of numbers.
 */
export interface MathTree {
  type: string;
  toString(): string;
}

type NodeClass = new (...parts: never[]) => MathTree;
type Factory = (dependencies: Readonly<Record<string, unknown>>) => NodeClass;
type ParserFactory = (dependencies: Readonly<Record<string, unknown>>) => (text: string) => MathTree;

/** A kind of part that no expression may have: the parser can make it, and who walks the tree refuses it by its type. */
const refused = (type: string): NodeClass =>
  class {
    readonly type = type;

    toString(): string {
      return type;
    }
  };

/** `parse` is one function for text, lists and options; only its text is of use here. */
const textOnly = (_name: string, signatures: { string(text: string): MathTree }): ((text: string) => MathTree) =>
  signatures.string;

textOnly.addConversion = (): void => {};

function parser(): (text: string) => MathTree {
  const Node = (createNode as Factory)({ mathWithTransform: {} });
  const SymbolNode = (createSymbolNode as Factory)({ math: {}, Node });
  return (createParse as ParserFactory)({
    typed: textOnly,
    numeric: Number,
    config: { number: 'number', numberFallback: 'number' },
    SymbolNode,
    ConstantNode: (createConstantNode as Factory)({ Node, isBounded: Number.isFinite }),
    ParenthesisNode: (createParenthesisNode as Factory)({ Node }),
    OperatorNode: (createOperatorNode as Factory)({ Node }),
    FunctionNode: (createFunctionNode as Factory)({ math: {}, Node, SymbolNode }),
    ConditionalNode: (createConditionalNode as Factory)({ Node }),
    RelationalNode: (createRelationalNode as Factory)({ Node }),
    AccessorNode: refused('AccessorNode'),
    ArrayNode: refused('ArrayNode'),
    AssignmentNode: refused('AssignmentNode'),
    BlockNode: refused('BlockNode'),
    FunctionAssignmentNode: refused('FunctionAssignmentNode'),
    IndexNode: refused('IndexNode'),
    ObjectNode: refused('ObjectNode'),
    RangeNode: refused('RangeNode'),
  });
}

/** The tree of an expression. @throws SyntaxError with `(char n)` in its message, counted from 1 */
export const parseMath = parser();
