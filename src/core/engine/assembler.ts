/**
 * A writer of WebAssembly modules: instructions as nested lists of bytes, and the sections around them.
 *
 * WebAssembly Core Specification 2.0, chapter 5 (binary format); numbers in brackets name its sections. Only what this program
 * needs: numbers of type i32, f64 and f64x2, one memory, functions imported, kept or exported.
 *
 * An instruction stands with its operands as it is read: `f64.add(a, b)` is the code of a, that of b, and the opcode.
 */

/** Code: bytes, in any nesting. */
export type Code = readonly (number | Code)[];

export const I32 = 0x7f;
export const F64 = 0x7c;
export const F64X2 = 0x7b;
export type ValueType = typeof I32 | typeof F64 | typeof F64X2;

const NOTHING = 0x40;
const MAGIC = [0x00, 0x61, 0x73, 0x6d, 0x01, 0x00, 0x00, 0x00];

/**
 * An unsigned integer in LEB128 [5.2.2].
 *
 * @param value whole, 0 or more
 */
export function unsigned(value: number): number[] {
  const bytes: number[] = [];
  let rest = value;
  while (rest >= 0x80) {
    bytes.push((rest & 0x7f) | 0x80);
    rest >>>= 7;
  }
  bytes.push(rest);
  return bytes;
}

/** A signed integer of 32 bits in LEB128. */
function signed(value: number): number[] {
  const bytes: number[] = [];
  for (let rest = value | 0; ; rest >>= 7) {
    const byte = rest & 0x7f;
    const last = (rest >> 6 === 0 && byte < 0x40) || (rest >> 6 === -1 && byte >= 0x40);
    bytes.push(last ? byte : byte | 0x80);
    if (last) return bytes;
  }
}

function bytesOf(value: number): number[] {
  return [...new Uint8Array(Float64Array.of(value).buffer)];
}

const one =
  (opcode: number) =>
  (a: Code): Code => [a, opcode];
const two =
  (opcode: number) =>
  (a: Code, b: Code): Code => [a, b, opcode];

/** Numeric instructions of doubles [5.4.7]; memory is addressed in bytes, eight to a number. */
export const f64 = {
  const: (value: number): Code => [0x44, bytesOf(value)],
  /** @param address of type i32 */
  load: (address: Code, offset = 0): Code => [address, 0x2b, 3, unsigned(offset)],
  store: (address: Code, offset: number, value: Code): Code => [address, value, 0x39, 3, unsigned(offset)],
  eq: two(0x61),
  ne: two(0x62),
  lt: two(0x63),
  gt: two(0x64),
  le: two(0x65),
  ge: two(0x66),
  abs: one(0x99),
  neg: one(0x9a),
  ceil: one(0x9b),
  floor: one(0x9c),
  sqrt: one(0x9f),
  add: two(0xa0),
  sub: two(0xa1),
  mul: two(0xa2),
  div: two(0xa3),
  min: two(0xa4),
  max: two(0xa5),
  /** From a truth, i32. */
  convert: one(0xb7),
};

const pair =
  (opcode: number) =>
  (a: Code, b: Code): Code => [a, b, 0xfd, unsigned(opcode)];

/** Two doubles at once, each as the instruction of `f64` does it [5.4.8]. */
export const f64x2 = {
  const: (value: number): Code => [0xfd, 0x0c, bytesOf(value), bytesOf(value)],
  splat: (a: Code): Code => [a, 0xfd, 0x14],
  load: (address: Code, offset = 0): Code => [address, 0xfd, 0x00, 3, unsigned(offset)],
  store: (address: Code, offset: number, value: Code): Code => [address, value, 0xfd, 0x0b, 3, unsigned(offset)],
  add: pair(0xf0),
  sub: pair(0xf1),
  mul: pair(0xf2),
};

export const i32 = {
  const: (value: number): Code => [0x41, signed(value)],
  eqz: one(0x45),
  lt: two(0x48),
  ge: two(0x4e),
  add: two(0x6a),
  sub: two(0x6b),
  and: two(0x71),
  or: two(0x72),
};

