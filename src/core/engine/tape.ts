/**
 * The derivation's tape of a system (`accelerations.generated.json`, written by derivation/direct.py) and its functions as
 * WebAssembly: the same operations in the same order as in `accelerations.generated.ts`, and so the same bits.
 */
import type { Op, Tape } from '../model/tape.ts';
import { call, f64, get, i32, select, set, when, type Code, type Func } from './assembler.ts';
import { COSINE, HALF_PI, ROUNDER, SINE, TWO_OVER_PI } from '../elementary/trigonometry.ts';

const binary: Readonly<Record<string, (a: Code, b: Code) => Code>> = {
  add: f64.add,
  sub: f64.sub,
  mul: f64.mul,
  div: f64.div,
  lt: (a, b) => f64.convert(f64.lt(a, b)),
  le: (a, b) => f64.convert(f64.le(a, b)),
  eq: (a, b) => f64.convert(f64.eq(a, b)),
};

const unary: Readonly<Record<string, (a: Code) => Code>> = {
  neg: f64.neg,
  sqrt: f64.sqrt,
  abs: f64.abs,
  floor: f64.floor,
  ceil: f64.ceil,
};

/** A value that was not read for so many operations is read from memory: its register is another's by then. */
const FAR = 400;

/** Where a function finds what its values are made of: an entry of an array, or a value that is at hand. */
export interface Places {
  input(array: string, position: number): Code;
  known: ReadonlyMap<number, Code>;
  /** Functions that WebAssembly has no instruction for. */
  host?(name: string): Func | undefined;
  /** Address where a value may be kept. */
  home(position: number): number;
}

/**
 * Code that computes some values of a tape in a function, in the tape's order; each that is used more than once is kept in a
 * local and in memory.
 *
 * The memory is there for V8, which orders freely what has no effect: it took the operations level by level, with hundreds of
 * values waiting, and moved most of them to the stack and back. A store holds its place in the order, and so what it is made of; that
 * and FAR make a quarter less time of 1,900 operations (Node 20).
 *
 * @param func the function that computes
 * @param wanted positions of the values
 * @param places where values that are used more than once lie
 * @returns the code, by position the code that reads a value afterwards, and whether it lies at home
 */
export function compute(
  func: Func,
  { ops }: Pick<Tape, 'ops'>,
  wanted: readonly number[],
  places: Places,
): { code: Code; value(position: number): Code; kept(position: number): boolean } {
  const order = reached(ops, wanted, places.known);
  const uses = new Map<number, number>();
  const use = (i: number): unknown => uses.set(i, (uses.get(i) ?? 0) + 1);
  for (const i of order) argumentsOf(ops[i]!).forEach(use);
  wanted.forEach(use);
  const ready = new Map<number, Code>();
  /** Where a value can be read again, and where in the order it was last. */
  const homes = new Map<number, Code>();
  const read = new Map<number, number>();
  const angles = new Map<number, Angle>();
  const code: Code[] = [];
  let now = 0;
  const keep = (i: number, made: Code): void => {
    const local = func.local();
    code.push(set(local, made));
    ready.set(i, get(local));
    read.set(i, now);
  };
  const value = (i: number): Code => {
    const home = homes.get(i);
    if (home) {
      if (now - (read.get(i) ?? -Infinity) > FAR) keep(i, home);
      read.set(i, now);
    }
    return ready.get(i)!;
  };
  const findable = (i: number, made: Code): unknown =>
    uses.get(i) === 1 ? ready.set(i, made) : uses.has(i) && homes.set(i, made);
  for (const [i, made] of places.known) findable(i, made);
  for (const i of order) {
    now++;
    const [kind, first, second, third] = ops[i]!;
    if (kind === 'const') {
      ready.set(i, f64.const(first as number));
      continue;
    }
    if (kind === 'input') {
      findable(i, places.input(first as string, second!));
      continue;
    }
    let made: Code;
    if (kind === 'sin' || kind === 'cos') {
      let angle = angles.get(first as number);
      if (!angle) angles.set(first as number, (angle = sineAndCosine(func, value(first as number), code)));
      made = angle[kind];
    } else if (unary[kind]) made = unary[kind](value(first as number));
    else if (kind === 'select')
      made = select(value(second!), value(third!), f64.ne(value(first as number), f64.const(0)));
    else if (binary[kind]) made = binary[kind](value(first as number), value(second!));
    else if (places.host?.(kind)) made = call(places.host(kind)!, ...argumentsOf(ops[i]!).map(value));
    else throw new Error(`a tape for WebAssembly cannot hold the operation "${kind}"`);
    if (uses.get(i)! === 1 && kind !== 'sin' && kind !== 'cos') {
      ready.set(i, made);
      continue;
    }
    keep(i, made);
    const home = places.home(i);
    code.push(f64.store(i32.const(0), home, ready.get(i)!));
    homes.set(i, f64.load(i32.const(0), home));
  }
  return { code, value, kept: (i) => homes.has(i) };
}

