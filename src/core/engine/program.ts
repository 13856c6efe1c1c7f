/**
 * A whole attempt of a step of an embedded Runge-Kutta pair as one WebAssembly module: slopes, error norm, projection on the
 * constraints and dense output, operation by operation as EmbeddedRungeKutta, DirectAccelerations and Projection do it, so
 * that both give the same bits. Where anything has no value the attempt says so, and they do it over.
 *
 * Symbols as in runge-kutta/tableau.ts; n coordinates, y = [q, v] of N = 2 n numbers.
 */
import type { EmbeddedTableau } from '../integrators/runge-kutta/tableau.ts';
import { HERMITE_TERMS } from '../integrators/shared/interpolation.ts';
import type { Tape, TapeSet } from '../model/tape.ts';
import { HEIGHT_GOAL, MOST_ITERATIONS, ROUNDING, VELOCITY_GOAL } from '../mechanics/projection.ts';
import {
  branchIf,
  call,
  f64,
  F64,
  forever,
  get,
  giveBack,
  i32,
  I32,
  Module,
  set,
  when,
  type Code,
  type Func,
} from './assembler.ts';
import { compute, type Places } from './tape.ts';

const BYTES = 8;

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
  /** Coefficients of the dense output, N each. */
  readonly dense: number;
  /** Two places for a step, one for the last accepted and one for that being tried; in each y0, y1 and the slopes, N each. */
  readonly steps: readonly [number, number];
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
  const step = (2 + tableau.A.length) * N;
  return {
    constants: take(tape.prepare.length),
    force: take(n),
    factors: take(set.factors.length),
    lambda: take(set.lambda.length),
    slip: take(set.slip.length),
    heights: take(set.heights.length),
    change: take(set.slip.length),
    sample: take(N),
    dense: take((HERMITE_TERMS + tableau.dense.length) * N),
    steps: [take(step), take(step)],
    size,
  };
}

/**
 * The module. It imports `host.force(t, y)` where forces act, and exports
 *
 *     accelerations(y, rate) -> 1 or 0                  at a state at an address, [v, a] to another
 *     attempt(step, t, h, rtol, atol, projecting)       scaled error of a step from its y0 and k_1; NaN where it has none
 *     makeDense(step, t, h) -> 1 or 0                   coefficients of its dense output
 *     interpolate(step, s)                              at a fraction of it, into `sample`
 */