export const get = (local: number): Code => [0x20, unsigned(local)];
export const set = (local: number, value: Code): Code => [value, 0x21, unsigned(local)];
/** a where the condition is not 0, else b; both are computed. */
export const select = (a: Code, b: Code, condition: Code): Code => [a, b, condition, 0x1b];
export const call = (func: Func, ...operands: Code[]): Code => [operands, 0x10, unsigned(func.index)];
export const giveBack = (value: Code): Code => [value, 0x0f];
export const when = (condition: Code, then: Code, otherwise?: Code): Code => [
  condition,
  [0x04, NOTHING],
  then,
  otherwise ? [0x05, otherwise] : [],
  0x0b,
];
/** Again and again; `leave` and `again` count the blocks from within: 1 leaves it, 0 repeats it. */
export const forever = (body: Code): Code => [[0x02, NOTHING], [0x03, NOTHING], body, [0x0c, 0], 0x0b, 0x0b];
export const branchIf = (depth: number, condition: Code): Code => [condition, 0x0d, unsigned(depth)];

/** A function: its locals are numbered from its parameters on. */
export class Func {
  readonly index: number;
  readonly parameters: readonly ValueType[];
  readonly results: readonly ValueType[];
  readonly locals: ValueType[] = [];
  body: Code = [];

  constructor(index: number, parameters: readonly ValueType[], results: readonly ValueType[]) {
    this.index = index;
    this.parameters = parameters;
    this.results = results;
  }

  /** A new local. @returns its number */
  local(type: ValueType = F64): number {
    return this.parameters.length + this.locals.push(type) - 1;
  }
}

/** A module with one memory, which it exports as `memory`. Imports come before everything else. */
export class Module {
  private readonly imports: { name: string; func: Func }[] = [];
  private readonly functions: Func[] = [];
  private readonly exports: { name: string; index: number }[] = [];

  /** A function of the host, `host.<name>`. */
  imported(name: string, parameters: readonly ValueType[], results: readonly ValueType[]): Func {
    const func = new Func(this.imports.length, parameters, results);
    this.imports.push({ name, func });
    return func;
  }

  /** A function whose `body` is set afterwards. @param name under which it is exported */
  func(parameters: readonly ValueType[], results: readonly ValueType[], name?: string): Func {
    const func = new Func(this.imports.length + this.functions.length, parameters, results);
    this.functions.push(func);
    if (name) this.exports.push({ name, index: func.index });
    return func;
  }

  /** The module's bytes. @param memory its size in bytes */
  bytes(memory: number): Uint8Array<ArrayBuffer> {
    const all = [...this.imports.map(({ func }) => func), ...this.functions];
    const types = all.map((f) => [0x60, vector(f.parameters.map((t) => [t])), vector(f.results.map((t) => [t]))]);
    const code: Code = [
      MAGIC,
      section(1, vector(types)),
      section(2, vector(this.imports.map(({ name, func }) => [text('host'), text(name), 0x00, unsigned(func.index)]))),
      section(3, vector(this.functions.map((f) => unsigned(f.index)))),
      section(5, vector([[0x00, unsigned(Math.ceil(memory / 65536))]])),
      section(
        7,
        vector([
          [text('memory'), 0x02, 0x00],
          ...this.exports.map(({ name, index }) => [text(name), 0x00, unsigned(index)]),
        ]),
      ),
      section(10, vector(this.functions.map((f) => sized([vector(f.locals.map((type) => [1, type])), f.body, 0x0b])))),
    ];
    return Uint8Array.from(flat(code));
  }
}

function flat(code: Code, out: number[] = []): number[] {
  for (const part of code) {
    if (typeof part === 'number') out.push(part);
    else flat(part, out);
  }
  return out;
}

const vector = (items: readonly Code[]): Code => [unsigned(items.length), items];
const text = (name: string): Code => vector([...name].map((letter) => [letter.charCodeAt(0)]));
function sized(code: Code): Code {
  const bytes = flat(code);
  return [unsigned(bytes.length), bytes];
}
const section = (id: number, content: Code): Code => [id, sized(content)];
