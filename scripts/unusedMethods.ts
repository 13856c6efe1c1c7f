// Methods that a library's classes have and nobody calls. A bundler keeps them, because it cannot know that no `x[name]`
// asks for them; of three.js they are a fifth. Here a method goes when its name is written nowhere else: neither in what
// of the library is taken, nor in what takes it. Whoever writes the name, even in a string, keeps the method.
import { parseAst } from 'rolldown/parseAst';

interface Node {
  type: string;
  start: number;
  end: number;
  [field: string]: unknown;
}

/** A method, or a function given to `this.name` by a constructor: where it stands. */
interface Method {
  name: string;
  start: number;
  end: number;
}

/** What is called without being named. */
const CALLED_UNSEEN = new Set(['constructor', 'toString', 'valueOf', 'then', 'handleEvent']);

const isNode = (value: unknown): value is Node => typeof (value as Node | null)?.type === 'string';

function* children(node: Node): Generator<Node> {
  for (const value of Object.values(node)) {
    if (isNode(value)) yield value;
    else if (Array.isArray(value)) yield* value.filter(isNode);
  }
}

const wordsOf = (text: string): readonly string[] => text.match(/[\p{L}_$][\p{L}\p{N}_$]*/gu) ?? [];

/** `this.name = function` or, where the function stands elsewhere in the constructor, `this.name = name`. */
function given(node: Node): string | null {
  const { expression } = node as { expression?: Node };
  if (node.type !== 'ExpressionStatement' || expression?.type !== 'AssignmentExpression') return null;
  const { left, right, operator } = expression as unknown as { left: Node; right: Node; operator: string };
  const { object, property, computed } = left as unknown as { object?: Node; property?: Node; computed?: boolean };
  if (operator !== '=' || object?.type !== 'ThisExpression' || computed || property?.type !== 'Identifier') return null;
  const name = property['name'] as string;
  return right.type === 'FunctionExpression' || (right.type === 'Identifier' && right['name'] === name) ? name : null;
}

function methodOf(node: Node): string | null {
  if (node.type !== 'MethodDefinition' || node['computed']) return given(node);
  const key = node['key'] as Node;
  return key.type === 'Identifier' ? (key['name'] as string) : null;
}

/** Reads a script: its methods, and every place where a word stands that could name one. */
function read(code: string): { methods: Method[]; uses: { word: string; at: number }[] } {
  const methods: Method[] = [];
  const uses: { word: string; at: number }[] = [];
  const use = (text: unknown, at: number): void => {
    if (typeof text === 'string') for (const word of wordsOf(text)) uses.push({ word, at });
  };
  const visit = (node: Node): void => {
    const name = methodOf(node);
    if (name !== null) methods.push({ name, start: node.start, end: node.end });
    const { property, key, expression } = node as Record<string, Node | undefined>;
    if (node.type === 'MemberExpression' && !node['computed']) use(property!['name'], node.start);
    else if (node.type === 'Property' && !node['computed']) use(key!['name'] ?? key!['value'], node.start);
    else if (node.type === 'Literal') use(node['value'], node.start);
    else if (node.type === 'TemplateElement') use((node['value'] as { raw: string }).raw, node.start);
    for (const child of children(node)) {
      // What a constructor gives itself is no use of the name; what it gives is looked through.
      if (name !== null && child === expression) visit(child['right'] as Node);
      else visit(child);
    }
  };
  visit(parseAst(code) as unknown as Node);
  return { methods, uses };
}

/**
 * Takes out the methods that nothing names.
 *
 * @param library its scripts that are taken, by path
 * @param users texts of what takes them: every word in them counts as a name
 * @returns the scripts without these methods, and the names of what went, by path
 */
export function withoutUnused(
  library: ReadonlyMap<string, string>,
  users: Iterable<string>,
): ReadonlyMap<string, { code: string; gone: readonly string[] }> {
  const named = new Set<string>(CALLED_UNSEEN);
  for (const text of users) for (const word of wordsOf(text)) named.add(word);
  const scripts = [...library].map(([path, code]) => ({ path, code, ...read(code) }));
  /** Words by the method, the innermost, that they stand in: they count as soon as it is kept itself. */
  const waiting = new Map<Method, Set<string>>();
  const methods = scripts.flatMap((script) => script.methods);
  for (const script of scripts) {
    for (const method of script.methods) waiting.set(method, new Set());
    for (const { word, at } of script.uses) {
      const within = script.methods.filter(({ start, end }) => at >= start && at < end);
      const holder = within.sort((a, b) => b.start - a.start)[0];
      if (holder) waiting.get(holder)!.add(word);
      else named.add(word);
    }
  }
  const kept = new Set<Method>();
  for (let grew = true; grew;) {
    const before = kept.size;
    for (const method of methods) {
      if (kept.has(method) || !named.has(method.name)) continue;
      kept.add(method);
      for (const word of waiting.get(method)!) named.add(word);
    }
    grew = kept.size > before;
  }
  return new Map(
    scripts.map(({ path, code, methods: all }) => {
      const gone = all.filter((method) => !kept.has(method));
      return [path, { code: cut(code, gone), gone: gone.map(({ name }) => name) }];
    }),
  );
}

function cut(code: string, gone: readonly Method[]): string {
  let [out, from] = ['', 0];
  for (const { start, end } of [...gone].sort((a, b) => a.start - b.start)) {
    if (start < from) continue; // within one that went
    out += code.slice(from, start);
    from = end;
  }
  return out + code.slice(from);
}