export function writeProgram(kind: Kind): Uint8Array<ArrayBuffer> {
  const { tableau, n, forced } = kind;
  const layout = layoutOf(kind);
  const module = new Module();
  const host = forced ? module.imported('force', [F64, I32], []) : null;
  const N = 2 * n;
  /** Distance of arrays within a step, bytes. */
  const y1 = N * BYTES;
  const slope = (j: number): number => (2 + j) * N * BYTES;

  const accelerations = accelerationsOf(module, kind, layout);
  const project = projectionOf(module, kind, layout, accelerations);
  /** The slope at the state at an address; leaves with `giveUp` where there is none. */
  const evaluate = (t: Code, at: Code, to: Code, giveUp: Code): Code => [
    host ? call(host, t, at) : [],
    when(i32.eqz(call(accelerations, at, to)), giveUp),
  ];
  /** Weighted sum of slopes at the component that a pointer runs over, from the first to the last. */
  const sum = (weights: readonly number[], p: number): Code =>
    weights
      .map((w, j) => ({ w, j }))
      .filter(({ w }) => w !== 0)
      .map(({ w, j }) => f64.mul(f64.const(w), f64.load(get(p), slope(j))))
      .reduce((total, term) => f64.add(total, term));

  const attempt = module.func([I32, F64, F64, F64, F64, I32], [F64], 'attempt');
  {
    const [step, t, h, rtol, atol, projecting] = [0, 1, 2, 3, 4, 5] as const;
    const p = attempt.local(I32);
    const squares = attempt.local();
    const lower = attempt.local();
    const scale = attempt.local();
    const r = attempt.local();
    const none = giveBack(f64.const(NaN));
    const { stages, c, A, error, lowOrderError } = tableau;
    const body: Code[] = [];
    for (let s = 1; s <= stages; s++) {
      body.push(
        each(p, get(step), N, f64.store(get(p), y1, f64.add(f64.load(get(p)), f64.mul(get(h), sum(A[s]!, p))))),
      );
      if (s < stages)
        body.push(
          evaluate(
            f64.add(get(t), f64.mul(f64.const(c[s]!), get(h))),
            i32.add(get(step), i32.const(y1)),
            i32.add(get(step), i32.const(slope(s))),
            none,
          ),
        );
    }
    const end: Code = [
      when(get(projecting), when(i32.eqz(call(project, i32.add(get(step), i32.const(y1)))), none)),
      evaluate(
        f64.add(get(t), get(h)),
        i32.add(get(step), i32.const(y1)),
        i32.add(get(step), i32.const(slope(stages))),
        none,
      ),
    ];
    const scaleHere = set(
      scale,
      f64.add(get(atol), f64.mul(get(rtol), f64.max(f64.abs(f64.load(get(p))), f64.abs(f64.load(get(p), y1))))),
    );
    const norm: Code = lowOrderError
      ? [
          set(squares, f64.const(0)),
          set(lower, f64.const(0)),
          each(p, get(step), N, [
            scaleHere,
            set(r, f64.div(sum(error, p), get(scale))),
            set(squares, f64.add(get(squares), f64.mul(get(r), get(r)))),
            set(r, f64.div(sum(lowOrderError, p), get(scale))),
            set(lower, f64.add(get(lower), f64.mul(get(r), get(r)))),
          ]),
          when(
            i32.and(f64.eq(get(squares), f64.const(0)), f64.eq(get(lower), f64.const(0))),
            set(r, f64.const(0)),
            set(
              r,
              f64.div(
                f64.mul(get(h), get(squares)),
                f64.sqrt(f64.mul(f64.add(get(squares), f64.mul(f64.const(0.01), get(lower))), f64.const(N))),
              ),
            ),
          ),
        ]
      : [
          set(squares, f64.const(0)),
          each(p, get(step), N, [
            scaleHere,
            set(r, f64.div(f64.mul(get(h), sum(error, p)), get(scale))),
            set(squares, f64.add(get(squares), f64.mul(get(r), get(r)))),
          ]),
          set(r, f64.sqrt(f64.div(get(squares), f64.const(N)))),
        ];
    attempt.body = [
      body,
      error.length > stages ? [end, norm] : [norm, when(f64.le(get(r), f64.const(1)), end)],
      get(r),
    ];
  }

  const makeDense = module.func([I32, F64, F64], [I32], 'makeDense');
  {
    const [step, t, h] = [0, 1, 2] as const;
    const p = makeDense.local(I32);
    const o = makeDense.local(I32);
    const difference = makeDense.local();
    const curvature = makeDense.local();
    const { stages, c, A, dense } = tableau;
    const coefficient = (k: number): number => (layout.dense + k * N) * BYTES;
    const giveUp = giveBack(i32.const(0));
    makeDense.body = [
      set(o, i32.const(0)),
      each(p, get(step), N, [
        set(difference, f64.sub(f64.load(get(p), y1), f64.load(get(p)))),
        set(curvature, f64.sub(f64.mul(get(h), f64.load(get(p), slope(0))), get(difference))),
        f64.store(get(o), coefficient(0), get(difference)),
        f64.store(get(o), coefficient(1), get(curvature)),
        f64.store(
          get(o),
          coefficient(2),
          f64.sub(f64.sub(get(difference), f64.mul(get(h), f64.load(get(p), slope(stages)))), get(curvature)),
        ),
        set(o, i32.add(get(o), i32.const(BYTES))),
      ]),
      A.slice(stages + 1).map((row, k) => {
        const s = stages + 1 + k;
        const sample = layout.sample * BYTES;
        return [
          set(o, i32.const(0)),
          each(p, get(step), N, [
            f64.store(get(o), sample, f64.add(f64.load(get(p)), f64.mul(get(h), sum(row, p)))),
            set(o, i32.add(get(o), i32.const(BYTES))),
          ]),
          evaluate(
            f64.add(get(t), f64.mul(f64.const(c[s]!), get(h))),
            i32.const(sample),
            i32.add(get(step), i32.const(slope(s))),
            giveUp,
          ),
        ];
      }),
      dense.length > 0 ? set(o, i32.const(0)) : [],
      dense.length > 0
        ? each(p, get(step), N, [
            dense.map((weights, k) =>
              f64.store(get(o), coefficient(HERMITE_TERMS + k), f64.mul(sum(weights, p), get(h))),
            ),
            set(o, i32.add(get(o), i32.const(BYTES))),
          ])
        : [],
      i32.const(1),
    ];
  }

  const interpolate = module.func([I32, F64], [], 'interpolate');
  {
    const [step, s] = [0, 1] as const;
    const p = interpolate.local(I32);
    const o = interpolate.local(I32);
    const r = interpolate.local();
    const terms = HERMITE_TERMS + tableau.dense.length;
    const coefficient = (k: number): Code => f64.load(get(o), (layout.dense + k * N) * BYTES);
    const nested = Array.from({ length: terms - 1 }, (_, k) => k).reduceRight<Code>(
      (total, k) => f64.add(coefficient(k), f64.mul(get(k % 2 === 0 ? r : s), total)),
      coefficient(terms - 1),
    );
    interpolate.body = [
      set(r, f64.sub(f64.const(1), get(s))),
      set(o, i32.const(0)),
      each(p, get(step), N, [
        f64.store(get(o), layout.sample * BYTES, f64.add(f64.load(get(p)), f64.mul(get(s), nested))),
        set(o, i32.add(get(o), i32.const(BYTES))),
      ]),
    ];
  }
  return module.bytes(layout.size * BYTES);
}

