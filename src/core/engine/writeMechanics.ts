/**
 * Accelerations and projection of the module that `program.ts` writes, from the derivation's tape: operation by operation as
 * DirectAccelerations and Projection do them.
 */
import { HEIGHT_GOAL, MOST_ITERATIONS, ROUNDING, VELOCITY_GOAL } from '../mechanics/projection.ts';
import {
  branchIf,
  call,
  f64,
  forever,
  get,
  giveBack,
  i32,
  I32,
  set,
  when,
  type Code,
  type Func,
  type Module,
} from './assembler.ts';
import { BYTES, constantsOf, fail, load, store, type Kind, type Layout } from './layout.ts';
import { compute, type Places } from './tape.ts';

/** Functions of the host, by name. */
type Functions = ReadonlyMap<string, Func>;

/** Addresses for values of a tape: factors have theirs. */
function homesOf(layout: Layout, factors: readonly number[] = []): (position: number) => number {
  const known = new Map(factors.map((i, k) => [i, layout.factors + k]));
  return (i) => (known.get(i) ?? layout.scratch + i) * BYTES;
}

/**
 * accelerations(y, rate), with lambda and factors to their places.
 *
 * @param module that it becomes part of
 * @param layout where the values lie in memory
 * @param functions those that it calls
 */
export function accelerationsOf(
  module: Module,
  { tape, set: values, n }: Kind,
  layout: Layout,
  functions: Functions,
): Func {
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
    host: (name) => functions.get(name),
    home: homesOf(layout, values.factors),
  };
  const wanted = [...values.rate, ...values.lambda, ...values.factors, ...values.larger, ...values.smaller];
  const { code, value, kept } = compute(func, tape, wanted, places);
  const total = func.local();
  func.body = [
    code,
    values.rate.map((i, k) => f64.store(get(rate), k * BYTES, value(i))),
    values.lambda.map((i, k) => store(layout.lambda + k, value(i))),
    values.factors.map((i, k) => (kept(i) && !tape.prepare.includes(i) ? [] : store(layout.factors + k, value(i)))),
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

/**
 * project(y) in place, as Projection.project.
 *
 * @param module that it becomes part of
 * @param kind tape, constraint set, method and number of coordinates
 * @param layout where the values lie in memory
 * @param functions those that it calls
 * @param accelerations as `accelerationsOf` writes it
 * @returns the same for the end of a step, near its last stage; both give 0 where they cannot
 */
export function projectionOf(
  module: Module,
  kind: Kind,
  layout: Layout,
  functions: Functions,
  accelerations: Func,
): Func {
  const { tape, set: values, n, contact, tableau } = kind;
  /** measured(y): some values of a state to their place. */
  const measuring = (wanted: readonly number[], to: number): Func => {
    const func = module.func([I32], []);
    const { code, value } = compute(func, tape, wanted, {
      input: (array, position) =>
        f64.load(get(0), (position + (array === 'q' ? 0 : array === 'v' ? n : fail(array))) * BYTES),
      known: constantsOf(tape, layout),
      host: (name) => functions.get(name),
      home: homesOf(layout),
    });
    func.body = [code, wanted.map((i, k) => store(to + k, value(i)))];
    return func;
  };
  const measureSlip = measuring(values.slip, layout.slip);
  const measureHeights = measuring(values.heights, layout.heights);
  /** shift(x): adds the smallest change in the mass metric that changes Omega x by `change`. */
  const shift = module.func([I32], []);
  {
    const { code, value } = compute(shift, tape, values.shift, {
      input: (array, position) => (array === 'g' ? load(layout.change + position) : fail(array)),
      known: new Map(values.factors.slice(0, -1).map((i, k) => [i, load(layout.factors + k)])),
      host: (name) => functions.get(name),
      home: homesOf(layout),
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
  const newton = (sizeOf: readonly number[], goal: number, correct: Code, y: Code, measure: Func): Func => {
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
    ? newton(
        at(layout.heights, contact.rows.length),
        HEIGHT_GOAL,
        change(contact.rows, layout.heights),
        get(0),
        measureHeights,
      )
    : null;
  const velocities = newton(
    at(layout.slip, rows.length),
    VELOCITY_GOAL,
    change(rows, layout.slip),
    i32.add(get(0), i32.const(n * BYTES)),
    measureSlip,
  );
  const iterate = module.func([I32], [I32]);
  iterate.body = [
    positions ? [call(measureHeights, get(0)), when(i32.eqz(call(positions, get(0))), giveBack(i32.const(0)))] : [],
    call(measureSlip, get(0)),
    call(velocities, get(0)),
  ];
  const project = module.func([I32], [I32], 'project');
  project.body = [
    when(i32.eqz(call(accelerations, get(0), i32.const(layout.rate * BYTES))), giveBack(i32.const(0))),
    call(iterate, get(0)),
    0x1a,
    i32.const(1),
  ];
  // The factors at hand are of the end's time where the last stage is.
  if (tableau.c[tableau.stages - 1] !== 1) return project;
  const near = module.func([I32], [I32]);
  near.body = [when(call(iterate, get(0)), giveBack(i32.const(1))), call(project, get(0))];
  return near;
}