interface Angle {
  sin: Code;
  cos: Code;
}

/** The statements of `block` and the choice of `chosen` in derivation/trigonometry.py. */
function sineAndCosine(func: Func, angle: Code, code: Code[]): Angle {
  const keep = (made: Code): Code => {
    const local = func.local();
    code.push(set(local, made));
    return get(local);
  };
  const { add, sub, mul } = f64;
  const along = (coefficients: readonly number[], z: Code): Code =>
    coefficients
      .slice(0, -1)
      .reduceRight<Code>((sum, c) => add(f64.const(c), mul(z, sum)), f64.const(coefficients.at(-1)!));
  const one = f64.const(1);
  const g = keep(angle);
  const k = keep(sub(add(mul(g, f64.const(TWO_OVER_PI)), f64.const(ROUNDER)), f64.const(ROUNDER)));
  const h = keep(sub(g, mul(k, f64.const(HALF_PI[0]))));
  const w = keep(mul(k, f64.const(HALF_PI[1])));
  const r = keep(sub(h, w));
  const t = keep(sub(sub(sub(h, r), w), mul(k, f64.const(HALF_PI[2]))));
  const z = keep(mul(r, r));
  const u = keep(mul(f64.const(0.5), z));
  const o = keep(sub(one, u));
  const q = keep(mul(z, mul(z, along(COSINE, z))));
  const s = keep(add(r, add(mul(mul(z, r), along(SINE, z)), mul(t, add(o, q)))));
  const c = keep(add(o, add(sub(sub(one, o), u), sub(q, mul(s, t)))));
  // The quadrant, k mod 4: exact for every k, as `k & 3` is.
  const n = keep(sub(k, mul(f64.const(4), f64.floor(mul(k, f64.const(0.25))))));
  const [sine, cosine] = [func.local(), func.local()];
  const choose = (sin: Code, cos: Code): Code => [set(sine, sin), set(cosine, cos)];
  const { neg, eq } = f64;
  // A branch each that is foretold nearly always costs less than choosing among values that have to be there.
  code.push(
    choose(s, c),
    when(
      f64.ne(n, f64.const(0)),
      when(eq(n, f64.const(2)), choose(neg(s), neg(c)), when(eq(n, one), choose(c, neg(s)), choose(neg(c), s))),
    ),
  );
  return { sin: get(sine), cos: get(cosine) };
}

/**
 * Positions of what values are made of, in order, not looking behind those that are known.
 *
 * @param ops the tape's operations
 * @param wanted positions
 * @param known by position
 */
export function reached(ops: readonly Op[], wanted: readonly number[], known: ReadonlyMap<number, unknown>): number[] {
  const seen = new Set<number>();
  const waiting = [...wanted];
  for (let i = waiting.pop(); i !== undefined; i = waiting.pop()) {
    if (seen.has(i) || known.has(i)) continue;
    seen.add(i);
    waiting.push(...argumentsOf(ops[i]!));
  }
  return [...seen].sort((a, b) => a - b);
}

function argumentsOf([kind, first, second, third]: Op): readonly number[] {
  if (kind === 'input' || kind === 'const') return [];
  if (third !== undefined) return [first as number, second!, third];
  return second === undefined ? [first as number] : [first as number, second];
}