/** A body for each of `count` numbers from an address on, with the local `p` pointing at it. */
function each(p: number, from: Code, count: number, body: Code): Code {
  const left = count * BYTES;
  // The pointer runs; the end is told by its distance from the start, which is computed anew: V8 keeps it in a register.
  return [
    set(p, from),
    [0x03, 0x40],
    body,
    set(p, i32.add(get(p), i32.const(BYTES))),
    branchIf(0, i32.lt(get(p), i32.add(from, i32.const(left)))),
    0x0b,
  ];
}

/** accelerations(y, rate), with lambda and factors to their places. */
function accelerationsOf(module: Module, { tape, set: values, n }: Kind, layout: Layout): Func {
  const func = module.func([I32, I32], [I32], 'accelerations');
  const [y, rate] = [0, 1] as const;
  const places: Places = {
    input: (array, position) =>
      array === 'q'
        ? f64.load(get(y), position * BYTES)
        : array === 'v'
          ? f64.load(get(y), (n + position) * BYTES)
          : load((array === 'f' ? layout.force : fail(array)) + position),
    known: constantsOf(tape, layout),
  };
  const wanted = [...values.rate, ...values.lambda, ...values.factors, ...values.larger, ...values.smaller];
  const { code, value } = compute(func, tape, wanted, places);
  const total = func.local();
  func.body = [
    code,
    values.rate.map((i, k) => f64.store(get(rate), k * BYTES, value(i))),
    values.lambda.map((i, k) => store(layout.lambda + k, value(i))),
    values.factors.map((i, k) => store(layout.factors + k, value(i))),
    set(
      total,
      values.rate.map((_, k) => f64.load(get(rate), k * BYTES)).reduce((sum, a) => f64.add(sum, a)),
    ),
    // One that is no number makes this none.
    values.larger
      .map((big, k) => f64.gt(value(big), value(values.smaller[k]!)))
      .reduce((all, test) => i32.and(all, test), f64.eq(f64.sub(get(total), get(total)), f64.const(0))),
  ];
  return func;
}

