/**
 * Functions of arrays from nodes of a graph: a tape that is interpreted, and WebAssembly of the same operations where the
 * function is called often and the host compiles it. Both give the same bits (docs/decisions/0021-engines.md).
 */
import { f64, i32, Module } from '../engine/assembler.ts';
import { compiles, HOST_FUNCTIONS, importsFor, instantiate } from '../engine/host.ts';
import { compute } from '../engine/tape.ts';
import { cosine, sine } from '../elementary/trigonometry.ts';
import type { Op } from '../model/tape.ts';
import { code, OPS, type Graph, type Id } from './graph.ts';

/** Arrays by name: each entry of an input is a node whose value is given, each of an output one that is wanted. */
export type Arrays = Readonly<Record<string, readonly Id[]>>;

/** Calls after which it pays to compile. */
const WARM = 8;
/** Operations beyond which no host compiles one function well. */
const MOST_COMPILED = 45_000;

/** Calls with the input arrays, then the output arrays, in the order in which they were named. */
export type Call = (...arrays: Float64Array[]) => void;

export class Program {
  readonly operations: number;
  readonly inputs: readonly Id[][];
  readonly outputs: readonly Id[][];
  private readonly graph: Graph;
  private readonly order: readonly Id[];
  /** Operation, place of the result, places of its operands; five numbers each. */
  readonly tape: Int32Array;
  /** Inputs in their order, then numbers and results. */
  readonly memory: Float64Array;
  /** Of each output. */
  readonly places: readonly Int32Array[];

  constructor(graph: Graph, inputs: Arrays, outputs: Arrays) {
    this.graph = graph;
    this.inputs = Object.values(inputs).map((ids) => [...ids]);
    this.outputs = Object.values(outputs).map((ids) => [...ids]);
    const given = new Map<Id, number>();
    let size = 0;
    // An array has its place whether it is read or not; the first place of a node is the one that is read.
    for (const ids of this.inputs)
      for (const id of ids) {
        if (!given.has(id)) given.set(id, size);
        size++;
      }
    const order: Id[] = (this.order = needed(graph, this.outputs.flat(), given));
    const place = new Map(given);
    const numbers: [number, number][] = [];
    const steps: number[] = [];
    const at = (id: Id): number => (id < 0 ? 0 : place.get(id)!);
    for (const id of order) {
      place.set(id, size);
      if (graph.op[id] === code.const) numbers.push([size, graph.value[id]!]);
      else steps.push(graph.op[id]!, size, at(graph.a[id]!), at(graph.b[id]!), at(graph.c[id]!));
      size++;
    }
    this.tape = Int32Array.from(steps);
    this.operations = steps.length / 5;
    this.memory = new Float64Array(size);
    for (const [k, x] of numbers) this.memory[k] = x;
    this.places = this.outputs.map((ids) => Int32Array.from(ids, at));
  }

  /** A function that is interpreted: for a few calls, and where nothing may be compiled. It holds no graph. */
  interpreted(): Call {
    const { memory, tape, places } = this;
    const starts: number[] = [];
    let size = 0;
    for (const ids of this.inputs) {
      starts.push(size);
      size += ids.length;
    }
    return (...arrays) => {
      for (let k = 0; k < starts.length; k++) memory.set(arrays[k]!, starts[k]);
      interpret(tape, memory);
      for (let k = 0; k < places.length; k++) {
        const [out, place] = [arrays[starts.length + k]!, places[k]!];
        for (let i = 0; i < place.length; i++) out[i] = memory[place[i]!]!;
      }
    };
  }

  /** A function that is compiled once it has been called a few times. */
  tiered(): Call {
    let call = this.interpreted();
    let calls = 0;
    return (...arrays) => {
      if (++calls === WARM) call = this.compiled() ?? call;
      call(...arrays);
    };
  }

  /** Null where the host compiles nothing, or not this. */
  compiled(): Call | null {
    if (this.operations > MOST_COMPILED || !compiles()) return null;
    const { memory: shared, run } = instantiate(this.bytes()) as { memory: { buffer: ArrayBuffer }; run(): void };
    const memory = new Float64Array(shared.buffer);
    let size = 0;
    const views = [...this.inputs, ...this.outputs].map((ids) => {
      const view = memory.subarray(size, size + ids.length);
      size += ids.length;
      return view;
    });
    this.outputs.forEach((ids, k) =>
      ids.forEach((id, i) => {
        if (this.graph.isNumber(id)) views[this.inputs.length + k]![i] = this.graph.value[id]!;
      }),
    );
    const count = this.inputs.length;
    return (...arrays) => {
      for (let k = 0; k < count; k++) views[k]!.set(arrays[k]!);
      run();
      for (let k = count; k < views.length; k++) arrays[k]!.set(views[k]!);
    };
  }

