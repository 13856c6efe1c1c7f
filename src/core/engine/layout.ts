/**
 * Where the module that `program.ts` writes keeps its numbers, and the small things that its writers share.
 *
 * Symbols as in runge-kutta/tableau.ts; n coordinates, y = [q, v] of N = 2 n numbers.
 */
import type { EmbeddedTableau } from '../integrators/runge-kutta/tableau.ts';
import { HERMITE_TERMS } from '../integrators/shared/interpolation.ts';
import type { Tape, TapeSet } from '../model/tape.ts';
import type { f64x2 } from './assembler.ts';
import { branchIf, call, f64, get, i32, set, when, type Code, type Func } from './assembler.ts';

/** Of a number. */
export const BYTES = 8;

/** Steps that lie in the memory at once: those computed ahead, and the last one taken, which may still be looked into. */
export const PLACES = 17;

/** What a step's place tells of it, by position. */
export const TOLD = {
  /** When it ended, s; its length; that of the next to try. */
  end: 0,
  taken: 1,
  next: 2,
  /** What the controller remembers of its error. */
  error: 3,
  rejected: 4,
  /** The last of the factors at its end: the inverse of the determinant. */
  factor: 5,
  count: 8,
} as const;

/** Where arrays lie in the memory, in numbers (not bytes) from its start. */
export interface Layout {
  readonly constants: number;
  /** Generalized forces from outside, n. */
  readonly force: number;
  readonly factors: number;
  readonly lambda: number;
  readonly slip: number;
  readonly heights: number;
  readonly change: number;
  /** Result of `interpolate`, N. */
  readonly sample: number;
  /** Of a state that is no step's end, [v, a], N. */
  readonly rate: number;
  /** Coefficients of the dense output, N each. */
  readonly dense: number;
  /** Places for steps, one after another, `PLACES` of `place` numbers each: what `TOLD` names, then y0, y1 and the slopes, N each. */
  readonly steps: number;
  readonly place: number;
  /** One for every value of the tape. */
  readonly scratch: number;
  readonly size: number;
}

export interface Contact {
  /** Row of Omega of each height. */
  readonly rows: readonly number[];
}

export interface Kind {
  readonly tape: Tape;
  readonly set: TapeSet;
  readonly tableau: EmbeddedTableau;
  readonly contact: Contact | null;
  /** Coordinates. */
  readonly n: number;
  /** Forces act from outside: the host is asked for them before every evaluation. */
  readonly forced: boolean;
}

export function layoutOf({ tape, set, tableau, n }: Omit<Kind, 'contact' | 'forced'>): Layout {
  let size = 0;
  const take = (count: number): number => (size += count) - count;
  const N = 2 * n;
  const place = TOLD.count + (2 + tableau.A.length) * N;
  return {
    constants: take(tape.prepare.length),
    force: take(n),
    factors: take(set.factors.length),
    lambda: take(set.lambda.length),
    slip: take(set.slip.length),
    heights: take(set.heights.length),
    change: take(set.slip.length),
    sample: take(N),
    rate: take(N),
    dense: take((HERMITE_TERMS + tableau.dense.length) * N),
    scratch: take(tape.ops.length),
    steps: take(PLACES * place),
    place,
    size,
  };
}

/** Writers of a module's parts. */
export interface Parts {
  readonly kind: Kind;
  readonly layout: Layout;
  /** accelerations(y, rate) -> 1 or 0 */
  readonly accelerations: Func;
  /** force(t, y) of the host, where forces act. */
  readonly force: Func | null;
}

/** Distance of arrays within a step from its y0, bytes. */
export const y1Of = ({ n }: Kind): number => 2 * n * BYTES;
export const slopeOf = ({ n }: Kind, j: number): number => (2 + j) * 2 * n * BYTES;

/** The slope at the state at an address; leaves with `giveUp` where there is none. */
export const evaluate = ({ accelerations, force }: Parts, t: Code, at: Code, to: Code, giveUp: Code): Code => [
  force ? call(force, t, at) : [],
  when(i32.eqz(call(accelerations, at, to)), giveUp),
];

/** Weighted sum of slopes at the component that a pointer runs over, from the first to the last; with f64x2, of two of them. */
export const weighted = (
  kind: Kind,
  weights: readonly number[],
  p: number,
  of: typeof f64 | typeof f64x2 = f64,
): Code =>
  weights
    .map((w, j) => ({ w, j }))
    .filter(({ w }) => w !== 0)
    .map(({ w, j }) => of.mul(of.const(w), of.load(get(p), slopeOf(kind, j))))
    .reduce((total, term) => of.add(total, term));

/**
 * A body for each of `count` numbers from an address on, with the local `p` pointing at it.
 *
 * @param p number of the local
 * @param from the first address, bytes
 * @param count how many numbers
 * @param body code that uses the local
 * @param step numbers at once
 */
export function each(p: number, from: Code, count: number, body: Code, step = 1): Code {
  const left = count * BYTES;
  // The pointer runs; the end is told by its distance from the start, which is computed anew: V8 keeps it in a register.
  return [
    set(p, from),
    [0x03, 0x40],
    body,
    set(p, i32.add(get(p), i32.const(step * BYTES))),
    branchIf(0, i32.lt(get(p), i32.add(from, i32.const(left)))),
    0x0b,
  ];
}

/** The same for every two of them: y = [q, v] has always an even number. */
export const eachPair = (p: number, from: Code, count: number, body: Code): Code => each(p, from, count, body, 2);

export const load = (at: number): Code => f64.load(i32.const(0), at * BYTES);
export const store = (at: number, value: Code): Code => f64.store(i32.const(0), at * BYTES, value);

export const constantsOf = ({ prepare }: Tape, layout: Layout): ReadonlyMap<number, Code> =>
  new Map(prepare.map((i, k) => [i, load(layout.constants + k)]));

/**
 * @param array its name
 * @throws Error for a function on the tape that reads an array which is not there
 */
export function fail(array: string): never {
  throw new Error(`a function on the tape reads the array "${array}", which it does not have`);
}