/** project(y) in place, as Projection.project at the end of a step. @returns a function that gives 0 where it cannot */
function projectionOf(module: Module, kind: Kind, layout: Layout, accelerations: Func): Func {
  const { tape, set: values, n, contact, tableau } = kind;
  const measure = module.func([I32], []);
  {
    const { code, value } = compute(measure, tape, [...values.slip, ...values.heights], {
      input: (array, position) =>
        f64.load(get(0), (position + (array === 'q' ? 0 : array === 'v' ? n : fail(array))) * BYTES),
      known: constantsOf(tape, layout),
    });
    measure.body = [
      code,
      values.slip.map((i, k) => store(layout.slip + k, value(i))),
      values.heights.map((i, k) => store(layout.heights + k, value(i))),
    ];
  }
  /** shift(x): adds the smallest change in the mass metric that changes Omega x by `change`. */
  const shift = module.func([I32], []);
  {
    const { code, value } = compute(shift, tape, values.shift, {
      input: (array, position) => (array === 'g' ? load(layout.change + position) : fail(array)),
      known: new Map(values.factors.slice(0, -1).map((i, k) => [i, load(layout.factors + k)])),
    });
    shift.body = [
      code,
      values.shift.map((i, k) => f64.store(get(0), k * BYTES, f64.add(f64.load(get(0), k * BYTES), value(i)))),
    ];
  }
  const change = (rows: readonly number[], from: number): Code =>
    values.slip.map((_, r) => {
      const k = rows.indexOf(r);
      return store(layout.change + r, k < 0 ? f64.const(0) : f64.neg(load(from + k)));
    });
  /** Newton's iteration: whether only rounding is left. */
  const newton = (sizeOf: readonly number[], goal: number, correct: Code, y: Code): Func => {
    const func = module.func([I32], [I32]);
    const [size, last, i] = [func.local(), func.local(), func.local(I32)] as const;
    func.body = [
      set(last, f64.const(Infinity)),
      forever([
        set(
          size,
          sizeOf.map((at) => f64.abs(load(at))).reduce((a, b) => f64.max(a, b), f64.const(0)),
        ),
        when(i32.eqz(f64.gt(get(size), f64.const(goal))), giveBack(i32.const(1))),
        when(i32.eqz(f64.lt(get(size), get(last))), giveBack(f64.le(get(size), f64.const(ROUNDING)))),
        set(last, get(size)),
        correct,
        call(shift, y),
        call(measure, get(0)),
        set(i, i32.add(get(i), i32.const(1))),
        branchIf(1, i32.ge(get(i), i32.const(MOST_ITERATIONS))),
      ]),
      f64.le(get(last), f64.const(ROUNDING)),
    ];
    return func;
  };
  const rows = values.slip.map((_, r) => r);
  const at = (first: number, count: number): number[] => Array.from({ length: count }, (_, k) => first + k);
  const positions = contact
    ? newton(at(layout.heights, contact.rows.length), HEIGHT_GOAL, change(contact.rows, layout.heights), get(0))
    : null;
  const velocities = newton(
    at(layout.slip, rows.length),
    VELOCITY_GOAL,
    change(rows, layout.slip),
    i32.add(get(0), i32.const(n * BYTES)),
  );
  const iterate = module.func([I32], [I32]);
  iterate.body = [
    call(measure, get(0)),
    positions ? when(i32.eqz(call(positions, get(0))), giveBack(i32.const(0))) : [],
    call(velocities, get(0)),
  ];
  const project = module.func([I32], [I32]);
  // The factors at hand are of the end's time where the last stage is.
  const near = tableau.c[tableau.stages - 1] === 1;
  project.body = [
    near ? when(call(iterate, get(0)), giveBack(i32.const(1))) : [],
    // The slope goes where nothing is kept before the dense output is made.
    when(i32.eqz(call(accelerations, get(0), i32.const(layout.sample * BYTES))), giveBack(i32.const(0))),
    call(iterate, get(0)),
    0x1a,
    i32.const(1),
  ];
  return project;
}

const load = (at: number): Code => f64.load(i32.const(0), at * BYTES);
const store = (at: number, value: Code): Code => f64.store(i32.const(0), at * BYTES, value);

const constantsOf = ({ prepare }: Tape, layout: Layout): ReadonlyMap<number, Code> =>
  new Map(prepare.map((i, k) => [i, load(layout.constants + k)]));

function fail(array: string): never {
  throw new Error(`a function on the tape reads the array "${array}", which it does not have`);
}