  private bytes(): Uint8Array<ArrayBuffer> {
    const { graph, order } = this;
    const ops: Op[] = [];
    const place = new Map<Id, number>();
    let size = 0;
    const addresses: number[] = [];
    for (const ids of this.inputs)
      for (const id of ids) {
        if (!place.has(id)) {
          place.set(id, ops.length);
          ops.push(['input', 'in', size]);
        }
        size++;
      }
    for (const id of order) {
      place.set(id, ops.length);
      ops.push(opOf(graph, id, place));
    }
    const module = new Module();
    const imports = importsFor(module, ops);
    const func = module.func([], [], 'run');
    const wanted: number[] = [];
    for (const ids of this.outputs)
      for (const id of ids) {
        if (!graph.isNumber(id)) {
          wanted.push(place.get(id)!);
          addresses.push(size);
        }
        size++;
      }
    const { code: body, value } = compute(func, { ops }, wanted, {
      input: (_array, position) => f64.load(i32.const(0), 8 * position),
      known: new Map(),
      host: (name) => imports.get(name),
      home: (position) => 8 * (size + position),
    });
    func.body = [body, wanted.map((position, k) => f64.store(i32.const(0), 8 * addresses[k]!, value(position)))];
    return module.bytes(8 * (size + ops.length));
  }
}

/**
 * One node as an operation of a tape.
 *
 * @param graph that holds the nodes
 * @param id of the node
 * @param place of what it is made of
 */
export function opOf(graph: Graph, id: Id, place: ReadonlyMap<Id, number>): Op {
  const name = OPS[graph.op[id]!]!;
  if (name === 'const') return ['const', graph.value[id]!];
  const [a, b, c] = [graph.a[id]!, graph.b[id]!, graph.c[id]!];
  if (c >= 0) return [name, place.get(a)!, place.get(b)!, place.get(c)!];
  return b >= 0 ? [name, place.get(a)!, place.get(b)!] : [name, place.get(a)!];
}

/**
 * Nodes that have to be computed or are numbers, in order, not looking behind those that are given.
 *
 * @param graph that holds the nodes
 * @param wanted nodes
 * @param given nodes whose values are there
 */
export function needed(graph: Graph, wanted: readonly Id[], given: ReadonlyMap<Id, unknown>): Id[] {
  const seen = new Set<Id>();
  const waiting = [...wanted];
  for (let id = waiting.pop(); id !== undefined; id = waiting.pop()) {
    if (seen.has(id) || given.has(id)) continue;
    if (graph.op[id] === code.input) throw new Error('a function needs an input that it is not given');
    seen.add(id);
    for (const x of [graph.a[id]!, graph.b[id]!, graph.c[id]!]) if (x >= 0) waiting.push(x);
  }
  return [...seen].sort((a, b) => a - b);
}

function interpret(tape: Int32Array, m: Float64Array): void {
  for (let k = 0; k < tape.length; k += 5) m[tape[k + 1]!] = evaluateOne(tape, k, m);
}

/**
 * The result of the operation that begins at k.
 *
 * @param tape five whole numbers an operation
 * @param k where the operation begins
 * @param m values by place
 */
export function evaluateOne(tape: Int32Array, k: number, m: Float64Array): number {
  const a = m[tape[k + 2]!]!;
  const b = m[tape[k + 3]!]!;
  switch (tape[k]) {
    case code.add:
      return a + b;
    case code.sub:
      return a - b;
    case code.mul:
      return a * b;
    case code.div:
      return a / b;
    case code.neg:
      return -a;
    case code.sin:
      return sine(a);
    case code.cos:
      return cosine(a);
    default:
      return seldom(tape[k]!, a, b, m[tape[k + 4]!]!);
  }
}

function seldom(op: number, a: number, b: number, c: number): number {
  switch (op) {
    case code.sqrt:
      return Math.sqrt(a);
    case code.abs:
      return Math.abs(a);
    case code.floor:
      return Math.floor(a);
    case code.ceil:
      return Math.ceil(a);
    case code.lt:
      return Number(a < b);
    case code.le:
      return Number(a <= b);
    case code.eq:
      return Number(a === b);
    case code.select:
      return a !== 0 ? b : c;
    default:
      return HOST_FUNCTIONS[OPS[op]!]!(a, b);
  }
}
